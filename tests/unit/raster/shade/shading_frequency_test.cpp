// SPDX-License-Identifier: Apache-2.0
// Shading frequencies: how often lighting is evaluated, and what comes of it.
#include "engines/raster/raster_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "math/isa.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

RenderSettings settings_for(Shading shading, int size = 65) {
    return {.width = size, .height = size, .shading = shading, .background = {0, 0, 0, 0}};
}

struct Picture {
    Frame frame;
    RenderStats stats;
    std::vector<ReportEntry> remarks;

    vec4 at(int x, int y) const { return frame.color[std::size_t(y * frame.window.width + x)]; }
};

Picture draw_picture(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 1) {
    Context context({.threads = threads});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Picture p;
    p.stats = engine->render(camera, settings, p.frame, context);
    p.remarks = context.report().entries();
    return p;
}

std::uint64_t evaluations(const Scene& scene, const Camera& camera, Shading shading) {
    return draw_picture(scene, camera, settings_for(shading)).stats.lighting_evaluations;
}

Material single_sided() {
    Material m = matte();
    m.model = MaterialModel::metallic_roughness;
    m.metallic_roughness.metallic = 0;
    return m;
}

Camera camera_at(dvec3 eye, double fov_deg = 40) {
    Camera camera;
    camera.vertical_fov_rad = radians(fov_deg);
    camera.z_near = 0.1;
    camera.to_world = look_at(eye, {0, 0, 0}, {0, 1, 0});
    return camera;
}

/// The unit cube's eight corners and twelve outward triangles; normals through the corners.
Mesh smooth_cube() {
    Mesh mesh;
    std::vector<vec3> corners, normals;
    for (int i = 0; i < 8; ++i) {
        corners.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
        normals.push_back(corners.back() / std::sqrt(3.0f));
    }
    mesh.positions = corners;
    mesh.normals = normals;
    mesh.indices = std::vector<std::uint32_t>{4, 5, 7, 4, 7, 6, 1, 0, 2, 1, 2, 3, 5, 1, 3, 5, 3, 7,
                                              0, 4, 6, 0, 6, 2, 6, 7, 3, 6, 3, 2, 0, 1, 5, 0, 5, 4};
    return mesh;
}

/// The same with four corners of its own a face.
Mesh sharp_cube() {
    const Mesh smooth = smooth_cube();
    std::vector<vec3> positions, normals;
    std::vector<std::uint32_t> indices;
    for (std::size_t face = 0; face < 6; ++face) {
        const std::uint32_t first = std::uint32_t(positions.size());
        const std::size_t quad[] = {0, 1, 2, 5};
        for (const std::size_t k : quad) positions.push_back(smooth.positions[smooth.indices[6 * face + k]]);
        const vec3 n = cross(positions[first + 1] - positions[first], positions[first + 2] - positions[first]);
        for (int k = 0; k < 4; ++k) normals.push_back(normalize_or(n, vec3{}));
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + k);
    }
    Mesh mesh;
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.indices = indices;
    return mesh;
}

/// Unit sphere of latitude and longitude with shared vertices: 2 + (rows - 1) columns of them, 2 columns (rows - 1)
/// triangles.
Mesh sphere(int rows, int columns) {
    std::vector<vec3> points;
    std::vector<std::uint32_t> indices;
    for (int r = 1; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const double b = pi * r / rows, a = 2 * pi * c / columns;
            points.push_back({float(std::sin(b) * std::sin(a)), float(std::cos(b)), float(std::sin(b) * std::cos(a))});
        }
    const auto top = std::uint32_t(points.size()), bottom = top + 1;
    points.push_back({0, 1, 0});
    points.push_back({0, -1, 0});
    const auto at = [columns](int r, int c) { return std::uint32_t(r * columns + c % columns); };
    for (int c = 0; c < columns; ++c) {
        for (const std::uint32_t i : {top, at(0, c), at(0, c + 1)}) indices.push_back(i);
        for (int r = 0; r + 2 < rows; ++r)
            for (const std::uint32_t i :
                 {at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c), at(r + 1, c + 1), at(r, c + 1)})
                indices.push_back(i);
        for (const std::uint32_t i : {bottom, at(rows - 2, c + 1), at(rows - 2, c)}) indices.push_back(i);
    }
    Mesh mesh;
    mesh.positions = points;
    mesh.normals = points;
    mesh.indices = indices;
    return mesh;
}

