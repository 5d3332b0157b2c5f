// SPDX-License-Identifier: Apache-2.0
// PLY -> scene: header, then element by element. Without faces and edges its vertices are points.
#include "io/ply/read_ply.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <filesystem>

#include "io/cloud_material.h"
#include "io/files/plain_text.h"
#include "io/model_readers.h"
#include "io/obj/references.h"
#include "io/pictures/image_io.h"
#include "io/ply/ply_faces.h"
#include "io/ply/ply_meshes.h"
#include "io/ply/ply_vertices.h"

namespace rakelight::io::ply {
namespace {

struct Contents {
    std::optional<VertexTable> vertices;
    Faces faces;
    explicit Contents(Context& context) : faces(context.memory()) {}
};

Contents read_elements(std::string_view file, const Header& header, const std::string& path, Context& context) {
    Contents out(context);
    Cursor cursor(file, header);
    for (const Element& e : header.elements) {
        context.progress("load", double(file.empty() ? 0 : header.bytes) / double(file.size()));
        if (e.name == "vertex" && !out.vertices) {
            if (e.count >= no_index)
                throw Error(ErrorCode::bad_file, "more than 4294967294 vertices are not supported");
            out.vertices.emplace(e.count, context);
            read_vertices(cursor, e, header.format, *out.vertices, path, context);
            if (!out.vertices->has_positions()) throw Error(ErrorCode::bad_file, "the vertices have no x, y and z");
        } else if (!out.vertices || (e.name != "face" && e.name != "tristrips" && e.name != "edge")) {
            if (e.count > 0)
                context.report().add(Remark::dropped, path, "",
                                     "the element '" + one_line(e.name, 40) + "' is left out");
            cursor.begin(e);
            for (std::uint64_t i = 0; i < e.count && !e.properties.empty(); ++i) cursor.skip_row(e);
        } else if (e.name == "face") {
            read_faces(cursor, e, header.format, *out.vertices, !out.vertices->has_colors(), out.faces, path, context);
        } else if (e.name == "tristrips") {
            read_strips(cursor, e, *out.vertices, out.faces, path, context);
        } else {
            read_edges(cursor, e, *out.vertices, out.faces, path, context);
        }
    }
    if (!cursor.is_at_end())
        context.report().add(Remark::warning, path, {}, "bytes follow the elements that the header declares");
    if (cursor.bad_words() > 0)
        context.report().add(Remark::warning, path, {},
                             std::to_string(cursor.bad_words()) + " words are not numbers; they are treated as NaN");
    return out;
}

void add_texture(Scene& scene, const Header& header, const std::string& path, const ReadOptions& options,
                 Report& report) {
    if (header.textures.empty() || scene.meshes[0].texcoords.empty()) return;
    const std::string name = one_line(obj::ReferenceFinder::bare_name(header.textures[0]), 80);
    if (header.textures.size() > 1)
        report.add(Remark::dropped, path, "", "the file names several textures; the first is used");
    const auto found = obj::ReferenceFinder(path, options.allow_outside).find(header.textures[0]);
    if (!found) {
        report.add(Remark::warning, path, "", "texture '" + name + "' is not in the model's folder; it is left out");
        return;
    }
    scene.textures.push_back({name, image_from_file(name, path, found->path), {}});
    scene.materials[0].base_color_texture.texture = 0;
}

}  // namespace

Scene read_ply_bytes(std::string_view bytes, const std::string& path, const ReadOptions& options, Context& context) {
    const PlainText text(bytes, path, context);
    const std::string_view file = text.view();
    const Header header = read_header(file);
    const auto vertices = std::ranges::find(header.elements, "vertex", &Element::name);
    if (vertices == header.elements.end() || vertices->count == 0)
        throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no vertex");
    Contents contents = read_elements(file, header, path, context);
    const bool promised_faces = std::ranges::any_of(
        header.elements, [](const Element& e) { return (e.name == "face" || e.name == "tristrips") && e.count > 0; });
    if (promised_faces && contents.faces.triangles.empty())
        throw Error(ErrorCode::bad_file, "nothing to draw: no face has three valid corners");
    Scene scene;
    scene.source = path;
    Mesh mesh;
    mesh.name = std::filesystem::path(path).stem().string();
    contents.vertices->move_to(mesh, path);
    mesh.material = 0;
    scene.nodes.emplace_back().name = mesh.name;
    add_meshes(scene, std::move(mesh), contents.faces, context);
    const Mesh& first = scene.meshes.back();
    scene.materials.push_back(plain_material(!first.colors.empty()));
    add_texture(scene, header, path, options, context.report());
    if (scene.materials[0].base_color_texture) scene.materials[0].base_color = {1, 1, 1, 1};
    return scene;
}

}  // namespace rakelight::io::ply

namespace rakelight::io {

namespace {

Scene read_bytes(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return ply::read_ply_bytes(text, path, options, context);
}

}  // namespace

constinit const ModelReader ply_reader = {.read_bytes = read_bytes};

}  // namespace rakelight::io
