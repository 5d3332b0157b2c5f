// SPDX-License-Identifier: Apache-2.0
// Clips and skins that are broken on purpose: one clear line each, and no crash where they are evaluated all the same.
#include <rakelight/base/report.h>
#include <rakelight/scene/motion.h>
#include <rakelight/scene/validate.h>

#include <cmath>
#include <limits>

#include "unit/io/gltf/gltf_support.h"

namespace rakelight::test {
namespace {

using Json = GltfFile::Json;

struct Clip {
    std::vector<float> times = {0, 1};
    std::vector<float> values = {0, 0, 0, 1, 2, 3};
    std::size_t width = 3;
    const char* interpolation = "LINEAR";
    Json target = {{"node", 0}, {"path", "translation"}};
};

GltfFile with(const Clip& clip) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {Json::object()};
    const int input = file.accessor(clip.times, f32, 1), output = file.accessor(clip.values, f32, clip.width);
    file.root["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", clip.target}}}},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", clip.interpolation}}}}}};
    return file;
}

Json pointer(const std::string& to) {
    Json target = {{"path", "pointer"}};
    target["extensions"]["KHR_animation_pointer"]["pointer"] = to;
    return target;
}

/// The model is there, the clip is not, and one line says why.
void expect_dropped(const Clip& clip, const std::string& why) {
    Context context({.threads = 1});
    const Scene scene = with(clip).load(context);
    ASSERT_EQ(scene.animations.size(), 1u) << "others keep their numbers";
    EXPECT_TRUE(scene.animations[0].channels.empty()) << why;
    EXPECT_EQ(scene.meshes.size(), 1u);
    const auto entries = context.report().entries();
    ASSERT_EQ(entries.size(), 1u) << why;
    EXPECT_EQ(entries[0].remark, Remark::dropped);
    EXPECT_NE(entries[0].message.find(why), std::string::npos) << entries[0].message;
    EXPECT_EQ(entries[0].message.find('\n'), std::string::npos);
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

TEST(HostileClips, KeysThatAreNoNumbersAreLeftOut) {
    expect_dropped({.values = {0, 0, 0, nan, 0, 0}}, "a key value is not finite");
    expect_dropped({.values = {0, 0, 0, 0, infinite, 0}}, "a key value is not finite");
    expect_dropped({.times = {0, nan}}, "its key times do not ascend at key 1");
    expect_dropped({.times = {nan, 1}}, "its key times do not ascend at key 0");
    expect_dropped({.times = {0, infinite}}, "its key times do not ascend at key 1");
}

TEST(HostileClips, TimesOutOfOrderAndCountsThatDoNotFitAreLeftOut) {
    expect_dropped({.times = {1, 0}}, "its key times do not ascend at key 1");
    expect_dropped({.times = {0, 1, 2}}, "it has 3 keys of 3 numbers, but 6 numbers");
    expect_dropped({.interpolation = "CUBICSPLINE"}, "it has 2 keys of 9 numbers, but 6 numbers");
    expect_dropped({.times = {}}, "it has no keys");
    expect_dropped({.values = {0, 1, 2, 3}, .width = 2}, "key values");
}

TEST(HostileClips, TargetsThatAreNotThereAreLeftOut) {
    expect_dropped({.target = {{"node", 7}, {"path", "translation"}}}, "node 7 does not exist (the file has 1)");
    expect_dropped({.values = {0, 1}, .width = 1, .target = pointer("/materials/3/alphaCutoff")},
                   "material 3 does not exist (the file has 1)");
    expect_dropped({.values = {0, 1}, .width = 1, .target = pointer("/cameras/0/perspective/yfov")},
                   "camera 0 does not exist (the file has 0)");
    expect_dropped({.values = {0, 1}, .width = 1, .target = pointer("/extensions/KHR_lights_punctual/lights/0/range")},
                   "light 0 does not exist (the file has 0)");
    expect_dropped({.target = pointer("/nodes/9/translation")}, "node 9 does not exist");
    expect_dropped({.target = {{"path", "pointer"}}}, "its path is 'pointer', but it has none");
}

TEST(HostileClips, PointersToNothingAreLeftOut) {
    for (const char* to :
         {"", "/", "/materials", "/materials/", "/materials/0", "/materials/0/", "/materials/-1/alphaCutoff",
          "/materials/x/alphaCutoff", "/materials/99999999999999999999/alphaCutoff", "/nodes/0/mesh",
          "materials/0/alphaCutoff", "/cameras/0/extensions/KHR_materials_emissive_strength/emissiveStrength"})
        expect_dropped({.target = pointer(to)}, "names cannot be animated");
    expect_dropped({.target = pointer("/materials/0/alphaCutoff")}, "key values");  // of three numbers
    expect_dropped({.target = pointer(std::string(100'000, '/'))}, "names cannot be animated");
}

TEST(HostileClips, NegativeTimesAreTimes) {
    const Scene scene = with({.times = {-2, -1}}).load();
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(clip_span(scene.animations[0]).begin_s, -2);
    const ClipTime clip{0, -1.5};
    EXPECT_EQ(scene_at(scene, std::span(&clip, 1)).pose->local[0].translation, (dvec3{0.5, 1, 1.5}));
}

TEST(HostileClips, TwoKeysAtOneTimeAreAStep) {
    const Scene scene = with({.times = {1, 1}}).load();
    for (const double time : {0.0, 1.0, 2.0}) {
        const ClipTime clip{0, time};
        const dvec3 t = scene_at(scene, std::span(&clip, 1)).pose->local[0].translation;
        EXPECT_EQ(t, time < 1 ? (dvec3{0, 0, 0}) : (dvec3{1, 2, 3}));
    }
}

TEST(HostileClips, AMillionKeysAreReadAndShown) {
    constexpr std::size_t count = 1'000'000;
    Clip clip{.times = std::vector<float>(count), .values = std::vector<float>(3 * count)};
    for (std::size_t k = 0; k < count; ++k) clip.times[k] = float(k) / 16, clip.values[3 * k] = float(k);
    const Scene scene = with(clip).load();
    ASSERT_EQ(scene.animations.at(0).channels[0].times.size(), count);
    const ClipTime moment{0, 1000.03125};  // half way from key 16000
    EXPECT_EQ(scene_at(scene, std::span(&moment, 1)).pose->local[0].translation.x, 16000.5);
}

TEST(HostileClips, SplinesWithHugeTangentsStayNumbers) {
    constexpr float most = std::numeric_limits<float>::max();
    const std::vector<float> values = {0, 0, 0, 0, 0, 0, most, -most, most, most, most, -most, 0, 0, 0, 0, 0, 0};
    const Scene scene = with({.times = {0, 1e30f}, .values = values, .interpolation = "CUBICSPLINE"}).load();
    const ClipTime clip{0, 5e29};
    const dvec3 t = scene_at(scene, std::span(&clip, 1)).pose->local[0].translation;
    EXPECT_TRUE(std::isfinite(t.x) && std::isfinite(t.y) && std::isfinite(t.z));
}

TEST(HostileClips, RotationsOfLengthZeroTurnNothing) {
    Clip clip{.values = std::vector<float>(8, 0.0f), .width = 4, .target = {{"node", 0}, {"path", "rotation"}}};
    const ClipTime moment{0, 0.5};
    const Scene scene = scene_at(with(clip).load(), std::span(&moment, 1));
    EXPECT_EQ(scene.pose->local[0].rotation, dquat{});
}

TEST(HostileClips, MaterialsThatAreMovedOutOfTheirRangeStayInIt) {
    Clip clip{.values = {-5, 1e30f, 0, 7, -5, 1e30f, 0, 7},
              .width = 4,
              .target = pointer("/materials/0/pbrMetallicRoughness/baseColorFactor")};
    const ClipTime moment{0, 0.5};
    const Scene scene = scene_at(with(clip).load(), std::span(&moment, 1));
    EXPECT_EQ(scene.materials[0].base_color, (vec4{0, 1e30f, 0, 1}));
    EXPECT_NO_THROW(validate(scene));
}

TEST(HostileSkins, WeightsThatSumToZeroAreSaidAndStandStill) {
    GltfFile file;
    const int joints = file.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, 0), u8, 4),
              weights = file.accessor<float>(std::vector<float>(12, 0.0f), f32, 4);
    Json& triangle = file.triangle();
    triangle["attributes"]["JOINTS_0"] = joints, triangle["attributes"]["WEIGHTS_0"] = weights;
    file.root["nodes"][0]["skin"] = 0;
    file.root["skins"] = {{{"joints", {0}}}};
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    EXPECT_NO_THROW(validate(scene));
    EXPECT_EQ(scene.nodes[0].skin, no_index) << "nothing follows a joint";
    EXPECT_TRUE(is_said(context, Remark::changed, "3 vertices have joint weights whose sum is zero"));
}

}  // namespace
}  // namespace rakelight::test
