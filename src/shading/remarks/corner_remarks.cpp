// SPDX-License-Identifier: Apache-2.0
#include "shading/remarks/corner_remarks.h"

#include "shading/draw_choices.h"

namespace rakelight::shading {

void remark_corner_shading(const DrawList& list, const RenderSettings& settings,
                           const std::function<bool(std::uint32_t draw)>& is_lit_at_corners, Report& report) {
    bool any = false, normals = false, heights = false, layers = false;
    for (std::uint32_t d = 0; d < list.draws.size(); ++d) {
        if (!is_lit_at_corners(d)) continue;
        const Draw& draw = list.draws[d];
        const Bump bump = bump_of(list, draw, settings);
        any = true;
        normals = normals || bump == Bump::normal;
        heights = heights || (bump != Bump::normal && bump != Bump::none);
        layers =
            layers || (lighting_of(list, draw, settings) == Lighting::pbr && has_layers(list.material(draw).factors));
    }
    const auto say = [&](bool is_so, const char* what) {
        if (is_so) report.add(Remark::dropped, list.scene.source, {}, what);
    };
    say(normals, "normal maps do not act on flat and Gouraud shading: lighting is not evaluated at the pixels");
    say(heights, "height maps do not act on flat and Gouraud shading: lighting is not evaluated at the pixels");
    say(layers, "clearcoat, sheen and anisotropy do not act on flat and Gouraud shading");
    say(settings.shadows && any,
        "shadows do not fall on flat and Gouraud shading: lighting is not evaluated at the pixels");
}

}  // namespace rakelight::shading