Light lamp(dvec3 position) {
    Light light;
    light.position = position;
    light.ambient = {0.05f, 0.05f, 0.1f};
    return light;
}

Material shiny(float exponent = 20) {
    Material m = matte({0.5f, 0.3f, 0.2f});
    m.classical.specular = {0.6f, 0.6f, 0.6f};
    m.classical.shininess = exponent;
    return m;
}

Scene scene_of(Mesh mesh, Material material) {
    Scene scene;
    scene.materials.push_back(std::move(material));
    mesh.material = 0;
    add_object(scene, std::move(mesh));
    scene.lights = {lamp({2, 3, 4})};
    return scene;
}

float difference(const Frame& a, const Frame& b) {
    float worst = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::fabs(a.color[i][c] - b.color[i][c]));
    return worst;
}

double mean_square(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::pow(double(a.color[i][c]) - double(b.color[i][c]), 2);
    return sum / double(a.color.size() * 3);
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

}  // namespace

TEST(ShadingFrequency, ACubeThatShowsThreeSidesIsLitAtItsSixTrianglesTwelveCornersOrAllItsPixels) {
    const Scene scene = scene_of(sharp_cube(), single_sided());
    const Camera camera = camera_at({4, 5, 6});
    EXPECT_EQ(evaluations(scene, camera, Shading::unlit), 0u);
    EXPECT_EQ(evaluations(scene, camera, Shading::flat), 6u);
    EXPECT_EQ(evaluations(scene, camera, Shading::gouraud), 12u);
    const Picture phong = draw_picture(scene, camera, settings_for(Shading::phong));
    EXPECT_GT(phong.stats.pixels_covered, 500u);
    EXPECT_EQ(phong.stats.lighting_evaluations, phong.stats.pixels_covered);
}

TEST(ShadingFrequency, AVertexIsLitOnceWhateverItsFacesAndTwiceWhereItIsSeenFromBothSides) {
    const Camera camera = camera_at({4, 5, 6});
    const Picture one = draw_picture(scene_of(smooth_cube(), single_sided()), camera, settings_for(Shading::gouraud));
    EXPECT_EQ(one.stats.lighting_evaluations, 7u) << "the eighth corner is behind";
    EXPECT_EQ(one.stats.vertices_lit_twice, 0u);
    const Picture both = draw_picture(scene_of(smooth_cube(), shiny()), camera, settings_for(Shading::gouraud));
    EXPECT_EQ(both.stats.drawn, 12u);
    EXPECT_EQ(both.stats.lighting_evaluations, 14u);
    EXPECT_EQ(both.stats.vertices_lit_twice, 6u);
    EXPECT_EQ(evaluations(scene_of(smooth_cube(), shiny()), camera, Shading::flat), 12u)
        << "a face has one side that is seen";
}

