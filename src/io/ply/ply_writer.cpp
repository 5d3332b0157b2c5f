// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_writer.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cstring>

#include "base/format_text.h"
#include "io/files/output_file.h"
#include "math/color.h"
#include "math/linear.h"
#include "scene/placed_normal.h"
#include "scene/placement.h"

namespace rakelight::io {
namespace {

struct Layout {
    bool normals = true, texcoords = true;
    bool colors = false;  ///< some mesh has them
    bool pad = false;     ///< vertices begin with a byte of 1
    std::uint64_t vertices = 0, faces = 0;
};

/// As display values.
void put_color(std::vector<std::byte>& out, vec4 c) {
    for (const std::uint8_t code : {srgb8_from_linear(c.x), srgb8_from_linear(c.y), srgb8_from_linear(c.z),
                                    std::uint8_t(std::min(std::max(c.w, 0.0f), 1.0f) * 255 + 0.5f)})
        out.push_back(std::byte{code});
}

vec3 world_position(const Mesh& mesh, std::size_t v, const dmat4& place) {
    return cast<float>(transform_point(place, cast<double>(mesh.positions[v]) + mesh.origin));
}

/// Readers that skip white space after the header lose such a first byte of the data: Assimp drops a line feed there, for
/// the sake of headers with \r\n.
bool begins_like_white_space(vec3 first) {
    std::uint8_t byte = 0;
    std::memcpy(&byte, &first, 1);
    return byte == ' ' || (byte >= '\t' && byte <= '\r');
}

Layout layout_of(const Scene& scene, const std::vector<dmat4>& world) {
    Layout layout;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            if (mesh.triangle_count() == 0) continue;
            if (layout.faces == 0) layout.pad = begins_like_white_space(world_position(mesh, 0, world[n]));
            layout.vertices += mesh.positions.size();
            layout.faces += mesh.triangle_count();
            layout.normals = layout.normals && !mesh.normals.empty();
            layout.colors = layout.colors || !mesh.colors.empty();
            layout.texcoords = layout.texcoords && !mesh.texcoords.empty() && !mesh.texcoords[0].empty();
        }
    return layout;
}

std::string header_of(const Layout& layout) {
    std::string text = format_text(
        "ply\nformat binary_little_endian 1.0\ncomment one mesh, in world space\nelement vertex {}\n", layout.vertices);
    if (layout.pad) text += "property uchar pad\n";
    text += "property float x\nproperty float y\nproperty float z\n";
    if (layout.normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
    if (layout.texcoords) text += "property float s\nproperty float t\n";
    if (layout.colors) text += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
    return format_text("{}element face {}\nproperty list uchar int vertex_indices\nend_header\n", text, layout.faces);
}

template <class T>
void put(std::vector<std::byte>& out, const T& value) {  // little-endian, as every machine we build for
    const auto* raw = reinterpret_cast<const std::byte*>(&value);
    out.insert(out.end(), raw, raw + sizeof value);
}

void put_vertices(std::vector<std::byte>& out, const Mesh& mesh, const dmat4& place, const Layout& layout) {
    const PlacedNormals placed(place);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (layout.pad) put(out, std::uint8_t(1));
        put(out, world_position(mesh, v, place));
        if (layout.normals) put(out, placed(mesh.normals[v]));
        if (layout.texcoords) put(out, vec2{mesh.texcoords[0][v].x, 1 - mesh.texcoords[0][v].y});
        if (layout.colors) put_color(out, mesh.colors.empty() ? vec4{1, 1, 1, 1} : mesh.colors[v]);
    }
}

/// A mirroring matrix turns triangles inside out: their corners go the other way round.
void put_faces(std::vector<std::byte>& out, const Mesh& mesh, const dmat4& place, std::uint32_t first) {
    const bool mirrored = determinant(upper_left(place)) < 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const std::uint32_t* c = mesh.indices.data() + 3 * t;
        put(out, std::uint8_t(3));
        put(out, first + c[0]);
        put(out, first + c[mirrored ? 2 : 1]);
        put(out, first + c[mirrored ? 1 : 2]);
    }
}

void say_what_is_lost(const Scene& scene, const Layout& layout, Report& report) {
    const auto lost = [&](const char* what) {
        report.add(Remark::dropped, scene.source, {}, std::string("PLY cannot store ") + what);
    };
    std::size_t objects = 0;
    bool normals = false, texcoords = false, tangents = false, others = false, has_groups = false, arrays = false;
    for (const Node& node : scene.nodes) {
        objects += !node.meshes.empty();
        for (const std::uint32_t m : node.meshes) {
            const Mesh& mesh = scene.meshes[m];
            normals = normals || !mesh.normals.empty();
            texcoords = texcoords || mesh.texcoords.size() > (layout.texcoords ? 1u : 0u);
            tangents = tangents || !mesh.tangents.empty();
            has_groups = has_groups || !mesh.smoothing.empty() || !mesh.smoothing_hint.empty();
            arrays = arrays || !mesh.arrays.empty();
            others = others || mesh.topology != Topology::triangles;
        }
    }
    if (objects > 1) lost("separate objects: they were merged into one mesh");
    if (!scene.materials.empty()) lost("materials and textures");
    if (normals && !layout.normals) lost("normals that only some meshes have");
    if (texcoords)
        lost(layout.texcoords ? "more than one set of texture coordinates"
                              : "texture coordinates that only some meshes have");
    if (tangents) lost("tangents");
    if (arrays) report.add(Remark::dropped, scene.source, {}, "other vertex attributes are not written");
    if (others) lost("lines and points here");
    if (has_groups)
        report.add(Remark::note, scene.source, {}, "PLY cannot store smoothing groups: only the normals keep them");
    if (!scene.cameras.empty() || !scene.lights.empty()) lost("cameras and lights");
    if (!scene.skins.empty() || !scene.animations.empty()) lost("skins and animations: the bind pose was written");
}

}  // namespace

void write_ply(const Scene& scene, const std::string& path, Context& context) {
    const std::vector<dmat4> world = world_matrices(scene);
    const Layout layout = layout_of(scene, world);
    if (layout.faces == 0) throw Error(ErrorCode::bad_file, "nothing to write: there is no triangle");
    if (layout.vertices > 0x7FFFFFFFu)
        throw Error(ErrorCode::bad_file, "more than 2147483647 vertices do not fit in a PLY file");
    say_what_is_lost(scene, layout, context.report());
    OutputFile file(path);
    const std::string header = header_of(layout);
    file.write(std::as_bytes(std::span(header)));
    std::vector<std::byte> out;
    const auto for_each_mesh = [&](auto use) {
        for (std::size_t n = 0; n < scene.nodes.size(); ++n)
            for (const std::uint32_t m : scene.nodes[n].meshes) {
                const Mesh& mesh = scene.meshes[m];
                if (mesh.triangle_count() == 0) continue;
                context.throw_if_cancelled();
                context.memory().check(mesh.positions.size() * 64 + mesh.triangle_count() * 26, "writing a mesh");
                out.clear();
                use(mesh, world[n]);
                file.write(out);
            }
    };
    for_each_mesh([&](const Mesh& mesh, const dmat4& place) { put_vertices(out, mesh, place, layout); });
    std::uint32_t first = 0;
    for_each_mesh([&](const Mesh& mesh, const dmat4& place) {
        put_faces(out, mesh, place, first);
        first += std::uint32_t(mesh.positions.size());
    });
    file.commit();
}

}  // namespace rakelight::io
