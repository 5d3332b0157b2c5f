// SPDX-License-Identifier: Apache-2.0
// Data channels against closed forms, and their bits over threads, windows and instruction sets.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engines/channel_arrays.h"
#include "engines/raster/raster_engine.h"
#include "math/isa.h"
#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight {
namespace {

using namespace test;

/// A ball of radius 1 about `center`: `rings` x 2 `rings` quads, smooth normals, u around, v down.
Mesh ball(int rings, dvec3 center, std::uint32_t material = no_index) {
    Mesh mesh;
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    const int columns = 2 * rings;
    for (int r = 0; r <= rings; ++r)
        for (int c = 0; c <= columns; ++c) {
            const double t = pi * r / rings, p = 2 * pi * c / columns;
            const dvec3 n = {std::sin(t) * std::sin(p), std::cos(t), std::sin(t) * std::cos(p)};
            normals.push_back(cast<float>(n));
            positions.push_back(cast<float>(center + n));
            tangents.push_back({float(std::cos(p)), 0, float(-std::sin(p)), 1});
            uv.push_back({float(c) / float(columns), float(r) / float(rings)});
        }
    for (int r = 0; r < rings; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto a = std::uint32_t(r * (columns + 1) + c), b = a + std::uint32_t(columns) + 1;
            indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.tangents = tangents;
    mesh.texcoords.emplace_back(uv);
    mesh.indices = indices;
    mesh.material = material;
    return mesh;
}

Camera looking_from(dvec3 eye, dvec3 at) {
    Camera camera;
    camera.to_world = look_at(eye, at, {0, 1, 0});
    camera.vertical_fov_rad = radians(40);
    camera.z_near = 0.1;
    camera.z_far = 100;
    return camera;
}

Frame draw(const Scene& scene, const Camera& camera, RenderSettings settings, int threads = 2) {
    const auto engine = raster::make_engine();
    Context context({.threads = threads});
    Frame frame;
    engine->prepare(scene, context);
    engine->render(camera, settings, frame, context);
    return frame;
}

RenderSettings everything(int side = 96) {
    RenderSettings settings;
    settings.width = settings.height = side;
    settings.channels = channels_all;
    return settings;
}

Light lamp(dvec3 direction) {
    Light light = directional(direction, {0.7f, 0.6f, 0.5f});
    light.ambient = {0.1f, 0.15f, 0.2f};
    return light;
}

/// A ball before a wall, lit; the ball glows a little.
Scene two_objects() {
    Scene scene;
    scene.materials = {matte({0.8f, 0.3f, 0.2f}), matte()};
    scene.materials[0].emission = {0.05f, 0.02f, 0.01f};
    scene.materials[0].classical.specular = {0.5f, 0.5f, 0.5f};
    scene.materials[0].classical.shininess = 20;
    scene.lights = {lamp({0, -1, -1}), lamp({-1, 0, -1})};
    add_object(scene, ball(24, {0, 0, 0}, 0));
    add_object(scene, square_mesh(1, 1.5f), translation(dvec3{0, 0, -2}));
    return scene;
}

TEST(Channels, OfASquareInParallelProjectionAreItsFormulas) {
    Scene scene;
    scene.lights = {directional({0, 0, -1})};
    add_object(scene, square_mesh(), translation(dvec3{10, 20, 30}));
    Camera camera = flat_camera();
    camera.to_world = translation(dvec3{10, 20, 35});
    const Frame f = draw(scene, camera, everything(64));
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto p = std::size_t(y * 64 + x);
            const float u = (float(x) + 0.5f) / 64, v = (float(y) + 0.5f) / 64;
            ASSERT_NEAR(f.position[p].x, 9 + 2 * u, 1e-5f);
            ASSERT_NEAR(f.position[p].y, 21 - 2 * v, 1e-5f);
            ASSERT_NEAR(f.position[p].z, 30, 1e-5f);
            ASSERT_NEAR(f.uv[p].x, u, 1e-6f);
            ASSERT_NEAR(f.uv[p].y, v, 1e-6f);
            ASSERT_EQ(f.uv1[p], (vec2{0, 0}));
            ASSERT_EQ(f.face_normal[p], (vec3{0, 0, 1}));
            ASSERT_NEAR(length(f.tangent[p].xyz() - vec3{1, 0, 0}), 0, 1e-6);
            ASSERT_EQ(f.tangent[p].w, 1);
            ASSERT_EQ(f.triangle[p], x > 63 - y ? 0u : x < 63 - y ? 1u : f.triangle[p]);
            ASSERT_EQ(f.overdraw[p], 1u);
            ASSERT_EQ(f.mesh[p], 0u);
        }
}

TEST(Channels, OfABallLieOnIt) {
    Scene scene;
    const dvec3 center = {3, -2, 1}, eye = {3, -1, 5};
    add_object(scene, ball(48, center));
    scene.lights = {lamp({0, 0, -1})};
    const Frame f = draw(scene, looking_from(eye, center), everything());
    const Mesh& mesh = scene.meshes[0];
    std::size_t seen = 0;
    const double snapped = 4.2 * 0.73 / 96 / 256;  // [m] 1/256 pixel: corners lie on that grid
    for (std::size_t p = 0; p < f.color.size(); ++p) {
        if (f.object[p] == no_index) continue;
        ++seen;
        const dvec3 from_center = cast<double>(f.position[p]) - center;
        EXPECT_NEAR(length(from_center), 1, 0.003);
        EXPECT_GT(dot(cast<double>(f.normal[p]), from_center), 0.996);
        EXPECT_GT(dot(f.face_normal[p], f.normal[p]), 0.99f);
        EXPECT_NEAR(length(f.face_normal[p]), 1, 1e-6);
        EXPECT_NEAR(dot(f.tangent[p].xyz(), f.normal[p]), 0, 1e-5);
        // The corners of the triangle, weighted, are the position and the texture coordinates.
        const vec3 b = f.barycentric[p];
        EXPECT_NEAR(b.x + b.y + b.z, 1, 1e-6);
        dvec3 position{};
        double u = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = mesh.indices[3 * f.triangle[p] + k];
            position = position + cast<double>(mesh.positions[corner]) * double(b[k]);
            u += double(mesh.texcoords[0][corner].x) * double(b[k]);
        }
        EXPECT_NEAR(length(position - cast<double>(f.position[p])), 0, snapped);
        EXPECT_NEAR(u, double(f.uv[p].x), 1e-5);
        const dvec3 to_eye = eye - cast<double>(f.position[p]), axis = normalize_or(eye - center, dvec3{});
        if (dot(cast<double>(f.face_normal[p]), normalize_or(to_eye, dvec3{})) < 0.3)
            continue;  // at the rim a bit aside is far
        EXPECT_NEAR(f.depth[p], dot(to_eye, axis), 4 * snapped);
    }
    EXPECT_GT(seen, 2000u);
}

