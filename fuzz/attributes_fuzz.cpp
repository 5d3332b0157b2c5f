// SPDX-License-Identifier: Apache-2.0
// Fitted normals and automatic creases of small models made from any bytes: broken numbers, faces and matrices, locks, groups,
// moved positions. Normals are unit, corners of one vertex and of one group agree, threads and regroup() change no bit.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/creases.h>

#include "geometry/attribute_plan.h"

namespace {

using namespace rakelight;

/// Numbers from the input; zeros after its end.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
    std::uint32_t byte() { return at_ == end_ ? 0 : *at_++; }
    std::uint32_t below(std::uint32_t count) { return byte() % count; }
    /// Rarely up to 255, for the ways of crowded places and large planes.
    std::uint32_t few(std::uint32_t count) { return is_rare() ? byte() : below(count); }
    bool is_rare() { return byte() < 10; }
    /// On a coarse grid for the most part, so that places meet and faces are flat.
    float coordinate() {
        static constexpr float special[] = {std::numeric_limits<float>::quiet_NaN(),
                                            std::numeric_limits<float>::infinity(),
                                            3e38f,
                                            -3e38f,
                                            1e-38f,
                                            1e-45f,
                                            -0.0f,
                                            1e19f,
                                            1e-19f,
                                            1e-7f,
                                            16777216.0f,
                                            0.1f};
        const std::uint32_t kind = byte();
        if (kind < 8) return special[below(12)];
        if (kind < 16) return any_float();
        if (kind < 64) return float(int(byte()) - 128) * 0.0625f + 1e-6f * float(byte());
        return float(int(kind % 8) - 4);
    }
    float any_float() {
        std::uint32_t bits = 0;
        for (int i = 0; i < 4; ++i) bits = bits << 8 | byte();
        float f;
        std::memcpy(&f, &bits, sizeof f);
        return f;
    }

private:
    const std::uint8_t *at_, *end_;
};

struct Model {
    struct Part {
        std::vector<vec3> positions, moved, normals, hints;
        std::vector<vec2> texcoords;
        std::vector<std::uint32_t> indices, smoothing;
        std::vector<std::uint8_t> locked;
        AttributeMesh mesh;
    };
    std::vector<Part> parts;
    AttributeOptions options, other;  // for regroup()

    std::vector<AttributeMesh> meshes(bool has_moved) const {
        std::vector<AttributeMesh> out;
        for (const Part& p : parts) {
            AttributeMesh m = p.mesh;
            m.positions = has_moved ? p.moved : p.positions;
            m.normals = p.normals, m.texcoords = p.texcoords, m.indices = p.indices, m.smoothing = p.smoothing;
            m.smoothing_hint = p.hints, m.locked = p.locked;
            out.push_back(m);
        }
        return out;
    }
};

/// Beyond 1e-19 to 1e19, times the smallest and the largest float, squares of weights leave the range of double.
double matrix_entry(Bytes& bytes) {
    const double x = double(bytes.coordinate()), size = std::fabs(x);
    return size < 1e-19 ? 0 : size > 1e19 && std::isfinite(x) ? x / size : x;
}

dmat4 read_matrix(Bytes& bytes) {
    dmat4 m;
    switch (bytes.below(8)) {
        case 0:
            for (std::size_t c = 0; c < 3; ++c) m[c][c] = matrix_entry(bytes);
            break;
        case 1:
            m[0][0] = -1;
            break;
        case 2:
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t r = 0; r < 3; ++r) m[c][r] = matrix_entry(bytes);
            break;
        case 3:
            m[2][2] = 0;
            break;
        case 4:
            for (std::size_t c = 0; c < 3; ++c) m[c][c] = std::ldexp(1.0, int(bytes.byte()) / 2 - 64);
            break;
        default:
            break;
    }
    return m;
}

