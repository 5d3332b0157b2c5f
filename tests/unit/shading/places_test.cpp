// SPDX-License-Identifier: Apache-2.0
// Views, rays of pixels, cameras of shadow maps, what lights reach, and vertices about the eye: against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "math/linear.h"
#include "shading/draw_frame.h"
#include "shading/lights/light_reach.h"
#include "shading/lights/lights.h"
#include "shading/lights/shadow_cameras.h"
#include "support/scene_builder.h"
#include "unit/shading/fake_textures.h"

namespace rakelight::shading {
namespace {

using test::add_object;
using test::matte;
using test::square_mesh;

Camera looking_down_z(double distance) {
    Camera camera;
    camera.vertical_fov_rad = radians(90.0);
    camera.z_near = 0.5, camera.z_far = 100;
    camera.to_world = translation(dvec3{0, 0, distance});
    return camera;
}

DrawList list_of(Scene scene) {
    Context context({.threads = 1});
    TextureCache textures;
    return make_draw_list(std::move(scene), textures, test::FakePacker(), context);
}

Scene one_square(const dmat4& to_world = {}) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0), to_world);
    return scene;
}

TEST(PixelRays, LeadThroughThePixelsOfPerspectiveAndParallelViews) {
    const DrawList list = list_of(one_square());
    const RenderSettings s{.width = 200, .height = 100};
    const PictureCamera view = picture_camera_of(list, looking_down_z(5), s);
    const dvec3 corner = pixel_rays(view, 0, 0).at(-0.5, -0.5), middle = pixel_rays(view, 100, 50).at(-0.5, -0.5);
    EXPECT_NEAR(corner.x, -2, 1e-12);  // a picture twice as wide as high, 45 degrees up
    EXPECT_NEAR(corner.y, 1, 1e-12);
    EXPECT_NEAR(corner.z, -1, 1e-12);
    EXPECT_NEAR(length(middle - dvec3{0, 0, -1}), 0, 1e-12);
    const PictureCamera flat = picture_camera_of(list, test::flat_camera(), {.width = 100, .height = 100});
    EXPECT_NEAR(length(pixel_rays(flat, 0, 0).at(-0.5, -0.5) - dvec3{-1, 1, 0}), 0, 1e-12);
}

Light lamp(LightType type, double range = std::numeric_limits<double>::infinity()) {
    Light light;
    light.type = type;
    light.position = {0, 0, 3};
    light.direction = {0, 0, -1};
    light.range = float(range);
    return light;
}

TEST(LightReach, ALightThatEndsIsLeftOutBeyondItsRangeAndNoneThatGoesOn) {
    Scene scene = one_square();
    scene.lights = {lamp(LightType::point, 1), lamp(LightType::point), lamp(LightType::directional)};
    const DrawList list = list_of(scene);
    const auto lights = make_lights(list.scene, list.node_to_world, {0, 0, 5});
    const LightReach reach(lights);
    std::vector<lighting::LightParameters> to;
    reach.in_box({{-1, -1, -3.2f}, {1, 1, -2.9f}}, nullptr, to);  // about the eye: the lamp is at z = -2, 0.9 away
    EXPECT_EQ(to.size(), 3u);
    reach.in_box({{-1, -1, -4}, {1, 1, -3.5f}}, nullptr, to);  // 1.5 away
    EXPECT_EQ(to.size(), 2u);
    const PictureCamera view = picture_camera_of(list, looking_down_z(5), {.width = 256, .height = 256});
    std::vector<std::uint32_t> seen;
    reach.in_square(view, 96, 96, 64, seen);
    EXPECT_EQ(seen.size(), 3u) << "the lamp stands in the middle";
    reach.in_square(view, 0, 0, 16, seen);
    EXPECT_EQ(seen.size(), 2u) << "its sphere of 1 m at 2 m is not in the corner";
}

TEST(ShadowCameras, OneForDirectionalLightsAndNarrowSpotsSixForWideOnesAndPointsNoneForAmbient) {
    Light spot = lamp(LightType::spot);
    spot.cutoff_rad = radians(30.0);
    EXPECT_EQ(shadow_map_count(spot), 1u);
    spot.cutoff_rad = radians(61.0);
    EXPECT_EQ(shadow_map_count(spot), 6u);
    EXPECT_EQ(shadow_map_count(lamp(LightType::point)), 6u);
    EXPECT_EQ(shadow_map_count(lamp(LightType::directional)), 1u);
    EXPECT_EQ(shadow_map_count(lamp(LightType::ambient)), 0u);
    Light unshaded = lamp(LightType::point);
    unshaded.casts_shadow = false;
    EXPECT_EQ(shadow_map_count(unshaded), 0u);
}