float sum(const Frame& f, std::size_t p, std::size_t c) {
    return f.ambient[p][c] + f.diffuse[p][c] + f.specular[p][c] + f.emission[p][c];
}

TEST(Channels, LightingTermsAddUpToTheColorInEveryShading) {
    for (const Shading shading : {Shading::unlit, Shading::flat, Shading::gouraud, Shading::phong}) {
        RenderSettings settings = everything();
        settings.shading = shading;
        const Frame f = draw(two_objects(), looking_from({0, 0.5, 6}, {0, 0, 0}), settings);
        float most[4] = {0, 0, 0, 0};
        for (std::size_t p = 0; p < f.color.size(); ++p) {
            if (f.object[p] == no_index) continue;
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(sum(f, p, c), f.color[p][c], 2e-6f) << int(shading) << ' ' << p;
            most[0] = std::max(most[0], f.ambient[p].x), most[1] = std::max(most[1], f.diffuse[p].x);
            most[2] = std::max(most[2], f.specular[p].x), most[3] = std::max(most[3], f.emission[p].x);
        }
        EXPECT_GT(most[3], 0.04f);
        for (int term = 0; term < 3; ++term) EXPECT_EQ(most[term] > 0.05f, shading != Shading::unlit) << term;
    }
}

TEST(Channels, NumbersSayWhichObjectMeshMaterialAndTriangle) {
    const Frame f = draw(two_objects(), looking_from({0, 0, 6}, {0, 0, 0}), everything());
    const std::size_t middle = 48 * 96 + 48, side = 48 * 96 + 71;
    EXPECT_EQ(f.object[middle], 0u);
    EXPECT_EQ(f.mesh[middle], 0u);
    EXPECT_EQ(f.material[middle], 0u);
    EXPECT_LT(f.triangle[middle], 24u * 48 * 2);
    EXPECT_NEAR(f.base_color[middle].x, 0.8f, 1e-6f);
    EXPECT_EQ(f.object[side], 1u);
    EXPECT_EQ(f.mesh[side], 1u);
    EXPECT_EQ(f.material[side], 1u);
    EXPECT_EQ(f.triangle[side], 0u);
    EXPECT_EQ(f.base_color[side], (vec3{1, 1, 1}));
}