TEST(ShadingFrequency, ASpheresCountsAreThoseOfItsFacesThatLookAtTheEye) {
    const Mesh mesh = sphere(12, 16);
    const dvec3 eye = {1, 2, 5};
    std::set<std::uint32_t> vertices;
    std::uint64_t faces = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        dvec3 p[3];
        for (std::size_t k = 0; k < 3; ++k) p[k] = cast<double>(mesh.positions[mesh.indices[t + k]]);
        if (!(dot(cross(p[1] - p[0], p[2] - p[0]), eye - p[0]) > 0)) continue;
        ++faces;
        vertices.insert({mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]});
    }
    const Scene scene = scene_of(mesh, single_sided());
    const Picture flat = draw_picture(scene, camera_at(eye, 26), settings_for(Shading::flat, 400));
    EXPECT_EQ(flat.stats.drawn, faces);
    EXPECT_EQ(flat.stats.culled_back, flat.stats.triangles_in - faces);
    EXPECT_EQ(flat.stats.lighting_evaluations, faces);
    EXPECT_EQ(draw_picture(scene, camera_at(eye, 26), settings_for(Shading::gouraud, 400)).stats.lighting_evaluations,
              vertices.size());
}

TEST(ShadingFrequency, PiecesOfClippedTrianglesAndTilesAddNoEvaluations) {
    Mesh floor = square_mesh(0, 50);  // reaches behind the eye and over all tiles
    const Scene scene = scene_of(floor, matte());
    Camera camera;
    camera.z_near = 0.1;
    camera.to_world = look_at({0, 0, 1}, {10, 9, 0}, {0, 0, 1});  // about along the border of the two triangles
    const Picture flat = draw_picture(scene, camera, settings_for(Shading::flat, 300));
    EXPECT_GT(flat.stats.clipped, 0u);
    EXPECT_GT(flat.stats.drawn, flat.stats.lighting_evaluations);
    EXPECT_EQ(flat.stats.lighting_evaluations, 2u);
    EXPECT_EQ(draw_picture(scene, camera, settings_for(Shading::gouraud, 300)).stats.lighting_evaluations, 4u);
}

TEST(ShadingFrequency, UnlitMaterialsCountNowhereAndBlendedSurfacesCountPerPixelTheyShade) {
    Scene scene = scene_of(square_mesh(0), matte({0.25f, 0.5f, 1}));
    scene.materials[0].model = MaterialModel::unlit;
    for (const Shading s : {Shading::flat, Shading::gouraud, Shading::phong}) {
        const Picture p = draw_picture(scene, flat_camera(), settings_for(s));
        EXPECT_EQ(p.stats.lighting_evaluations, 0u);
        EXPECT_EQ(p.at(7, 9), (vec4{0.25f, 0.5f, 1, 1}));
    }
    scene.materials[0] = matte();
    scene.materials[0].alpha_mode = AlphaMode::blend;
    scene.materials[0].base_color.w = 0.5f;
    EXPECT_EQ(evaluations(scene, flat_camera(), Shading::flat), 2u);
    EXPECT_EQ(evaluations(scene, flat_camera(), Shading::gouraud), 4u);
    EXPECT_EQ(evaluations(scene, flat_camera(), Shading::phong), 65u * 65u);
}

TEST(ShadingFrequency, WithoutLightsOrTrianglesTheNumbersAreStillRight) {
    Scene scene = scene_of(square_mesh(0), matte());
    scene.materials[0].emission = {0.5f, 0, 0};
    scene.lights.clear();
    for (const Shading s : {Shading::flat, Shading::gouraud}) {
        EXPECT_EQ(draw_picture(scene, flat_camera(), settings_for(s)).at(3, 3), (vec4{0.5f, 0, 0, 1}));
        EXPECT_EQ(draw_picture(Scene{}, flat_camera(), settings_for(s)).stats.lighting_evaluations, 0u);
    }
}

