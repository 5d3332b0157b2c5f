// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/scene/validate.h>

#include "unit/scene/scenes.h"

namespace rakelight {
namespace {

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The text of the error that validate() throws for a quad scene with one fault; empty if it throws none.
std::string fault(const std::function<void(Scene&)>& spoil) {
    Scene scene = test::quad_scene();
    spoil(scene);
    try {
        validate(scene);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::bad_file);
        return e.what();
    }
    return {};
}

void expect_fault(const std::string& part, const std::function<void(Scene&)>& spoil) {
    const std::string text = fault(spoil);
    EXPECT_NE(text.find(part), std::string::npos) << "wanted '" << part << "' in '" << text << "'";
}

TEST(Validate, AcceptsTheEmptySceneAndAWholeOne) {
    EXPECT_NO_THROW(validate(Scene{}));
    EXPECT_EQ(fault([](Scene&) {}), "");
}

TEST(Validate, NamesTheMeshAndTheFirstIndexOutOfRange) {
    expect_fault("mesh 0 'quad': index 4 at corner 5 exceeds 4 vertices",
                 [](Scene& s) { s.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 4}; });
    expect_fault("index 4294967295 at corner 0", [](Scene& s) {
        s.meshes[0].indices = std::vector<std::uint32_t>{no_index, 1, 2};
    });
    expect_fault("index 0 at corner 0 exceeds 0 vertices", [](Scene& s) { s.meshes[0].positions = {}; });
}

TEST(Validate, RefusesIndexCountsThatDoNotFitTheTopology) {
    expect_fault("4 indices are not a multiple of 3", [](Scene& s) {
        s.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2, 3};
    });
    expect_fault("3 indices are not a multiple of 2", [](Scene& s) {
        s.meshes[0].topology = Topology::lines;
        s.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2};
    });
    EXPECT_EQ(fault([](Scene& s) {
                  s.meshes[0].topology = Topology::points;
                  s.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2, 3, 3};
              }),
              "");
}

TEST(Validate, RefusesVertexArraysOfAnotherSize) {
    expect_fault("3 normals for 4 vertices", [](Scene& s) { s.meshes[0].normals = std::vector<vec3>(3); });
    expect_fault("5 tangents for 4 vertices", [](Scene& s) { s.meshes[0].tangents = std::vector<vec4>(5); });
    expect_fault("1 texture coordinates for 4", [](Scene& s) { s.meshes[0].texcoords = {{}, std::vector<vec2>(1)}; });
    expect_fault("8 colors for 4", [](Scene& s) { s.meshes[0].colors = std::vector<vec4>(8); });
    expect_fault("3 smoothing groups for 2 triangles",
                 [](Scene& s) { s.meshes[0].smoothing = std::vector<std::uint32_t>(3); });
    expect_fault("3 polygon numbers for 2 triangles",
                 [](Scene& s) { s.meshes[0].polygons = std::vector<std::uint32_t>(3); });
    expect_fault("2 smoothing hints for 6 corners",
                 [](Scene& s) { s.meshes[0].smoothing_hint = std::vector<vec3>(2); });
    expect_fault("1 joint influences for 4", [](Scene& s) { s.meshes[0].influences = std::vector<JointInfluence>(1); });
    expect_fault("1 morph normals for 4", [](Scene& s) { s.meshes[0].targets = {{"", {}, std::vector<vec3>(1), {}}}; });
}

TEST(Validate, RefusesParentsThatDoNotComeFirst) {
    expect_fault("node 0 'object': parent 0 does not come before its child", [](Scene& s) { s.nodes[0].parent = 0; });
    expect_fault("parent 7 does not come", [](Scene& s) { s.nodes[0].parent = 7; });
}