TEST(Channels, OverdrawCountsHiddenSurfacesWhateverTheOrder) {
    const Camera camera = looking_from({0, 0, 6}, {0, 0, 0});
    Scene scene = two_objects(), turned = two_objects();
    std::swap(turned.nodes[0], turned.nodes[1]);
    RenderSettings settings = everything();
    settings.cull = Cull::none;
    const Frame f = draw(scene, camera, settings), g = draw(turned, camera, settings);
    EXPECT_EQ(f.overdraw[48 * 96 + 48], 3u);  // front and back of the ball, the wall
    EXPECT_EQ(f.overdraw[48 * 96 + 71], 1u);
    EXPECT_EQ(f.overdraw[0], 0u);
    EXPECT_EQ(f.overdraw, g.overdraw);
    settings.cull = Cull::back;
    EXPECT_EQ(draw(scene, camera, settings).overdraw[48 * 96 + 48], 2u);
}

TEST(Channels, HolesOfAMaskAreNoLayers) {
    Scene scene;
    Material holes = matte();
    holes.alpha_mode = AlphaMode::mask;
    holes.alpha_cutoff = 0.5f;
    holes.base_color.w = 0.2f;
    scene.materials = {holes, matte()};
    scene.lights = {directional({0, 0, -1})};
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, 1}));
    add_object(scene, square_mesh(1));
    EXPECT_EQ(draw(scene, flat_camera(), everything()).overdraw[48 * 96 + 48], 1u);
    scene.materials[0].base_color.w = 0.9f;
    EXPECT_EQ(draw(scene, flat_camera(), everything()).overdraw[48 * 96 + 48], 2u);
}

TEST(Channels, WhereNothingIsTheyHoldWhatIsSaid) {
    const Frame f = draw(two_objects(), looking_from({0, 0, 16}, {0, 0, 0}), everything());
    EXPECT_EQ(f.depth[0], std::numeric_limits<float>::infinity());
    for (const auto* numbers : {&f.object, &f.material, &f.mesh, &f.triangle}) EXPECT_EQ((*numbers)[0], no_index);
    for (const auto* vectors : {&f.normal, &f.face_normal, &f.position, &f.barycentric, &f.base_color, &f.ambient,
                                &f.diffuse, &f.specular, &f.emission})
        EXPECT_EQ((*vectors)[0], (vec3{0, 0, 0}));
    EXPECT_EQ(f.tangent[0], (vec4{0, 0, 0, 0}));
    EXPECT_EQ(f.uv[0], (vec2{0, 0}));
}

