// SPDX-License-Identifier: Apache-2.0
// Bumps behind texture transforms, in every engine: a plane whose normal map tilts all normals the same way, so that the light
// that it reflects says which way. Tangents belong to the transformed coordinates, and so does the relief of heights.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/render/render.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/motion.h>

#include "support/scene_builder.h"
#include "support/shared.h"

namespace rakelight {
namespace {

using namespace test;

constexpr double tilt_u = 0.5, tilt_up = 0.25;  // of the map's normals, along u and against v

/// The matrix of KHR_texture_transform, and the tangent frame of a square whose u runs along +X and v along -Y.
struct Turned {
    double m[2][2];

    explicit Turned(const TextureTransform& t) {
        const double c = std::cos(double(t.rotation_rad)), s = std::sin(double(t.rotation_rad));
        m[0][0] = c * double(t.scale.x), m[0][1] = s * double(t.scale.y);
        m[1][0] = -s * double(t.scale.x), m[1][1] = c * double(t.scale.y);
    }
    double determinant() const { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }
    /// dP/du', unit.
    dvec3 tangent() const {
        return normalize_or(dvec3{m[1][1], m[1][0], 0} * (determinant() > 0 ? 1.0 : -1.0), dvec3{1, 0, 0});
    }
    /// Perpendicular to the tangent, on the side of -dP/dv'.
    dvec3 up() const { return cross(dvec3{0, 0, 1}, tangent()) * (determinant() > 0 ? 1.0 : -1.0); }
    dvec3 bumped() const {
        const double z = std::sqrt(1 - tilt_u * tilt_u - tilt_up * tilt_up);
        return tangent() * tilt_u + up() * tilt_up + dvec3{0, 0, z};
    }
};

int code_of(double x) { return int(std::lround((x * 0.5 + 0.5) * 255)); }

/// The square under one light, with this normal map and without tangents.
Scene bumpy_square(const TextureTransform& transform, dvec3 to_light) {
    Scene scene;
    scene.source = "bumpy.test";
    Material m = matte();
    const double z = std::sqrt(1 - tilt_u * tilt_u - tilt_up * tilt_up);
    m.normal_texture = add_texture(scene, picture(rgb_pixels(4, 4, [&](int, int) {
                                       return std::vector<int>{code_of(tilt_u), code_of(tilt_up), code_of(z)};
                                   })));
    m.normal_texture.transform = transform;
    scene.materials = {m};
    Mesh mesh = square_mesh(0);
    mesh.tangents = {};
    add_object(scene, std::move(mesh));
    scene.lights = {directional(to_light * -1.0)};
    return scene;
}

/// The engine with this name, or null where this build or machine has none.
std::unique_ptr<Engine> engine_of(const std::string& name) {
    try {
        return make_engine(name);
    } catch (const Error&) {
        return nullptr;
    }
}

/// Linear red of the pixel in the middle.
double brightness(const std::string& engine, const Scene& scene, const RenderSettings& wanted = {}) {
    std::unique_ptr<Engine> made = engine_of(engine);
    if (!made) return -1;
    Context context;
    Session session(std::move(made));
    session.set(scene, PrepareOptions{});
    RenderSettings settings = wanted;
    settings.width = settings.height = 9;
    Frame frame;
    session.render(flat_camera(), settings, frame, context);
    return double(frame.color[4 * 9 + 4].x);
}

const TextureTransform transforms[] = {
    {},
    {.scale = {-1, 1}},
    {.scale = {1, -1}},
    {.scale = {-2, -3}},
    {.rotation_rad = float(pi / 2)},
    {.offset = {0.3f, 0.1f}, .scale = {1, -1}, .rotation_rad = 0.7f},
    {.scale = {3, 0.5f}, .rotation_rad = -2.1f},
};

class TextureTransforms : public testing::TestWithParam<std::string> {};

TEST_P(TextureTransforms, BumpsPointWhereTheTransformedCoordinatesDo) {
    if (!engine_of(GetParam())) GTEST_SKIP() << "no engine " << GetParam();
    const dvec3 lights[] = {{0.6, 0, 0.8}, {-0.6, 0, 0.8}, {0, 0.6, 0.8}, {0, -0.6, 0.8}};
    for (const TextureTransform& t : transforms)
        for (const dvec3& light : lights)
            EXPECT_NEAR(brightness(GetParam(), bumpy_square(t, light)), dot(Turned(t).bumped(), light), 0.008)
                << t.rotation_rad << " " << t.scale.x << " " << t.scale.y << ", light " << light.x << " " << light.y;
}

TEST_P(TextureTransforms, ATransformThatMapsAllToALineStaysFinite) {
    if (!engine_of(GetParam())) GTEST_SKIP() << "no engine " << GetParam();
    for (const vec2 scale : {vec2{0, 0}, vec2{0, 1}, vec2{1, 0}, vec2{1e-30f, 1e-30f}, vec2{1e30f, -1e30f}}) {
        Scene scene = bumpy_square({.scale = scale}, {0, 0.6, 0.8});
        scene.materials[0].height_texture = scene.materials[0].normal_texture;
        for (const Bump bump : {Bump::normal, Bump::height, Bump::parallax, Bump::occlusion}) {
            const double value = brightness(GetParam(), scene, {.bump = bump});
            EXPECT_TRUE(value >= 0 && value <= 1.001) << value;
        }
    }
}

/// A ramp of heights that grows along the transformed u: its slope bends normals against the tangent.
TEST_P(TextureTransforms, SlopesOfHeightsPointWhereTheTransformedCoordinatesDo) {
    if (!engine_of(GetParam())) GTEST_SKIP() << "no engine " << GetParam();
    for (const TextureTransform& t : transforms)
        for (const dvec3& light : {dvec3{0.6, 0, 0.8}, dvec3{0, -0.6, 0.8}}) {
            Scene scene = bumpy_square(t, light);
            Material& m = scene.materials[0];
            m.normal_texture = {};
            m.height_texture = add_texture(scene,
                                           picture(rgb_pixels(256, 256,
                                                              [](int x, int) {
                                                                  const int h = x < 128 ? x : 255 - x;
                                                                  return std::vector<int>{h, h, h};
                                                              })),
                                           {.mip = MipFilter::none});
            m.relief = Relief{.depth = 0.4f};
            m.height_texture.transform = t;
            // The middle of the square, u = v = 0.5, is moved into the rising half of the ramp.
            const Turned turned(t);
            m.height_texture.transform.offset.x = float(0.25 - 0.5 * (turned.m[0][0] + turned.m[0][1]));
            const dvec3 n = normalize_or(dvec3{0, 0, 1} - turned.tangent() * (0.4 * 256 / 255), dvec3{});
            EXPECT_NEAR(brightness(GetParam(), scene, {.bump = Bump::height}), dot(n, light), 0.01)
                << t.rotation_rad << " " << t.scale.x << " " << t.scale.y << ", light " << light.x << " " << light.y;
        }
}

/// Exact shapes have tangents by their formulas, triangles by theirs.
TEST(TextureTransformsOfShapes, ExactShapesAreBumpedAsTheirTriangles) {
    if (!engine_of("trace")) GTEST_SKIP() << "no engine trace";
    for (const TextureTransform& t : transforms)
        for (const dvec3& light : {dvec3{0.6, 0, 0.8}, dvec3{0, 0.6, 0.8}}) {
            Scene scene = bumpy_square(t, light);
            Scene exact = scene;  // a plane lies along X and Z: the square is set upright
            Mesh& mesh = exact.meshes[0];
            std::vector<vec3> positions, normals;
            for (const vec3 p : mesh.positions) positions.push_back({p.x, 0, -p.y}), normals.push_back({0, 1, 0});
            mesh.positions = std::move(positions), mesh.normals = std::move(normals);
            mesh.shape = ExactShape{.kind = ExactShape::Kind::plane, .width = 2, .depth = 2};
            exact.nodes[0].local.matrix = dmat4{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}};
            EXPECT_NEAR(brightness("trace", exact), dot(Turned(t).bumped(), light), 0.008)
                << t.rotation_rad << " " << t.scale.x << " " << t.scale.y;
        }
}

/// As a clip of KHR_animation_pointer sets it, a quarter turn in a second.
TEST_P(TextureTransforms, TheyMayMove) {
    if (!engine_of(GetParam())) GTEST_SKIP() << "no engine " << GetParam();
    const dvec3 light{0.6, 0, 0.8};
    Scene scene = bumpy_square({}, light);
    AnimationChannel channel{.element = 0, .path = AnimationPath::material, .property = "normal_texture.rotation"};
    channel.times = std::vector<float>{0, 1};
    channel.values = std::vector<float>{0, float(pi / 2)};
    scene.animations.push_back({.name = "turn", .channels = {channel}});
    for (const double time : {0.0, 0.5, 1.0}) {
        const TextureTransform t{.rotation_rad = float(time * pi / 2)};
        EXPECT_NEAR(brightness(GetParam(), scene_at(scene, std::vector<ClipTime>{{0, time}})),
                    dot(Turned(t).bumped(), light), 0.008)
            << time;
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, TextureTransforms, testing::Values("soft", "gl", "trace"),
                         [](const testing::TestParamInfo<std::string>& of) { return of.param; });

}  // namespace
}  // namespace rakelight
