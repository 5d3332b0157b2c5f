// SPDX-License-Identifier: Apache-2.0
// The soft engine on small scenes whose pictures are known.
#include "engines/raster/raster_engine.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr RenderSettings small{.width = 64, .height = 64, .background = {0, 0, 0, 0}};

Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings = small, int threads = 1,
             RenderStats* stats = nullptr) {
    return draw(scene, camera, settings, threads, stats);
}

Scene lit_square(Material material = matte()) {
    Scene scene;
    scene.materials.push_back(std::move(material));
    add_object(scene, square_mesh(0));
    scene.lights.push_back(directional({0, 0, -1}));
    return scene;
}

std::size_t covered(const Frame& f) {
    std::size_t n = 0;
    for (const vec4& c : f.color) n += c.w > 0;
    return n;
}

Camera inside_camera() {
    Camera camera;
    camera.vertical_fov_rad = radians(80);
    camera.z_near = 0.05;
    camera.to_world = look_at({0.3, 0.2, 1}, {0, 0, -1}, {0, 1, 0});
    return camera;
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

}  // namespace

TEST(SoftEngine, AWhiteLambertSurfaceFacingALightOfColorOneHasRadianceOne) {
    const Frame f = render(lit_square(), flat_camera());
    EXPECT_EQ(covered(f), 64u * 64u);
    for (const vec4& c : f.color) EXPECT_NEAR(c.x, 1.0f, 1e-6f);
}

TEST(SoftEngine, LambertsCosine) {
    Scene scene = lit_square();
    scene.lights = {directional({0, std::sin(radians(60)), -std::cos(radians(60))})};
    EXPECT_NEAR(pixel(render(scene, flat_camera()), 32, 32).y, 0.5f, 1e-6f);
}

TEST(SoftEngine, TheSceneWithoutObjectsIsTheBackground) {
    RenderSettings s = small;
    s.background = {0.25f, 0.5f, 0.75f, 1};
    for (const vec4& c : render(Scene{}, flat_camera(), s).color) EXPECT_EQ(c, s.background);
}

TEST(SoftEngine, WithoutLightsOnlyEmissionShows) {
    Material glowing = matte();
    glowing.emission = {0.25f, 0, 2};
    Scene scene = lit_square(glowing);
    scene.lights.clear();
    const vec4 c = pixel(render(scene, flat_camera()), 3, 60);
    EXPECT_EQ(c.x, 0.25f);
    EXPECT_EQ(c.y, 0);
    EXPECT_EQ(c.z, 2);
}

TEST(SoftEngine, BackFacesOfSingleSidedSurfacesAreNotDrawnAndOfDoubleSidedOnesAreLit) {
    Material gltf = matte();
    gltf.model = MaterialModel::metallic_roughness;
    gltf.metallic_roughness.metallic = 0;
    Scene scene = lit_square(gltf);
    scene.nodes[0].local.matrix = scaling(dvec3{1, 1, -1}) * scaling(dvec3{-1, 1, 1});  // half a turn: its back is seen
    scene.lights = {directional({0, 0, -1})};
    EXPECT_EQ(covered(render(scene, flat_camera())), 0u);
    scene.materials[0].double_sided = true;
    const Frame f = render(scene, flat_camera());
    EXPECT_EQ(covered(f), 64u * 64u);
    EXPECT_GT(pixel(f, 20, 20).x, 0.8f) << "lit from the side that is seen";
}

TEST(SoftEngine, AMirroredPlacementKeepsItsOutside) {
    Material gltf = matte();
    gltf.model = MaterialModel::metallic_roughness;
    Scene scene = lit_square(gltf);
    const Frame plain = render(scene, flat_camera());
    scene.nodes[0].local.matrix = scaling(dvec3{-1, 1, 1});
    const Frame mirrored = render(scene, flat_camera());
    EXPECT_EQ(covered(mirrored), 64u * 64u);
    EXPECT_NEAR(pixel(plain, 9, 9).x, pixel(mirrored, 9, 9).x, 1e-6f);
}

TEST(SoftEngine, AModelAThousandKilometersAwayRendersLikeItself) {
    Scene scene = busy_scene();
    const Frame here = render(scene, inside_camera());
    const dvec3 far = {1e6, -3e5, 7e5};
    for (Node& n : scene.nodes) n.local.matrix = translation(far) * *n.local.matrix;
    for (Light& l : scene.lights) l.position = l.position + far;
    Camera camera = inside_camera();
    camera.to_world = translation(far) * camera.to_world;
    const Frame there = render(scene, camera);
    std::size_t off = 0;
    for (std::size_t i = 0; i < here.color.size(); ++i)
        off += std::fabs(here.color[i].x - there.color[i].x) > 2.0f / 255;
    EXPECT_LE(off, here.color.size() / 500);
}

