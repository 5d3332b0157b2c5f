// SPDX-License-Identifier: Apache-2.0
// glTF 2.0: from the file to a scene. Everything is read from the nodes of the default scene downward, so parts that
// are not drawn are not read.
#include "io/gltf/read_gltf.h"

#include <algorithm>
#include <new>

#include "io/gltf/lights_cameras.h"
#include "io/gltf/motion/animations.h"
#include "io/gltf/nodes.h"
#include "io/model_readers.h"

namespace rakelight::io {
namespace gltf {
namespace {

bool draws_something(const Scene& scene) {
    return std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const Node& node) { return !node.meshes.empty(); });
}

Scene read_document(const std::string& path, Bytes file, const ReadOptions& options, Context& context) {
    const Document document(path, std::move(file), options, context);
    Scene scene;
    scene.source = path;
    scene.missing_normals_are_flat = true;  // glTF 2.0 specification, section 3.7.2.1
    Buffers buffers(document);
    Accessors accessors(document, buffers);
    Textures textures(document, buffers, scene);
    Materials materials(document, textures, scene);
    Meshes meshes(accessors, materials, scene);
    Nodes nodes(accessors, meshes, scene);
    context.progress("load", 0.2);
    nodes.read();
    if (!draws_something(scene))
        throw Error(ErrorCode::bad_file, "nothing to draw: no node of its scene holds a triangle, line or point");
    context.progress("load", 0.9);
    read_skins(accessors, meshes, nodes, scene);
    const std::vector<std::uint32_t> cameras = read_cameras(document, nodes, scene);
    const std::vector<std::uint32_t> lights = read_lights(document, nodes, scene);
    read_animations(accessors, {document, nodes, materials, cameras, lights, scene}, scene);
    scene.charges.push_back(share(std::move(document.scene_charge())));
    context.progress("load", 1);
    return scene;
}

}  // namespace

Scene read_gltf_bytes(const std::string& path, Bytes file, const ReadOptions& options, Context& context) {
    try {
        return read_document(path, std::move(file), options, context);
    } catch (const Error& error) {
        throw error.with_file(path);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(path);
    }
}

}  // namespace gltf

constinit const ModelReader gltf_reader = {.read_bytes = gltf::read_gltf_bytes};

}  // namespace rakelight::io
