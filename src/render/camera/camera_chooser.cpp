// SPDX-License-Identifier: Apache-2.0
// Which camera: the caller's, else the file's first, else one fitted to the model.
#include "render/camera/camera_chooser.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include <rakelight/render/camera_chooser.h>
#include <rakelight/scene/words.h>

#include "base/format_text.h"
#include "math/functions.h"
#include "math/linear.h"
#include "prepare/pose_scene.h"
#include "render/camera/camera_depths.h"
#include "render/camera/place_camera.h"
#include "scene/drawn_vertices.h"
#include "scene/faults.h"
#include "scene/fitted_camera.h"
#include "scene/placement.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// A camera of the file, or the fitted one with a remark where the file's cannot show the model, neither as it is nor
/// by the depths that were requested. One that shows it except for those is kept.
Camera checked_camera_of_file(const Scene& scene, std::size_t index, const ViewRequest& view, double aspect,
                              const DrawnVertices& drawn, const NearestSurface& nearest, Context& context) {
    const Bounds& bounds = drawn.bounds();
    Camera camera = camera_of_file(scene, index, aspect);
    if (has_default_depths(scene, camera)) set_depths(camera, bounds, nearest);
    const std::string place = format_text("camera {}{}", index, camera.name.empty() ? "" : " '" + camera.name + "'");
    const auto use_default = [&](const std::string& why) {
        context.report().add(Remark::warning, scene.source, place, why + "; the default view is used instead");
        Camera fitted = default_camera(drawn, aspect, {.world_up = view.world_up});
        set_asked_depths(fitted, view);
        if (view.z_near || view.z_far) warn_if_blind(fitted, aspect, bounds, scene.source, context.report());
        return fitted;
    };
    if (fault_of(camera, CameraUse::in_engine)) return use_default("the camera is impossible");
    const std::string why_by_its_own = why_blind(camera, aspect, bounds);
    set_asked_depths(camera, view);
    const std::string why = why_blind(camera, aspect, bounds);
    if (why.empty()) return camera;
    if (!why_by_its_own.empty()) return use_default("the camera sees nothing of the model: " + why_by_its_own);
    context.report().add(Remark::warning, scene.source, place, "the camera sees nothing of the model: " + why);
    return camera;
}

/// The smaller the angle, the farther away a camera must be to see the whole model. Engines take distances as floats:
/// if those of the model's front and back are equal, they draw nothing.
void check_fitted(const Camera& camera) {
    if ((camera.z_far - camera.z_near) * 0x1p24 >= camera.z_far) return;
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.2g", camera.z_far);
    throw Error(ErrorCode::usage,
                std::string("the camera's angle of view is so small that the whole model is visible from ") + distance +
                    " m away, where floats cannot distinguish the distances of its front and back",
                {}, "give a larger angle, or 'camera-position'")
        .naming({"camera-position"});
}

/// @param is_moved  the camera goes elsewhere afterwards
FitOptions fit_wishes(const ViewRequest& view, bool is_moved) {
    FitOptions wishes{.world_up = view.world_up,
                      .up = view.up,
                      .vertical_fov_rad = view.vertical_fov_rad,
                      .horizontal_fov_rad = view.horizontal_fov_rad,
                      .orthographic = view.orthographic && !is_moved,
                      .direction = view.direction};
    wishes.fill = view.zoom_factor.value_or(wishes.fill);
    if (is_moved) return wishes;
    wishes.azimuth_rad = view.azimuth_rad.value_or(0), wishes.elevation_rad = view.elevation_rad.value_or(0);
    return wishes;
}

}  // namespace

ViewRequest resolve_angles(ViewRequest view, double& aspect) {
    if (!view.horizontal_fov_rad) return view;
    const double half_width = math::tan(0.5 * *view.horizontal_fov_rad);
    if (view.vertical_fov_rad) {
        aspect = half_width / math::tan(0.5 * *view.vertical_fov_rad);
    } else {
        view.vertical_fov_rad = 2 * math::atan2(half_width / aspect, 1);
        view.horizontal_fov_rad.reset();
    }
    return view;
}

bool takes_camera_of_file(const Scene& scene, const ViewRequest& view) {
    const bool asks = !view.camera.empty() || view.side == "file";
    return asks || (view.side.empty() && !view.is_placed() && !scene.cameras.empty());
}

Camera camera_of_file(const Scene& scene, std::size_t index, double aspect) {
    Camera camera = scene.cameras[index];
    camera.to_world = camera_to_world(scene, camera, world_matrices(scene));
    camera.node = no_index;
    return adapt_to_aspect(camera, aspect);
}