TEST(SoftEngine, AFloorThroughTheEyePlaneDoesNotWrapRound) {
    Scene scene = lit_square();
    Mesh floor = square_mesh(0);
    floor.positions = std::vector<vec3>{{-1000, -1, 1000}, {1000, -1, 1000}, {1000, -1, -1000}, {-1000, -1, -1000}};
    scene.meshes[0] = floor;
    Camera camera;
    camera.vertical_fov_rad = radians(90);
    camera.z_near = 0.1;
    camera.z_far = 1e5;
    const Frame f = render(scene, camera);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_EQ(pixel(f, x, y).w > 0, y >= 32) << x << ", " << y;
}

TEST(SoftEngine, TheNearerSurfaceHidesTheFartherWhateverTheOrder) {
    for (const bool swapped : {false, true}) {
        Scene scene;
        scene.materials = {matte({1, 0, 0}), matte({0, 1, 0})};
        add_object(scene, square_mesh(swapped ? 1 : 0), translation(dvec3{0, 0, swapped ? -1.0 : 0.0}));
        add_object(scene, square_mesh(swapped ? 0 : 1), translation(dvec3{0, 0, swapped ? 0.0 : -1.0}));
        scene.lights = {directional({0, 0, -1})};
        const vec4 c = pixel(render(scene, flat_camera()), 32, 32);
        EXPECT_GT(c.x, 0.9f);
        EXPECT_EQ(c.y, 0);
    }
}

TEST(SoftEngine, MaskedTexelsAreHolesAndBlendedSurfacesMix) {
    Scene scene;
    Material mask = matte({1, 0, 0});
    mask.alpha_mode = AlphaMode::mask;
    Pixels half = rgb_pixels(2, 1, [](int x, int) { return std::array<int, 4>{255, 255, 255, x == 0 ? 255 : 0}; });
    half.channels = 4;
    mask.base_color_texture =
        add_texture(scene, picture(half), {.magnify = Filter::nearest, .minify = Filter::nearest});
    Material glass = matte({0, 0, 1});
    glass.alpha_mode = AlphaMode::blend;
    glass.base_color.w = 0.25f;
    scene.materials = {mask, matte({0, 1, 0}), glass};
    add_object(scene, square_mesh(2), translation(dvec3{0, 0, 1}));
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh(1), translation(dvec3{0, 0, -1}));
    scene.lights = {directional({0, 0, -1})};
    const Frame f = render(scene, flat_camera());
    const vec4 left = pixel(f, 10, 32), right = pixel(f, 50, 32);
    EXPECT_NEAR(left.x, 0.75f, 1e-5f);
    EXPECT_NEAR(left.y, 0, 1e-5f);
    EXPECT_NEAR(left.z, 0.25f, 1e-5f);
    EXPECT_NEAR(right.x, 0, 1e-5f) << "through the hole the green square shows";
    EXPECT_NEAR(right.y, 0.75f, 1e-5f);
}

TEST(SoftEngine, ANormalMapTurnsTheNormalTowardsGreenUp) {
    Scene scene;
    Material bumpy = matte();
    const auto up = [](int, int) {
        return std::array<int, 3>{128, 218, 218};
    };  // (0, 0.71, 0.71): leans to the picture's top
    bumpy.normal_texture = add_texture(scene, picture(rgb_pixels(4, 4, up)));
    scene.materials = {bumpy};
    add_object(scene, square_mesh(0));
    scene.lights = {directional({0, -1, -1})};  // from above, 45 degrees
    EXPECT_NEAR(pixel(render(scene, flat_camera()), 32, 32).x, 1.0f, 0.01f);
    RenderSettings flat = small;
    flat.bump = Bump::none;
    EXPECT_NEAR(pixel(render(scene, flat_camera(), flat), 32, 32).x, 0.7071f, 0.01f);
}

