// SPDX-License-Identifier: Apache-2.0
// Fitted normals and automatic creases of small models made from any bytes: broken numbers, faces and matrices, locks, groups,
// moved positions. Normals are unit, corners of one vertex and of one group agree, threads and regroup() change no bit. Every
// other model is a gentle sheet: only few places of it are creases, so that the fast path keeps it, and equals the general one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/creases.h>

#include "geometry/attribute_plan.h"
#include "geometry/fast/fast_attributes.h"

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

/// Rows of vertices on a curved sheet, cut into parts by columns: parts meet in equal positions. Heights are small, and rarely any.
struct Sheet {
    std::uint32_t columns, rows;
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    dmat4 to_world;
    double crease_angle_rad = -1;
};

/// Keeps angles: the axes in any order, mirrored or not, one scale.
dmat4 read_similarity(Bytes& bytes) {
    dmat4 m;
    const std::uint32_t kind = bytes.byte();
    if (kind < 128) return m;
    const double scale = std::ldexp((kind & 64) != 0 ? 1.0 : 1.1, int(bytes.below(41)) - 20);
    for (std::size_t c = 0; c < 3; ++c) {
        m[c] = {};
        m[c][(c + kind) % 3] = (kind >> (3 + c) & 1) != 0 ? -scale : scale;
        m[3][c] = matrix_entry(bytes);
    }
    return m;
}

Sheet read_sheet(Bytes& bytes) {
    static constexpr std::array<float, 8> slopes{0, 1e-5f, 1e-4f, 1e-3f, 3e-3f, 1e-2f, 3e-2f, 0.1f};
    Sheet s{3 + bytes.below(14), 3 + bytes.below(14), {}, {}, read_similarity(bytes)};
    const float curve = 0.0005f * float(bytes.byte()), saddle = 0.0005f * float(int(bytes.byte()) - 128);
    const float slope = slopes[bytes.below(8)];
    const std::uint32_t turn = bytes.byte();  // of the texture, and whether it is mirrored at a column
    for (std::uint32_t r = 0; r < s.rows; ++r)
        for (std::uint32_t c = 0; c < s.columns; ++c) {
            const std::uint32_t b = bytes.byte();
            const float x = float(c), y = float(r), u = (turn & 3) == 0 && c > 3 ? 6 - x : x;
            const float z = b == 255 ? bytes.coordinate() : float(int(b) - 128) * slope;
            s.positions.push_back({x, y, z - curve * x * x - saddle * y * y});
            s.texcoords.push_back({0.1f * (u + y * 0.01f * float(turn)), b == 254 ? bytes.coordinate() : 0.1f * y});
        }
    if (bytes.is_rare()) s.crease_angle_rad = radians(double(bytes.below(181)));
    return s;
}

/// Columns first .. last of a sheet.
Model::Part read_part_of(Bytes& bytes, const Sheet& sheet, std::uint32_t first, std::uint32_t last) {
    Model::Part part;
    part.mesh.object = bytes.below(3);
    part.mesh.to_world = sheet.to_world, part.mesh.crease_angle_rad = sheet.crease_angle_rad;
    const std::uint32_t with = bytes.byte(), width = last - first + 1;
    for (std::uint32_t r = 0; r < sheet.rows; ++r)
        for (std::uint32_t c = first; c <= last; ++c) {
            part.positions.push_back(sheet.positions[r * sheet.columns + c]);
            if ((with & 1) != 0) part.texcoords.push_back(sheet.texcoords[r * sheet.columns + c]);
            const std::uint32_t v = r * width + c - first;
            if (r + 1 == sheet.rows || c == last) continue;
            if ((with & 2) != 0)
                part.indices.insert(part.indices.end(), {v, v + 1, v + width + 1, v, v + width + 1, v + width});
            else
                part.indices.insert(part.indices.end(), {v, v + 1, v + width, v + 1, v + width + 1, v + width});
        }
    part.moved = part.positions;
    for (std::uint32_t faces = (with & 28) == 0 ? bytes.below(8) : 0; faces > 0; --faces)
        for (int k = 0; k < 3; ++k) part.indices.push_back(bytes.below(std::uint32_t(part.positions.size())));
    if ((with & 224) == 0) read_arrays(bytes, part);
    return part;
}

void read_gentle_parts(Bytes& bytes, Model& model) {
    const Sheet sheet = read_sheet(bytes);
    for (std::uint32_t first = 0; first + 1 < sheet.columns;) {
        const std::uint32_t last = std::min(first + 1 + bytes.below(16), sheet.columns - 1);
        model.parts.push_back(read_part_of(bytes, sheet, first, last));
        first = last;
    }
    for (AttributeOptions* o : {&model.options, &model.other})
        o->fans = false, o->weld_distance = std::min(o->weld_distance, 0.0);
}

