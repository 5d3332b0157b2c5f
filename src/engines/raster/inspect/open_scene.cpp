// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/open_scene.h"

#include "engines/raster/material_jobs.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/visibility/visibility_methods.h"
#include "math/isa.h"
#include "scene/charge_arrays.h"
#include "shading/draw_choices.h"
#include "shading/lights/lights.h"

namespace rakelight::raster {

/// The depths of the whole picture, and what they are drawn of.
struct OpenScene::Depths {
    TileGrid grid;
    FrontEnd front;
    Binned binned;
    std::optional<AmbientOcclusion> occlusion;

    Depths(const OpenScene& of, Context& context)
        : grid(of.settings().width, of.settings().height, {}),
          front{.list = of.list(),
                .view = of.view(),
                .settings = of.settings(),
                .kernels = *RL_COMMON_ISA::geometry_kernels(),
                .memory = PictureMemory(context.memory())} {
        transform_draws(front, context);
        binned = set_up_and_bin(front, grid, {}, context);
        front.shading.assign(of.list().draws.size(), Shading::phong);
        make_material_jobs(front, {});
        occlusion.emplace(front, binned, grid, *RL_COMMON_ISA::kernels(), context);
        occlusion->draw_depths(grid.window, context);
    }
};

OpenScene::~OpenScene() = default;

const AmbientOcclusion* OpenScene::occlusion() const { return depths_ ? &*depths_->occlusion : nullptr; }

OpenScene::OpenScene(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context)
    : settings_(settings_for_method(settings)),
      list_(cpu_shading::make_draw_list(charged_copy(scene, context), textures_, context)) {
    shading::EnvironmentCache environments;
    cpu_shading::set_environment(list_.scene, environments, false, list_.views, context);
    settings_.window = {};
    view_ = picture_camera_of(list_, camera, settings_);
    const dvec3 eye = view_.camera_to_world[3].xyz();
    lights_ = shading::make_lights(list_.scene, list_.node_to_world, eye);
    shadows_.update(list_, settings_, *RL_COMMON_ISA::kernels(), *RL_COMMON_ISA::geometry_kernels(), eye, lights_,
                    context);
    behind_ = picture_behind({list_, view_, settings_, lights_, shadows_.data(), *RL_COMMON_ISA::kernels(),
                              *RL_COMMON_ISA::geometry_kernels()},
                             context);
    if (settings_.ambient_occlusion) depths_ = std::make_unique<const Depths>(*this, context);
}

bool OpenScene::is_culled(std::uint32_t draw, bool is_back) const {
    const shading::Culling culled = shading::culling_of(list_, list_.draws[draw], settings_);
    return is_back ? culled.back : culled.front;
}

static RenderSettings settings_for(RenderSettings settings, Window window, bool with_culled,
                                   std::optional<Shading> shading) {
    settings.window = window;
    if (shading) {
        settings.shading = *shading;
        settings.shading_rules.clear();
        settings.material_shading = false;
    }
    if (with_culled) settings.cull = Cull::none;
    return settings;
}

OpenGeometry::OpenGeometry(const OpenScene& of, Window window, bool with_culled, Context& context,
                           std::optional<Shading> shading)
    : settings(settings_for(of.settings(), window, with_culled, shading)),
      grid(settings.width, settings.height, window),
      front{.list = of.list(),
            .view = of.view(),
            .settings = settings,
            .kernels = *RL_COMMON_ISA::geometry_kernels(),
            .memory = PictureMemory(context.memory())} {
    transform_draws(front, context);
    binned = set_up_and_bin(front, grid, {}, context);
    make_material_jobs(front, of.effects());
    points = light_points(front, binned, of.lights(), *RL_COMMON_ISA::kernels(), {}, context);
    marks = make_marks(front, grid, context);
}

TileJob tile_job(const OpenScene& of, const OpenGeometry& drawn) {
    return {.front = drawn.front,
            .binned = drawn.binned,
            .grid = drawn.grid,
            .lights = of.lights(),
            .kernels = *RL_COMMON_ISA::kernels(),
            .has_blended = true,
            .points = drawn.points,
            .whole_records = true,
            .marks = &drawn.marks,
            .occlusion = of.occlusion()};
}

}  // namespace rakelight::raster
