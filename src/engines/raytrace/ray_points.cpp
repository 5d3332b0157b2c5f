// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/ray_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/linear.h"
#include "shading/mark_color.h"

namespace rakelight::raytrace {
namespace {

constexpr float most = 1e18f;  ///< coordinates that Embree is given

bool is_in_reach(vec3 v) { return std::fabs(v.x) < most && std::fabs(v.y) < most && std::fabs(v.z) < most; }

/// A box about the disc, however it turns.
void find_bounds(const RTCBoundsFunctionArguments* args) {
    const RayPoints::Disc& disc = static_cast<const RayPoints::Disc*>(args->geometryUserPtr)[args->primID];
    const float slack = 1e-6f * (std::fabs(disc.place.x) + std::fabs(disc.place.y) + std::fabs(disc.place.z));
    const vec3 half = vec3{1, 1, 1} * (1.001f * disc.radius + slack), low = disc.place - half, high = disc.place + half;
    RTCBounds& out = *args->bounds_o;
    out.lower_x = low.x, out.lower_y = low.y, out.lower_z = low.z;
    out.upper_x = high.x, out.upper_y = high.y, out.upper_z = high.z;
}

}  // namespace

/// The data that Embree passes to meet().
struct RayPoints::Ray {
    RTCIntersectContext embree;  // first: Embree hands a pointer to it
    const std::vector<Cloud>* clouds;
    dvec3 across;  ///< unit: discs stand across it
    float to;
    bool with_blended;

