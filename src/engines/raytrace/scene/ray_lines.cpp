// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/ray_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engines/raytrace/scene/mark_geometry.h"

namespace rakelight::raytrace {
namespace {

void find_bounds(const RTCBoundsFunctionArguments* args) {
    const RayLines::Segment& s = static_cast<const RayLines::Segment*>(args->geometryUserPtr)[args->primID];
    float low[3], high[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const float slack = 1e-6f * (std::fabs(s.a[c]) + std::fabs(s.b[c]));
        low[c] = std::min(s.a[c] - 1.001f * s.radius_a, s.b[c] - 1.001f * s.radius_b) - slack;
        high[c] = std::max(s.a[c] + 1.001f * s.radius_a, s.b[c] + 1.001f * s.radius_b) + slack;
    }
    RTCBounds& out = *args->bounds_o;
    out.lower_x = low[0], out.lower_y = low[1], out.lower_z = low[2];
    out.upper_x = high[0], out.upper_y = high[1], out.upper_z = high[2];
}

/// An end that is cut lies at `part` between the line's own ends.
struct End {
    dvec3 place;
    double part;
};

/// Keeps what lies on one side of a plane across the view axis: side * (distance - border) >= 0.
bool keep(End& a, End& b, dvec3 ahead, double border, double side) {
    const double at_a = side * (dot(a.place, ahead) - border), at_b = side * (dot(b.place, ahead) - border);
    if (!(at_a >= 0) && !(at_b >= 0)) return false;
    const auto move = [](End& end, double at_end, const End& inside, double at_inside) {
        const double part = at_inside / (at_inside - at_end);
        end = {inside.place + (end.place - inside.place) * part, inside.part + (end.part - inside.part) * part};
    };
    if (!(at_a >= 0)) move(a, at_a, b, at_b);
    if (!(at_b >= 0)) move(b, at_b, a, at_a);
    return true;
}

/// Where a line is nearest to a ray.
struct Near {
    double t, part;
};

}  // namespace

/// The data that Embree passes to meet().
struct RayLines::Ray {
    RTCIntersectContext embree;  // first: Embree hands a pointer to it
    const RayLines* lines;
    const MarkQuery& query;