/// A bent sheet of rows of 4 vertices, or triangles between any vertices.
void read_faces(Bytes& bytes, Model::Part& part) {
    const std::uint32_t count = std::uint32_t(part.positions.size()), width = 4;
    if (count == 0) return;
    if (bytes.below(2) == 0)
        for (std::uint32_t v = 0; v + width + 1 < count; ++v)
            if (v % width != width - 1)
                part.indices.insert(part.indices.end(), {v, v + 1, v + width + 1, v, v + width + 1, v + width});
    for (std::uint32_t faces = bytes.few(32); faces > 0; --faces)
        for (int k = 0; k < 3; ++k) part.indices.push_back(bytes.below(count));
}

void read_arrays(Bytes& bytes, Model::Part& part) {
    const std::size_t vertices = part.positions.size(), faces = part.indices.size() / 3;
    const std::uint32_t with = bytes.byte();
    if ((with & 1) != 0)
        for (std::size_t v = 0; v < vertices; ++v)
            part.normals.push_back({bytes.coordinate(), bytes.coordinate(), bytes.coordinate()});
    if ((with & 3) == 3)
        for (std::size_t v = 0; v < vertices; ++v) part.locked.push_back(std::uint8_t(bytes.below(3)));
    if ((with & 4) != 0) {
        for (std::size_t t = 0; t < faces; ++t) part.smoothing.push_back(bytes.below(4));
        part.mesh.group_kind = GroupKind(bytes.below(3));
    }
    if ((with & 8) != 0)
        for (std::size_t c = 0; c < 3 * faces; ++c) part.hints.push_back({float(bytes.below(3)), 0, 1});
    if ((with & 16) != 0)
        for (std::size_t v = 0; v < vertices; ++v) part.texcoords.push_back({bytes.coordinate(), bytes.coordinate()});
    if ((with & 32) != 0) part.mesh.crease_angle_rad = radians(double(bytes.below(181)));
    if ((with & 192) == 192) part.mesh.position_step = 0.0625;
}

Model::Part read_part(Bytes& bytes) {
    Model::Part part;
    part.mesh.object = bytes.below(3);
    part.mesh.to_world = read_matrix(bytes);
    for (std::uint32_t count = bytes.few(40); count > 0; --count)
        part.positions.push_back({bytes.coordinate(), bytes.coordinate(), bytes.coordinate()});
    part.moved = part.positions;
    if (bytes.below(2) == 0)
        for (vec3& p : part.moved) p = p + vec3{0, bytes.coordinate(), 0};
    read_faces(bytes, part);
    read_arrays(bytes, part);
    return part;
}

AttributeOptions read_options(Bytes& bytes) {
    static constexpr CornerWeight weights[] = {CornerWeight::automatic, CornerWeight::fit, CornerWeight::automatic,
                                               CornerWeight::max};
    static constexpr double welds[] = {-1, 0, 1e-6, 0.5, 3, 1e30};
    const std::uint32_t with = bytes.byte();
    AttributeOptions o;
    o.weight = weights[bytes.below(4)];
    o.creases = (with & 1) != 0 ? Creasing::automatic : Creasing::angle;
    o.crease_angle_rad = (with & 2) != 0 ? pi : radians(double(bytes.below(181)));
    o.fans = (with & 4) != 0, o.groups_across = (with & 8) != 0;
    o.locked_vote = (with & 16) == 0, o.tangents = (with & 32) != 0;
    o.scope = bytes.is_rare() ? Scope::object : Scope::model;
    o.weld_distance = welds[bytes.below(6)];
    return o;
}

void require(bool holds) {
    if (!holds) std::abort();
}
template <class T>
bool have_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
bool is_locked(const AttributeMesh& mesh, std::size_t vertex) {
    return vertex < mesh.locked.size() && mesh.locked[vertex] != 0;
}
void require_same(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    require(a.size() == b.size());
    for (std::size_t m = 0; m < a.size(); ++m)
        require(have_same_bits(a[m].normals, b[m].normals) && have_same_bits(a[m].tangents, b[m].tangents) &&
                a[m].indices == b[m].indices && a[m].source_vertex == b[m].source_vertex);
}

