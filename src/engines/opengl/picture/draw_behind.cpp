// SPDX-License-Identifier: Apache-2.0
// The pass before the picture: what is behind transmissive surfaces.
#include "engines/opengl/renderer.h"
#include "shading/behind.h"

namespace rakelight::opengl {

/// As draw_part(), of the whole view without what transmits or blends.
void Renderer::draw_behind(Context& context) {
    has_behind_ = false;  // not on its own picture
    if (!shading::needs_behind(list_, settings_)) return behind_.forget();
    const shading::PictureCamera view = shading::camera_behind(view_);
    const RenderSettings settings = shading::settings_behind(settings_, view);
    const Window whole{0, 0, view.width, view.height};
    lights_.set(light_parameters_, light_shadows_, view, whole);
    const PictureState now = picture_state();
    const PictureState state{.list = now.list,
                             .cache = now.cache,
                             .textures = now.textures,
                             .settings = settings,
                             .view = view,
                             .shading = now.shading,
                             .lights = now.lights,
                             .has_environment = now.has_environment,
                             .has_shadows = now.has_shadows,
                             .units = now.units};
    const PictureTools with = tools();
    const PictureDrawer drawer(with, state, whole);
    Target& to = behind_.begin(view, settings.samples);
    to.begin(settings.background, far_depth());
    drawer.begin();
    if (environment_ && list_.scene.environment && list_.scene.environment->is_background) drawer.draw_sky();
    {
        const PassMeter::Pass pass(meter_, "what is behind transmissive surfaces");
        for (std::uint32_t d = 0; d < list_.draws.size(); ++d) {
            context.throw_if_cancelled();
            if (!drawer.is_outside(d) && shading::is_behind(list_, list_.draws[d], settings))
                drawer.draw(d, draw_state(state, d, Output::color, false));
        }
    }
    to.resolve();
    if (Marks::are_in(list_, settings)) marks_.draw(drawer, state, to, meter_);
    behind_.finish(driver_);
    behind_factors_ = shading::behind_factors(view);
    has_behind_ = true;
}

}  // namespace rakelight::opengl