TEST(ShadingFrequency, AFlatFaceHasOneColorAndItIsThatOfItsPlane) {
    Scene scene = scene_of(sphere(6, 9), single_sided());
    scene.lights = {directional({-1, -2, -3})};
    const RenderSettings settings = {.width = 200,
                                     .height = 200,
                                     .channels = channel_normal,
                                     .shading = Shading::flat,
                                     .lighting = Lighting::lambert,
                                     .background = {0, 0, 0, 0}};
    const Picture flat = draw_picture(scene, camera_at({0.3, 1, 5}, 26), settings);
    std::set<std::array<float, 4>> colors;
    const vec3 to_light = normalize_or(vec3{1, 2, 3}, vec3{});
    for (std::size_t i = 0; i < flat.frame.color.size(); ++i) {
        const vec4 c = flat.frame.color[i];
        if (c.w == 0) continue;
        colors.insert({c.x, c.y, c.z, c.w});
        EXPECT_NEAR(c.y, std::max(0.0f, dot(flat.frame.normal[i], to_light)), 1e-5f);
    }
    EXPECT_LE(colors.size(), flat.stats.lighting_evaluations);
    EXPECT_GT(colors.size(), 15u);
    scene.lights = {lamp({2, 3, 4})};  // light that differs over a face, and its highlight
    scene.materials[0] = shiny();
    std::set<std::array<float, 4>> faces;
    const Picture lamp_lit = draw_picture(scene, camera_at({0.3, 1, 5}, 26), settings_for(Shading::flat, 200));
    for (const vec4& c : lamp_lit.frame.color) faces.insert({c.x, c.y, c.z, c.w});
    EXPECT_LE(faces.size(), lamp_lit.stats.lighting_evaluations + 1);
}

TEST(ShadingFrequency, AFlatFaceMirrorsTheEnvironmentByItsPlaneWhateverChannelsAreAskedFor) {
    Scene scene = scene_of(sphere(6, 9), single_sided());
    scene.lights.clear();
    scene.environment = Environment{};
    scene.environment->is_light = true;
    RenderSettings settings = settings_for(Shading::flat);
    const Camera camera = camera_at({0, 0, 4});
    const Picture plain = draw_picture(scene, camera, settings);
    settings.channels = channel_normal;
    const Picture with_normals = draw_picture(scene, camera, settings);
    EXPECT_EQ(plain.frame.color, with_normals.frame.color);
}

TEST(ShadingFrequency, GouraudIsTheLightingAtTheVerticesAndLinearBetweenThem) {
    const auto at = [](int x, int y) { return vec3{float((x + 0.5) / 65 * 2 - 1), float(1 - (y + 0.5) / 65 * 2), 0}; };
    Mesh fan;  // vertices on centers of pixels
    fan.positions = std::vector<vec3>{at(32, 32), at(8, 32), at(32, 60), at(56, 32), at(32, 4)};
    fan.normals = std::vector<vec3>(5, vec3{0, 0, 1});
    fan.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    Scene scene = scene_of(fan, shiny());
    scene.lights = {lamp({0.4, 0.3, 0.8})};
    const Picture gouraud = draw_picture(scene, flat_camera(), settings_for(Shading::gouraud));
    const Picture phong = draw_picture(scene, flat_camera(), settings_for(Shading::phong));
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(gouraud.at(32, 32)[c], phong.at(32, 32)[c], 2e-5f);
        EXPECT_NEAR(gouraud.at(8, 32)[c], phong.at(8, 32)[c], 2e-5f);
        EXPECT_NEAR(gouraud.at(32, 4)[c], phong.at(32, 4)[c], 2e-5f);
        for (int x = 8; x <= 32; ++x) {
            const float t = float(x - 8) / 24;
            EXPECT_NEAR(gouraud.at(x, 32)[c], phong.at(8, 32)[c] * (1 - t) + phong.at(32, 32)[c] * t, 2e-5f) << x;
        }
        EXPECT_GT(std::fabs(phong.at(20, 32)[c] - gouraud.at(20, 32)[c]), 5e-3f) << "and Phong is not linear";
    }
}

