// SPDX-License-Identifier: Apache-2.0
// Plots of vertices and tables of their coordinates, in any space, for the stages before pixels.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "math/linear.h"
#include "tools/object_title.h"
#include "tools/stages/stage.h"

namespace rakelight::stages {

inline constexpr std::size_t listed_rows = 48;
inline constexpr Code ground{16, 18, 24}, wire{150, 190, 230}, frame{240, 170, 60}, red{255, 80, 60}, axis{70, 80, 100};

/// A number of a table; JSON has no infinities.
Cell cell(double value);

/// The vertices of the scene in every space, draw by draw.
class Vertices {
public:
    explicit Vertices(const Sources& of) : of_(of) {}

    const std::vector<shading::Draw>& draws() const { return of_.engine.list().draws; }
    const Mesh& mesh(std::size_t d) const { return of_.engine.list().scene.meshes[draws()[d].mesh]; }
    bool is_transformed(std::size_t d) const { return !of_.drawn.clip(d).empty(); }

    std::string object(std::size_t d) const { return object_title(of_.engine.list().scene, draws()[d].node); }

    dvec3 model(std::size_t d, std::uint32_t v) const { return cast<double>(mesh(d).positions[v]); }
    dvec3 world(std::size_t d, std::uint32_t v) const { return transform_point(draws()[d].to_world, model(d, v)); }
    dvec3 camera(std::size_t d, std::uint32_t v) const {
        return transform_point(of_.engine.view().world_to_camera, world(d, v));
    }
    /// The engine's own; not there for objects that are wholly outside.
    shading::ClipVertex clip(std::size_t d, std::uint32_t v) const { return of_.drawn.clip(d)[v]; }
    /// The depth key of the engine, from a distance [m] along the view axis: greater is nearer.
    double depth_key(double distance) const;
    /// Of what is not behind the near plane: x, y in the square from -1 to 1, and the depth key.
    dvec3 device(std::size_t d, std::uint32_t v) const;
    /// [m] along the view axis, of the farthest vertex.
    double farthest() const;

private:
    const Sources& of_;
};

/// Where a vertex is plotted.
using Place = std::function<dvec2(std::size_t draw, std::uint32_t vertex)>;

/// Maps a rectangle of a plot into a picture with equal scales, y up.
struct Fit {
    double scale = 1, x = 0, y = 0;
    dvec2 operator()(dvec2 p) const { return {x + p.x * scale, y - p.y * scale}; }
};

/// Room of a twentieth is left at each side.
Fit fit(dvec2 low, dvec2 high, int width, int height);

/// A parallel view from the right, above and in front (isometric).
dvec2 oblique(dvec3 p);

/// The corners of the frustum at the near plane and at a distance [m], in camera space; [0..3] near, [4..7] far, each
/// round.
std::array<dvec3, 8> frustum(const shading::PictureCamera& view, double far);

struct PlotLine {
    dvec2 a, b;
    Code color = frame;
};

/// A space that vertices are shown in.
struct Space {
    std::string caption;
    bool only_transformed = false;         ///< leave out objects that are wholly outside of the picture
    Place place;                           ///< what is not finite is left out
    std::vector<PlotLine> behind, before;  ///< lines under and over the model's
    std::optional<Fit> fixed;              ///< how it lies on the picture; else so that everything is seen
};

/// Adds a picture of all triangles' outlines.
void add_plot(Stage& stage, const Sources& of, const Vertices& vertices, const std::string& name, const Space& space);

using VertexRow = std::function<std::vector<double>(std::size_t draw, std::uint32_t vertex)>;

/// Adds rows of numbers, and the range of each column that has finite ones, for all vertices.
void add_table(Stage& stage, const Vertices& vertices, bool only_transformed, const std::vector<std::string>& columns,
               const VertexRow& values);

}  // namespace rakelight::stages
