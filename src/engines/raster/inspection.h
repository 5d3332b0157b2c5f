// SPDX-License-Identifier: Apache-2.0
// The soft engine with its stages open to look at: the same functions as a picture goes through, run for tools that show
// what happens on the way (`rakelight explain`, `rakelight stages`).
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "engines/raster/front_end.h"
#include "engines/raster/kernels/trace_types.h"
#include "engines/raster/light_points.h"
#include "engines/raster/marks.h"

namespace rakelight::raster {

/// What became of a triangle at a pixel that it covers.
enum class Fate : std::uint8_t {
    visible,       ///< the nearest one that is not seen through: its color is the pixel's
    blended,       ///< seen through, before the visible one: its color is laid over
    hidden,        ///< behind the visible one
    masked_out,    ///< its alpha is below the material's cutoff here
    culled_back,   ///< not drawn: seen from behind
    culled_front,  ///< not drawn: seen from the front
};

/// A triangle that covers a pixel's center.
struct CoveringTriangle {
    std::uint32_t draw = none, triangle = none;  ///< into DrawList::draws; which triangle of its mesh
    std::array<std::uint32_t, 3> vertex{};       ///< into the mesh's arrays
    bool is_back = false;     ///< seen from behind
    bool is_clipped = false;  ///< this is a piece: the triangle passes a clipping plane
    float depth_key = 0;      ///< what is compared: greater is nearer
    float distance = 0;       ///< [m] along the view axis
    float alpha = 1;          ///< of masked and blended materials
    Fate fate = Fate::hidden;
};

/// A point that was lit before there were pixels, with what each light gave it.
struct TracedCorner {
    LitCorner corner;
    std::vector<TracedLight> lights;  ///< as Scene::lights; terms per unit of reflectance
};

/// The points that a triangle's light is interpolated from, one or three; `job` is of its material. Empty: it is lit at
/// its pixels.
std::vector<TracedCorner> trace_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s,
                                        const ShadeJob& job);

/// One surface that was shaded for the pixel.
struct ShadedLayer {
    std::size_t triangle = 0;      ///< into PixelExplanation::triangles
    PixelTrace trace{};
    std::vector<TracedLight> lights;  ///< as Scene::lights; empty for unlit surfaces and where trace.is_lit_at_corners
    std::vector<TracedCorner> corners;  ///< where trace.is_lit_at_corners: the three vertices, or the centroid alone
    int reflection_model = 0, reflection_form = 0;  ///< of ShadeJob
    bool is_unlit = false, is_blended = false;
    vec4 before, after;            ///< the pixel, linear, before and after this layer
};

struct PixelExplanation {
    int x = 0, y = 0;
    vec4 background;
    std::vector<CoveringTriangle> triangles;  ///< nearest first
    std::vector<ShadedLayer> layers;          ///< in the order in which they were laid: at most one that is not blended
    vec4 sum;     ///< what the layers come to
    vec4 color;   ///< the pixel's surfaces as the engine draws them: equal to `sum` to the bit
    bool has_marks = false;  ///< lines or points of the scene may lie over them
};

/// A prepared scene seen by a camera. Not to be copied: its parts refer to each other.
class Inspection {
public:
    /// @throws Error as Engine::prepare() and Engine::render()
    Inspection(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
    Inspection(const Inspection&) = delete;
    Inspection& operator=(const Inspection&) = delete;

    const DrawList& list() const { return list_; }
    const View& view() const { return view_; }
    const RenderSettings& settings() const { return settings_; }
    const std::vector<lighting::LightParameters>& lights() const { return lights_; }
    /// [m] distance along the view axis of a depth key.
    float distance_of(float key) const { return float(view_.distance_of(double(key))); }
    /// Whether culling drops what is seen from behind (or from the front) of a draw.
    bool is_culled(std::uint32_t draw, bool is_back) const;

    /// The geometry stages of a window of the picture.
    struct Geometry {
        /// @param with_culled also the triangles that culling drops, so that they can be shown
        /// @param shading     another one than the settings name
        Geometry(const Inspection& of, Window window, bool with_culled, Context& context,
                 std::optional<Shading> shading = {});
        RenderSettings settings;
        TileGrid grid;
        FrontEnd front;  ///< refers to `settings`
        Binned binned;
        LightPoints points;  ///< flat and Gouraud: lit corners
        Marks marks;         ///< the scene's lines and points
    };

    /// Everything about one pixel. @throws Error usage: outside of the picture
    PixelExplanation explain(int x, int y, Context& context) const;

private:
    RenderSettings settings_;
    TextureCache textures_;
    DrawList list_;
    View view_;
    std::vector<lighting::LightParameters> lights_;
};

}  // namespace rakelight::raster
