// SPDX-License-Identifier: Apache-2.0
#include "io/vertex_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <rakelight/base/report.h>
#include <rakelight_internal/base/text.h>

#include "io/position_origin.h"
#include "io/stray_vertices.h"
#include "math/linear.h"

namespace rakelight::io {
namespace {

constexpr std::size_t rows_per_task = 1 << 16;

enum class Role : std::uint8_t { position, normal, texcoord, packed, harmonics };
struct KnownName {
    std::string_view name;
    Role role;
    std::size_t component;
};
constexpr KnownName known_names[] = {
    {"x", Role::position, 0},         {"y", Role::position, 1},         {"z", Role::position, 2},
    {"nx", Role::normal, 0},          {"ny", Role::normal, 1},          {"nz", Role::normal, 2},
    {"normal_x", Role::normal, 0},    {"normal_y", Role::normal, 1},    {"normal_z", Role::normal, 2},
    {"rgb", Role::packed, 0},         {"rgba", Role::packed, 1},        {"f_dc_0", Role::harmonics, 0},
    {"f_dc_1", Role::harmonics, 1},   {"f_dc_2", Role::harmonics, 2},   {"s", Role::texcoord, 0},
    {"t", Role::texcoord, 1},         {"u", Role::texcoord, 0},         {"v", Role::texcoord, 1},
    {"texture_u", Role::texcoord, 0}, {"texture_v", Role::texcoord, 1}, {"texture_s", Role::texcoord, 0},
    {"texture_t", Role::texcoord, 1},
};

const KnownName* find_name(const std::string& written) {
    const std::string name = lower_case(written);
    for (const KnownName& known : known_names)
        if (known.name == name) return &known;
    return nullptr;
}

}  // namespace

VertexTable::VertexTable(std::uint64_t count, Context& context)
    : count_(count), context_(context), charge_(context.memory()) {}

template <class T>
float* VertexTable::part_of(std::vector<T>& array, std::size_t component, T filled_with) {
    if (array.empty()) {
        charge_.grow(count_ * sizeof(T), "the vertices");
        array.assign(std::size_t(count_), filled_with);
    }
    return &array[0].x + component;
}

/// The first of the three decides for all.
ColumnTarget VertexTable::position_column(std::size_t axis, ColumnKind kind) {
    has_axis_[axis] = true;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (exact_.empty() && (positions_.empty() ? kind.needs_double : false)) {
        charge_.grow(count_ * sizeof(dvec3), "the vertices");
        exact_.assign(std::size_t(count_), dvec3{nan, nan, nan});
    }
    if (!exact_.empty()) return {nullptr, &exact_[0].x + axis, 3};
    constexpr float float_nan = std::numeric_limits<float>::quiet_NaN();
    return {part_of(positions_, axis, vec3{float_nan, float_nan, float_nan}), nullptr, 3};
}

ColumnTarget VertexTable::column(std::string_view name, ColumnKind kind) {
    const KnownName* const known = find_name(std::string(name));
    if (count_ == 0 || name == "pad") return {};  // what fills up bytes, as our own writer's does
    if (const std::optional<std::size_t> c = color_component(name); c && color_columns_.take(*c, kind.color))
        return {part_of(colors_, *c, vec4{0, 0, 0, largest_of(kind.color)}), nullptr, 4};
    if (known) switch (known->role) {
            case Role::position:
                return has_axis_[known->component] ? ColumnTarget{} : position_column(known->component, kind);
            case Role::normal:
                return {part_of(normals_, known->component, vec3{}), nullptr, 3};
            case Role::texcoord:
                return {part_of(texcoords_, known->component, vec2{}), nullptr, 2};
            case Role::harmonics:
                return {part_of(harmonics_, known->component, vec3{}), nullptr, 3};
            case Role::packed:
                charge_.grow(count_ * sizeof(double), "the vertices");
                packed_.assign(std::size_t(count_), 0.0);
                is_packed_real_ = kind.is_real, has_packed_alpha_ = known->component == 1;
                return {nullptr, packed_.data(), 1};
        }
    for (const auto& [taken, values] : arrays_)
        if (taken == name) return {};
    charge_.grow(count_ * sizeof(float) + name.size() + sizeof arrays_[0], "the vertex attributes");
    arrays_.emplace_back(std::string(name), std::vector<float>(std::size_t(count_)));
    return {arrays_.back().second.data(), nullptr, 1};
}

dvec3 VertexTable::position(std::uint64_t vertex) const {
    return exact_.empty() ? cast<double>(positions_[vertex]) : exact_[vertex];
}

template <class T>
Block<T> VertexTable::block_of(std::vector<T>& array) {
    const std::uint64_t bytes = array.size() * sizeof(T);
    return {std::move(array), charge_.split(bytes)};
}

void VertexTable::finish_positions(Mesh& mesh, const std::string& path) {
    std::uint64_t bad = 0;
    if (!exact_.empty()) {
        dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
        double error = 0;
        for (const dvec3& p : exact_)
            for (std::size_t k = 0; k < 3; ++k) {
                if (!(std::fabs(p[k]) <= double(std::numeric_limits<float>::max()))) continue;
                low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
                error = std::max(error, std::fabs(double(float(p[k])) - p[k]));
            }
        mesh.origin = position_origin(low, high, error);
        charge_.grow(count_ * sizeof(vec3), "the vertices");
        positions_.reserve(exact_.size());
        for (const dvec3& p : exact_) positions_.push_back(cast<float>(p - mesh.origin));
        charge_.shrink(exact_.size() * sizeof(dvec3));
        exact_ = {};
    }
    for (const vec3& p : positions_) bad += !is_finite(p);
    if (has_stray_vertices(positions_)) context_.report().add(Remark::warning, path, "", stray_vertices_text);
    mesh.positions = block_of(positions_);
    if (bad > 0)
        context_.report().add(Remark::warning, path, "", std::to_string(bad) + " vertices are not finite numbers");
}

/// Unit to within rounding stays as it is; zero and non-finite ones are left for prepare.
void VertexTable::finish_normals(Mesh& mesh, const std::string& path) {
    if (normals_.empty()) return;
    std::uint64_t zero = 0;
    for (vec3& n : normals_) {
        const float squared = dot(n, n);
        if (!(std::fabs(squared - 1) <= 1e-4f)) n = normalize_or(n, n);
        zero += !(squared > 0);
    }
    if (zero == count_) {
        context_.report().add(Remark::dropped, path, "", "all vertex normals are zero; they are treated as missing");
        charge_.shrink(count_ * sizeof(vec3));
        normals_ = {};
        return;
    }
    mesh.normals = block_of(normals_);
}

/// PCL writes the three bytes as one number, its bits as a float's where the column is real.
void VertexTable::unpack_colors() {
    if (packed_.empty() || !colors_.empty()) return;
    charge_.grow(count_ * sizeof(vec4), "the vertex colors");
    colors_.resize(std::size_t(count_));
    for (std::size_t i = 0; i < packed_.size(); ++i) {
        const double value = packed_[i];
        const std::uint32_t bits = is_packed_real_ && std::fabs(value) < 1 ? std::bit_cast<std::uint32_t>(float(value))
                                   : value >= 0 && value < 4294967296.0    ? std::uint32_t(value)
                                   : value < 0 && value > -2147483649.0    ? std::uint32_t(std::int64_t(value))
                                                                           : 0u;
        const auto byte = [bits](int shift) { return float(bits >> shift & 0xffu); };
        colors_[i] = {byte(16), byte(8), byte(0), has_packed_alpha_ ? byte(24) : 255.0f};
    }
    color_columns_.take_all(ColorScale::bytes);
}

void VertexTable::finish_colors(Mesh& mesh, const std::string& path) {
    unpack_colors();
    if (colors_.empty() && !harmonics_.empty()) {
        // The constant part of spherical harmonics: Kerbl et al. 2023, "3D Gaussian Splatting for Real-Time Radiance Field Rendering".
        charge_.grow(count_ * sizeof(vec4), "the vertex colors");
        for (const vec3& h : harmonics_)
            colors_.push_back({0.5f + 0.28209479f * h.x, 0.5f + 0.28209479f * h.y, 0.5f + 0.28209479f * h.z, 1});
        color_columns_.take_all(ColorScale::unit);
        context_.report().add(Remark::guessed, path, "",
                              "Gaussian splats are shown as points in the constant part of their colors");
    }
    if (colors_.empty()) return;
    if (color_columns_.is_by_value())
        for (const vec4& c : colors_) color_columns_.look_at(c);
    color_columns_.settle("vertex", path, context_.report());
    context_.parallel_for((colors_.size() + rows_per_task - 1) / rows_per_task, [&](std::size_t task) {
        const std::size_t end = std::min(colors_.size(), (task + 1) * rows_per_task);
        for (std::size_t i = task * rows_per_task; i < end; ++i) colors_[i] = color_columns_.linear(colors_[i]);
    });
    mesh.colors = block_of(colors_);
}

void VertexTable::move_to(Mesh& mesh, const std::string& path) {
    finish_positions(mesh, path);
    finish_normals(mesh, path);
    finish_colors(mesh, path);
    for (vec2& uv : texcoords_) uv = std::isfinite(uv.x) && std::isfinite(uv.y) ? vec2{uv.x, 1 - uv.y} : vec2{};
    if (!texcoords_.empty()) mesh.texcoords.push_back(block_of(texcoords_));
    for (auto& [name, values] : arrays_) mesh.arrays.push_back({std::move(name), 1, block_of(values)});
    arrays_.clear();
}

}  // namespace rakelight::io
