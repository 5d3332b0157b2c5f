// SPDX-License-Identifier: Apache-2.0
#include "shading/picture_camera.h"

#include <algorithm>
#include <limits>

#include "engines/check_settings.h"
#include "math/functions.h"
#include "scene/placement.h"
#include "shading/draw_list.h"

namespace rakelight::shading {
double PictureCamera::distance_of(double key) const {
    if (orthographic && key >= 0) return z_near + (1 - key) * (z_far - z_near);
    return key > 0 ? z_near / key : std::numeric_limits<double>::infinity();
}

dvec3 PictureCamera::place(double x, double y, double key) const {
    const double distance = distance_of(key), scale = orthographic ? 1 : distance;
    const dvec2 at = {(2 * x / width - 1) / scale_x, (1 - 2 * y / height) / scale_y};
    return transform_point(camera_to_world, dvec3{at.x * scale, at.y * scale, -distance});
}

PixelRays pixel_rays(const PictureCamera& view, int first_x, int first_y) {
    const dvec3 right = view.camera_to_world[0].xyz() / view.scale_x, up = view.camera_to_world[1].xyz() / view.scale_y;
    const double x = 2 * (first_x + 0.5) / view.width - 1, y = 1 - 2 * (first_y + 0.5) / view.height;
    const dvec3 forward = view.orthographic ? dvec3{} : -view.camera_to_world[2].xyz();
    return {right * (2.0 / view.width), up * (-2.0 / view.height), right * x + up * y + forward};
}

PictureCamera make_picture_camera(const Camera& camera, const dmat4& camera_to_world, const RenderSettings& settings) {
    PictureCamera view;
    view.camera_to_world = camera_to_world;
    if (!inverse_affine(camera_to_world, view.world_to_camera))
        throw Error(ErrorCode::usage, "the camera's placement is singular or not finite");
    const dvec3 eye = camera_to_world[3].xyz();
    view.world_to_eye = translation(-eye);
    view.orthographic = camera.projection == Projection::orthographic;
    view.width = settings.width;
    view.height = settings.height;
    view.z_near = camera.z_near;
    view.z_far = camera.z_far;
    const double aspect = double(settings.width) / double(settings.height);
    const double half_height = view.orthographic ? camera.half_height : math::tan(camera.vertical_fov_rad * 0.5);
    view.scale_y = 1.0 / half_height;
    view.scale_x = view.scale_y / aspect;
    if (view.orthographic && camera.half_width) view.scale_x = 1.0 / *camera.half_width;
    if (!view.orthographic && camera.horizontal_fov_rad)
        view.scale_x = 1.0 / math::tan(*camera.horizontal_fov_rad * 0.5);
    return view;
}

PictureCamera picture_camera_of(const DrawList& list, const Camera& camera, const RenderSettings& settings) {
    check_settings(settings);
    check_camera(camera, list.scene.nodes.size());
    PictureCamera view = make_picture_camera(camera, camera_to_world(list.scene, camera, list.node_to_world), settings);
    if (settings.visibility == Visibility::z_reversed) narrow_depths(view, list.bounds);
    return view;
}

void narrow_depths(PictureCamera& view, const Bounds& drawn) {
    if (drawn.empty()) return;
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (int corner = 0; corner < 8; ++corner) {
        const double distance = -transform_point(view.world_to_camera, drawn.corner(corner)).z;
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    double near = view.z_near, far = view.z_far;
    if (!view.orthographic) {
        near = std::max(near, 1e-30 * farthest);  // keys are near / distance: they have to be normal floats
    } else {
        const double diagonal = drawn.diagonal();
        if (!(diagonal > 0) || view.z_far - view.z_near <= 256 * diagonal) return;
        const double margin = 0.5 * diagonal + 1e-6 * std::max(std::fabs(nearest), std::fabs(farthest));
        near = std::max(near, nearest - margin);
        far = std::min(far, farthest + margin);
    }
    if (near < far) view.z_near = near, view.z_far = far;  // else the scene lies outside of them
}

}  // namespace rakelight::shading