TEST(ShadingFrequency, AHighlightAndASpotConeInTheMiddleOfAFaceAreMissingInGouraudAndRightInPhong) {
    Scene scene = scene_of(square_mesh(0), shiny(200));
    scene.lights = {lamp({0, 0, 2})};
    const Camera camera = camera_at({0, 0, 4}, 35);
    EXPECT_GT(draw_picture(scene, camera, settings_for(Shading::phong)).at(32, 32).y, 0.8f);
    EXPECT_LT(draw_picture(scene, camera, settings_for(Shading::gouraud)).at(32, 32).y, 0.4f);
    scene.lights[0].type = LightType::spot;
    scene.lights[0].direction = {0, 0, -1};
    scene.lights[0].cutoff_rad = float(radians(15));
    scene.lights[0].ambient = {};
    EXPECT_GT(draw_picture(scene, camera, settings_for(Shading::phong)).at(32, 32).y, 0.8f);
    const Picture gouraud = draw_picture(scene, camera, settings_for(Shading::gouraud));
    for (const vec4& c : gouraud.frame.color) EXPECT_EQ(c.x + c.y + c.z, 0.0f);
}

TEST(ShadingFrequency, OnFinerSpheresFlatAndGouraudComeCloserToPhong) {
    const Camera camera = camera_at({0.5, 1, 5}, 26);
    const Frame finest =
        draw_picture(scene_of(sphere(128, 256), shiny()), camera, settings_for(Shading::phong, 128)).frame;
    double flat_before = 1, gouraud_before = 1;
    for (const int rows : {8, 16, 32, 64, 128}) {
        const Scene scene = scene_of(sphere(rows, 2 * rows), shiny());
        const double flat = mean_square(draw_picture(scene, camera, settings_for(Shading::flat, 128)).frame, finest);
        const double gouraud =
            mean_square(draw_picture(scene, camera, settings_for(Shading::gouraud, 128)).frame, finest);
        EXPECT_LT(flat, flat_before / 1.5) << rows;
        EXPECT_LT(gouraud, gouraud_before / 1.5) << rows;
        EXPECT_LT(gouraud, flat) << rows;
        flat_before = flat;
        gouraud_before = gouraud;
    }
    EXPECT_LT(flat_before, 1e-4);
    EXPECT_LT(gouraud_before, 1e-7);
    EXPECT_GT(
        mean_square(draw_picture(scene_of(sphere(128, 256), shiny()), camera, settings_for(Shading::unlit, 128)).frame,
                    finest),
        1e-3);
}

TEST(ShadingFrequency, TexturesActAtThePixelWhereverLightingIsEvaluated) {
    Scene scene;
    Material m = single_sided();
    const auto checks = [](int x, int y) {
        return std::array<int, 3>{(x ^ y) & 4 ? 255 : 40, x * 16 % 256, y * 16 % 256};
    };
    m.base_color_texture = add_texture(scene, picture(rgb_pixels(16, 16, checks)));
    m.occlusion_texture = m.base_color_texture;
    m.emission_texture = m.base_color_texture;
    m.emission = {0.1f, 0.2f, 0.1f};
    const auto metal = [](int x, int) { return std::array<int, 3>{0, 255, x < 8 ? 255 : 30}; };
    m.metallic_roughness.texture = add_texture(scene, picture(rgb_pixels(16, 16, metal)));
    m.metallic_roughness.metallic = 0.8f;
    m.metallic_roughness.roughness = 0.6f;
    scene.materials = {m, shiny()};
    scene.materials[1].base_color_texture = scene.materials[1].classical.specular_texture = m.base_color_texture;
    add_object(scene, square_mesh(0), translation(dvec3{-1, 0, 0}));
    add_object(scene, square_mesh(1), translation(dvec3{1, 0, 0}));
    Light sky = directional({-0.2, -0.3, -1}, {0.7f, 0.8f, 0.9f});
    sky.ambient = {0.3f, 0.2f, 0.1f};
    scene.lights = {sky};  // parallel light and view on a plane: lighting is the same everywhere
    const Frame phong = draw_picture(scene, flat_camera(), settings_for(Shading::phong)).frame;
    EXPECT_LT(difference(draw_picture(scene, flat_camera(), settings_for(Shading::gouraud)).frame, phong), 1e-5f);
    EXPECT_LT(difference(draw_picture(scene, flat_camera(), settings_for(Shading::flat)).frame, phong), 1e-5f);
}