TEST(Validate, RefusesReferencesToWhatIsNotThere) {
    expect_fault("node 0 'object': mesh 1 does not exist (there are 1)", [](Scene& s) { s.nodes[0].meshes = {1}; });
    expect_fault("skin 0 does not exist", [](Scene& s) { s.nodes[0].skin = 0; });
    expect_fault("material 1 does not exist", [](Scene& s) { s.meshes[0].material = 1; });
    expect_fault("normal texture 1 does not exist", [](Scene& s) { s.materials[0].normal_texture.texture = 1; });
    expect_fault("anisotropy texture 9",
                 [](Scene& s) { s.materials[0].metallic_roughness.anisotropy_texture.texture = 9; });
    expect_fault("texture 0 'texture': it has no image", [](Scene& s) { s.textures[0].image = nullptr; });
    expect_fault("light 0: node 3", [](Scene& s) { s.lights[0].node = 3; });
    expect_fault("camera 0: node 3", [](Scene& s) { s.cameras[0].node = 3; });
    expect_fault("skin 0: joint 1", [](Scene& s) { s.skins.push_back({"", {1}, {dmat4{}}}); });
    expect_fault("0 inverse bind matrices for 1 joints", [](Scene& s) { s.skins.push_back({"", {0}, {}}); });
}

TEST(Validate, RefusesNumbersThatAreNotFinite) {
    expect_fault("node 0 'object': the translation", [](Scene& s) { s.nodes[0].local.translation.y = infinity; });
    expect_fault("the rotation", [](Scene& s) { s.nodes[0].local.rotation.w = nan_f; });
    expect_fault("the matrix", [](Scene& s) {
        s.nodes[0].local.matrix = dmat4{};
        (*s.nodes[0].local.matrix)[3].w = nan_f;
    });
    expect_fault("mesh 0 'quad': the origin", [](Scene& s) { s.meshes[0].origin.x = nan_f; });
    expect_fault("material 0: the base color", [](Scene& s) { s.materials[0].base_color.w = nan_f; });
    expect_fault("a texture transform",
                 [](Scene& s) { s.materials[0].base_color_texture.transform.rotation_rad = nan_f; });
    expect_fault("light 0: a color", [](Scene& s) { s.lights[0].diffuse.z = nan_f; });
    expect_fault("light 0: the range", [](Scene& s) { s.lights[0].range = nan_f; });
    expect_fault("the color", [](Scene& s) { s.fog.color.x = nan_f; });
    expect_fault("a parameter", [](Scene& s) { s.fog.end = std::numeric_limits<float>::infinity(); });
    expect_fault("the density is negative", [](Scene& s) { s.fog.density = -1; });
    expect_fault("camera 0: the matrix", [](Scene& s) { s.cameras[0].to_world[1].x = nan_f; });
    EXPECT_EQ(fault([](Scene& s) { s.lights[0].range = std::numeric_limits<float>::infinity(); }), "");
}

TEST(Validate, RefusesAWorldMatrixThatOverflows) {
    expect_fault("node 1: the world matrix is not finite", [](Scene& s) {
        s.nodes[0].local.scale = {1e200, 1e200, 1e200};
        Node child;
        child.parent = 0;
        child.local.scale = {1e200, 1e200, 1e200};
        s.nodes.push_back(child);
    });
}

TEST(Validate, LeavesPositionsAndNormalsThatAreNotFiniteToPrepare) {
    EXPECT_EQ(fault([](Scene& s) {
                  s.meshes[0].positions = std::vector<vec3>(4, {nan_f, 0, 0});
                  s.meshes[0].normals = std::vector<vec3>(4, {nan_f, 0, 0});
              }),
              "");
}

