// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/ray_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engines/raytrace/scene/mark_geometry.h"

namespace rakelight::raytrace {
namespace {

/// A box about the disc or square, however it turns.
void find_bounds(const RTCBoundsFunctionArguments* args) {
    const RayPoints::Disc& disc = static_cast<const RayPoints::Disc*>(args->geometryUserPtr)[args->primID];
    const float slack = 1e-6f * (std::fabs(disc.place.x) + std::fabs(disc.place.y) + std::fabs(disc.place.z));
    const vec3 half = vec3{1, 1, 1} * (1.416f * disc.radius + slack), low = disc.place - half, high = disc.place + half;
    RTCBounds& out = *args->bounds_o;
    out.lower_x = low.x, out.lower_y = low.y, out.lower_z = low.z;
    out.upper_x = high.x, out.upper_y = high.y, out.upper_z = high.z;
}

}  // namespace

/// The data that Embree passes to meet().
struct RayPoints::Ray {
    RTCIntersectContext embree;  // first: Embree hands a pointer to it
    const RayPoints* points;
    dvec3 across;  ///< unit: discs stand across it
    const MarkQuery& query;

    static void meet(const RTCIntersectFunctionNArguments* args);
};

/// By the place where the ray hits the disc's plane; ray.tfar is where its paraboloid is, the hit's u the former.
void RayPoints::Ray::meet(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const Ray& asked = *reinterpret_cast<const Ray*>(args->context);
    auto& both = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    const Cloud& cloud = asked.points->clouds_[args->geomID];
    const MarkQuery& query = asked.query;
    if ((!query.with_blended && cloud.opacity < 1) || (cloud.run != no_index && cloud.run == query.left_out)) return;
    const Disc& disc = cloud.discs[args->primID];
    const dvec3 origin{both.ray.org_x, both.ray.org_y, both.ray.org_z},
        along{both.ray.dir_x, both.ray.dir_y, both.ray.dir_z};
    const dvec3 place = cast<double>(disc.place);
    const double radius = double(disc.radius), forward = dot(along, asked.across);
    const double t = dot(place - origin, asked.across) / forward;
    if (!(forward > 0 && t > double(query.from) && t < double(query.to))) return;
    const dvec3 beside = origin + along * t - place;
    const double square = dot(beside, beside);
    const double farthest =
        std::max(std::fabs(dot(beside, asked.points->right_)), std::fabs(dot(beside, asked.points->up_)));
    if (!(asked.points->are_squares_ ? farthest <= radius : square <= radius * radius)) return;
    const MarkPlace here{float(t + square / (radius * forward)), cloud.mark, args->primID};
    if (here.depth > both.ray.tfar || !query.is_before(query.after, here)) return;
    if (both.hit.geomID != RTC_INVALID_GEOMETRY_ID &&
        !query.is_before(here, {both.ray.tfar, asked.points->clouds_[both.hit.geomID].mark, both.hit.primID}))
        return;
    both.ray.tfar = here.depth;
    both.hit.u = float(t), both.hit.v = 0;
    both.hit.Ng_x = -both.ray.dir_x, both.hit.Ng_y = -both.ray.dir_y, both.hit.Ng_z = -both.ray.dir_z;
    both.hit.geomID = args->geomID, both.hit.primID = args->primID;
    both.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

RayPoints::RayPoints(const RayScene& rays, const std::vector<MarkedDraw>& marks, const shading::PictureCamera& view,
                     const RenderSettings& settings, Context& context)
    : rays_(rays),
      ahead_(-view.camera_to_world[2].xyz()),
      right_(view.camera_to_world[0].xyz()),
      up_(view.camera_to_world[1].xyz()),
      are_squares_(settings.points == PointShape::square) {
    std::uint64_t points = 0;
    for (const MarkedDraw& m : marks)
        if (!m.is_line) points += m.count();
    if (points == 0) return;
    charge_ = MemoryCharge(context.memory(), points * (sizeof(Disc) + tree_bytes), "rays");
    for (std::uint32_t i = 0; i < marks.size(); ++i)
        if (!marks[i].is_line && marks[i].count() > 0) add(i, marks[i], view, settings.point_size, context);
    build(context);
}

RayPoints::~RayPoints() {
    if (scene_) embree().ReleaseScene(scene_);
}

void RayPoints::add(std::uint32_t mark, const MarkedDraw& marked, const shading::PictureCamera& view, float size_px,
                    Context& context) {
    Cloud cloud{std::vector<Disc>(marked.count()), mark, marked.run, marked.color.w};
    const dmat4 to_eye = view.world_to_eye * marked.draw->to_world;
    const double half_px = double(size_px) / (view.scale_y * view.height);  // [m] at 1 m
    constexpr std::size_t per_task = 1 << 14;
    context.parallel_for((cloud.discs.size() + per_task - 1) / per_task, [&](std::size_t task) {
        const std::size_t end = std::min(cloud.discs.size(), (task + 1) * per_task);
        for (std::size_t i = task * per_task; i < end; ++i) {
            const dvec3 place = transform_point(to_eye, cast<double>(marked.mesh->positions[marked.vertex(i)]));
            Disc& disc = cloud.discs[i];
            disc = {cast<float>(place), float(half_px * mark_scale(view, place))};
            if (!is_in_reach(disc.place) || !is_in_reach({disc.radius, 0, 0})) disc = {{}, 0};
        }
    });
    for (const Disc& disc : cloud.discs) widest_ = std::max(widest_, disc.radius);
    clouds_.push_back(std::move(cloud));
}

void RayPoints::build(Context& context) {
    context.throw_if_cancelled();
    scene_ = embree().NewScene(rays_.device());
    embree().SetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t c = 0; c < clouds_.size(); ++c)
        attach_marks(rays_.device(), scene_, c, clouds_[c].discs, find_bounds, Ray::meet);
    rays_.commit(scene_, context);
}

MarkMeeting RayPoints::first(const MarkQuery& query) const {
    if (is_empty() || !is_in_reach(query.origin) || !is_in_reach(query.direction) || !(query.from >= 0)) return {};
    const dvec3 along = cast<double>(query.direction);
    Ray ray{{}, this, query.is_primary ? ahead_ : along * (1 / length(along)), query};
    rtcInitIntersectContext(&ray.embree);
    // Paraboloids are up to twice the radius behind their points, at the corners of squares.
    const double least = double(query.after.depth) - 2.001 * double(widest_) / dot(along, ray.across);
    const float from = std::max(query.from, float(0.999999 * least));
    RTCRayHit meeting{ray_of(query.origin, query.direction, from, std::numeric_limits<float>::infinity()), {}};
    meeting.hit.geomID = meeting.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree().Intersect1(scene_, &ray.embree, &meeting);
    if (meeting.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {{meeting.ray.tfar, clouds_[meeting.hit.geomID].mark, meeting.hit.primID}, meeting.hit.u, 0};
}

}  // namespace rakelight::raytrace