TEST(ShadingFrequency, ASurfaceSeenFromBehindIsLitOnTheSideThatIsSeen) {
    for (const bool classical : {true, false}) {
        Scene scene = scene_of(square_mesh(0), classical ? matte() : single_sided());
        scene.materials[0].double_sided = true;
        scene.lights = {directional({0, 0, -1})};
        scene.nodes[0].local.matrix = scaling(dvec3{1, 1, -1}) * scaling(dvec3{-1, 1, 1});
        const Frame phong = draw_picture(scene, flat_camera(), settings_for(Shading::phong)).frame;
        EXPECT_NEAR(phong.color[500].x, 1.0f, 0.05f);
        EXPECT_LT(difference(draw_picture(scene, flat_camera(), settings_for(Shading::gouraud)).frame, phong), 1e-5f);
        EXPECT_LT(difference(draw_picture(scene, flat_camera(), settings_for(Shading::flat)).frame, phong), 1e-5f);
    }
}

TEST(ShadingFrequency, WithoutVertexNormalsGouraudIsFlat) {
    Mesh mesh = smooth_cube();
    mesh.normals = {};
    const Scene scene = scene_of(mesh, shiny());
    const Picture gouraud = draw_picture(scene, camera_at({4, 5, 6}), settings_for(Shading::gouraud));
    EXPECT_EQ(gouraud.stats.lighting_evaluations, 12u);
    EXPECT_TRUE(same_bits(gouraud.frame, draw_picture(scene, camera_at({4, 5, 6}), settings_for(Shading::flat)).frame));
}

TEST(ShadingFrequency, NormalMapsAreLeftOutAndItIsSaid) {
    Scene scene = scene_of(square_mesh(0), shiny());
    const Frame plain = draw_picture(scene, flat_camera(), settings_for(Shading::gouraud)).frame;
    const auto bumps = [](int x, int) { return std::array<int, 3>{x & 1 ? 200 : 60, 128, 220}; };
    scene.materials[0].normal_texture = add_texture(scene, picture(rgb_pixels(16, 16, bumps)));
    const Picture mapped = draw_picture(scene, flat_camera(), settings_for(Shading::gouraud));
    EXPECT_TRUE(same_bits(mapped.frame, plain));
    ASSERT_EQ(mapped.remarks.size(), 1u);
    EXPECT_EQ(mapped.remarks[0].remark, Remark::dropped);
    EXPECT_EQ(draw_picture(scene, flat_camera(), settings_for(Shading::phong)).remarks.size(), 0u);
    RenderSettings without = settings_for(Shading::flat);
    without.bump = Bump::none;
    EXPECT_EQ(draw_picture(scene, flat_camera(), without).remarks.size(), 0u);
}

TEST(ShadingFrequency, HeightMapsAreLeftOutAndItIsSaidAlsoOfMaterialsThatNameATechnique) {
    Scene scene = scene_of(square_mesh(0), shiny());
    const auto bumps = [](int x, int y) { return std::array<int, 3>{16 * x, 16 * x, 8 * x + y}; };
    scene.materials[0].height_texture = add_texture(scene, picture(rgb_pixels(16, 16, bumps)));
    const auto said = [&](Bump bump, Shading shading) {
        RenderSettings s = settings_for(shading);
        s.bump = bump;
        const Picture p = draw_picture(scene, flat_camera(), s);
        return p.remarks.empty() ? std::string()
                                 : p.remarks.at(0).message.substr(0, 11) + std::to_string(p.remarks.size());
    };
    EXPECT_EQ(said(Bump::height, Shading::gouraud), "height maps1");
    EXPECT_EQ(said(Bump::steep, Shading::flat), "height maps1");
    EXPECT_EQ(said(Bump::height, Shading::phong), "");
    EXPECT_EQ(said(Bump::normal, Shading::gouraud), "");  // there is none
    EXPECT_EQ(said(Bump::none, Shading::gouraud), "");
    scene.materials[0].bump = Bump::occlusion;
    EXPECT_EQ(said(Bump::none, Shading::gouraud), "height maps1");
    scene.materials[0].bump = Bump::none;
    EXPECT_EQ(said(Bump::height, Shading::gouraud), "");
}

