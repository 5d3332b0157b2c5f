// SPDX-License-Identifier: Apache-2.0
#include "prepare/shapes/primitives.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "math/functions.h"

namespace rakelight {
namespace {

constexpr const char* shape_names[] = {"sphere", "cylinder", "cone", "torus", "plane"};
constexpr double max_triangles = 4e6, largest_m = 1e6;
constexpr int max_divisions = 1024, max_objects = 1024;

constexpr std::size_t vertex_bytes = 2 * sizeof(vec3) + sizeof(vec2), index_bytes = sizeof(std::uint32_t);

struct Arrays {
    std::vector<vec3> positions, normals;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
    MemoryCharge charge;

    /// Reserves the exact sizes.
    void reserve(std::size_t vertices, std::size_t triangles, MemoryBudget* memory) {
        if (memory) charge = MemoryCharge(*memory, vertices * vertex_bytes + 3 * triangles * index_bytes, "a shape");
        positions.reserve(vertices), normals.reserve(vertices), texcoords.reserve(vertices);
        indices.reserve(3 * triangles);
    }
};

/// A profile point of a surface of revolution about +Y: distance from the axis, height, normal in the profile plane,
/// texture coordinate.
struct ProfilePoint {
    double rho, y, n_rho, n_y, v;
    bool is_pole() const { return rho == 0; }
};

enum class CapUv : std::uint8_t { around, top, bottom };

/// Revolves a profile from top to bottom, so that triangles are counter-clockwise from outside. A pole has one vertex
/// per column, with the direction of the column's middle, so no triangle is degenerate.
class Revolution {
public:
    explicit Revolution(int columns) : columns_(columns) {
        for (int i = 0; i <= 2 * columns;
             ++i) {  // even: columns, odd: their middles; the last is bit-identical to the first
            const double phi = pi * double(i % (2 * columns)) / columns - pi;
            directions_.push_back(i % (2 * columns) == 0 ? dvec2{0, -1} : dvec2{math::sin(phi), math::cos(phi)});
        }
    }

    void add(std::span<const ProfilePoint> profile, CapUv uv, Arrays& out) const {
        std::vector<std::uint32_t> first;
        for (const ProfilePoint& p : profile) {
            first.push_back(std::uint32_t(out.positions.size()));
            for (int c = 0; c < columns_ + (p.is_pole() ? 0 : 1); ++c)
                add_vertex(p, 2 * c + (p.is_pole() ? 1 : 0), uv, out);
        }
        for (std::size_t row = 0; row + 1 < profile.size(); ++row)
            for (std::uint32_t c = 0; c < std::uint32_t(columns_); ++c) {
                const std::uint32_t a = first[row] + c, b = first[row + 1] + c;
                if (!profile[row + 1].is_pole()) out.indices.insert(out.indices.end(), {a, b, b + 1});
                if (!profile[row].is_pole()) {
                    const std::uint32_t corner = profile[row + 1].is_pole() ? b : b + 1;
                    out.indices.insert(out.indices.end(), {a, corner, a + 1});
                }
            }
    }

private:
    void add_vertex(const ProfilePoint& p, int half_column, CapUv uv, Arrays& out) const {
        const dvec2 at = directions_[std::size_t(half_column)];
        out.positions.push_back({float(p.rho * at.x), float(p.y), float(p.rho * at.y)});
        out.normals.push_back({float(p.n_rho * at.x), float(p.n_y), float(p.n_rho * at.y)});
        if (uv == CapUv::around)
            out.texcoords.push_back({float(double(half_column) / (2 * columns_)), float(p.v)});
        else  // v: distance from the center, 0..1
            out.texcoords.push_back(
                {float(0.5 + 0.5 * p.v * at.x), float(0.5 + (uv == CapUv::top ? 0.5 : -0.5) * p.v * at.y)});
    }

