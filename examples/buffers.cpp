// SPDX-License-Identifier: Apache-2.0
// A picture of buffers of your own: no file. Two squares that meet at a right angle become two objects of a scene.
//
//   buffers [PICTURE]      buffers.png by default
#include <cstdio>
#include <string>
#include <vector>

#include <rakelight/rakelight.h>

namespace {

/// One mesh at one node, as an object of its own.
void add_object(rakelight::Scene& scene, std::vector<rakelight::vec3> positions, rakelight::vec4 color) {
    rakelight::Material material;
    material.base_color = color;
    material.metallic_roughness.metallic = 0;
    material.double_sided = true;
    scene.materials.push_back(material);

    rakelight::Mesh mesh;
    mesh.positions = std::move(positions);  // moved in, never copied again: scenes share it
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    mesh.material = std::uint32_t(scene.materials.size() - 1);
    scene.meshes.push_back(std::move(mesh));

    rakelight::Node node;
    node.meshes = {std::uint32_t(scene.meshes.size() - 1)};
    scene.nodes.push_back(std::move(node));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        rakelight::Scene scene;
        add_object(scene, {{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}}, {0.8f, 0.3f, 0.2f, 1});
        add_object(scene, {{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}}, {0.2f, 0.4f, 0.8f, 1});

        rakelight::Context context;
        rakelight::RenderSettings settings;
        settings.width = 320;
        settings.height = 240;
        settings.samples = 4;
        rakelight::save(rakelight::render(scene, settings, context), argc > 1 ? argv[1] : "buffers.png");
        return 0;
    } catch (const rakelight::Error& error) {  // a wrong index, a size that does not fit: said with its place
        std::fprintf(stderr, "buffers: %s\n", error.what());
        return 1;
    }
}
