// SPDX-License-Identifier: Apache-2.0
#include "geometry/input/attribute_input.h"

#include <cmath>
#include <cstring>
#include <string>

#include "base/enumerators.h"
#include "base/format_text.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint64_t max_vertices = 0xffffffffull - 1, max_corners = 0xffffffffull - 2;
constexpr std::uint32_t no_index = 0xffffffffu;
constexpr double angle_slack = 1e-9;  // conversion from degrees may round to just above pi

[[noreturn]] void fail(std::size_t mesh, const std::string& reason) {
    throw Error(ErrorCode::bad_file, reason, format_text("mesh {}", mesh));
}

void check_size(std::size_t mesh, const char* what, std::size_t given, std::uint64_t wanted, const char* of) {
    if (given != 0 && given != wanted) fail(mesh, format_text("{} {} for {} {}", given, what, wanted, of));
}

void check_mesh(std::size_t m, const AttributeMesh& mesh) {
    if (!exists(mesh.group_kind, GroupKind::numbers)) fail(m, no_such("kind of smoothing groups", mesh.group_kind));
    if (mesh.indices.size() % 3 != 0) fail(m, format_text("{} indices, not a multiple of 3", mesh.indices.size()));
    const std::uint64_t triangles = mesh.indices.size() / 3;
    check_size(m, "texture coordinates", mesh.texcoords.size(), mesh.positions.size(), "vertices");
    check_size(m, "normals", mesh.normals.size(), mesh.positions.size(), "vertices");
    check_size(m, "locks", mesh.locked.size(), mesh.positions.size(), "vertices");
    if (!mesh.locked.empty() && mesh.normals.empty()) fail(m, "locked vertices, but no normals to keep");
    if (!(mesh.position_step >= 0) || !std::isfinite(mesh.position_step))
        fail(m, "the step of the positions is not a length");
    if (!(mesh.crease_angle_rad <= pi + angle_slack)) fail(m, "the crease angle must be 0 to 180 degrees");
    check_size(m, "smoothing groups", mesh.smoothing.size(), triangles, "triangles");
    check_size(m, "smoothing hints", mesh.smoothing_hint.size(), 3 * triangles, "corners");
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(mesh.to_world[c][r])) fail(m, "the matrix to the world is not finite");
}

Placement place(const dmat4& to_world) {
    Placement p;
    p.to_world = to_world;
    p.linear = upper_left(to_world);
    double largest = 0;  // the sign of the determinant without overflow or underflow
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::fmax(largest, std::fabs(p.linear[c][r]));
    dmat3 scaled = p.linear;
    for (int c = 0; c < 3; ++c) scaled[c] = largest > 0 ? scaled[c] / largest : scaled[c];
    p.flip = determinant(scaled) < 0 ? -1 : 1;
    p.normal_to_world = cofactor(p.linear);
    for (int c = 0; c < 3; ++c) {
        p.normal_to_world[c] = p.normal_to_world[c] * p.flip;
        p.scale = std::fmax(p.scale, length(p.linear[c]));
    }
    return p;
}

// Branch-free, with four independent chains: nearly always this first pass is sufficient.
std::uint32_t largest_of(std::span<const std::uint32_t> indices) {
    std::uint32_t a = 0, b = 0, c = 0, d = 0;
    std::size_t i = 0;
    for (; i + 4 <= indices.size(); i += 4) {
        a = std::max(a, indices[i]);
        b = std::max(b, indices[i + 1]);
        c = std::max(c, indices[i + 2]);
        d = std::max(d, indices[i + 3]);
    }
    for (; i < indices.size(); ++i) a = std::max(a, indices[i]);
    return std::max(std::max(a, b), std::max(c, d));
}

}  // namespace

// The first thread that finds one.
void check_indices(const AttributeInput& input, Context& context) {
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    std::vector<std::uint32_t> first_bad(chunks.size(), no_index);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        std::uint32_t bad = no_index;
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::span<const std::uint32_t> indices = input.meshes[m].indices;
            const std::size_t vertices = input.meshes[m].positions.size();
            if (bad != no_index || first == last) return;
            if (largest_of(indices.subspan(3 * std::size_t(first), 3 * std::size_t(last - first))) < vertices) return;
            std::uint32_t i = 3 * first;
            while (indices[i] < vertices) ++i;
            bad = 3 * input.triangle_base[m] + i;
        });
        first_bad[c] = bad;
    });
    const auto found = std::min_element(first_bad.begin(), first_bad.end());
    if (found == first_bad.end() || *found == no_index) return;
    const std::uint32_t m = input.mesh_of_triangle(*found / 3), corner = *found - 3 * input.triangle_base[m];
    fail(m, format_text("index {} at corner {} exceeds {} vertices", input.meshes[m].indices[corner], corner,
                        input.meshes[m].positions.size()));
}