// A tangent that leans 45 degrees out of the surface: put right it lies in it, left alone the bump along it leans too.
TEST(SoftEngine, TangentsAreUsedAsTheyAreWhereTheyAreNotToBeMadePerpendicular) {
    Scene scene;
    Material bumpy = matte();
    const auto along = [](int, int) { return std::array<int, 3>{218, 128, 218}; };  // (0.71, 0, 0.71)
    bumpy.normal_texture = add_texture(scene, picture(rgb_pixels(4, 4, along)));
    scene.materials = {bumpy};
    Mesh square = square_mesh(0);
    const float half = std::sqrt(0.5f);
    square.tangents = std::vector<vec4>(square.positions.size(), {half, 0, half, 1});
    add_object(scene, square);
    scene.lights = {directional({0, 0, -1})};  // along the normal
    RenderSettings settings = small;
    EXPECT_NEAR(pixel(render(scene, flat_camera(), settings), 32, 32).x, std::sqrt(0.5f), 0.01f);
    settings.orthogonalize = false;
    const Frame raw = render(scene, flat_camera(), settings);
    // m.x T + m.z N = 0.71 (0.71, 0, 1.71), made unit
    EXPECT_NEAR(pixel(raw, 32, 32).x, (half + 1) / std::sqrt(0.5f + (half + 1) * (half + 1)), 0.01f);
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        for (const int threads : {1, 4})
            EXPECT_TRUE(same_bits(raw, render(scene, flat_camera(), settings, threads))) << name(isa) << threads;
    }
    Mesh without = square_mesh(0);
    without.tangents = std::vector<vec4>(without.positions.size(), {0, 0, 0, 1});
    scene.meshes[0] = without;
    EXPECT_TRUE(is_finite(pixel(render(scene, flat_camera(), settings), 32, 32).xyz()))
        << "a tangent of no length falls back";
}

TEST(SoftEngine, AWindowHasTheBitsOfTheWhole) {
    const Scene scene = busy_scene();
    RenderSettings settings = small;
    settings.width = 200;
    settings.height = 150;
    const Frame whole = render(scene, inside_camera(), settings);
    settings.window = {37, 21, 90, 77};
    const Frame part = render(scene, inside_camera(), settings);
    for (int y = 0; y < 77; ++y)
        EXPECT_EQ(std::memcmp(&part.color[std::size_t(y * 90)], &whole.color[std::size_t((y + 21) * 200 + 37)],
                              90 * sizeof(vec4)),
                  0);
}

TEST(SoftEngine, TheSameBitsForAnyNumberOfThreadsAndEachInstructionSet) {
    const Scene scene = busy_scene();
    RenderSettings settings = small;
    settings.width = 300;
    settings.height = 200;
    const Frame reference = [&] {
        const IsaGuard guard(Isa::scalar);
        return render(scene, inside_camera(), settings);
    }();
    EXPECT_GT(covered(reference), 10000u);
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        for (const int threads : {1, 2, 4})
            EXPECT_TRUE(same_bits(reference, render(scene, inside_camera(), settings, threads)))
                << name(isa) << threads;
    }
}

TEST(SoftEngine, AnUnknownInstructionSetIsRefused) {
    setenv("RAKELIGHT_ISA", "avx1024", 1);
    EXPECT_THROW(raster::make_engine(), Error);
    unsetenv("RAKELIGHT_ISA");
}

TEST(SoftEngine, ChannelsHoldDepthNormalObjectAndMaterial) {
    RenderSettings settings = small;
    settings.channels = channel_depth | channel_normal | channel_object | channel_material;
    Camera camera = flat_camera();
    camera.half_height = 2;
    const Frame f = render(lit_square(), camera, settings);
    const auto middle = std::size_t(32 * 64 + 32);
    EXPECT_NEAR(f.depth[middle], 5.0f, 1e-4f);
    EXPECT_NEAR(f.normal[middle].z, 1.0f, 1e-6f);
    EXPECT_EQ(f.object[middle], 0u);
    EXPECT_EQ(f.material[middle], 0u);
    EXPECT_EQ(f.depth[0], std::numeric_limits<float>::infinity());
    EXPECT_EQ(f.object[0], no_index);
}

TEST(SoftEngine, CountsWhatHappensToTriangles) {
    RenderStats stats;
    render(lit_square(), flat_camera(), small, 1, &stats);
    EXPECT_EQ(stats.triangles_in, 2u);
    EXPECT_EQ(stats.drawn, 2u);
    EXPECT_EQ(stats.pixels_covered, 64u * 64u);
    EXPECT_EQ(stats.objects_outside, 0u);
    Camera away = flat_camera();
    away.to_world = translation(dvec3{100, 0, 5});
    render(lit_square(), away, small, 1, &stats);
    EXPECT_EQ(stats.culled_outside, 2u);
    EXPECT_EQ(stats.drawn, 0u);
    EXPECT_EQ(stats.objects_outside, 1u);
}

