// SPDX-License-Identifier: Apache-2.0
// Scenes that are wrong, and every public function that takes one.
#pragma once
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>
#include <rakelight/tools/check_scene.h>
#include <rakelight_internal/tools/bench_render.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "support/scene_builder.h"
#include "support/temporary_folder.h"

namespace rakelight::test {

inline constexpr float nan_f = std::numeric_limits<float>::quiet_NaN(), inf_f = std::numeric_limits<float>::infinity();
inline constexpr double nan_d = nan_f, inf_d = inf_f;

using Points = std::vector<vec3>;
using Numbers = std::vector<std::uint32_t>;

inline constexpr int most = std::numeric_limits<int>::max();

/// An enumerator that there is not.
template <class E>
E no_such() {
    return E(99);
}

/// A triangle with texture coordinates, a material, a light and a camera that sees it.
inline Scene triangle_scene() {
    Scene s;
    s.source = "triangle";
    Mesh& m = s.meshes.emplace_back();
    m.positions = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    m.indices = Numbers{0, 1, 2};
    m.texcoords = {std::vector<vec2>{{0, 0}, {1, 0}, {0, 1}}};
    m.material = 0;
    s.nodes.emplace_back().meshes = {0};
    s.materials.emplace_back();
    s.lights.emplace_back().position = {1, 1, 3};
    s.cameras.emplace_back().to_world[3] = {0.3, 0.3, 3, 1};
    return s;
}

inline RenderSettings small_settings() { return {.width = 24, .height = 16}; }

struct Fault {
    const char* name;
    std::function<void(Scene&)> spoil;
    const char* message = "";  ///< part of the error that every door throws
};

/// What gtest shows in place of the bytes of the structure.
inline void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

inline std::string name_of_fault(const testing::TestParamInfo<Fault>& info) { return info.param.name; }

inline void add_skin(Scene& s, JointInfluence influence, Skin skin) {
    s.meshes[0].influences = std::vector<JointInfluence>(3, influence);
    s.skins.push_back(std::move(skin));
    s.nodes[0].skin = 0;
}

inline JointInfluence follow(std::uint16_t joint) { return {{joint, joint, joint, joint}, {1, 0, 0, 0}}; }

inline void add_target(Scene& s, Points positions, std::vector<float> weights) {
    s.meshes[0].targets = test::with(s.meshes[0].targets, MorphTarget{"", std::move(positions), {}, {}});
    s.nodes[0].morph_weights = std::move(weights);
}

/// A function of the library that takes a scene.
struct Door {
    const char* name;
    std::function<void(const Scene&, Context&)> open;
};

inline Inspection seams_of_triangle() {
    Inspection i;
    i.seam_lines.push_back({{0, 0, 0}, {1, 0, 0}, 10, 20});
    return i;
}

inline void draw_with_engine(const Scene& scene, Context& context) {
    const std::unique_ptr<Engine> engine = make_engine("soft");
    engine->prepare(scene, context);
    Camera camera;
    camera.to_world[3] = {0.3, 0.3, 3, 1};
    RenderSettings settings = small_settings();
    settings.shadows = true;
    settings.channels = channels_all;
    Frame frame;
    engine->render(camera, settings, frame, context);
}

inline const std::vector<Door>& doors() {
    static const std::vector<Door> all{
        {"validate", [](const Scene& s, Context&) { validate(s); }},
        {"render", [](const Scene& s, Context& c) { (void)render(s, small_settings(), c); }},
        {"render by a camera", [](const Scene& s, Context& c) { (void)render(s, Camera{}, small_settings(), c); }},
        {"Engine::prepare", [](const Scene& s, Context& c) { draw_with_engine(s, c); }},
        {"smooth", [](const Scene& s, Context& c) { (void)smooth(s, {}, c); }},
        {"prepare_scene", [](const Scene& s, Context& c) { (void)prepare_scene(s, {}, c); }},
        {"prepare_scene, all of it",
         [](const Scene& s, Context& c) {
             (void)prepare_scene(s,
                                 {.normals = NormalSource::model,
                                  .uv = UvProjection::box,
                                  .measure_orthogonality = true,
                                  .all_tangents = true,
                                  .subdivision = {.level = 1},
                                  .displacement = {.is_on = true, .max_triangles = 1000}},
                                 c);
         }},
        {"choose_camera", [](const Scene& s, Context& c) { (void)choose_camera(s, {}, 1.5, c); }},
        {"choose_camera, a side",
         [](const Scene& s, Context& c) { (void)choose_camera(s, {.side = "front"}, 1.5, c); }},
        {"override_materials", [](const Scene& s, Context& c) { (void)override_materials(s, {.roughness = 0.5}, c); }},
        {"inspect", [](const Scene& s, Context& c) { (void)inspect(s, {}, c); }},
        {"draw_seams",
         [](const Scene& s, Context& c) { (void)draw_seams(s, seams_of_triangle(), {}, {}, small_settings(), c); }},
        {"summarize", [](const Scene& s, Context&) { (void)summarize(s); }},
        {"check_picture", [](const Scene& s, Context& c) { check_picture(s, {}, c); }},
    };
    return all;
}

/// The call throws Error usage with this in its text.
inline void expect_usage(const std::string& name, const std::string& wanted, const std::function<void()>& call) {
    try {
        call();
        ADD_FAILURE() << name << " was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::usage) << name << ": " << error.what();
        EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << name << ": " << error.what();
    }
}

/// A picture that nobody gets to write.
inline std::string unwritten() {
    static const TemporaryFolder folder;
    return folder.file("misused.png");
}

}  // namespace rakelight::test
