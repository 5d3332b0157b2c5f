// SPDX-License-Identifier: Apache-2.0
#include "render/sequence/sequence_views.h"

#include <algorithm>

#include <rakelight/math/linear.h>
#include <rakelight/scene/scene_queries.h>

#include "prepare/pose_scene.h"
#include "render/camera/camera_chooser.h"
#include "render/camera/camera_depths.h"
#include "render/camera/place_camera.h"
#include "render/camera/swept_outline.h"
#include "scene/drawn_vertices.h"
#include "scene/fitted_camera.h"
#include "scene/merge_scenes.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

constexpr int moments_shown = 16;  ///< of a clip, that a fitted view shows

/// The places of all that is drawn at a moment; nothing in it moves.
Scene outline_of(Scene scene, Context& context) {
    std::optional<Scene> posed = posed_outline(scene, context);
    return posed ? std::move(*posed) : std::move(scene);
}

Bounds both(const Bounds& a, const Bounds& b) {
    const auto least = [](dvec3 p, dvec3 q) {
        return dvec3{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
    };
    return {least(a.low, b.low), -least(-a.high, -b.high)};
}

/// All that a sequence shows, as one scene; its cameras are those of the first moment.
Scene everything(const std::vector<Scene>& outlines, Context& context) {
    if (outlines.size() == 1) return outlines[0];
    std::vector<ScenePart> parts;
    parts.reserve(outlines.size());
    for (const Scene& outline : outlines) parts.push_back({outline, {}, parts.empty(), parts.empty()});
    return merge_scenes(parts, context).scene;
}

}  // namespace

SequenceViews::SequenceViews(const SequencePlan& plan, const PictureRequest& request,
                             const std::function<Scene(double)>& requested_at, Context& context)
    : aspect_(double(request.settings.width) / double(request.settings.height)),
      visibility_(request.settings.visibility),
      axis_(axis_of_turns(request.view)),
      is_turned_(plan.is_turntable()) {
    std::vector<Scene> outlines;
    for (const double time : plan.moments(moments_shown)) {
        context.throw_if_cancelled();
        outlines.push_back(outline_of(requested_at(time), context));
        bounds_ = both(bounds_, world_bounds(outlines.back()));
    }
    const Scene begin = requested_at(plan.begin_s());
    const bool is_of_file = takes_camera_of_file(begin, request.view);
    is_fitted_ = !is_of_file && !request.view.position && !request.view.focal_point;
    const bool is_swept = is_turned_ && is_fitted_ && !bounds_.empty();
    Scene all = is_swept ? swept_outline(outlines, bounds_, axis_) : everything(outlines, context);
    all.source = begin.source;
    base_ = valid::choose_camera(all, request.view, aspect_, visibility_, context);
    view_ = resolve_angles(request.view, aspect_);
    // The file's camera was replaced where it cannot see the model: it is not followed then.
    follows_file_ = is_of_file && camera_of_file_in(begin).to_world == base_.to_world;
    find_focal_point();
}

/// As place_camera() has it, and the viewer.
void SequenceViews::find_focal_point() {
    const dvec3 center = bounds_.center(), eye = base_.to_world[3].xyz(), back = base_.to_world[2].xyz();
    focal_ = view_.focal_point.value_or(center);
    if (is_fitted_ || view_.focal_point || view_.position) return;
    const double distance = dot(eye - center, back);
    focal_ = eye - back * (distance > 0 ? distance : std::max(0.5 * bounds_.diagonal(), 1e-9));
}

Camera SequenceViews::camera_of_file_in(const Scene& scene) const {
    const Scene placed = with_posed_nodes(scene);
    const std::size_t index = view_.camera.empty() ? 0 : find_camera(placed, view_.camera);
    Camera camera = camera_of_file(placed, index, aspect_);
    if (view_.is_placed() || view_.is_orbited()) {
        Context quiet({.threads = 1});  // remarks were made for the first picture
        return place_camera(camera, false, view_, aspect_, bounds_, nearest_in(scene), scene.source, quiet);
    }
    if (has_default_depths(scene, camera)) set_depths(camera, bounds_, nearest_in(scene));
    set_asked_depths(camera, view_);
    return camera;
}

NearestSurface SequenceViews::nearest_in(const Scene& scene) const {
    return [&scene, aspect = aspect_, visibility = visibility_](const Camera& camera, double limit) {
        Context quiet({.threads = 1});
        const Scene outline = outline_of(scene, quiet);
        return nearest_of(NearSurfaces(outline), aspect, visibility)(camera, limit);
    };
}

Camera SequenceViews::camera(const Scene& scene, double angle_rad) const {
    Camera camera = follows_file_ ? camera_of_file_in(scene) : base_;
    const bool is_placed = view_.position || view_.focal_point;
    if (!is_turned_ && (follows_file_ || !is_placed)) return camera;
    if (is_turned_) camera.to_world = orbited(camera.to_world, focal_, axis_, -angle_rad, 0);
    if (is_fitted_) return camera;  // all that is seen of it lies about the axis
    set_depths(camera, bounds_, nearest_in(scene));
    set_asked_depths(camera, view_);
    return camera;
}

}  // namespace rakelight
