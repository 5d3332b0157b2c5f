// SPDX-License-Identifier: Apache-2.0
// OBJ -> scene, in three passes over the text: count, vertices, faces. See README.md beside.
#include <filesystem>
#include <set>
#include <string_view>

#include "io/file.h"
#include "io/obj/mtl_materials.h"
#include "io/obj/obj_faces.h"
#include "io/obj/obj_vertices.h"
#include "io/obj/read_obj.h"
#include "io/reader.h"

namespace rakelight::io {
namespace {

using namespace obj;

void add_objects(Scene& scene, Elements& elements, const VertexData& data, bool has_smoothing, Remarks& remarks,
                 Context& context) {
    const dvec3 origin = choose_origin(data.positions, elements.meshes.meshes());
    const std::size_t meshes = elements.meshes.meshes().size();
    MemoryCharge charge(context.memory(),
                        elements.objects.size() * sizeof(Node) + meshes * (sizeof(Mesh) + sizeof(std::uint32_t)),
                        "the objects of an OBJ file");
    scene.nodes.resize(elements.objects.size());
    scene.meshes.reserve(meshes);
    for (std::size_t i = 0; i < elements.objects.size(); ++i) scene.nodes[i].name = elements.objects[i];
    std::set<std::pair<std::uint32_t, std::uint32_t>> without_normals;  // object and material
    for (GrowingMesh& growing : elements.meshes.meshes()) {
        const MeshKey& key = growing.key;
        scene.nodes[key.object].meshes.push_back(std::uint32_t(scene.meshes.size()));
        scene.meshes.push_back(finish_mesh(growing, data, origin, has_smoothing, remarks, elements.charge, context));
        const std::string& name = elements.objects[key.object];
        charge.grow(name.size(), "the names of an OBJ file");  // each mesh has its own copy
        scene.meshes.back().name = name;
        if (key.topology == Topology::triangles && !key.has_normals) without_normals.emplace(key.object, key.material);
    }
    for (const GrowingMesh& m : elements.meshes.meshes())
        if (m.key.has_normals && without_normals.count({m.key.object, m.key.material}))
            remarks.add(Issue::normals_missing, 0);
    scene.charges.push_back(share(std::move(charge)));
}

Scene scene_of(std::string_view text, const std::string& path, const ReadOptions& options, Remarks& remarks,
               Context& context) {
    const Contents contents = count_contents(text, remarks, context);
    if (contents.elements == 0)
        throw Error(ErrorCode::bad_file, "nothing to draw: the file has no faces, lines or points");
    Scene scene;
    scene.source = path;
    MaterialLibrary library(scene, path, options.allow_outside, context);
    for (const std::string& argument : contents.libraries) library.load(argument);
    const VertexData data = read_vertices(text, contents, remarks, context);
    const FindMaterial find = [&](const std::string& name, std::uint64_t line) { return library.find(name, line); };
    const std::string stem = std::filesystem::path(path).stem().string();
    Elements elements = read_elements(text, contents, data, stem, find, remarks, context);
    library.finish();
    if (elements.drawable == 0)
        throw Error(ErrorCode::bad_file, "nothing to draw: no face, line or point has valid and finite corners");
    add_objects(scene, elements, data, contents.has_smoothing, remarks, context);
    return scene;
}

}  // namespace

namespace obj {

Scene read_obj_text(std::string_view text, const std::string& path, const ReadOptions& options, Context& context) {
    Remarks remarks(path);
    try {
        Scene scene = scene_of(text, path, options, remarks, context);
        remarks.flush(context.report());
        return scene;
    } catch (const Error& e) {
        remarks.flush(context.report());
        throw e.with_file(path);
    }
}

}  // namespace obj

Scene read_obj(const std::string& path, const ReadOptions& options, Context& context) {
    const Bytes bytes = read_file(path, context);
    return read_obj_text({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path, options, context);
}

}  // namespace rakelight::io
