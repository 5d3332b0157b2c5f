// SPDX-License-Identifier: Apache-2.0
// Lines over the picture: grid, axes, lights, normals and the like, seams.
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/tools/inspect.h>

#include "../document/document.h"

namespace rakelight::viewer {

std::vector<Line> grid_lines(const Bounds& bounds, dvec3 world_up);
std::vector<Line> axis_lines(const Bounds& bounds);
/// Position at which a light is displayed: a lamp at its place, a directional light at its arrow's middle. Ambient
/// light has none.
std::optional<dvec3> place_of(const Light& light, const Bounds& bounds);
/// [px] of a picture of that size, y down; none: behind the camera.
std::optional<dvec2> pixel_of(dvec3 place, const Camera& camera, int width, int height);

/// Half the width and height of what a camera sees: [m] of a parallel projection, else at distance 1.
dvec2 half_size_of(const Camera& camera, int width, int height);
/// Tail and tip of the arrow of a directional light, which points at the model.
std::pair<dvec3, dvec3> directional_arrow(const Light& light, const Bounds& bounds);
/// A line with a head of four.
void add_arrow(std::vector<Line>& to, dvec3 tail, dvec3 tip, vec4 color, float width);

/// A star where a lamp is, an arrow the way that a light goes, the cone of a spot.
std::vector<Line> light_lines(std::span<const LightItem> lights, const Bounds& bounds, std::size_t selected);

enum class VertexVector { normal, tangent, bitangent };
/// A line per vertex of a prepared scene, in the world; at most `most`, taken evenly.
std::vector<Line> vertex_lines(const Scene& prepared, VertexVector which, const Bounds& bounds,
                               std::size_t most = 20000);

/// The seams of a model, of which only the worst are drawn.
struct Seams {
    std::size_t count = 0;
    double worst_deg = 0;
    std::vector<SeamLine> drawn;
};
/// How to look for the seams that are seen: missing normals that the file wants to be flat are so.
PrepareOptions seam_options(const Scene& scene, PrepareOptions of_picture);
Seams worst_seams(std::vector<SeamLine> all, std::size_t most = 20000);
/// Colored by heat_color().
std::vector<Line> seam_lines(std::span<const SeamLine> seams);

/// Those that no surface hides: both ends are compared with the depths of a picture, up to `slack` of the model's size. Lines that
/// are seen through surfaces stay.
/// @param depth  [width * height] of a picture by `camera`
std::vector<Line> visible_lines(std::span<const Line> lines, const Camera& camera, std::span<const float> depth,
                                int width, int height, double slack);

}  // namespace rakelight::viewer