bool is_unit(vec3 n) {
    const double square = double(n.x) * double(n.x) + double(n.y) * double(n.y) + double(n.z) * double(n.z);
    return std::fabs(square - 1) < 1e-4;
}

void require_sound(const std::vector<AttributeMesh>& meshes, const std::vector<MeshAttributes>& out) {
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const std::size_t count = meshes[m].positions.size();
        require(out[m].normals.size() == count + out[m].source_vertex.size());
        require(out[m].indices.empty() || out[m].indices.size() == meshes[m].indices.size());
        for (const std::uint32_t v : out[m].indices) require(v < out[m].normals.size());
        for (std::size_t v = 0; v < out[m].normals.size(); ++v) {
            const std::size_t source = v < count ? v : out[m].source_vertex[v - count];
            require(is_locked(meshes[m], source) || is_unit(out[m].normals[v]));
        }
    }
}

/// Vertices of one corner group have the same bits where their matrices have.
void require_no_seams(const AttributePlan& plan, const std::vector<AttributeMesh>& meshes,
                      const std::vector<MeshAttributes>& out) {
    struct First {
        std::size_t mesh;
        vec3 normal;
    };
    const std::vector<std::uint32_t>& group = plan.impl().topology.group;
    std::map<std::uint32_t, std::vector<First>> seen;
    std::size_t row = 0;
    const auto see = [&](std::size_t m, std::size_t v, std::size_t source) {
        require(row < group.size());
        const std::uint32_t g = group[row++];
        if (is_locked(meshes[m], source)) return;
        std::vector<First>& of_group = seen[g];
        for (const First& f : of_group)
            if (std::memcmp(&meshes[f.mesh].to_world, &meshes[m].to_world, sizeof(dmat4)) == 0)
                return require(std::memcmp(&f.normal, &out[m].normals[v], sizeof(vec3)) == 0);
        of_group.push_back({m, out[m].normals[v]});
    };
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (std::size_t v = 0; v < meshes[m].positions.size(); ++v) see(m, v, v);
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (std::size_t i = 0; i < out[m].source_vertex.size(); ++i)
            see(m, meshes[m].positions.size() + i, out[m].source_vertex[i]);
    require(row == group.size());
}

void check(const Model& model) {
    Context one({.threads = 1, .max_memory = 64u << 20}), three({.threads = 3, .max_memory = 64u << 20});
    const std::vector<AttributeMesh> meshes = model.meshes(false), moved = model.meshes(true);
    const std::vector<MeshAttributes> out = compute_attributes(meshes, model.options, one);
    require_sound(meshes, out);
    require_same(out, compute_attributes(meshes, model.options, three));
    const AttributePlan plan = group(meshes, model.options, three);
    const std::vector<MeshAttributes> in_steps = accumulate(plan, meshes, one);
    require_same(out, in_steps);
    require_no_seams(plan, meshes, in_steps);
    const std::vector<MeshAttributes> of_moved = accumulate(plan, moved, one);
    require_sound(moved, of_moved);
    require_same(of_moved, accumulate(plan, moved, three));
    const AttributePlan again = regroup(plan, meshes, model.other, one);
    require_same(accumulate(again, meshes, one), accumulate(group(meshes, model.other, one), meshes, one));
    const Creases creases = find_creases(meshes, model.options, one), same = find_creases(meshes, model.options, three);
    require(creases.hard == same.hard && creases.report == same.report);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    Model model;
    model.options = read_options(bytes);
    model.other = read_options(bytes);
    for (std::uint32_t parts = 1 + bytes.below(4); parts > 0; --parts) model.parts.push_back(read_part(bytes));
    try {
        check(model);
    } catch (const Error&) {
    }
    return 0;
}
