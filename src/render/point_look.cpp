// SPDX-License-Identifier: Apache-2.0
#include "render/point_look.h"

#include <rakelight/scene/scene_queries.h>

#include <algorithm>

#include "math/functions.h"
#include "math/linear.h"
#include "prepare/splat_points.h"
#include "render/look.h"
#include "render/prepared_scene.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr double smallest = 1.5, largest = 48;  ///< [px] of a point

bool is_by_spacing(const PictureRequest& request) {
    return request.look != Look::plain && !names(request, "point-size");
}

/// [m] along the view, to the nearest corner of the box: the points there lie farthest apart on the picture. Of boxes that reach to the
/// eye a third of the way to the middle.
double nearest_distance(const Bounds& box, const dmat4& to_camera) {
    double nearest = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 at{corner & 1 ? box.low.x : box.high.x, corner & 2 ? box.low.y : box.high.y,
                       corner & 4 ? box.low.z : box.high.z};
        nearest = std::min(nearest, -transform_point(to_camera, at).z);
    }
    return std::max(nearest, -transform_point(to_camera, (box.low + box.high) * 0.5).z / 3);
}

}  // namespace

Scene with_splats(Scene scene, const PictureRequest& request, Context& context) {
    const RenderSettings& s = request.settings;
    if (!is_by_spacing(request) || s.points != PointShape::none || !s.surfaces || s.edges) return scene;
    return splat_points(std::move(scene), context);
}

void size_points(PictureRequest& request, Session& session, const Shot& shot, Context& context) {
    if (!is_by_spacing(request) || request.settings.points != PointShape::none) return;
    const std::shared_ptr<const PreparedScene> prepared = session.prepared_for(shot, context);
    const Camera& camera = shot.camera;
    const Scene& scene = scene_of(*prepared);
    const std::optional<double> diameter = point_diameter(scene, context);
    if (!diameter) return;
    const Bounds bounds = world_bounds(scene);
    const dmat4 placed = camera_to_world(scene, camera, world_matrices(scene));
    dmat4 to_camera;
    if (bounds.empty() || !inverse_affine(placed, to_camera)) return;
    const bool is_parallel = camera.projection == Projection::orthographic;
    const double distance = nearest_distance(bounds, to_camera);
    if (!is_parallel && !(distance > 0)) return;
    const double half = is_parallel ? camera.half_height : distance * math::tan(camera.vertical_fov_rad * 0.5);
    const double pixels = *diameter / half * 0.5 * request.settings.height;
    request.settings.point_size = float(std::clamp(pixels, smallest, largest));
}

}  // namespace rakelight
