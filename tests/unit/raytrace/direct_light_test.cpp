// SPDX-License-Identifier: Apache-2.0
// Direct light against closed forms, seen from the eye and in a mirror: rays that come from a surface are lit alike.
#include <gtest/gtest.h>

#include <cmath>

#include "engines/raytrace/raytrace_engine.h"
#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {
namespace {

/// A place on the square z = 0, whose normal is +Z, seen from above and from a side; the second time over a mirror in z = 5.
struct Seen {
    vec3 straight, mirrored;
};

vec3 color_at(const Scene& scene, dvec3 from, dvec3 to, RenderSettings settings) {
    Camera camera;
    camera.to_world = look_at(from, to, {0, 1, 0});
    camera.vertical_fov_rad = 1e-4;
    camera.z_near = 1e-3, camera.z_far = 1e3;
    settings.width = settings.height = 1;
    settings.background = {0, 0, 0, 1};
    Context context({.threads = 1});
    const auto engine = make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    return frame.color[0].xyz();
}

/// The eye stands at (-3, 0, 4) as seen from the place; the mirror's image of it stands there, too.
constexpr dvec3 eye{-3, 0, 4};

class DirectLight : public testing::Test {
protected:
    DirectLight() {
        scene_.materials = {test::matte({0.5f, 0.25f, 1})};
        scene_.materials[0].classical.specular = {};
        scene_.materials[0].classical.ambient = {1, 0.5f, 0.25f};
        test::add_object(scene_, test::square_mesh(0, 1));
    }
    void expect(vec3 wanted, RenderSettings settings = {}, double near = 1e-5) {
        const vec3 straight = color_at(scene_, eye, {0, 0, 0}, settings);
        Scene with_mirror = scene_;
        Material mirror = test::matte({0, 0, 0});
        mirror.classical.ambient = {}, mirror.classical.specular = {1, 1, 1},
        mirror.classical.mirror = Mirror::constant;
        mirror.lighting = Lighting::phong, mirror.classical.shininess = 1e4f, mirror.double_sided = true;
        with_mirror.materials.push_back(mirror);
        const auto number = std::uint32_t(with_mirror.materials.size() - 1);
        test::add_object(with_mirror, test::square_mesh(number, 0.5f), translation(dvec3{-6, 0, 8}));
        // From (-9, 0, 4) up to the mirror at (-6, 0, 8) and down to the place, which it reaches as from `eye`.
        const vec3 mirrored = color_at(with_mirror, {-9, 0, 4}, {-6, 0, 8}, settings);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(straight[c], wanted[c], near * (1 + double(wanted[c]))) << "from the eye, " << c;
            if (has_fog_) continue;
            EXPECT_NEAR(mirrored[c], wanted[c], near * (1 + double(wanted[c]))) << "in the mirror, " << c;
        }
    }
    Light& add(LightType type) {
        Light light;
        light.type = type;
        light.direction = {0, 0, -1};
        scene_.lights.push_back(light);
        return scene_.lights.back();
    }
    static constexpr vec3 k_d{0.5f, 0.25f, 1}, k_a{1, 0.5f, 0.25f};
    Scene scene_;
    bool has_fog_ = false;
};

TEST_F(DirectLight, AmbientIsKaTimesIt) {
    add(LightType::ambient).ambient = {0.5f, 0.5f, 0.5f};
    expect(k_a * 0.5f);
}

TEST_F(DirectLight, LambertIsTheCosine) {
    add(LightType::directional).direction = {-std::sin(1.0), 0, -std::cos(1.0)};
    expect(k_d * float(std::cos(1.0)));
}

TEST_F(DirectLight, PointLightsFallOffAsTheirTermsSay) {
    Light& light = add(LightType::point);
    light.position = {0, 3, 4};  // 5 m away, cosine 0.8
    light.constant = 0.5f, light.linear = 0.25f, light.quadratic = 0.125f;
    expect(k_d * float(0.8 / (0.5 + 1.25 + 3.125)));
}