    static void meet(const RTCIntersectFunctionNArguments* args);
};

/// By the place where the ray hits the disc's plane; ray.tfar is where its paraboloid is, the hit's u the former.
void RayPoints::Ray::meet(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const Ray& asked = *reinterpret_cast<const Ray*>(args->context);
    auto& both = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    const Cloud& cloud = (*asked.clouds)[args->geomID];
    if (!asked.with_blended && cloud.color.w < 1) return;
    const Disc& disc = cloud.discs[args->primID];
    const dvec3 origin{both.ray.org_x, both.ray.org_y, both.ray.org_z},
        along{both.ray.dir_x, both.ray.dir_y, both.ray.dir_z};
    const dvec3 place = cast<double>(disc.place);
    const double radius = double(disc.radius), forward = dot(along, asked.across);
    const double t = dot(place - origin, asked.across) / forward;
    if (!(forward > 0 && t > double(both.ray.tnear) && t < double(asked.to))) return;
    const dvec3 beside = origin + along * t - place;
    const double square = dot(beside, beside);
    if (!(square <= radius * radius)) return;
    const auto order = float(t + square / (radius * forward));
    const bool is_first = both.hit.geomID == RTC_INVALID_GEOMETRY_ID ||
                          std::pair(args->geomID, args->primID) < std::pair(both.hit.geomID, both.hit.primID);
    if (order > both.ray.tfar || (order == both.ray.tfar && !is_first)) return;
    both.ray.tfar = order;
    both.hit.u = float(t), both.hit.v = 0;
    both.hit.Ng_x = -both.ray.dir_x, both.hit.Ng_y = -both.ray.dir_y, both.hit.Ng_z = -both.ray.dir_z;
    both.hit.geomID = args->geomID, both.hit.primID = args->primID;
    both.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

RayPoints::RayPoints(const RayScene& rays, const shading::DrawList& list, const shading::PictureCamera& view,
                     float size_px, Context& context)
    : rays_(rays), list_(list), ahead_(-view.camera_to_world[2].xyz()) {
    std::uint64_t points = 0;
    for (const shading::Draw& draw : list.line_draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        if (mesh.topology == Topology::points) points += mesh.indices.size();
    }
    if (points == 0) return;
    charge_ = MemoryCharge(context.memory(), points * (sizeof(Disc) + tree_bytes), "rays");
    for (std::uint32_t d = 0; d < list.line_draws.size(); ++d) add(d, view, size_px, context);
    build(context);
}

RayPoints::~RayPoints() {
    if (scene_) embree().ReleaseScene(scene_);
}

void RayPoints::add(std::uint32_t number, const shading::PictureCamera& view, float size_px, Context& context) {
    const shading::Draw& draw = list_.line_draws[number];
    const Mesh& mesh = list_.scene.meshes[draw.mesh];
    if (mesh.topology != Topology::points || mesh.indices.empty()) return;
    Cloud cloud{{}, shading::mark_color(list_.materials[draw.material]), number};
    cloud.discs.resize(mesh.indices.size());
    const dmat4 to_eye = view.world_to_eye * draw.to_world;
    const double half_px = double(size_px) / (view.scale_y * view.height);  // [m] at 1 m
    constexpr std::size_t per_task = 1 << 14;
    context.parallel_for((cloud.discs.size() + per_task - 1) / per_task, [&](std::size_t task) {
        const std::size_t end = std::min(cloud.discs.size(), (task + 1) * per_task);
        for (std::size_t i = task * per_task; i < end; ++i) {
            const dvec3 place = transform_point(to_eye, cast<double>(mesh.positions[mesh.indices[i]]));
            const double away = dot(place, ahead_);
            const double scale = view.orthographic    ? 1
                                 : away > view.z_near ? away
                                                      : length(place);  // mirrors show what is behind the eye
            cloud.discs[i] = {cast<float>(place), float(half_px * scale)};
            if (!is_in_reach(cloud.discs[i].place) || !(cloud.discs[i].radius < most)) cloud.discs[i] = {{}, 0};
        }
    });
    clouds_.push_back(std::move(cloud));
}

void RayPoints::build(Context& context) {
    context.throw_if_cancelled();
    scene_ = embree().NewScene(rays_.device());
    embree().SetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t c = 0; c < clouds_.size(); ++c) {
        RTCGeometry geometry = embree().NewGeometry(rays_.device(), RTC_GEOMETRY_TYPE_USER);
        embree().SetGeometryUserPrimitiveCount(geometry, unsigned(clouds_[c].discs.size()));
        embree().SetGeometryUserData(geometry, clouds_[c].discs.data());
        embree().SetGeometryBoundsFunction(geometry, find_bounds, nullptr);
        embree().SetGeometryIntersectFunction(geometry, Ray::meet);
        embree().CommitGeometry(geometry);
        embree().AttachGeometryByID(scene_, geometry, c);
        embree().ReleaseGeometry(geometry);
    }
    rays_.commit(scene_, context);
}

RayPoints::Meeting RayPoints::first(vec3 origin, vec3 direction, float from, float to, bool is_primary,
                                    bool with_blended) const {
    if (!is_in_reach(origin) || !is_in_reach(direction) || !(from >= 0)) return {};
    const dvec3 along = cast<double>(direction);
    Ray ray{{}, &clouds_, is_primary ? ahead_ : along * (1 / length(along)), to, with_blended};
    rtcInitIntersectContext(&ray.embree);
    RTCRayHit meeting{ray_of(origin, direction, from, std::numeric_limits<float>::infinity()), {}};
    meeting.hit.geomID = meeting.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree().Intersect1(scene_, &ray.embree, &meeting);
    if (meeting.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {clouds_[meeting.hit.geomID].draw, meeting.hit.primID, meeting.hit.u};
}

vec4 RayPoints::color(std::uint32_t draw, std::uint32_t point) const {
    const shading::Draw& of = list_.line_draws[draw];
    const Mesh& mesh = list_.scene.meshes[of.mesh];
    vec4 color = shading::mark_color(list_.materials[of.material]);
    if (!mesh.colors.empty()) {
        const vec4 own = mesh.colors[mesh.indices[point]];
        color = {color.x * own.x, color.y * own.y, color.z * own.z, color.w};
    }
    return {color.x, color.y, color.z, std::clamp(color.w, 0.0f, 1.0f)};
}

}  // namespace rakelight::raytrace