TEST(Validate, RefusesImpossibleCamerasAndLights) {
    expect_fault("near must be", [](Scene& s) { s.cameras[0].z_far = 0.05; });
    expect_fault("near must be greater than 0", [](Scene& s) { s.cameras[0].z_near = 0; });
    expect_fault("field of view", [](Scene& s) { s.cameras[0].vertical_fov_rad = pi; });
    for (const double angle : {0.0, -1.0, pi, double(nan_f), double(infinity)})
        expect_fault("horizontal field of view", [&](Scene& s) { s.cameras[0].horizontal_fov_rad = angle; });
    for (const double half : {0.0, -1.0, double(nan_f), double(infinity)})
        expect_fault("visible width", [&](Scene& s) {
            s.cameras[0].projection = Projection::orthographic;
            s.cameras[0].half_width = half;
        });
    expect_fault("visible height", [](Scene& s) {
        s.cameras[0].projection = Projection::orthographic;
        s.cameras[0].half_height = 0;
    });
    expect_fault("aspect", [](Scene& s) { s.cameras[0].aspect = -1; });
    expect_fault("direction is zero", [](Scene& s) {
        s.lights[0].type = LightType::spot;
        s.lights[0].direction = {0, 0, 0};
    });
    EXPECT_EQ(fault([](Scene& s) { s.cameras[0].z_far = infinity; }), "");
    EXPECT_EQ(fault([](Scene& s) {
                  s.cameras[0].projection = Projection::orthographic;
                  s.cameras[0].z_near = -5;
              }),
              "");
}

TEST(Validate, ChecksJointsOfASkinnedNodeButNotThoseOfWeightZero) {
    const auto with_joint = [](float weight) {
        return [weight](Scene& s) {
            s.skins.push_back({"bones", {0}, {dmat4{}}});
            s.nodes[0].skin = 0;
            JointInfluence influence;
            influence.joints[2] = 5;
            influence.weights[2] = weight;
            s.meshes[0].influences = std::vector<JointInfluence>(4, influence);
        };
    };
    expect_fault("mesh 0 'quad': joint 5 exceeds the 1 joints of skin 0", with_joint(0.5f));
    EXPECT_EQ(fault(with_joint(0)), "");
}

TEST(Validate, ChecksKeysOfAnimations) {
    const auto channel = [](std::vector<float> times, std::size_t values,
                            Interpolation interpolation = Interpolation::linear) {
        return [=](Scene& s) {
            AnimationChannel c;
            c.element = 0;
            c.path = AnimationPath::rotation;
            c.interpolation = interpolation;
            c.times = times;
            c.values = std::vector<float>(values);
            s.animations.push_back({"spin", {c}});
        };
    };
    EXPECT_EQ(fault(channel({0, 1}, 8)), "");
    EXPECT_EQ(fault(channel({0, 1}, 24, Interpolation::cubic_spline)), "");
    EXPECT_EQ(fault(channel({}, 0)), "");
    expect_fault("animation 0 'spin': 7 values of a channel for 8 expected", channel({0, 1}, 7));
    expect_fault("do not ascend", channel({1, 0}, 8));
    expect_fault("a key's time", channel({0, nan_f}, 8));
}

TEST(Validate, ChecksSharedNumbersOnceInEachUse) {
    const Block<float> ascending(std::vector<float>{0, 1}), falling(std::vector<float>{1, 0});
    const auto channels = [](Block<float> times, Block<float> first_values, Block<float> second_times,
                             Block<float> second_values) {
        return [=](Scene& s) {
            AnimationChannel a, b;
            a.element = b.element = 0;
            a.path = b.path = AnimationPath::morph_weights;
            s.nodes[0].morph_weights = {0};
            for (std::uint32_t m : s.nodes[0].meshes) s.meshes[m].targets = {MorphTarget{}};
            a.times = times, a.values = first_values, b.times = second_times, b.values = second_values;
            s.animations.push_back({"one", {a}});
            s.animations.push_back({"two", {b}});
        };
    };
    EXPECT_EQ(fault(channels(ascending, falling, ascending, falling)), "");
    expect_fault("animation 1 'two': the times of a channel do not ascend",
                 channels(ascending, falling, falling, falling));
    expect_fault("animation 1 'two': 3 values", channels(ascending, falling, ascending, std::vector<float>{0, 0, 0}));
}

TEST(Validate, MakesNamesSafeForOneLine) {
    expect_fault("mesh 0 'a?b'", [](Scene& s) {
        s.meshes[0].name = "a\nb";
        s.meshes[0].material = 5;
    });
}

}  // namespace
}  // namespace rakelight