TEST(SoftEngine, CountsObjectsOfWhichNoMeshMayBeSeen) {
    Scene scene = lit_square();
    const dmat4 aside = translation(dvec3{50, 0, 0});
    add_object(scene, square_mesh(0), aside);
    scene.nodes.back().meshes.push_back(0);  // two meshes of one object
    Mesh wide = square_mesh(0);
    wide.positions = std::vector<vec3>{{-60, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-60, 1, 0}};
    scene.meshes.push_back(wide);
    add_object(scene, square_mesh(0), aside);
    scene.nodes.back().meshes.push_back(
        std::uint32_t(scene.meshes.size() - 2));  // `wide`, that reaches into the picture
    RenderStats stats;
    render(scene, flat_camera(), small, 1, &stats);
    EXPECT_EQ(stats.objects_outside, 1u);
    EXPECT_EQ(stats.triangles_in, 10u);
}

TEST(SoftEngine, ImpossibleCamerasAndSettingsAreRefused) {
    Camera camera = flat_camera();
    camera.z_far = camera.z_near;
    EXPECT_THROW(render(lit_square(), camera), Error);
    RenderSettings s = small;
    s.width = 0;
    EXPECT_THROW(render(lit_square(), flat_camera(), s), Error);
    s = small;
    s.window = {60, 0, 10, 10};
    EXPECT_THROW(render(lit_square(), flat_camera(), s), Error);
}

TEST(SoftEngine, NothingIsNotANumberForDegenerateAndExtremeInput) {
    for (const float size : {1e-30f, 1e-12f, 1e12f, 1e30f}) {
        Scene scene = lit_square();
        std::vector<vec3> scaled;
        for (const vec3& p : scene.meshes[0].positions) scaled.push_back(p * size);
        scene.meshes[0].positions = scaled;
        scene.meshes[0].normals = std::vector<vec3>(4, vec3{0, 0, 0});
        Camera camera;
        camera.z_near = double(size) * 0.01;
        camera.z_far = double(size) * 100;
        camera.to_world = translation(dvec3{0, 0, 4.0 * double(size)});
        RenderStats stats;
        const Frame f = render(scene, camera, small, 1, &stats);
        EXPECT_EQ(stats.pixels_not_finite, 0u) << size;
        EXPECT_GT(covered(f), 500u) << size;
    }
}

TEST(SoftEngine, CornersAtAnyDistanceAndAnyNearPlaneDoNotWrapRound) {
    for (const double near : {1e-300, 1e-38, 1e-3, 1.0})
        for (const float size : {1e3f, 1e6f, 1e9f, 1e18f, 1e30f, 1e37f}) {
            Scene scene = lit_square();
            scene.meshes[0].positions =
                std::vector<vec3>{{-size, -2, size}, {size, -2, 1}, {size, -2, -size}, {-size, -2, -size}};
            Camera camera;
            camera.z_near = near;
            camera.z_far = std::numeric_limits<double>::infinity();
            const Frame f = render(scene, camera);
            for (int x = 0; x < 64; ++x)
                EXPECT_EQ(pixel(f, x, 4).w, 0) << "above the horizon: " << near << ", " << size;
            if (size > 1e10f) continue;  // beyond, what lies 2 below the eye is too thin for double
            EXPECT_GT(pixel(f, 32, 60).w, 0) << "the floor: " << near << ", " << size;
        }
}

TEST(SoftEngine, AnUnlitMaterialShowsItsBaseColorAlone) {
    Material own = matte({0.25f, 0.5f, 0.75f});
    own.model = MaterialModel::unlit;
    own.emission = {1, 1, 1};  // KHR_materials_unlit: only the base color counts
    EXPECT_EQ(pixel(render(lit_square(own), flat_camera()), 9, 9), (vec4{0.25f, 0.5f, 0.75f, 1}));
}

TEST(SoftEngine, OpacityBeyondItsRangeCountsAsItsEnds) {
    for (const float alpha : {-3.0f, 5.0f}) {
        Material glass = matte({0, 0, 1});
        glass.alpha_mode = AlphaMode::blend;
        Scene scene = lit_square(glass);
        scene.meshes[0].colors = std::vector<vec4>(4, vec4{1, 1, 1, alpha});
        RenderSettings s = small;
        s.background = {1, 0, 0, 1};
        const vec4 c = pixel(render(scene, flat_camera(), s), 9, 9);
        EXPECT_NEAR(c.x, alpha < 0 ? 1 : 0, 1e-6f);
        EXPECT_NEAR(c.z, alpha < 0 ? 0 : 1, 1e-6f);
        EXPECT_EQ(c.w, 1);
    }
}

