// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/view.h"

#include <algorithm>
#include <limits>

#include "engines/raster/draw_list.h"
#include "math/functions.h"

namespace rakelight::raster {
namespace {

[[noreturn]] void refuse(const std::string& reason) { throw Error(ErrorCode::usage, reason); }

void check_settings(const RenderSettings& s) {
    if (s.width < 1 || s.height < 1 || s.width > 65536 || s.height > 65536) refuse("the resolution must be 1 to 65536 pixels a side");
    if (s.samples != 1 && s.samples != 4 && s.samples != 8) refuse("the samples of a pixel must be 1, 4 or 8");
    if (s.shadow_size < 16 || s.shadow_size > 8192) refuse("the size of a shadow map must be 16 to 8192 texels");
    if (s.shadow_filter < 0 || s.shadow_filter > 4) refuse("the radius of the shadow filter must be 0 to 4 texels");
    if (!(s.shadow_bias >= 0 && s.shadow_bias <= 100)) refuse("the shadow bias must be 0 to 100");
    if (s.anisotropy < 1 || s.anisotropy > 16) refuse("anisotropy must be 1 to 16");
    if (s.samples != 1 && s.visibility != Visibility::z_reversed)
        refuse("more than one sample a pixel needs the default visibility, z-reversed");
    const Window w = s.window;
    if (w.width == 0) return;
    if (w.x < 0 || w.y < 0 || w.width < 1 || w.height < 1 || w.x > s.width - w.width || w.y > s.height - w.height)
        refuse("the window must lie inside the picture");
}

void check_camera(const Camera& c) {
    const bool depths_fit = std::isfinite(c.near) && c.far > c.near && (c.projection == Projection::orthographic || c.near > 0);
    if (!depths_fit) refuse("the camera's near distance must be positive and less than its far distance");
    if (c.projection == Projection::perspective && !(c.vertical_fov_rad > 0 && c.vertical_fov_rad < pi))
        refuse("the camera's field of view must be more than 0 and less than 180 degrees");
    const std::optional<double>& across = c.horizontal_fov_rad;
    if (c.projection == Projection::perspective && across && !(*across > 0 && *across < pi))
        refuse("the camera's horizontal field of view must be more than 0 and less than 180 degrees");
    if (c.projection == Projection::orthographic && c.half_width && !(*c.half_width > 0 && std::isfinite(*c.half_width)))
        refuse("the orthographic camera's width must be positive");
    if (c.projection == Projection::orthographic && !(c.half_height > 0 && std::isfinite(c.half_height)))
        refuse("the orthographic camera's height must be positive");
    if (c.projection == Projection::orthographic && !std::isfinite(c.far)) refuse("an orthographic camera needs a finite far distance");
}

}  // namespace

double View::distance_of(double key) const {
    if (orthographic && key >= 0) return near + (1 - key) * (far - near);
    return key > 0 ? near / key : std::numeric_limits<double>::infinity();
}

dvec3 View::place(double x, double y, double key) const {
    const double distance = distance_of(key), scale = orthographic ? 1 : distance;
    const dvec2 at = {(2 * x / width - 1) / scale_x, (1 - 2 * y / height) / scale_y};
    return transform_point(camera_to_world, dvec3{at.x * scale, at.y * scale, -distance});
}

View make_view(const Camera& camera, const dmat4& camera_to_world, const RenderSettings& settings) {
    check_settings(settings);
    check_camera(camera);
    View view;
    view.camera_to_world = camera_to_world;
    if (!inverse_affine(camera_to_world, view.world_to_camera)) refuse("the camera's placement is singular or not finite");
    const dvec3 eye = camera_to_world[3].xyz();
    view.world_to_eye = translation(-eye);
    view.orthographic = camera.projection == Projection::orthographic;
    view.width = settings.width;
    view.height = settings.height;
    view.near = camera.near;
    view.far = camera.far;
    const double aspect = double(settings.width) / double(settings.height);
    const double half_height = view.orthographic ? camera.half_height : math::tan(camera.vertical_fov_rad * 0.5);
    view.scale_y = 1.0 / half_height;
    view.scale_x = view.scale_y / aspect;
    if (view.orthographic && camera.half_width) view.scale_x = 1.0 / *camera.half_width;
    if (!view.orthographic && camera.horizontal_fov_rad) view.scale_x = 1.0 / math::tan(*camera.horizontal_fov_rad * 0.5);
    return view;
}

void narrow_depths(View& view, const Bounds& drawn) {
    if (drawn.empty()) return;
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = {corner & 1 ? drawn.high.x : drawn.low.x, corner & 2 ? drawn.high.y : drawn.low.y,
                         corner & 4 ? drawn.high.z : drawn.low.z};
        const double distance = -transform_point(view.world_to_camera, p).z;
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    double near = view.near, far = view.far;
    if (!view.orthographic) {
        near = std::max(near, 1e-30 * farthest);  // keys are near / distance: they have to be normal floats
    } else {
        const double diagonal = drawn.diagonal();
        if (!(diagonal > 0) || view.far - view.near <= 256 * diagonal) return;
        const double margin = 0.5 * diagonal + 1e-6 * std::max(std::fabs(nearest), std::fabs(farthest));
        near = std::max(near, nearest - margin);
        far = std::min(far, farthest + margin);
    }
    if (near < far) view.near = near, view.far = far;  // else the scene lies outside of them
}

View view_of(const DrawList& list, const Camera& camera, const RenderSettings& settings) {
    View view = make_view(camera, camera_to_world(list.scene, camera, list.node_to_world), settings);
    if (settings.visibility == Visibility::z_reversed) narrow_depths(view, list.bounds);
    return view;
}

}  // namespace rakelight::raster
