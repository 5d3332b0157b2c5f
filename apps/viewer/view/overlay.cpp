// SPDX-License-Identifier: Apache-2.0
#include "overlay.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>

namespace rakelight::viewer {
namespace {

constexpr vec4 yellow{1, 0.9f, 0.3f, 1}, orange{1, 0.55f, 0.1f, 1};

double size_of(const Bounds& bounds) {
    const double d = bounds.empty() ? 1 : bounds.diagonal();
    return d > 0 && std::isfinite(d) ? d : 1;
}

/// Two directions perpendicular to a unit one.
void make_frame(dvec3 n, dvec3& a, dvec3& b) {
    a = normalize_or(cross(n, std::fabs(n.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0}), dvec3{1, 0, 0});
    b = cross(n, a);
}

/// 1, 2 or 5 times a power of ten.
double round_step(double about) {
    const double power = std::pow(10, std::floor(std::log10(about))), times = about / power;
    return power * (times < 1.5 ? 1 : times < 3.5 ? 2 : times < 7.5 ? 5 : 10);
}

void add_star(std::vector<Line>& to, dvec3 at, double r, vec4 color, float width) {
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along{};
        along[std::size_t(axis)] = r;
        to.push_back({at - along, at + along, color, width, true});
    }
    for (int i = 0; i < 4; ++i) {
        const dvec3 diagonal = dvec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 1.0} * (0.45 * r);
        to.push_back({at - diagonal, at + diagonal, color, width, true});
    }
}

void add_cone(std::vector<Line>& to, dvec3 at, dvec3 along, double half_rad, double length, vec4 color, float width) {
    dvec3 a, b;
    make_frame(along, a, b);
    constexpr int count = 16;
    const double r = std::tan(std::min(half_rad, 1.4)) * length;
    const auto rim = [&](int i) {
        const double t = 2 * pi * i / count;
        return at + along * length + a * (r * std::cos(t)) + b * (r * std::sin(t));
    };
    for (int i = 0; i < count; ++i) {
        to.push_back({rim(i), rim(i + 1), color, width, true});
        if (i % 4 == 0) to.push_back({at, rim(i), color, width, true});
    }
}

dvec3 vector_of(const Mesh& mesh, std::size_t v, VertexVector which, const dmat4& m) {
    const dvec3 n = cast<double>(mesh.normals[v]);
    const dmat3 around = cofactor(upper_left(m));
    const dvec3 normal = around * n * (determinant(upper_left(m)) < 0 ? -1.0 : 1.0);
    if (which == VertexVector::normal) return normalize_or(normal, dvec3{});
    const vec4 t = mesh.tangents[v];
    const dvec3 tangent = transform_direction(m, dvec3{t.x, t.y, t.z});
    if (which == VertexVector::tangent) return normalize_or(tangent, dvec3{});
    const double side = double(t.w) * (determinant(upper_left(m)) < 0 ? -1.0 : 1.0);
    return normalize_or(cross(normal, tangent) * side, dvec3{});
}

}  // namespace

std::vector<Line> grid_lines(const Bounds& bounds, dvec3 world_up) {
    const double size = size_of(bounds), step = round_step(size / 10);
    const dvec3 c = bounds.center();
    std::vector<Line> lines;
    dvec3 a, b;
    make_frame(world_up, a, b);
    const dvec3 lowest = min(bounds.low, bounds.high);
    const double ground = dot(lowest, world_up);
    const auto snapped = [step](double x) { return std::round(x / step) * step; };
    const dvec3 at = a * snapped(dot(c, a)) + b * snapped(dot(c, b)) + world_up * ground;
    constexpr int half = 10;
    for (int i = -half; i <= half; ++i) {
        const vec4 color{0.03f, 0.03f, 0.03f, i == 0 ? 0.7f : 0.35f};
        for (int j = -half; j < half; ++j) {  // cell by cell, since lines are hidden by whether their ends are
            lines.push_back(
                {at + a * (i * step) + b * (j * step), at + a * (i * step) + b * ((j + 1) * step), color, 1});
            lines.push_back(
                {at + b * (i * step) + a * (j * step), at + b * (i * step) + a * ((j + 1) * step), color, 1});
        }
    }
    return lines;
}

