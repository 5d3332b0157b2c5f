// SPDX-License-Identifier: Apache-2.0
// A scene that moves, made in code, for tests of poses.
#pragma once
#include <rakelight/engines/engine.h>

#include <algorithm>
#include <cmath>

#include "support/scene_builder.h"

namespace rakelight::test {

/// An arm of two bones along y, closed about, with a target that swells it. Normals and tangents of its own.
inline Scene arm() {
    constexpr std::size_t rings = 33, around = 24;
    std::vector<vec3> positions, normals, swelling, swelling_normals;
    std::vector<vec4> tangents;
    std::vector<JointInfluence> influences;
    std::vector<std::uint32_t> indices;
    for (std::size_t r = 0; r < rings; ++r)
        for (std::size_t a = 0; a <= around; ++a) {
            const double turn = 2 * pi * double(a) / double(around), y = 2.0 * double(r) / double(rings - 1);
            const auto c = float(std::cos(turn)), s = float(std::sin(turn));
            const auto bent = float(std::clamp(2 * y - 1.5, 0.0, 1.0));
            positions.push_back({0.3f * c, float(y), 0.3f * s}), normals.push_back({c, 0, s});
            tangents.push_back({-s, 0, c, a % 2 ? 1.0f : -1.0f});
            influences.push_back({{0, 1, 0, 0}, {1 - bent, bent, 0, 0}});
            const auto bulge = float(0.2 * std::exp(-8 * (y - 1) * (y - 1)));
            swelling.push_back({bulge * c, 0, bulge * s});
            swelling_normals.push_back({0, float(1.5 * (y - 1)) * bulge, 0});
            const auto at = std::uint32_t(r * (around + 1) + a), up = at + std::uint32_t(around + 1);
            if (r + 1 < rings && a < around) indices.insert(indices.end(), {at, up, at + 1, at + 1, up, up + 1});
        }
    Scene scene;
    Mesh mesh;
    mesh.targets = {{"swell", std::move(swelling), std::move(swelling_normals), {}}};
    mesh.positions = std::move(positions), mesh.normals = std::move(normals), mesh.tangents = std::move(tangents);
    mesh.influences = std::move(influences), mesh.indices = std::move(indices);
    scene.materials = {test::matte({0.7f, 0.5f, 0.3f})};
    mesh.material = 0;
    const std::uint32_t node = test::add_object(scene, std::move(mesh), translation(dvec3{9, 9, 9}));  // does not count
    scene.nodes[node].skin = 0, scene.nodes[node].morph_weights = {0};
    Node joint;
    scene.nodes.push_back(joint);
    joint.parent = 1, joint.local.translation = {0, 1, 0};
    scene.nodes.push_back(joint);
    scene.skins.push_back({"bones", {1, 2}, {dmat4{}, translation(dvec3{0, -1, 0})}});
    test::add_object(scene, test::square_mesh(0), translation(dvec3{0, 1, -1}));
    scene.lights = {test::directional({-1, -1, -2}), test::directional({1, 0.2, -0.5}, {0.3f, 0.3f, 0.5f})};
    return scene;
}

/// @param bend  [rad] of the upper bone
inline Scene bent(Scene scene, double bend, float swollen = 0) {
    ScenePose pose;
    for (const Node& node : scene.nodes)
        pose.local.push_back(node.local), pose.morph_weights.push_back(node.morph_weights);
    pose.local[2].rotation = {0, 0, std::sin(bend / 2), std::cos(bend / 2)};
    pose.morph_weights[0] = {swollen};
    scene.pose = pose;
    return scene;
}

inline Camera oblique() {
    Camera camera;
    camera.vertical_fov_rad = 0.8;
    camera.to_world = look_at({1.2, 1.9, 3.2}, {-0.2, 1, 0}, {0, 1, 0});
    return camera;
}

inline RenderSettings small() {
    RenderSettings s;
    s.width = 120, s.height = 90;
    return s;
}

}  // namespace rakelight::test