TEST(ShadingFrequency, TheBitsDoNotDependOnThreadsInstructionSetOrWindow) {
    Scene scene = scene_of(sphere(40, 60), shiny());
    scene.materials.push_back(single_sided());
    scene.materials[1].double_sided = true;
    add_object(scene, square_mesh(1, 3), translation(dvec3{0, 0, -1}));
    add_object(scene, sharp_cube(), translation(dvec3{1.5, 0, 0.5}) * scaling(dvec3{-0.5, 0.4, 0.7}));
    Light spot = lamp({-2, 0, 4});
    spot.type = LightType::spot;
    spot.cutoff_rad = 0.6f;
    spot.exponent = 8;
    scene.lights.push_back(spot);
    scene.lights.push_back(directional({1, -1, -2}, {0.3f, 0.3f, 0.4f}));
    const Camera camera = camera_at({0.3, 0.4, 4}, 60);
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
        const Picture first = draw_picture(scene, camera, settings_for(shading, 150));
        for (const int threads : {2, 4})
            EXPECT_TRUE(same_bits(draw_picture(scene, camera, settings_for(shading, 150), threads).frame, first.frame));
        for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            const IsaGuard guard(isa);
            const Picture other = draw_picture(scene, camera, settings_for(shading, 150));
            EXPECT_TRUE(same_bits(other.frame, first.frame)) << name(isa);
            EXPECT_EQ(other.stats.lighting_evaluations, first.stats.lighting_evaluations);
        }
        RenderSettings part = settings_for(shading, 150);
        part.window = {33, 50, 70, 81};
        const Picture window = draw_picture(scene, camera, part);
        for (int y = 0; y < 81; ++y)
            for (int x = 0; x < 70; ++x) ASSERT_EQ(window.at(x, y), first.at(x + 33, y + 50)) << x << ' ' << y;
    }
}

TEST(ShadingFrequency, DegenerateTrianglesAndNormalsGiveNoNotANumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Mesh mesh = square_mesh(0);
    mesh.normals = std::vector<vec3>{{0, 0, 0}, {nan, 0, 1}, {0, 0, 1}, {1e30f, 0, 0}};
    mesh.positions = std::vector<vec3>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, nan, 0}};
    const Scene scene = scene_of(mesh, shiny());
    for (const Shading s : {Shading::flat, Shading::gouraud})
        EXPECT_EQ(draw_picture(scene, flat_camera(), settings_for(s)).stats.pixels_not_finite, 0u);
}

TEST(ShadingFrequency, OverdrawCountsHowOftenPixelsWereWritten) {
    Scene scene = scene_of(square_mesh(0), matte());
    const Picture once = draw_picture(scene, flat_camera(), settings_for(Shading::phong));
    EXPECT_EQ(once.stats.depth_passes, 65u * 65u);
    EXPECT_EQ(once.stats.overdraw(), 1.0);
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, 1}));
    EXPECT_EQ(draw_picture(scene, flat_camera(), settings_for(Shading::phong)).stats.overdraw(), 2.0)
        << "the farther one is drawn first";
    scene.nodes[1].local.matrix = translation(dvec3{0, 0, -1});
    EXPECT_EQ(draw_picture(scene, flat_camera(), settings_for(Shading::phong)).stats.overdraw(), 1.0);
    EXPECT_EQ(RenderStats{}.overdraw(), 0.0) << "nothing covered";
}