TEST(ShadowCameras, OfADirectionalLightSeesAllThatIsDrawn) {
    Scene scene = one_square();
    add_object(scene, square_mesh(0), translation(dvec3{7, -3, 20}));
    const DrawList list = list_of(scene);
    Light light = lamp(LightType::directional);
    light.direction = {1, -2, 0.5};
    RenderSettings s;
    s.shadow_size = 256;
    const auto cameras = shadow_cameras(list, light, s);
    ASSERT_EQ(cameras.size(), 1u);
    const MapCamera& m = cameras[0];
    for (const dvec3 p : {dvec3{-1, -1, 0}, dvec3{8, -2, 20}, dvec3{6, -4, 20}, dvec3{1, 1, 0}}) {
        const dvec3 d = p - m.eye;
        EXPECT_LE(std::abs(dot(d, m.axes.x)), m.camera.half_height);
        EXPECT_LE(std::abs(dot(d, m.axes.y)), m.camera.half_height);
        EXPECT_GE(dot(d, m.axes.z), m.camera.z_near);
        EXPECT_LE(dot(d, m.axes.z), m.camera.z_far);
    }
}

TEST(ShadowCameras, MapsThatTakeMoreThanHalfOfTheMemoryAreRefusedWithTheirNumbers) {
    const std::vector<Light> lights = {lamp(LightType::point)};
    RenderSettings s;
    s.shadow_size = 1024;
    s.shadows = true;
    const Context little({.max_memory = 64 << 20});
    EXPECT_THROW(check_shadow_memory(lights, s, const_cast<Context&>(little).memory()), Error);  // 6 x 8 MiB
    s.shadow_size = 512;
    EXPECT_NO_THROW(check_shadow_memory(lights, s, const_cast<Context&>(little).memory()));
}

TEST(ShadowFactors, TakePositionsAboutTheEyeToTheMapsAxes) {
    const DrawList list = list_of(one_square());
    RenderSettings s;
    s.shadow_size = 200, s.shadow_bias = 1.5f, s.shadow_filter = 2;
    const Light light = lamp(LightType::point);  // at (0, 0, 3)
    const auto cameras = shadow_cameras(list, light, s);
    ASSERT_EQ(cameras.size(), 6u);
    const dvec3 eye = {1, 2, 3}, point = {0.5, -0.25, 7};
    RenderSettings of_map;
    of_map.width = of_map.height = 200;
    const PictureCamera view = picture_camera_of(list, cameras[5].camera, of_map);
    const ShadowFactors f = shadow_factors(cameras[0], view, 6, s, eye);
    EXPECT_EQ(f.faces, 6);
    EXPECT_EQ(f.size, 200);
    EXPECT_EQ(f.is_orthographic, 0);
    const dvec3 about = point - eye, from_light = point - dvec3{0, 0, 3};
    for (std::size_t c = 0; c < 3; ++c)  // the axes of the world
        EXPECT_NEAR(double(f.to_light[c][0]) * about.x + double(f.to_light[c][1]) * about.y +
                        double(f.to_light[c][2]) * about.z + double(f.to_light[c][3]),
                    from_light[c], 1e-6);
    EXPECT_LT(f.texels, 100.0f);  // 90 degrees and the filter's margin lie in 200 texels
    EXPECT_GT(f.texels, 90.0f);
}

TEST(HasShadowMaps, ScenesBeyondFloatsHaveNoneAndSaySo) {
    DrawList list;
    list.draws.emplace_back();
    list.bounds = {{-1, -1, -1}, {1, 1, 1}};
    RenderSettings settings;
    Context context({.threads = 1});
    EXPECT_FALSE(has_shadow_maps(list, settings, context.report())) << "nobody asked";
    settings.shadows = true;
    EXPECT_TRUE(has_shadow_maps(list, settings, context.report()));
    EXPECT_TRUE(context.report().entries().empty());
    list.bounds = {{-1e30, 0, 0}, {1e30, 0, 0}};
    EXPECT_FALSE(has_shadow_maps(list, settings, context.report()));
    EXPECT_EQ(context.report().entries().size(), 1u);
    list.draws.clear();
    EXPECT_FALSE(has_shadow_maps(list, settings, context.report())) << "of nothing";
    EXPECT_EQ(context.report().entries().size(), 1u);
}

TEST(NarrowDepths, ParallelViewsOfAWideRangeComeToTheSceneOthersStay) {
    const Bounds drawn{{-1, -1, -1}, {1, 1, 1}};
    Camera camera = test::flat_camera();  // from z = 5
    RenderSettings s;
    s.width = s.height = 8;
    PictureCamera view = make_picture_camera(camera, camera.to_world, s);
    narrow_depths(view, drawn);
    EXPECT_EQ(view.z_near, 0.1);
    EXPECT_EQ(view.z_far, 100);
    camera.z_far = 1e6;
    view = make_picture_camera(camera, camera.to_world, s);
    narrow_depths(view, drawn);
    EXPECT_LE(view.z_near, 4);
    EXPECT_GE(view.z_far, 6);
    EXPECT_LT(view.z_far - view.z_near, 10);
}