void add_arrow(std::vector<Line>& to, dvec3 tail, dvec3 tip, vec4 color, float width) {
    const double length = rakelight::length(tip - tail);
    const dvec3 along = normalize_or(tip - tail, dvec3{0, 0, -1});
    dvec3 a, b;
    make_frame(along, a, b);
    to.push_back({tail, tip, color, width, true});
    for (const dvec3 side : {a, -a, b, -b})
        to.push_back({tip, tip - along * (0.25 * length) + side * (0.1 * length), color, width, true});
}

std::pair<dvec3, dvec3> directional_arrow(const Light& light, const Bounds& bounds) {
    const dvec3 along = normalize_or(light.direction, dvec3{0, 0, -1});
    return {bounds.center() - along * (0.5 * size_of(bounds)), bounds.center() - along * (0.3 * size_of(bounds))};
}

std::optional<dvec3> place_of(const Light& light, const Bounds& bounds) {
    if (light.type == LightType::ambient) return {};
    if (light.type != LightType::directional) return light.position;
    return bounds.center() - normalize_or(light.direction, dvec3{0, 0, -1}) * (0.4 * size_of(bounds));
}

std::vector<Line> axis_lines(const Bounds& bounds) {
    const double length = 0.6 * size_of(bounds);
    return {{{0, 0, 0}, {length, 0, 0}, {0.95f, 0.3f, 0.3f, 1}, 2, true},
            {{0, 0, 0}, {0, length, 0}, {0.35f, 0.85f, 0.35f, 1}, 2, true},
            {{0, 0, 0}, {0, 0, length}, {0.4f, 0.55f, 1, 1}, 2, true}};
}

std::vector<Line> light_lines(std::span<const LightItem> lights, const Bounds& bounds, std::size_t selected) {
    std::vector<Line> lines;
    const double size = size_of(bounds);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i].light;
        vec4 color = i == selected ? orange : yellow;
        if (!lights[i].is_on) color.w = 0.3f;
        const float width = i == selected ? 2.5f : 1.5f;
        const dvec3 along = normalize_or(light.direction, dvec3{0, 0, -1});
        if (light.type == LightType::directional) {
            const auto [tail, tip] = directional_arrow(light, bounds);
            add_arrow(lines, tail, tip, color, width);
        }
        if (light.type == LightType::point || light.type == LightType::spot)
            add_star(lines, light.position, 0.03 * size, color, width);
        const bool is_classical = light.units == LightUnits::classical;
        if (light.type == LightType::spot)
            add_cone(lines, light.position, along, double(is_classical ? light.cutoff_rad : light.outer_cone_rad),
                     0.15 * size, color, width);
    }
    return lines;
}

std::vector<Line> vertex_lines(const Scene& prepared, VertexVector which, const Bounds& bounds, std::size_t most) {
    const std::vector<dmat4> world = node_matrices(prepared);
    const auto has = [&](const Mesh& mesh) {
        return mesh.topology == Topology::triangles && mesh.normals.size() == mesh.positions.size() &&
               (which == VertexVector::normal || mesh.tangents.size() == mesh.positions.size());
    };
    std::size_t count = 0;
    for (const Node& node : prepared.nodes)
        for (const std::uint32_t m : node.meshes)
            if (has(prepared.meshes[m])) count += prepared.meshes[m].positions.size();
    const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
    const double length = 0.02 * size_of(bounds);
    constexpr vec4 colors[] = {{0.3f, 0.7f, 1, 1}, {1, 0.4f, 0.3f, 1}, {0.4f, 0.9f, 0.4f, 1}};
    std::vector<Line> lines;
    std::size_t next = 0, number = 0;
    for (std::size_t n = 0; n < prepared.nodes.size(); ++n)
        for (const std::uint32_t m : prepared.nodes[n].meshes) {
            const Mesh& mesh = prepared.meshes[m];
            if (!has(mesh)) continue;
            for (; next < number + mesh.positions.size(); next += step) {
                const std::size_t v = next - number;
                const dvec3 at = position_in_world(world[n], mesh, v);
                lines.push_back(
                    {at, at + vector_of(mesh, v, which, world[n]) * length, colors[std::size_t(which)], 1.2f});
            }
            number += mesh.positions.size();
        }
    return lines;
}