    static void meet(const RTCIntersectFunctionNArguments* args);
    std::optional<Near> on_screen(const Segment& s, dvec3 origin, dvec3 along) const;
    static std::optional<Near> in_space(const Segment& s, dvec3 origin, dvec3 along);
};

/// Places are compared in the plane across the view axis at 1 m, or at the eye in parallel views: there the line is straight, and
/// as wide everywhere.
std::optional<Near> RayLines::Ray::on_screen(const Segment& s, dvec3 origin, dvec3 along) const {
    const shading::PictureCamera& view = lines->view_;
    const dvec3 ahead = lines->ahead_;
    End a{cast<double>(s.a), 0}, b{cast<double>(s.b), 1};
    if (!keep(a, b, ahead, view.z_near, 1) || !keep(a, b, ahead, view.z_far, -1)) return {};
    const double forward = dot(along, ahead), away_a = dot(a.place, ahead), away_b = dot(b.place, ahead);
    if (!(forward > 0)) return {};
    const auto shown = [&](dvec3 place, double away) {
        return view.orthographic ? place - ahead * away : place * (1 / away);
    };
    const dvec3 p = shown(a.place, away_a), pq = shown(b.place, away_b) - p,
                to_ray = (view.orthographic ? origin - ahead * dot(origin, ahead) : along * (1 / forward)) - p;
    const double square = dot(pq, pq), u = square > 0 ? std::clamp(dot(to_ray, pq) / square, 0.0, 1.0) : 0;
    const dvec3 beside = to_ray - pq * u;
    if (!(dot(beside, beside) <= lines->half_ * lines->half_)) return {};
    const double part = view.orthographic ? u : u * away_a / (away_b * (1 - u) + away_a * u);
    const double away = away_a + (away_b - away_a) * part;
    return Near{(away - dot(origin, ahead)) / forward, a.part + (b.part - a.part) * part};
}

/// The shortest way between ray and line.
std::optional<Near> RayLines::Ray::in_space(const Segment& s, dvec3 origin, dvec3 along) {
    const dvec3 a = cast<double>(s.a), ab = cast<double>(s.b) - a, to_a = a - origin;
    const double dd = dot(along, along), dl = dot(along, ab), ll = dot(ab, ab);
    const double across = dd * ll - dl * dl;
    const double u = across > 1e-12 * dd * ll ? (dl * dot(along, to_a) - dd * dot(ab, to_a)) / across : 0;
    const double part = std::clamp(u, 0.0, 1.0), t = dot(along, to_a + ab * part) / dd;
    const dvec3 beside = to_a + ab * part - along * t;
    const double radius = double(s.radius_a) + (double(s.radius_b) - double(s.radius_a)) * part;
    if (!(dot(beside, beside) <= radius * radius)) return {};
    return Near{t, part};
}

void RayLines::Ray::meet(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const Ray& asked = *reinterpret_cast<const Ray*>(args->context);
    auto& both = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    const Bundle& bundle = asked.lines->bundles_[args->geomID];
    const MarkQuery& query = asked.query;
    if ((!query.with_blended && bundle.opacity < 1) || (bundle.run != no_index && bundle.run == query.left_out)) return;
    const Segment& segment = bundle.segments[args->primID];
    const dvec3 origin{both.ray.org_x, both.ray.org_y, both.ray.org_z},
        along{both.ray.dir_x, both.ray.dir_y, both.ray.dir_z};
    const std::optional<Near> near =
        query.is_primary ? asked.on_screen(segment, origin, along) : in_space(segment, origin, along);
    if (!near || !(near->t > double(query.from))) return;
    const MarkPlace here{float(near->t), bundle.mark, args->primID};
    if (here.depth > both.ray.tfar || !query.is_before(query.after, here)) return;
    if (both.hit.geomID != RTC_INVALID_GEOMETRY_ID &&
        !query.is_before(here, {both.ray.tfar, asked.lines->bundles_[both.hit.geomID].mark, both.hit.primID}))
        return;
    both.ray.tfar = here.depth;
    both.hit.u = float(near->part), both.hit.v = 0;
    both.hit.Ng_x = -both.ray.dir_x, both.hit.Ng_y = -both.ray.dir_y, both.hit.Ng_z = -both.ray.dir_z;
    both.hit.geomID = args->geomID, both.hit.primID = args->primID;
    both.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

RayLines::RayLines(const RayScene& rays, const std::vector<MarkedDraw>& marks, const shading::PictureCamera& view,
                   float width_px, Context& context)
    : rays_(rays),
      view_(view),
      ahead_(-view.camera_to_world[2].xyz()),
      half_(double(std::max(width_px, 1.0f)) / (view.scale_y * view.height)),
      coverage_(std::min(width_px, 1.0f)) {
    std::uint64_t lines = 0;
    for (const MarkedDraw& m : marks)
        if (m.is_line) lines += m.count();
    if (lines == 0) return;
    charge_ = MemoryCharge(context.memory(), lines * (sizeof(Segment) + tree_bytes), "rays");
    for (std::uint32_t i = 0; i < marks.size(); ++i)
        if (marks[i].is_line && marks[i].count() > 0) add(i, marks[i], view, context);
    build(context);
}

RayLines::~RayLines() {
    if (scene_) embree().ReleaseScene(scene_);
}

void RayLines::add(std::uint32_t mark, const MarkedDraw& marked, const shading::PictureCamera& view, Context& context) {
    Bundle bundle{std::vector<Segment>(marked.count()), mark, marked.run, marked.color.w};
    const dmat4 to_eye = view.world_to_eye * marked.draw->to_world;
    constexpr std::size_t per_task = 1 << 14;
    context.parallel_for((bundle.segments.size() + per_task - 1) / per_task, [&](std::size_t task) {
        const std::size_t end = std::min(bundle.segments.size(), (task + 1) * per_task);
        for (std::size_t i = task * per_task; i < end; ++i) {
            const auto place = [&](std::size_t v) {
                return transform_point(to_eye, cast<double>(marked.mesh->positions[marked.vertex(v)]));
            };
            const dvec3 a = place(2 * i), b = place(2 * i + 1);
            Segment& s = bundle.segments[i];
            s = {cast<float>(a), cast<float>(b), float(half_ * mark_scale(view, a)),
                 float(half_ * mark_scale(view, b))};
            const bool is_sound = is_in_reach(s.a) && is_in_reach(s.b) && is_in_reach({s.radius_a, s.radius_b, 0});
            if (!is_sound) s = {{}, {}, 0, 0};
        }
    });
    bundles_.push_back(std::move(bundle));
}

void RayLines::build(Context& context) {
    context.throw_if_cancelled();
    scene_ = embree().NewScene(rays_.device());
    embree().SetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t b = 0; b < bundles_.size(); ++b)
        attach_marks(rays_.device(), scene_, b, bundles_[b].segments, find_bounds, Ray::meet);
    rays_.commit(scene_, context);
}

MarkMeeting RayLines::first(const MarkQuery& query) const {
    if (is_empty() || !is_in_reach(query.origin) || !is_in_reach(query.direction) || !(query.from >= 0)) return {};
    Ray ray{{}, this, query};
    rtcInitIntersectContext(&ray.embree);
    const float from = std::max(query.from, query.after.depth);
    RTCRayHit meeting{ray_of(query.origin, query.direction, from, query.to), {}};
    meeting.hit.geomID = meeting.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree().Intersect1(scene_, &ray.embree, &meeting);
    if (meeting.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const float t = meeting.ray.tfar;
    return {{t, bundles_[meeting.hit.geomID].mark, meeting.hit.primID}, t, meeting.hit.u};
}

}  // namespace rakelight::raytrace
