// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/inspection.h"

#include <string>

#include "base/format_text.h"
#include "engines/raster/inspect/open_scene.h"

namespace rakelight::raster {

Inspection::Inspection(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context)
    : opened_(std::make_unique<const OpenScene>(scene, camera, settings, context)) {}
Inspection::~Inspection() = default;

const shading::DrawList& Inspection::list() const { return opened_->list(); }
const PictureCamera& Inspection::view() const { return opened_->view(); }
const RenderSettings& Inspection::settings() const { return opened_->settings(); }
const std::vector<lighting::LightParameters>& Inspection::lights() const { return opened_->lights(); }

std::vector<ShadowMapView> Inspection::shadow_maps() const {
    std::vector<ShadowMapView> out;
    for (const ShadowView& map : opened_->shadow_maps()) {
        const std::size_t texels = std::size_t(map.size) * std::size_t(map.size) * std::size_t(map.faces);
        out.push_back({map, {map.nearness, texels}});
    }
    return out;
}

Inspection::Geometry::Geometry(const Inspection& of, Window window, bool with_culled, Context& context)
    : opened_(std::make_unique<const OpenGeometry>(of.opened(), window, with_culled, context)) {}
Inspection::Geometry::~Geometry() = default;

std::span<const ClipVertex> Inspection::Geometry::clip(std::size_t draw) const { return opened_->front.clip[draw]; }
const RenderStats& Inspection::Geometry::stats() const { return opened_->front.stats; }

PixelExplanation Inspection::explain(int x, int y, Context& context) const {
    if (x < 0 || y < 0 || x >= settings().width || y >= settings().height)
        throw Error(ErrorCode::usage,
                    format_text("pixel {},{} is not in the picture of {} x {} pixels", x, y, settings().width,
                                settings().height),
                    {}, "0,0 is the top left one");
    return explain_pixel(*opened_, x, y, context);
}

SnappedPlace snapped_place(const PictureCamera& view, const ClipVertex& vertex) {
    const ScreenVertex snapped = snap_to_screen(ScreenMap(view), vertex);
    return {snapped.x, snapped.y};
}

}  // namespace rakelight::raster