PrepareOptions seam_options(const Scene& scene, PrepareOptions of_picture) {
    const bool is_as_file =
        std::ranges::all_of(scene.meshes, [](const Mesh& mesh) { return mesh.normals.empty() && !mesh.normal_choice; });
    // If a file has no normals, inspect() shows those that each object would have alone; here those of the picture
    // count.
    if (of_picture.normals == NormalSource::automatic && is_as_file)
        of_picture.normals = scene.missing_normals_are_flat ? NormalSource::flat : NormalSource::model;
    return of_picture;
}

Seams worst_seams(std::vector<SeamLine> all, std::size_t most) {
    const auto angle = [](const SeamLine& s) { return std::max(s.deg_a, s.deg_b); };
    Seams seams{.count = all.size()};
    for (const SeamLine& s : all) seams.worst_deg = std::max(seams.worst_deg, double(angle(s)));
    if (all.size() > most) {
        std::ranges::nth_element(all, all.begin() + std::ptrdiff_t(most), std::greater<>(), angle);
        all.resize(most);
        all.shrink_to_fit();
    }
    seams.drawn = std::move(all);
    return seams;
}

std::vector<Line> seam_lines(std::span<const SeamLine> seams) {
    std::vector<Line> lines;
    const auto shown = [](float linear) {
        return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
    };
    for (const SeamLine& seam : seams) {
        const vec3 c = heat_color(double(std::max(seam.deg_a, seam.deg_b)));
        lines.push_back({seam.a, seam.b, {shown(c.x), shown(c.y), shown(c.z), 1}, 4});
    }
    return lines;
}

dvec2 half_size_of(const Camera& camera, int width, int height) {
    const bool is_parallel = camera.projection == Projection::orthographic;
    const double half_height = is_parallel ? camera.half_height : std::tan(0.5 * camera.vertical_fov_rad);
    const double half_width = is_parallel                 ? camera.half_width.value_or(half_height * width / height)
                              : camera.horizontal_fov_rad ? std::tan(0.5 * *camera.horizontal_fov_rad)
                                                          : half_height * width / height;
    return {half_width, half_height};
}

std::optional<dvec2> pixel_of(dvec3 place, const Camera& camera, int width, int height) {
    const bool is_parallel = camera.projection == Projection::orthographic;
    const auto [half_width, half_height] = half_size_of(camera, width, height);
    const dvec3 p = place - camera.to_world[3].xyz();
    const double away = -dot(p, camera.to_world[2].xyz()), by = is_parallel ? 1 : away;
    if (!(away > 0)) return {};
    const double x = dot(p, camera.to_world[0].xyz()) / (by * half_width),
                 y = dot(p, camera.to_world[1].xyz()) / (by * half_height);
    return dvec2{(0.5 * x + 0.5) * width, (0.5 - 0.5 * y) * height};
}

std::vector<Line> visible_lines(std::span<const Line> lines, const Camera& camera, std::span<const float> depth,
                                int width, int height, double slack) {
    std::vector<Line> out;
    if (depth.size() != std::size_t(width) * std::size_t(height)) return {lines.begin(), lines.end()};
    const auto is_seen = [&](dvec3 world) {
        const std::optional<dvec2> p = pixel_of(world, camera, width, height);
        if (!p) return false;
        if (!(p->x >= 0 && p->y >= 0 && p->x < width && p->y < height)) return true;
        const double away = -dot(world - camera.to_world[3].xyz(), camera.to_world[2].xyz());
        return away <= double(depth[std::size_t(p->y) * std::size_t(width) + std::size_t(p->x)]) + slack;
    };
    for (const Line& line : lines)
        if (line.is_overlay || is_seen(line.from) || is_seen(line.to)) out.push_back(line);
    return out;
}

}  // namespace rakelight::viewer
