// SPDX-License-Identifier: Apache-2.0
#include "gizmo.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>

#include "overlay.h"

namespace rakelight::viewer {
namespace {

constexpr double axis_px = 80, arrow_px = 110, square_px = 7, reach_px = 8;
constexpr double shortest_px = 14;      // an axis that is seen shorter points at the viewer
constexpr double most_parallel = 1e-4;  // 1 - cos^2 of the angle between an axis and the view
constexpr vec4 highlight{1, 1, 1, 1}, orange{1, 0.55f, 0.1f, 1};

dvec3 axis_of(Handle handle) {
    return handle == Handle::x ? dvec3{1, 0, 0} : handle == Handle::y ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
}

bool is_axis(Handle handle) { return handle == Handle::x || handle == Handle::y || handle == Handle::z; }

double meters_per_px(dvec3 place, const GizmoView& view) {
    const bool is_parallel = view.camera.projection == Projection::orthographic;
    const dmat4& m = view.camera.to_world;
    const double away = -dot(place - m[3].xyz(), m[2].xyz());
    const double half = is_parallel ? view.camera.half_height : away * std::tan(0.5 * view.camera.vertical_fov_rad);
    return 2 * half / view.height;
}

std::optional<dvec2> seen(dvec3 place, const GizmoView& view) {
    return pixel_of(place, view.camera, view.width, view.height);
}

/// The arrow's head turns on a ball about a pivot.
struct Arrow {
    dvec3 pivot, tail, tip;
    double radius = 0;
    bool points_outward = true;  ///< else at the pivot
};

std::optional<Arrow> arrow_of(const Light& light, const GizmoView& view) {
    const dvec3 along = normalize_or(light.direction, dvec3{0, 0, -1});
    if (light.type == LightType::directional) {
        const auto [tail, tip] = directional_arrow(light, view.bounds);
        const dvec3 center = view.bounds.center();
        return Arrow{center, tail, tip, length(tip - center), false};
    }
    if (light.type != LightType::spot) return {};
    const double radius = arrow_px * view.scale * meters_per_px(light.position, view);
    return Arrow{light.position, light.position, light.position + along * radius, radius, true};
}

bool has_place(const Light& light) { return light.type == LightType::point || light.type == LightType::spot; }

double distance_to_segment(dvec2 p, dvec2 a, dvec2 b) {
    const dvec2 ab{b.x - a.x, b.y - a.y}, ap{p.x - a.x, p.y - a.y};
    const double along = ab.x * ab.x + ab.y * ab.y;
    const double t = along > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / along, 0.0, 1.0) : 0;
    return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

/// How far along an axis through `place` the ray comes nearest to it [m]; none: behind the viewer, or both are parallel.
std::optional<double> along_axis(const Ray& ray, dvec3 place, dvec3 axis) {
    const dvec3 w = place - ray.origin;
    const double b = dot(axis, ray.direction), d = dot(axis, w), e = dot(ray.direction, w), rest = 1 - b * b;
    if (rest < most_parallel || e - b * d < 0) return {};
    return (b * e - d) / rest;
}

/// The point of a ball that a ray hits, on the side `is_far`; past the rim it continues over the other side.
dvec3 on_ball(const Ray& ray, dvec3 center, double radius, bool is_far) {
    const double middle = dot(center - ray.origin, ray.direction);
    const dvec3 nearest = ray.origin + ray.direction * middle;
    const double distance = length(nearest - center), side = is_far ? 1 : -1;
    if (distance < radius) return nearest + ray.direction * (side * std::sqrt(radius * radius - distance * distance));
    const double beyond_rad = std::min((distance - radius) / radius, pi / 2);
    const dvec3 out = (nearest - center) * (1 / distance);
    return center + (out * std::cos(beyond_rad) - ray.direction * (side * std::sin(beyond_rad))) * radius;
}

Light turned(const Light& start, dvec2 from, dvec2 to, const GizmoView& view) {
    const std::optional<Arrow> arrow = arrow_of(start, view);
    const std::optional<dvec2> tip = arrow ? seen(arrow->tip, view) : std::nullopt;
    if (!tip || !(arrow->radius > 0)) return start;
    const Ray ray = ray_of({tip->x + to.x - from.x, tip->y + to.y - from.y}, view);
    const bool is_far = dot(arrow->tip - arrow->pivot, ray.direction) > 0;
    const dvec3 out = on_ball(ray, arrow->pivot, arrow->radius, is_far) - arrow->pivot;
    Light light = start;
    light.direction = normalize_or(arrow->points_outward ? out : -out, start.direction);
    return light;
}

}  // namespace

Ray ray_of(dvec2 pixel, const GizmoView& view) {
    const Camera& camera = view.camera;
    const dmat4& m = camera.to_world;
    const dvec2 half = half_size_of(camera, view.width, view.height);
    const double x = (2 * pixel.x / view.width - 1) * half.x, y = (1 - 2 * pixel.y / view.height) * half.y;
    const dvec3 across = m[0].xyz() * x + m[1].xyz() * y, ahead = -m[2].xyz();
    if (camera.projection == Projection::orthographic) return {m[3].xyz() + across, ahead};
    return {m[3].xyz(), normalize_or(ahead + across, ahead)};
}

std::vector<Line> gizmo_lines(const Light& light, const GizmoView& view, Handle lit) {
    std::vector<Line> lines;
    const auto add = [&](dvec3 from, dvec3 to, vec4 color, Handle handle) {
        lines.push_back({from, to, handle == lit ? highlight : color, handle == lit ? 4.0f : 2.0f, true});
    };
    if (has_place(light)) {
        const double px = meters_per_px(light.position, view) * view.scale;
        if (!(px > 0)) return {};  // behind the viewer
        constexpr vec4 colors[] = {{0.95f, 0.3f, 0.3f, 1}, {0.35f, 0.85f, 0.35f, 1}, {0.4f, 0.55f, 1, 1}};
        for (const Handle handle : {Handle::x, Handle::y, Handle::z})
            add(light.position, light.position + axis_of(handle) * (axis_px * px),
                colors[std::size_t(handle) - std::size_t(Handle::x)], handle);
        const dvec3 right = view.camera.to_world[0].xyz() * (square_px * px),
                    up = view.camera.to_world[1].xyz() * (square_px * px);
        const dvec3 corners[] = {light.position + right + up, light.position - right + up, light.position - right - up,
                                 light.position + right - up};
        for (std::size_t i = 0; i < 4; ++i) add(corners[i], corners[(i + 1) % 4], orange, Handle::center);
    }
    if (const std::optional<Arrow> arrow = arrow_of(light, view)) {
        std::vector<Line> shaft;
        add_arrow(shaft, arrow->tail, arrow->tip, orange, 2.5f);
        for (const Line& line : shaft) add(line.from, line.to, line.color, Handle::tip);
    }
    return lines;
}

Handle handle_at(dvec2 pixel, const Light& light, const GizmoView& view) {
    const double reach = reach_px * view.scale;
    const auto is_near = [&](dvec3 place, double by) {
        const std::optional<dvec2> p = seen(place, view);
        return p && std::hypot(p->x - pixel.x, p->y - pixel.y) <= by;
    };
    if (const std::optional<Arrow> arrow = arrow_of(light, view)) {
        if (is_near(arrow->tip, 1.5 * reach)) return Handle::tip;
        const std::optional<dvec2> tail = seen(arrow->tail, view), tip = seen(arrow->tip, view);
        const bool is_all_one = light.type == LightType::directional;
        if (is_all_one && tail && tip && distance_to_segment(pixel, *tail, *tip) <= reach) return Handle::tip;
    }
    if (!has_place(light)) return Handle::none;
    if (is_near(light.position, (square_px + 3) * view.scale)) return Handle::center;
    const std::optional<dvec2> from = seen(light.position, view);
    const double px = meters_per_px(light.position, view) * view.scale;
    Handle best = Handle::none;
    double nearest = reach;
    for (const Handle handle : {Handle::x, Handle::y, Handle::z}) {
        const std::optional<dvec2> to = seen(light.position + axis_of(handle) * (axis_px * px), view);
        if (!from || !to || std::hypot(to->x - from->x, to->y - from->y) < shortest_px * view.scale) continue;
        const double distance = distance_to_segment(pixel, *from, *to);
        if (distance <= nearest) nearest = distance, best = handle;
    }
    return best;
}

Light dragged(const Light& start, Handle handle, dvec2 from, dvec2 to, const GizmoView& view) {
    if (handle == Handle::tip) return turned(start, from, to, view);
    Light light = start;
    if (handle == Handle::center) {
        const double px = meters_per_px(start.position, view);
        light.position += view.camera.to_world[0].xyz() * ((to.x - from.x) * px) -
                          view.camera.to_world[1].xyz() * ((to.y - from.y) * px);
    }
    if (is_axis(handle)) {
        const dvec3 axis = axis_of(handle);
        const std::optional<double> before = along_axis(ray_of(from, view), start.position, axis),
                                    after = along_axis(ray_of(to, view), start.position, axis);
        if (before && after) light.position += axis * (*after - *before);
    }
    return light;
}

}  // namespace rakelight::viewer