TEST(MakeLights, OfANodeStandAndShineAsItDoesAboutTheEye) {
    Scene scene = one_square();
    dmat4 turned;  // looks along +X
    turned[0] = {0, 0, 1, 0}, turned[2] = {-1, 0, 0, 0}, turned[3] = {4, 5, 6, 1};
    Node node;
    node.local.matrix = turned;
    scene.nodes.push_back(node);
    Light light = lamp(LightType::spot, 0);
    light.node = 1;
    light.cutoff_rad = radians(60.0);
    scene.lights = {light, lamp(LightType::ambient)};
    const DrawList list = list_of(std::move(scene));
    const auto lights = make_lights(list.scene, list.node_to_world, {1, 1, 1});
    EXPECT_EQ(lights[0].position[0], 3);
    EXPECT_EQ(lights[0].position[2], 5);
    EXPECT_NEAR(lights[0].direction[0], 1, 1e-7);
    EXPECT_NEAR(lights[0].cos_cutoff, 0.5, 1e-7);
    EXPECT_TRUE(std::isfinite(lights[0].inverse_range)) << "a range of 0 is the least one";
    EXPECT_TRUE(lights[0].casts_shadow);
    EXPECT_FALSE(lights[1].casts_shadow);
    EXPECT_EQ(lights[1].inverse_range, 0);
}

TEST(DrawFrame, VerticesAreAboutTheEyeAndFramesKeepTheirHandAcrossMirrors) {
    dmat4 mirror;
    mirror[0].x = -2;
    for (const bool is_mirrored : {false, true}) {
        const DrawList list = list_of(one_square(is_mirrored ? mirror : dmat4{}));
        const PictureCamera view = picture_camera_of(list, looking_down_z(5), {.width = 8, .height = 8});
        const dmat4 to_eye = view.world_to_eye * list.draws[0].to_world;
        const DrawFrame frame(list, list.draws[0], to_eye, view, FrontFace::counter_clockwise);
        const DrawFrame::Corners c = frame.corners(0);
        EXPECT_NEAR(length(c.position[0] - dvec3{is_mirrored ? 2.0 : -1.0, -1, -5}), 0, 1e-12);
        EXPECT_NEAR(length(c.normal[0] - dvec3{0, 0, 1}), 0, 1e-12);
        EXPECT_NEAR(length(c.tangent[0] - dvec3{is_mirrored ? -1.0 : 1.0, 0, 0}), 0, 1e-12);
        EXPECT_EQ(c.handedness, is_mirrored ? -1 : 1);
        const DrawFrame::Face face = frame.face(0);
        EXPECT_NEAR(length(face.normal - dvec3{0, 0, 1}), 0, 1e-12) << "towards the viewer";
        EXPECT_NEAR(face.centroid.z, -5, 1e-12);
    }
}

TEST(DrawFrame, FacesSeenFromBehindTurnTheirNormalsToTheViewer) {
    const DrawList list = list_of(one_square());
    Camera behind = looking_down_z(0);
    behind.to_world[0].x = -1, behind.to_world[2].z = -1, behind.to_world[3].z = -5;
    const PictureCamera view = picture_camera_of(list, behind, {.width = 8, .height = 8});
    const dmat4 to_eye = view.world_to_eye * list.draws[0].to_world;
    const DrawFrame frame(list, list.draws[0], to_eye, view, FrontFace::counter_clockwise);
    EXPECT_NEAR(length(frame.face(0).normal - dvec3{0, 0, -1}), 0, 1e-12);
    EXPECT_EQ(frame.seen_side(0, false), 0);
    EXPECT_EQ(frame.seen_side(0, true), 1);
}

TEST(DrawFrame, WithoutNormalsCornersHaveThoseOfTheFaceOnItsFront) {
    Scene scene = one_square();
    scene.meshes[0].normals = std::vector<vec3>{};
    scene.meshes[0].tangents = std::vector<vec4>{};
    const DrawList list = list_of(std::move(scene));
    const PictureCamera view = picture_camera_of(list, looking_down_z(5), {.width = 8, .height = 8});
    const dmat4 to_eye = view.world_to_eye * list.draws[0].to_world;
    const DrawFrame front(list, list.draws[0], to_eye, view, FrontFace::counter_clockwise);
    const DrawFrame turned(list, list.draws[0], to_eye, view, FrontFace::clockwise);
    EXPECT_NEAR(length(front.corners(0).normal[2] - dvec3{0, 0, 1}), 0, 1e-12);
    EXPECT_NEAR(length(turned.corners(0).normal[2] - dvec3{0, 0, -1}), 0, 1e-12);
    EXPECT_EQ(front.corners(0).tangent[0].x, 0);
}

}  // namespace
}  // namespace rakelight::shading