namespace {

void check_combination(const Scene& scene, const ViewRequest& view) {
    if (!view.side.empty() && !view.camera.empty())
        throw Error(ErrorCode::usage, "a named view and a camera of the file cannot both be used");
    if (view.direction && (!view.side.empty() || !view.camera.empty() || view.position))
        throw Error(ErrorCode::usage,
                    "a direction of view and a named view, a camera of the file or a position cannot both be used");
    if (view.zoom_factor && (!view.camera.empty() || view.position))
        throw Error(ErrorCode::usage, "a zoom factor is for fitted views, not for a camera of the file or a position");
    if (view.side == "file" && scene.cameras.empty())
        throw Error(ErrorCode::usage, "the file has no camera").about("view", {"view"});
}

/// @param scene  static; `drawn` are its vertices
Camera chosen(const Scene& scene, const DrawnVertices& drawn, const NearSurfaces& surfaces, const ViewRequest& asked,
              double aspect, Visibility visibility, Context& context) {
    const ViewRequest view = resolve_angles(asked, aspect);
    const NearestSurface nearest = nearest_of(surfaces, aspect, visibility);
    const Bounds& bounds = drawn.bounds();
    if (bounds.empty()) throw Error(ErrorCode::bad_file, "nothing to draw").with_file(scene.source);
    check_combination(scene, view);
    if (takes_camera_of_file(scene, view)) {
        const std::size_t index = view.camera.empty() ? 0 : find_camera(scene, view.camera);
        if (!view.is_placed() && !view.is_orbited())
            return checked_camera_of_file(scene, index, view, aspect, drawn, nearest, context);
        return place_camera(camera_of_file(scene, index, aspect), false, view, aspect, bounds, nearest, scene.source,
                            context);
    }
    const bool is_moved = view.position || view.focal_point;
    Camera fitted = view_camera(drawn, aspect, view.side.empty() ? "default" : view.side, fit_wishes(view, is_moved));
    if (!view.position) check_fitted(fitted);
    if (is_moved) return place_camera(fitted, true, view, aspect, bounds, nearest, scene.source, context);
    if (view.up && (view.world_up || view.direction))
        warn_if_up_is_along(*view.up, fitted, scene.source, context.report());
    set_asked_depths(fitted, view);
    if (view.z_near || view.z_far) warn_if_blind(fitted, aspect, bounds, scene.source, context.report());
    return fitted;
}

void check_aspect(double aspect) {
    if (!(aspect > 0 && std::isfinite(aspect)))
        throw Error(ErrorCode::usage, "the picture's aspect must be a number > 0");
}

}  // namespace

Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Context& context) {
    return choose_camera(scene, view, aspect, Visibility::z_reversed, context);
}

Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                     Context& context) {
    validate(scene);
    check_aspect(aspect);
    return valid::choose_camera(scene, view, aspect, visibility, context);
}

Camera valid::choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                            Context& context) {
    check_placement(view);
    const std::optional<Scene> posed = posed_outline(scene, context);
    const Scene& still = posed ? *posed : scene;
    return chosen(still, DrawnVertices(still), NearSurfaces(still), view, aspect, visibility, context);
}

struct CameraChooser::State {
    State(Scene scene, Context& context) : still(std::move(scene)), drawn(with_pose(still, context)), surfaces(still) {}
    static const Scene& with_pose(Scene& scene, Context& context) {
        validate(scene);
        if (std::optional<Scene> posed = posed_outline(scene, context)) scene = std::move(*posed);
        return scene;
    }

    Scene still;
    DrawnVertices drawn;
    NearSurfaces surfaces;
};

CameraChooser::CameraChooser(Scene scene, Context& context)
    : state_(std::make_unique<State>(std::move(scene), context)) {}
CameraChooser::~CameraChooser() = default;
CameraChooser::CameraChooser(CameraChooser&&) noexcept = default;
CameraChooser& CameraChooser::operator=(CameraChooser&&) noexcept = default;

Camera CameraChooser::choose(const ViewRequest& view, double aspect, Context& context) const {
    return choose(view, aspect, Visibility::z_reversed, context);
}

Camera CameraChooser::choose(const ViewRequest& view, double aspect, Visibility visibility, Context& context) const {
    check_aspect(aspect);
    check_placement(view);
    return chosen(state_->still, state_->drawn, state_->surfaces, view, aspect, visibility, context);
}

const Bounds& CameraChooser::bounds() const { return state_->drawn.bounds(); }

Camera adapt_to_aspect(Camera camera, double aspect) {
    if (camera.projection == Projection::perspective && camera.horizontal_fov_rad && camera.vertical_fov_rad == 0) {
        camera.vertical_fov_rad = 2 * math::atan2(math::tan(0.5 * *camera.horizontal_fov_rad) / aspect, 1);
        camera.horizontal_fov_rad.reset();
        camera.aspect.reset();
        return camera;
    }
    const bool has_width = camera.projection == Projection::perspective ? camera.horizontal_fov_rad.has_value()
                                                                        : camera.half_width.has_value();
    if (camera.aspect && *camera.aspect > aspect && !has_width) {  // the picture is narrower: show more above and below
        const double factor = *camera.aspect / aspect;
        camera.half_height *= factor;
        if (camera.projection == Projection::perspective)
            camera.vertical_fov_rad = 2 * math::atan2(math::tan(0.5 * camera.vertical_fov_rad) * factor, 1);
    }
    camera.aspect.reset();
    return camera;
}

}  // namespace rakelight