AttributeOptions read_options(Bytes& bytes) {
    static constexpr CornerWeight weights[] = {
        CornerWeight::automatic, CornerWeight::fit,     CornerWeight::automatic, CornerWeight::max,
        CornerWeight::angle,     CornerWeight::uniform, CornerWeight::area,      CornerWeight::angle_area};
    static constexpr double welds[] = {-1, 0, 1e-6, 0.5, 3, 1e30, -1, 0};
    const std::uint32_t with = bytes.byte();
    AttributeOptions o;
    o.weight = weights[bytes.below(8)];
    o.creases = (with & 1) != 0 ? Creasing::automatic : Creasing::angle;
    o.crease_angle_rad = (with & 2) != 0 ? pi : radians(double(bytes.below(181)));
    o.fans = (with & 4) != 0, o.groups_across = (with & 8) != 0;
    o.locked_vote = (with & 16) == 0, o.tangents = (with & 32) != 0;
    o.scope = bytes.is_rare() ? Scope::object : Scope::model;
    o.weld_distance = welds[bytes.below(8)];
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

/// The fast path sums in float: equal faces and vertices, near vectors.
void require_near(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    constexpr double tolerance = 1e-3;
    require(a.size() == b.size());
    for (std::size_t m = 0; m < a.size(); ++m) {
        require(a[m].indices == b[m].indices && a[m].source_vertex == b[m].source_vertex);
        require(a[m].degenerate_faces == b[m].degenerate_faces && a[m].isolated_vertices == b[m].isolated_vertices);
        require(a[m].normals.size() == b[m].normals.size() && a[m].tangents.size() == b[m].tangents.size());
        for (std::size_t v = 0; v < a[m].normals.size(); ++v)
            require(length(cast<double>(a[m].normals[v]) - cast<double>(b[m].normals[v])) < tolerance);
    }
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

/// The caller's buffers get the same, with memory of an earlier call, too.
void require_same_into(const std::vector<AttributeMesh>& meshes, const AttributeOptions& options,
                       const std::vector<MeshAttributes>& out, AttributeWorkspace& workspace, Context& context) {
    std::vector<std::vector<vec3>> normals;
    std::vector<std::vector<vec4>> tangents;
    std::vector<AttributeBuffers> buffers;
    for (const AttributeMesh& m : meshes) {
        normals.emplace_back(m.positions.size()), tangents.emplace_back(m.texcoords.size());
        buffers.push_back({normals.back(), tangents.back()});
    }
    const std::vector<SplitAttributes> splits = compute_attributes_into(meshes, options, buffers, workspace, context);
    std::vector<MeshAttributes> made(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        MeshAttributes& r = made[m];
        r.normals = normals[m], r.source_vertex = splits[m].source_vertex;
        r.normals.insert(r.normals.end(), splits[m].normals.begin(), splits[m].normals.end());
        if (!out[m].tangents.empty()) r.tangents = tangents[m];
        r.tangents.insert(r.tangents.end(), splits[m].tangents.begin(), splits[m].tangents.end());
        if (!out[m].indices.empty()) r.indices.assign(meshes[m].indices.begin(), meshes[m].indices.end());
        for (const CornerVertex& c : splits[m].corners) r.indices.at(c.corner) = c.vertex;
    }
    require_same(out, made);
}

void check(const Model& model) {
    Context one({.threads = 1, .max_memory = 64u << 20}), three({.threads = 3, .max_memory = 64u << 20});
    const std::vector<AttributeMesh> meshes = model.meshes(false), moved = model.meshes(true);
    const std::vector<MeshAttributes> out = compute_attributes(meshes, model.options, one);
    require_sound(meshes, out);
    require_same(out, compute_attributes(meshes, model.options, three));
    AttributeWorkspace workspace;
    require_same_into(meshes, model.options, out, workspace, three);
    require_same_into(meshes, model.options, out, workspace, one);
    const AttributePlan plan = group(meshes, model.options, three);
    const std::vector<MeshAttributes> in_steps = accumulate(plan, meshes, one);
    if (geometry::takes_fast_path(meshes, model.options))
        require_near(out, in_steps), require_no_seams(plan, meshes, out);
    else
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
    if (const std::uint32_t kind = bytes.byte(); (kind & 4) != 0)
        read_gentle_parts(bytes, model);
    else
        for (std::uint32_t parts = 1 + kind % 4; parts > 0; --parts) model.parts.push_back(read_part(bytes));
    try {
        check(model);
    } catch (const Error&) {
    }
    return 0;
}
