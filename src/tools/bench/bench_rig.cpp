// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_rig.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/bench/bench_model.h"
#include "tools/bench/bench_textures.h"

namespace rakelight {
namespace {

constexpr double low = -1.3, high = 1.3;  // what the chain spans along Y, with the sphere in it
constexpr double bend_rad = 0.05;         // of each joint at the middle of the clip

/// The four joints nearest to a height, by a cubic's weights: they change smoothly, and depend on the place alone.
JointInfluence influence_of(float y, std::uint32_t joints) {
    const double at = (double(y) - low) / (high - low) * (joints - 1);
    const int first = std::clamp(int(std::floor(at)) - 1, 0, std::max(int(joints) - 4, 0));
    JointInfluence influence;
    double sum = 0, weight[4];
    for (int k = 0; k < 4; ++k) {
        const double away = std::min(1.0, std::fabs(at - (first + k)) / 2);
        weight[k] = first + k < int(joints) ? (1 - away) * (1 - away) * (1 + 2 * away) + 1e-3 : 0;
        sum += weight[k];
    }
    for (int k = 0; k < 4; ++k) {
        influence.weights[std::size_t(k)] = float(weight[k] / sum);
        influence.joints[std::size_t(k)] = std::uint16_t(weight[k] > 0 ? first + k : 0);
    }
    return influence;
}

/// A chain of nodes from below to above, and a clip that bends it to one side and back.
void add_skeleton(Scene& scene, std::uint32_t joints) {
    const double step = (high - low) / (joints - 1), sine = math::sin(bend_rad / 2), cosine = math::cos(bend_rad / 2);
    scene.skins.resize(1);
    scene.animations.resize(1);
    scene.animations[0].name = "bend";
    std::vector<dmat4> inverse_bind;
    for (std::uint32_t j = 0; j < joints; ++j) {
        Node node;
        node.name = "joint " + std::to_string(j);
        node.local.translation = {0, j == 0 ? low : step, 0};
        if (j > 0) node.parent = std::uint32_t(scene.nodes.size() - 1);
        AnimationChannel turn;
        turn.element = std::uint32_t(scene.nodes.size());
        turn.path = AnimationPath::rotation;
        turn.times = std::vector<float>{0, 0.5f, 1};
        turn.values = std::vector<float>{0, 0, 0, 1, 0, 0, float(sine), float(cosine), 0, 0, 0, 1};
        scene.animations[0].channels.push_back(std::move(turn));
        scene.skins[0].joints.push_back(std::uint32_t(scene.nodes.size()));
        inverse_bind.push_back(translation(dvec3{0, -(low + step * j), 0}));
        scene.nodes.push_back(std::move(node));
    }
    scene.skins[0].inverse_bind = std::move(inverse_bind);
}

}  // namespace

Scene make_bench_rig(std::uint64_t triangles, std::uint32_t objects, std::uint32_t joints) {
    Scene scene;
    scene.source = "a character made for measuring";
    BenchModel model = make_bench_sphere(triangles, objects, false);
    add_skeleton(scene, joints);
    scene.textures = make_bench_wall();
    Material wall;
    wall.name = "bricks";
    wall.model = MaterialModel::classical;
    wall.classical.specular = {0.35f, 0.35f, 0.35f};
    wall.base_color_texture.texture = 0, wall.normal_texture.texture = 1;
    scene.materials = {wall};
    for (BenchPart& part : model.parts) {
        std::vector<JointInfluence> influences;
        influences.reserve(part.positions.size());
        for (const vec3 p : part.positions) influences.push_back(influence_of(p.y, joints));
        Mesh mesh;
        mesh.positions = std::move(part.positions), mesh.indices = std::move(part.indices);
        mesh.texcoords = {std::move(part.texcoords)};
        mesh.influences = std::move(influences);
        mesh.material = 0;
        Node node;
        node.name = "part " + std::to_string(scene.meshes.size());
        node.meshes = {std::uint32_t(scene.meshes.size())};
        node.skin = 0;
        scene.meshes.push_back(std::move(mesh));
        scene.nodes.push_back(std::move(node));
    }
    return scene;
}

}  // namespace rakelight