    int columns_;
    std::vector<dvec2> directions_;
};

/// Number of segments of a full circle for a chord error of at most `tolerance`: r (1 - cos(pi / n)) <= tolerance.
double pieces_of_circle(double radius, double tolerance) {
    const double half_angle = math::acos(1 - std::min(tolerance / radius, 0.5));
    return std::max(std::ceil(pi / half_angle), 3.0);
}

void check_count(double triangles) {
    if (!(triangles <= max_triangles))
        throw Error(ErrorCode::usage, "the tolerance asks for more than 4 million triangles", {}, "say a larger one");
}

void add_sphere(double radius, double tolerance, MemoryBudget* memory, Arrays& out) {
    // errors of both directions add up: half of the tolerance each
    const double columns = pieces_of_circle(radius, tolerance / 2), rows = std::max(std::ceil(columns / 2), 2.0);
    check_count(2 * columns * rows);
    const auto n = std::size_t(columns), m = std::size_t(rows);
    out.reserve((m - 1) * (n + 1) + 2 * n, 2 * n * (m - 1), memory);
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= int(rows); ++i) {
        const bool is_pole = i == 0 || i == int(rows);
        const double theta = pi * i / rows, s = is_pole ? 0 : math::sin(theta),
                     c = is_pole ? (i == 0 ? 1 : -1) : math::cos(theta);
        profile.push_back({radius * s, radius * c, s, c, i / rows});
    }
    Revolution(int(columns)).add(profile, CapUv::around, out);
}

void add_torus(double radius, double tube, double tolerance, MemoryBudget* memory, Arrays& out) {
    const double columns = pieces_of_circle(radius + tube, tolerance / 2), rows = pieces_of_circle(tube, tolerance / 2);
    check_count(2 * columns * rows);
    const auto n = std::size_t(columns), m = std::size_t(rows);
    out.reserve((m + 1) * (n + 1), 2 * n * m, memory);
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= int(rows); ++i) {
        const int at = i % int(rows);
        const double psi = 2 * pi * at / rows, c = at == 0 ? 1 : math::cos(psi), s = at == 0 ? 0 : math::sin(psi);
        profile.push_back({radius - tube * c, tube * s, -c, s, i / rows});
    }
    Revolution(int(columns)).add(profile, CapUv::around, out);
}

void add_cylinder(double radius, double height, double tolerance, MemoryBudget* memory, Arrays& out) {
    const double columns = pieces_of_circle(radius, tolerance), top = height / 2;
    check_count(4 * columns);
    out.reserve(6 * std::size_t(columns) + 4, 4 * std::size_t(columns), memory);
    const Revolution turn{int(columns)};
    const ProfilePoint cap[] = {{0, top, 0, 1, 0}, {radius, top, 0, 1, 1}};
    const ProfilePoint side[] = {{radius, top, 1, 0, 0}, {radius, -top, 1, 0, 1}};
    const ProfilePoint base[] = {{radius, -top, 0, -1, 1}, {0, -top, 0, -1, 0}};
    turn.add(cap, CapUv::top, out);
    turn.add(side, CapUv::around, out);
    turn.add(base, CapUv::bottom, out);
}

void add_cone(double radius, double height, double tolerance, MemoryBudget* memory, Arrays& out) {
    const double columns = pieces_of_circle(radius, tolerance), top = height / 2;
    check_count(2 * columns);
    out.reserve(4 * std::size_t(columns) + 2, 2 * std::size_t(columns), memory);
    const double slant = std::sqrt(radius * radius + height * height), n_rho = height / slant, n_y = radius / slant;
    const Revolution turn{int(columns)};
    const ProfilePoint side[] = {{0, top, n_rho, n_y, 0}, {radius, -top, n_rho, n_y, 1}};
    const ProfilePoint base[] = {{radius, -top, 0, -1, 1}, {0, -top, 0, -1, 0}};
    turn.add(side, CapUv::around, out);
    turn.add(base, CapUv::bottom, out);
}

void add_plane(double width, double depth, int divisions, MemoryBudget* memory, Arrays& out) {
    const auto n = std::size_t(divisions);
    out.reserve((n + 1) * (n + 1), 2 * n * n, memory);
    for (int row = 0; row <= divisions; ++row)
        for (int column = 0; column <= divisions; ++column) {
            const double u = double(column) / divisions, v = double(row) / divisions;
            out.positions.push_back({float(width * (u - 0.5)), 0, float(depth * (v - 0.5))});
            out.normals.push_back({0, 1, 0});
            out.texcoords.push_back({float(u), float(v)});
        }
    const auto at = [&](int row, int column) { return std::uint32_t(row * (divisions + 1) + column); };
    for (int r = 0; r < divisions; ++r)
        for (int c = 0; c < divisions; ++c)
            out.indices.insert(out.indices.end(),
                               {at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c), at(r + 1, c + 1), at(r, c + 1)});
}

void check_length(double length, const char* what) {
    if (!(length > 0 && length <= largest_m))
        throw Error(ErrorCode::usage, std::string(what) + " must be more than 0 and at most 1e6 m");
}