void PlacementTable::push_back(const dmat4& to_world) {
    // Compared bitwise: the sign of zeros affects the sign of zeros in normals.
    if (distinct_.empty() || std::memcmp(&distinct_.back().to_world, &to_world, sizeof to_world) != 0)
        distinct_.push_back(place(to_world));
    number_.push_back(std::uint32_t(distinct_.size() - 1));
}

AttributeInput number_input(std::span<const AttributeMesh> meshes) {
    AttributeInput input;
    input.meshes = meshes;
    input.vertex_base.reserve(meshes.size() + 1);
    input.triangle_base.reserve(meshes.size() + 1);
    input.placements.reserve(meshes.size());
    std::uint64_t vertices = 0, triangles = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        check_mesh(m, meshes[m]);
        input.vertex_base.push_back(std::uint32_t(vertices));
        input.triangle_base.push_back(std::uint32_t(triangles));
        vertices += meshes[m].positions.size();
        triangles += meshes[m].indices.size() / 3;
        // Splitting can add a vertex for each corner, and all are numbered with 32 bits.
        if (vertices + 3 * triangles > max_vertices || 3 * triangles > max_corners)
            fail(m, "more than 2^32 vertices and corners in one call");
        input.placements.push_back(meshes[m].to_world);
    }
    input.vertex_base.push_back(std::uint32_t(vertices));
    input.triangle_base.push_back(std::uint32_t(triangles));
    return input;
}

AttributeInput check_input(std::span<const AttributeMesh> meshes, Context& context) {
    AttributeInput input = number_input(meshes);
    check_indices(input, context);
    return input;
}

void check_normals(std::span<const AttributeMesh> meshes) {
    for (std::size_t m = 0; m < meshes.size(); ++m)
        if (meshes[m].normals.size() != meshes[m].positions.size())
            throw Error(ErrorCode::bad_file,
                        format_text("{} normals for {} vertices", meshes[m].normals.size(), meshes[m].positions.size()),
                        format_text("mesh {}", m));
}

void check_options(const AttributeOptions& options) {
    if (!(options.crease_angle_rad >= 0 && options.crease_angle_rad <= pi + angle_slack))
        throw Error(ErrorCode::usage, "the crease angle must be 0 to 180 degrees");
    if (!std::isfinite(options.weld_distance)) throw Error(ErrorCode::usage, "the weld distance must be finite");
    const auto require = [](const char* what, auto value, auto last) {
        if (!exists(value, last)) throw Error(ErrorCode::usage, no_such(what, value));
    };
    require("scope", options.scope, Scope::model);
    require("way to find creases", options.creases, Creasing::automatic);
    require("weight", options.weight, CornerWeight::automatic);
    require("way to make tangents", options.tangent_mode, TangentMode::published_no_handedness);
    require("way to orthogonalize", options.orthogonalize, Orthogonalize::off);
}

CreaseRange crease_range(std::span<const AttributeMesh> meshes, const AttributeOptions& options) {
    if (meshes.empty()) return {options.crease_angle_rad, options.crease_angle_rad};
    CreaseRange range{crease_angle(meshes[0], options), crease_angle(meshes[0], options)};
    for (const AttributeMesh& mesh : meshes) {
        range.least = std::min(range.least, crease_angle(mesh, options));
        range.most = std::max(range.most, crease_angle(mesh, options));
        range.has_rule |= follows_rule(mesh, options);
    }
    return range;
}

std::vector<Chunk> make_chunks(std::span<const std::uint32_t> base, std::uint32_t target) {
    constexpr std::uint32_t max_pieces = 64;  // the number of outboxes is pieces^2
    constexpr std::uint32_t max_meshes = 4096;
    std::vector<Chunk> chunks;
    std::uint32_t open = 0;  // items in the last chunk of whole meshes; 0: none is open
    for (std::uint32_t m = 0; m + 1 < base.size(); ++m) {
        const std::uint32_t count = base[m + 1] - base[m];
        if (count > target) {
            const std::uint32_t pieces = std::min(max_pieces, count / target + 1);
            for (std::uint32_t p = 0; p < pieces; ++p) chunks.push_back({m, m + 1, p, pieces});
            open = 0;
            continue;
        }
        if (open == 0 || open + count > target || m - chunks.back().mesh_begin >= max_meshes) {
            chunks.push_back({m, m + 1, 0, 1});
            open = 1;
        }
        chunks.back().mesh_end = m + 1;
        open += count;
    }
    return chunks;
}

}  // namespace rakelight::geometry
