// SPDX-License-Identifier: Apache-2.0
// Small scenes made in code, for tests of prepare and engines.
#pragma once
#include <rakelight/scene/scene.h>

#include <utility>
#include <vector>

#include "math/linear.h"

namespace rakelight::test {

/// Blocks are equal where they share an array; this one is compared by its values.
template <class T>
std::vector<T> values_of(const Block<T>& block) {
    return {block.begin(), block.end()};
}

/// A block with one more value at its end.
template <class T>
Block<T> with(const Block<T>& block, T value) {
    std::vector<T> values(block.begin(), block.end());
    values.push_back(std::move(value));
    return values;
}

/// A block after change(values).
template <class T, class Change>
Block<T> changed(const Block<T>& block, const Change& change) {
    std::vector<T> values(block.begin(), block.end());
    change(values);
    return values;
}

/// A square in the plane z = 0 facing +Z, side 2 about the origin, u to the right, v down, normals and tangents as glTF.
inline Mesh square_mesh(std::uint32_t material = no_index, float half = 1) {
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = std::vector<vec3>{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh.normals = std::vector<vec3>(4, vec3{0, 0, 1});
    mesh.tangents = std::vector<vec4>(4, vec4{1, 0, 0, 1});
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    mesh.material = material;
    return mesh;
}

inline Material matte(vec3 color = {1, 1, 1}) {
    Material m;
    m.name = "matte";
    m.model = MaterialModel::classical;
    m.base_color = {color.x, color.y, color.z, 1};
    m.classical.ambient = color;
    return m;
}

inline std::uint32_t add_object(Scene& scene, Mesh mesh, const dmat4& to_world = {}) {
    scene.meshes.push_back(std::move(mesh));
    Node node;
    node.name = "object " + std::to_string(scene.nodes.size());
    node.local.matrix = to_world;
    node.meshes = {std::uint32_t(scene.meshes.size() - 1)};
    scene.nodes.push_back(std::move(node));
    return std::uint32_t(scene.nodes.size() - 1);
}

inline Light directional(dvec3 direction, vec3 color = {1, 1, 1}) {
    Light light;
    light.type = LightType::directional;
    light.direction = direction;
    light.diffuse = light.specular = color;
    return light;
}

/// Sees the square from -1 to 1 exactly: parallel, from z = distance.
inline Camera flat_camera(double distance = 5) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.half_height = 1;
    camera.z_near = 0.1;
    camera.z_far = 100;
    camera.to_world = translation(dvec3{0, 0, distance});
    return camera;
}

/// A picture made in code: decode() gives these pixels.
inline ImageHandle picture(Pixels pixels, std::string name = "made in code") {
    auto image = std::make_shared<EncodedImage>();
    image->name = std::move(name);
    image->decode = [pixels = std::move(pixels)](const EncodedImage&, Context&) { return pixels; };
    return image;
}

/// RGB picture of `width` x `height` whose texel (x, y) is color(x, y), three bytes each.
template <class Color>
Pixels rgb_pixels(int width, int height, const Color& color) {
    Pixels p;
    p.width = width;
    p.height = height;
    p.channels = 3;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int c : color(x, y)) p.bytes.push_back(std::byte(c));
    return p;
}

/// Adds the picture as a texture and returns its use.
inline TextureUse add_texture(Scene& scene, ImageHandle image, Sampler sampler = {}) {
    scene.textures.push_back({"texture", std::move(image), sampler});
    TextureUse use;
    use.texture = std::uint32_t(scene.textures.size() - 1);
    return use;
}

}  // namespace rakelight::test