Arrays arrays_of(const PrimitiveRequest& r, MemoryBudget* memory) {
    const bool is_plane = r.shape == PrimitiveShape::plane, is_torus = r.shape == PrimitiveShape::torus;
    const bool is_high = r.shape == PrimitiveShape::cylinder || r.shape == PrimitiveShape::cone;
    if (!is_plane) check_length(r.radius, "the radius");
    if (is_torus) check_length(r.tube_radius, "the radius of the tube");
    if (is_torus && r.tube_radius > r.radius)
        throw Error(ErrorCode::usage, "the radius of the torus's tube must be at most that of the torus");
    if (is_high) check_length(r.height, "the height");
    if (is_plane) check_length(r.width, "the width"), check_length(r.depth, "the depth");
    if (r.tolerance != 0) check_length(r.tolerance, "the tolerance");
    if (is_plane && (r.divisions < 1 || r.divisions > max_divisions))
        throw Error(ErrorCode::usage, "the divisions of a plane must be 1 to 1024");
    const double largest = r.radius + (is_torus ? r.tube_radius : 0);
    const double tolerance = r.tolerance != 0 ? r.tolerance : largest / 1000;
    Arrays out;
    switch (r.shape) {
        case PrimitiveShape::sphere:
            add_sphere(r.radius, tolerance, memory, out);
            break;
        case PrimitiveShape::cylinder:
            add_cylinder(r.radius, r.height, tolerance, memory, out);
            break;
        case PrimitiveShape::cone:
            add_cone(r.radius, r.height, tolerance, memory, out);
            break;
        case PrimitiveShape::torus:
            add_torus(r.radius, r.tube_radius, tolerance, memory, out);
            break;
        case PrimitiveShape::plane:
            add_plane(r.width, r.depth, r.divisions, memory, out);
            break;
    }
    return out;
}

/// Triangles first..last-1 with the vertices that they use, in the order of their first use.
/// @param number  [all vertices] that are `no_index`, before and after
Arrays part_of(const Arrays& all, std::size_t first, std::size_t last, std::vector<std::uint32_t>& number,
               MemoryBudget* memory) {
    std::vector<std::uint32_t> used;
    for (std::size_t i = 3 * first; i < 3 * last; ++i)
        if (std::uint32_t& n = number[all.indices[i]]; n == no_index) {
            n = std::uint32_t(used.size());
            used.push_back(all.indices[i]);
        }
    Arrays out;
    out.reserve(used.size(), last - first, memory);
    for (std::size_t i = 3 * first; i < 3 * last; ++i) out.indices.push_back(number[all.indices[i]]);
    for (const std::uint32_t v : used) {
        out.positions.push_back(all.positions[v]);
        out.normals.push_back(all.normals[v]);
        out.texcoords.push_back(all.texcoords[v]);
        number[v] = no_index;
    }
    return out;
}

void add_object(std::string name, Arrays arrays, Scene& scene) {
    Mesh mesh;
    mesh.name = name;
    const auto block = [&](auto&& array) {
        MemoryCharge charge = arrays.charge.split(array.size() * sizeof(array[0]));
        return Block(std::move(array), std::move(charge));
    };
    mesh.positions = block(std::move(arrays.positions));
    mesh.normals = block(std::move(arrays.normals));
    mesh.texcoords.push_back(block(std::move(arrays.texcoords)));
    mesh.indices = block(std::move(arrays.indices));
    mesh.material = 0;
    Node node;
    node.name = std::move(name);
    node.meshes = {std::uint32_t(scene.meshes.size())};
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(std::move(node));
}

Material gray(const char* name) {
    Material m;
    m.name = name;
    m.base_color = {0.6f, 0.6f, 0.6f, 1};
    m.metallic_roughness.metallic = 0;
    m.metallic_roughness.roughness = 0.4f;
    return m;
}

ExactShape exact_shape(const PrimitiveRequest& r) {
    static_assert(int(PrimitiveShape::plane) == int(ExactShape::Kind::plane));
    return {ExactShape::Kind(r.shape), r.radius, r.tube_radius, r.height, r.width, r.depth};
}

}  // namespace

std::optional<PrimitiveShape> primitive_named(std::string_view name) {
    for (std::size_t i = 0; i < std::size(shape_names); ++i)
        if (name == shape_names[i]) return PrimitiveShape(i);
    return {};
}

const char* name_of(PrimitiveShape shape) { return shape_names[std::size_t(shape)]; }

Scene make_primitive(const PrimitiveRequest& request, MemoryBudget* memory) {
    const std::string name = name_of(request.shape);
    Arrays all = arrays_of(request, memory);
    const std::size_t triangles = all.indices.size() / 3, objects = std::size_t(std::max(request.objects, 0));
    if (objects < 1 || objects > max_objects || objects > triangles)
        throw Error(ErrorCode::usage,
                    "the objects of a " + name + " must be 1 to 1024, and no more than its triangles");
    Scene scene;
    scene.source = "builtin:" + name;
    scene.materials.push_back(gray(name.c_str()));
    scene.materials[0].double_sided = request.shape == PrimitiveShape::plane;
    if (objects == 1) {
        add_object(name, std::move(all), scene);
        scene.meshes[0].shape = exact_shape(request);
        return scene;
    }
    std::vector<std::uint32_t> number(all.positions.size(), no_index);
    for (std::size_t i = 0; i < objects; ++i)
        add_object(format_text("{} {}", name, i + 1),
                   part_of(all, triangles * i / objects, triangles * (i + 1) / objects, number, memory), scene);
    return scene;
}

}  // namespace rakelight