TEST(SoftEngine, InstancesAndLargeTrianglesWithoutNumberAreRefusedBeforeTheyFillMemory) {
    Scene instances = lit_square();
    instances.meshes[0].positions = std::vector<vec3>(10000, vec3{0, 0, 0});
    instances.meshes[0].normals = std::vector<vec3>(10000, vec3{0, 0, 1});
    instances.meshes[0].texcoords.clear();
    instances.meshes[0].tangents = {};
    for (int n = 0; n < 1000; ++n) {
        instances.nodes.push_back(instances.nodes[0]);
        instances.nodes.back().local.matrix = dmat4{};
    }
    Scene triangles = lit_square();
    std::vector<std::uint32_t> indices;
    for (int n = 0; n < 30000; ++n) indices.insert(indices.end(), {0, 1, 2});
    triangles.meshes[0].indices = indices;
    for (const Scene& scene : {instances, triangles})
        for (const int threads : {1, 4}) {
            Context context({.threads = threads, .max_memory = 100'000'000});
            auto engine = raster::make_engine();
            engine->prepare(scene, context);
            Frame frame;
            try {
                engine->render(flat_camera(), {.width = 2048, .height = 2048}, frame, context);
                FAIL() << "not refused";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::bad_file);
                EXPECT_EQ(error.reason(),
                          "the picture's triangles, lines and points need more than 50000000 bytes, half of the limit");
            }
        }
}

TEST(SoftEngine, MeshesWithoutNormalsAreLitFromOutsideWhicheverWayFrontsTurn) {
    for (const MaterialModel model : {MaterialModel::classical, MaterialModel::metallic_roughness}) {
        Scene scene = busy_scene();  // seen from both sides, mirrored ones and cut ones among them
        for (Material& m : scene.materials) {
            m.model = model;
            m.double_sided = true;
            m.normal_texture = {};  // needs tangents, which are made for one side
        }
        for (Mesh& mesh : scene.meshes) {
            mesh.normals = {};
            mesh.tangents = {};
        }
        RenderSettings clockwise = small;
        clockwise.front_face = FrontFace::clockwise;
        RenderStats stats;
        const Frame reference = render(scene, inside_camera(), small, 1, &stats);
        EXPECT_GT(stats.clipped, 0u);
        EXPECT_TRUE(same_bits(render(scene, inside_camera(), clockwise), reference)) << int(model);
    }
}

TEST(SoftEngine, APrepareThatFailsLeavesAnEmptySceneAndTheNextOneIsAsEver) {
    Material painted = matte();
    painted.base_color_texture.texture = 0;
    Scene scene = lit_square(painted), other = scene;
    scene.textures.push_back({.image = picture(rgb_pixels(4, 4, [](int, int) { return std::array{200, 100, 50}; }))});
    other.textures.push_back({.image = picture(rgb_pixels(4, 4, [](int, int) { return std::array{50, 100, 200}; }))});
    const Frame reference = render(scene, flat_camera());
    const auto engine = raster::make_engine();
    Context context({.threads = 1}), cancelled({.threads = 1});
    engine->prepare(scene, context);
    cancelled.cancel();
    EXPECT_THROW(engine->prepare(other, cancelled), Error);
    EXPECT_TRUE(engine->scene().meshes.empty());
    Frame empty, again;
    engine->render(flat_camera(), small, empty, context);
    EXPECT_EQ(covered(empty), 0u);
    engine->prepare(scene, context);
    engine->render(flat_camera(), small, again, context);
    EXPECT_TRUE(same_bits(again, reference));
}

TEST(SoftEngine, APictureOfTheGreatestSizeHasTheBitsOfItsWindow) {
    RenderSettings settings = small;
    settings.width = settings.height = 65536;
    settings.window = {65536 - 40, 65536 - 30, 40, 30};  // the last tile
    Scene scene = lit_square();
    RenderStats stats;
    const Frame f = render(scene, flat_camera(), settings, 1, &stats);
    EXPECT_EQ(covered(f), 40u * 30u);
    EXPECT_EQ(stats.pixels_covered, 40u * 30u) << "and no more";
}
