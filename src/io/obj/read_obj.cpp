// SPDX-License-Identifier: Apache-2.0
// OBJ -> scene, in three passes over the chunks of the text: count, vertices, faces. See README.md beside.
#include <filesystem>
#include <set>
#include <string_view>

#include "io/files/file.h"
#include "io/files/plain_text.h"
#include "io/model_readers.h"
#include "io/obj/mtl_materials.h"
#include "io/obj/obj_faces.h"
#include "io/obj/obj_points.h"
#include "io/obj/obj_vertices.h"
#include "io/obj/read_obj.h"
#include "io/obj/write/kept_obj.h"
#include "io/vertex_colors.h"

namespace rakelight::io {
namespace {

using namespace obj;

void add_objects(Scene& scene, Elements& elements, const VertexData& data, Remarks& remarks, Context& context) {
    const dvec3 origin = choose_origin(data.positions, elements.meshes, context);
    const std::size_t meshes = elements.meshes.size();
    MemoryCharge charge(context.memory(),
                        elements.objects.size() * sizeof(Node) + meshes * (sizeof(Mesh) + sizeof(std::uint32_t)),
                        "the objects of an OBJ file");
    scene.nodes.resize(elements.objects.size());
    scene.meshes.reserve(meshes);
    for (std::size_t i = 0; i < elements.objects.size(); ++i) scene.nodes[i].name = elements.objects[i];
    std::set<std::pair<std::uint32_t, std::uint32_t>> without_normals;  // object and material
    for (ReadMesh& read : elements.meshes) {
        const MeshKey& key = read.key;
        scene.nodes[key.object].meshes.push_back(std::uint32_t(scene.meshes.size()));
        scene.meshes.push_back(finish_mesh(read, data, origin, remarks, elements.charge, context));
        const std::string& name = elements.objects[key.object];
        charge.grow(name.size(), "the names of an OBJ file");  // each mesh has its own copy
        scene.meshes.back().name = name;
        if (key.topology == Topology::triangles && !key.has_normals) without_normals.emplace(key.object, key.material);
    }
    for (const ReadMesh& m : elements.meshes)
        if (m.key.has_normals && without_normals.count({m.key.object, m.key.material}))
            remarks.add(Issue::normals_missing, 0);
    scene.charges.push_back(share(std::move(charge)));
}

/// @param kept  null: nothing of the text is needed later
Scene scene_of(std::string_view text, const std::string& path, const ReadOptions& options, Remarks& remarks,
               Context& context, std::size_t chunk_bytes, KeptObj* kept) {
    Contents contents = count_contents(text, remarks, context, chunk_bytes);
    if (contents.elements == 0) {
        VertexData points = contents.positions > 0 ? read_vertices(text, contents, remarks, context) : VertexData{};
        Scene cloud;
        cloud.source = path;
        if (is_point_cloud(contents, points)) {
            add_points(cloud, points, std::filesystem::path(path).stem().string(), context);
            return cloud;
        }
        throw Error(ErrorCode::bad_file, "nothing to draw: the file has no faces, lines or points");
    }
    Scene scene;
    scene.source = path;
    MaterialLibrary library(scene, path, options.allow_outside, context);
    for (const std::string& argument : contents.libraries) library.load(argument);
    VertexData data = read_vertices(text, contents, remarks, context);
    const FindMaterial find = [&](const std::string& name, std::uint64_t line) { return library.find(name, line); };
    const std::string stem = std::filesystem::path(path).stem().string();
    Elements elements = read_elements(text, contents, data, stem, find, remarks, context, kept != nullptr);
    library.finish();
    if (elements.drawable == 0)
        throw Error(ErrorCode::bad_file, "nothing to draw: no face, line or point has valid and finite corners");
    add_objects(scene, elements, data, remarks, context);
    show_vertex_colors(scene, library.have_invented_color(), context);
    if (kept) {
        VertexData normals;
        normals.charge = data.charge.split(data.normals.size() * sizeof(vec3));
        normals.normals = std::move(data.normals);
        kept->contents = std::move(contents);
        kept->data = std::move(normals);
        kept->elements = std::move(elements);
    }
    return scene;
}

Scene read_text(std::string_view text, const std::string& path, const ReadOptions& options, Context& context,
                std::size_t chunk_bytes, KeptObj* kept) {
    Remarks remarks(path);
    try {
        Scene scene = scene_of(text, path, options, remarks, context, chunk_bytes, kept);
        remarks.flush(context.report());
        return scene;
    } catch (const Error& e) {
        remarks.flush(context.report());
        throw e.with_file(path);
    }
}

}  // namespace

namespace obj {

Scene read_obj_text(std::string_view text, const std::string& path, const ReadOptions& options, Context& context,
                    std::size_t chunk_bytes) {
    return read_text(text, path, options, context, chunk_bytes, nullptr);
}

}  // namespace obj

namespace {

Scene read_obj(const std::string& path, const ReadOptions& options, Context& context) {
    const Bytes bytes = read_file(path, context);
    const auto text = std::make_shared<const PlainText>(
        std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()), path, context);
    if (!options.keep_obj) return obj::read_obj_text(text->view(), path, options, context);
    const auto kept = std::make_shared<KeptObj>();
    kept->bytes = bytes;
    kept->text = text;
    Scene scene = read_text(text->view(), path, options, context, usual_chunk_bytes, kept.get());
    *options.keep_obj = kept;
    return scene;
}

Scene read_obj_bytes(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return obj::read_obj_text(PlainText(text, path, context).view(), path, options, context);
}

}  // namespace

constinit const ModelReader obj_reader = {.read_bytes = read_obj_bytes, .read_file = read_obj};

}  // namespace rakelight::io
