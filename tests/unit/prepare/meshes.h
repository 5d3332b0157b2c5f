// SPDX-License-Identifier: Apache-2.0
// Minimal scenes for the tests of prepare, and questions to a report.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include <cmath>
#include <string>

#include "math/linear.h"
#include "unit/scene/scenes.h"

namespace rakelight::test {

/// Upright, with a second set of texture coordinates that is turned by a quarter.
inline Mesh textured_quad() {
    Mesh mesh = quad_mesh();
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    mesh.texcoords.emplace_back(std::vector<vec2>{{1, 1}, {1, 0}, {0, 0}, {0, 1}});
    return mesh;
}

/// Two unit squares that share the edge x = 1, the second folded by `angle_rad` about it; six vertices.
inline Mesh folded_mesh(double angle_rad) {
    const float x = float(1 + std::cos(angle_rad)), z = float(-std::sin(angle_rad));
    Mesh mesh;
    mesh.name = "folded";
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {x, 0, z}, {x, 1, z}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    return mesh;
}

/// The cube -1..1 with 8 vertices and 12 triangles.
inline Mesh cube_mesh() {
    Mesh mesh;
    mesh.name = "cube";
    std::vector<vec3> positions;
    for (int i = 0; i < 8; ++i) positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
    mesh.positions = std::move(positions);
    mesh.indices = std::vector<std::uint32_t>{4, 5, 7, 4, 7, 6, 1, 0, 2, 1, 2, 3, 5, 1, 3, 5, 3, 7,
                                              0, 4, 6, 0, 6, 2, 6, 7, 3, 6, 3, 2, 0, 1, 5, 0, 5, 4};
    return mesh;
}

/// A ball about the origin: `around` columns, `rings` rows, one vertex a place (no seam), poles shared.
inline Mesh ball_mesh(int around, int rings) {
    Mesh mesh;
    mesh.name = "ball";
    std::vector<vec3> p{{0, 1, 0}};
    std::vector<std::uint32_t> index;
    for (int r = 1; r < rings; ++r)
        for (int c = 0; c < around; ++c) {
            const double theta = pi * r / rings, phi = 2 * pi * c / around;
            p.push_back({float(std::sin(theta) * std::sin(phi)), float(std::cos(theta)),
                         float(std::sin(theta) * std::cos(phi))});
        }
    p.push_back({0, -1, 0});
    const auto at = [&](int r, int c) { return std::uint32_t(1 + (r - 1) * around + c % around); };
    const auto last = std::uint32_t(p.size() - 1);
    for (int c = 0; c < around; ++c) {
        index.insert(index.end(), {0, at(1, c), at(1, c + 1)});
        for (int r = 1; r + 1 < rings; ++r)
            index.insert(index.end(),
                         {at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c), at(r + 1, c + 1), at(r, c + 1)});
        index.insert(index.end(), {at(rings - 1, c), last, at(rings - 1, c + 1)});
    }
    mesh.positions = std::move(p);
    mesh.indices = std::move(index);
    return mesh;
}

/// A scene of these meshes, one node each.
inline Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.source = "made.test";
    scene.meshes = std::move(meshes);
    for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
        Node node;
        node.meshes = {i};
        scene.nodes.push_back(node);
    }
    return scene;
}

/// A material with a texture in one role, for all meshes of the scene.
inline TextureUse& give_texture(Scene& scene, TextureUse Material::*role, std::uint32_t set = 0) {
    scene.textures.push_back({"texture", any_image(), {}});
    scene.materials.emplace_back();
    for (Mesh& mesh : scene.meshes) mesh.material = std::uint32_t(scene.materials.size() - 1);
    TextureUse& use = scene.materials.back().*role;
    use.texture = 0;
    use.texcoord_set = set;
    return use;
}

/// Remarks of a kind whose message has these words.
inline std::uint64_t remarks(Context& context, Remark remark, const std::string& words) {
    std::uint64_t count = 0;
    for (const ReportEntry& e : context.report().entries())
        if (e.remark == remark && e.message.find(words) != std::string::npos) count += e.count;
    return count;
}

inline std::string all_remarks(Context& context) {
    std::string text;
    for (const ReportEntry& e : context.report().entries())
        text += std::string(name_of(e.remark)) + ": " + e.place + ": " + e.message + "\n";
    return text;
}

inline void expect_unit(const Block<vec3>& normals, std::size_t vertices) {
    ASSERT_EQ(normals.size(), vertices);
    for (const vec3& n : normals) EXPECT_NEAR(length(n), 1, 1e-5);
}

}  // namespace rakelight::test