TEST(Channels, OfABackSideKeepTheFrameRightHandedWithTheirNormal) {
    Scene scene;
    Material both = matte();
    both.double_sided = true;
    scene.materials = {both};
    scene.lights = {directional({0, 0, 1})};
    add_object(scene, square_mesh(0));
    Camera camera = looking_from({0, 0, -5}, {0, 0, 0});
    const Frame f = draw(scene, camera, everything());
    const std::size_t middle = 48 * 96 + 48;
    EXPECT_EQ(f.face_normal[middle], (vec3{0, 0, -1}));
    EXPECT_NEAR(length(f.normal[middle] - vec3{0, 0, -1}), 0, 1e-6);
    const vec3 bitangent = cross(f.normal[middle], f.tangent[middle].xyz()) * f.tangent[middle].w;
    EXPECT_NEAR(length(bitangent - vec3{0, 1, 0}), 0, 1e-6);  // -dP/dv
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const Frame& a, const Frame& b) {
    bool same = same_bits(a.color, b.color);
    for_each_channel(
        [&](std::uint32_t bit, const auto& x, const auto& y) {
            if (bit & channels_all) same = same && !x.empty() && same_bits(x, y);
        },
        static_cast<const ChannelArrays&>(a), static_cast<const ChannelArrays&>(b));
    return same;
}

TEST(Channels, HaveTheSameBitsForThreadsWindowsAndInstructionSets) {
    const Scene scene = two_objects();
    const Camera camera = looking_from({0.5, 1, 3}, {0, 0, 0});
    const RenderSettings settings = everything(150);
    setenv("RAKELIGHT_ISA", "scalar", 1);
    const Frame reference = draw(scene, camera, settings, 1);
    for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        setenv("RAKELIGHT_ISA", name(isa), 1);
        for (const int threads : {1, 4})
            EXPECT_TRUE(same_bits(reference, draw(scene, camera, settings, threads))) << name(isa) << threads;
    }
    unsetenv("RAKELIGHT_ISA");
    RenderSettings part = settings;
    part.window = {37, 21, 90, 101};
    const Frame window = draw(scene, camera, part);
    for (int y = 0; y < 101; ++y)
        for (int x = 0; x < 90; ++x) {
            const auto whole = std::size_t((y + 21) * 150 + x + 37), own = std::size_t(y * 90 + x);
            for_each_channel(
                [&](std::uint32_t bit, const auto& a, const auto& b) {
                    if ((bit & channels_all) == 0) return;
                    ASSERT_EQ(std::memcmp(&a[whole], &b[own], sizeof a[0]), 0) << bit;
                },
                static_cast<const ChannelArrays&>(reference), static_cast<const ChannelArrays&>(window));
        }
}

TEST(Channels, AreFiniteWhereColorsAreNotAndAddUpToWhatIsShown) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, ball(24, {0, 0, 0}, 0));
    scene.meshes[0].colors = std::vector<vec4>(scene.meshes[0].positions.size(), vec4{1, 1, std::nanf(""), 1});
    Light light = lamp({0.3, -1, -0.5});
    light.units = LightUnits::photometric;  // finite numbers whose product is not: no number where the cosine is 0
    light.color = {3e38f, 1e-30f, 1e-30f};
    light.intensity = 1e30f;
    scene.lights = {light};
    const Frame f = draw(scene, looking_from({0, 0.5, 4}, {0, 0, 0}), everything());
    int seen = 0;
    for (std::size_t p = 0; p < f.color.size(); ++p) {
        if (f.object[p] == no_index) continue;
        ++seen;
        EXPECT_EQ(f.base_color[p], (vec3{1, 1, 0}));
        const vec3 sum = f.ambient[p] + f.diffuse[p] + f.specular[p] + f.emission[p];
        ASSERT_TRUE(is_finite(f.ambient[p]) && is_finite(f.diffuse[p]) && is_finite(f.specular[p])) << p;
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(sum[c], f.color[p][c], 2e-6f) << p << ", " << c;
    }
    EXPECT_GT(seen, 1000);
}

TEST(Channels, DoNotChangeThePicture) {
    const Scene scene = two_objects();
    const Camera camera = looking_from({0, 0.5, 6}, {0, 0, 0});
    RenderSettings settings = everything();
    const Frame with = draw(scene, camera, settings);
    settings.channels = 0;
    EXPECT_TRUE(same_bits(with.color, draw(scene, camera, settings).color));
}

}  // namespace
}  // namespace rakelight