TEST_F(DirectLight, SpotsFallOffInsideOfTheirCone) {
    Light& light = add(LightType::spot);
    light.position = {0, 3, 4}, light.direction = {0, 0, -1};
    light.cutoff_rad = 1, light.exponent = 3;
    expect(k_d * float(0.8 * 0.8 * 0.8 * 0.8));
    light.cutoff_rad = 0.5f;  // 36.9 degrees are outside
    expect({0, 0, 0});
}

TEST_F(DirectLight, PhotometricPointLightsFallOffWithTheSquare) {
    Light& light = add(LightType::point);
    light.units = LightUnits::photometric, light.position = {0, 3, 4}, light.intensity = 100;
    expect(k_d * float(100.0 / 25 * 0.8 / pi));
}

TEST_F(DirectLight, PhongIsACosineOfTheMirrorDirection) {
    scene_.materials[0].classical.specular = {0.5f, 1, 0.25f}, scene_.materials[0].classical.shininess = 9;
    // The eye stands 36.9 degrees off; the light straight above: r.v = 0.8.
    add(LightType::directional);
    expect(k_d + vec3{0.5f, 1, 0.25f} * float(std::pow(0.8, 9)), {.lighting = Lighting::phong});
}

TEST_F(DirectLight, BlinnPhongIsACosineOfTheHalfVector) {
    scene_.materials[0].classical.specular = {0.5f, 1, 0.25f}, scene_.materials[0].classical.shininess = 9;
    add(LightType::directional);
    expect(k_d + vec3{0.5f, 1, 0.25f} * float(std::pow(std::sqrt(0.9), 9)), {.lighting = Lighting::blinn_phong});
}

TEST_F(DirectLight, LightsAddUpAndEmissionIsOnTop) {
    scene_.materials[0].emission = {0.125f, 0, 0};
    add(LightType::directional);
    add(LightType::directional).diffuse = {0.5f, 0.5f, 0.5f};
    expect(k_d * 1.5f + vec3{0.125f, 0, 0});
}

TEST_F(DirectLight, ShadowsTakeTheLightAndLeaveAmbient) {
    add(LightType::point).position = {0, 3, 4};
    add(LightType::ambient).ambient = {0.5f, 0.5f, 0.5f};
    scene_.materials.push_back(test::matte());
    const std::uint32_t node = test::add_object(scene_, test::square_mesh(1, 0.1f), translation(dvec3{0, 1.5, 2}));
    expect(k_a * 0.5f, {.shadows = true});
    scene_.nodes[node].local.matrix = translation(dvec3{0, 1.8, 2});  // beside the ray
    expect(k_a * 0.5f + k_d * 0.8f, {.shadows = true});
}

TEST_F(DirectLight, FogThinsWithTheDistance) {
    has_fog_ = true;  // the way over the mirror is longer
    add(LightType::directional);
    scene_.fog = {.kind = FogKind::exponential, .color = {0.2f, 0.4f, 0.8f}, .density = 0.1f};
    const float f = float(std::exp(-0.5));
    expect(k_d * f + vec3{0.2f, 0.4f, 0.8f} * (1 - f));
}

/// Mirror and place each stand behind 5 m of fog: the mirror has no color of its own but the fog before it.
TEST_F(DirectLight, FogThinsEachPartOfAWay) {
    Material mirror = test::matte({0, 0, 0});
    mirror.classical.ambient = {}, mirror.classical.specular = {1, 1, 1}, mirror.classical.mirror = Mirror::constant;
    mirror.classical.shininess = 1e6f, mirror.double_sided = true;
    add(LightType::directional);
    scene_.fog = {.kind = FogKind::exponential, .color = {0.2f, 0.4f, 0.8f}, .density = 0.1f};
    scene_.materials.push_back(mirror);
    test::add_object(scene_, test::square_mesh(1, 0.5f), translation(dvec3{-6, 0, 8}));
    const double first = std::exp(-0.5), second = std::exp(-1.0);
    const vec3 c = color_at(scene_, {-9, 0, 4}, {-6, 0, 8}, {});
    for (std::size_t i = 0; i < 3; ++i) {
        const double fog = double(scene_.fog.color[i]);
        EXPECT_NEAR(c[i], fog * (1 - first) + first * (fog * (1 - second) + second * double(k_d[i])), 1e-5) << i;
    }
}

}  // namespace
}  // namespace rakelight::raytrace
