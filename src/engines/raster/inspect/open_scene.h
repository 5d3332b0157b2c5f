// SPDX-License-Identifier: Apache-2.0
// The soft engine with its stages open: the same functions as a picture goes through. What inspection.h lets tools see.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engines/raster/behind.h"
#include "engines/raster/geometry/front_end.h"
#include "engines/raster/inspect/explanation.h"
#include "engines/raster/lights/light_points.h"
#include "engines/raster/marks/marks.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/shadows/shadow_maps.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

class AmbientOcclusion;

/// A prepared scene seen by a camera. Not to be copied: its parts refer to each other.
class OpenScene {
public:
    /// @throws Error as Engine::prepare() and Engine::render()
    OpenScene(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
    ~OpenScene();
    OpenScene(const OpenScene&) = delete;
    OpenScene& operator=(const OpenScene&) = delete;

    const DrawList& list() const { return list_; }
    const PictureCamera& view() const { return view_; }
    const RenderSettings& settings() const { return settings_; }
    const std::vector<lighting::LightParameters>& lights() const { return lights_; }
    std::span<const ShadowView> shadow_maps() const { return shadows_.all(); }
    PictureEffects effects() const {
        return {.shadows = shadows_.data(), .is_explained = true, .behind = behind_ ? behind_->view() : nullptr};
    }
    const AmbientOcclusion* occlusion() const;  ///< of the whole picture; null: none
    /// [m] distance along the view axis of a depth key.
    float distance_of(float key) const { return float(view_.distance_of(double(key))); }
    /// Whether culling drops what is seen from behind (or from the front) of a draw.
    bool is_culled(std::uint32_t draw, bool is_back) const;

private:
    RenderSettings settings_;
    shading::TextureCache textures_;
    DrawList list_;
    PictureCamera view_;
    std::vector<lighting::LightParameters> lights_;
    ShadowMaps shadows_;
    std::unique_ptr<const cpu_shading::BehindPicture> behind_;  ///< null: nothing is transmissive
    struct Depths;
    std::unique_ptr<const Depths> depths_;  ///< null: no ambient occlusion
};

/// The geometry stages of a window of the picture.
struct OpenGeometry {
    /// @param with_culled also the triangles that culling drops, so that they can be shown
    /// @param shading     another one than the settings name
    OpenGeometry(const OpenScene& of, Window window, bool with_culled, Context& context,
                 std::optional<Shading> shading = {});
    RenderSettings settings;
    TileGrid grid;
    FrontEnd front;  ///< refers to `settings`
    Binned binned;
    LightPoints points;  ///< flat and Gouraud: lit corners
    Marks marks;         ///< the scene's lines and points
};

/// Everything about one pixel, which lies in the picture.
PixelExplanation explain_pixel(const OpenScene& of, int x, int y, Context& context);

/// The points that a triangle's light is interpolated from, one or three; `job` is of its material. Empty: it is lit at
/// its pixels.
std::vector<TracedCorner> trace_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s,
                                        const ShadeJob& job);

/// Tiles of `drawn` as Engine::render() draws them, in scalar words, with all attributes in the records.
TileJob tile_job(const OpenScene& of, const OpenGeometry& drawn);

}  // namespace rakelight::raster
