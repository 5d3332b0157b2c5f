// SPDX-License-Identifier: Apache-2.0
// glTF files made in a test, saved with other normals.
#pragma once
#include "io/gltf/write/save_gltf.h"
#include "unit/io/gltf/gltf_support.h"

namespace rakelight::test {

/// The scene with the normal (0, 0, -1) everywhere.
inline Scene turned(Scene scene) {
    for (Mesh& mesh : scene.meshes) mesh.normals = std::vector<vec3>(mesh.positions.size(), vec3{0, 0, -1});
    return scene;
}

struct Saved {
    io::GltfSaveResult result;
    GltfFile::Json tree;
    Scene scene;
    std::string bytes;   ///< of the model file
    std::string binary;  ///< the binary chunk of a GLB file
};

/// What is computed for the file that was written: the same numbers as for its source, in the order of its meshes.
inline Scene rounded(Scene written, const Scene& computed) {
    if (written.meshes.size() != computed.meshes.size()) return written;
    for (std::size_t m = 0; m < written.meshes.size(); ++m) {
        written.meshes[m].normals = computed.meshes[m].normals;
        written.meshes[m].tangents = computed.meshes[m].tangents;
    }
    return written;
}

/// Saves `file` after `change`, reads it again, and saves that once more, which must change nothing.
template <class Change>
Saved save(GltfFile& file, Context& context, Change change, const std::string& output = "out.gltf",
           const io::GltfSaveOptions& options = {}) {
    const TemporaryFolder folder;
    const std::string json = file.text();
    folder.write("data.bin", file.data);
    const std::string source = folder.write("model.gltf", json), out = (folder.path() / output).string();
    const Scene before = io::gltf_reader.read(source, {}, context), after = change(before);
    Saved saved;
    saved.result = io::save_gltf(source, before, after, out, options, context);
    std::ifstream opened(out, std::ios::binary);
    saved.bytes.assign(std::istreambuf_iterator<char>(opened), {});
    const bool is_glb = saved.bytes.starts_with("glTF");
    std::uint32_t length = 0;
    if (is_glb) std::memcpy(&length, saved.bytes.data() + 12, 4);
    saved.tree = GltfFile::Json::parse(is_glb ? saved.bytes.substr(20, length) : saved.bytes);
    if (is_glb) saved.binary = saved.bytes.substr(28 + length);
    saved.scene = io::gltf_reader.read(out, {}, context);
    const std::string again = (folder.path() / ("again" + output.substr(output.rfind('.')))).string();
    EXPECT_FALSE(io::save_gltf(out, saved.scene, rounded(saved.scene, after), again, {}, context).changed);
    return saved;
}

}  // namespace rakelight::test
