// SPDX-License-Identifier: Apache-2.0
// Scenes that are valid and strange, and pictures that are not what they say: drawn or refused, but never a crash.
#include "unit/tools/misuse_support.h"

namespace rakelight {
namespace {

using namespace test;

class StrangeScene : public testing::TestWithParam<Fault> {};

TEST_P(StrangeScene, IsDrawnOrRefusedByEveryDoor) {
    Scene scene = triangle_scene();
    GetParam().spoil(scene);
    EXPECT_NO_THROW(validate(scene));
    for (const Door& door : doors()) {
        Context context({.threads = 2});
        try {
            door.open(scene, context);
        } catch (const Error& error) {
            EXPECT_FALSE(error.reason().empty()) << door.name;
        }
    }
}

/// The texture in every role, with displacement and without.
void use_image(Scene& s, EncodedImage image, Bump bump) {
    s.textures.push_back({"", std::make_shared<const EncodedImage>(std::move(image)), {}});
    Material& m = s.materials[0];
    for (TextureUse* use : {&m.base_color_texture, &m.normal_texture, &m.height_texture, &m.opacity_texture,
                            &m.emission_texture, &m.metallic_roughness.texture})
        use->texture = 0;
    m.bump = bump;
    s.environment.emplace().image = s.textures[0].image;
}

std::function<void(Scene&)> with_pixels(Pixels pixels, Bump bump = Bump::automatic) {
    return [=](Scene& s) {
        use_image(s, {.name = "picture", .decode = [=](const EncodedImage&, Context&) { return pixels; }}, bump);
    };
}

std::vector<std::byte> zeros(std::size_t count) { return std::vector<std::byte>(count); }

/// What decoding gives is looked at when it is needed: a remark of the report, as for a picture file that is broken.
const Fault pictures[] = {
    {"NoDecoder", [](Scene& s) { use_image(s, {.name = "picture"}, Bump::automatic); }},
    {"NoDecoderDisplaced", [](Scene& s) { use_image(s, {.name = "picture"}, Bump::displacement); }},
    {"DecoderThatThrows",
     [](Scene& s) {
         use_image(s,
                   {.decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "no"); }},
                   Bump::height);
     }},
    {"NoPixels", with_pixels({})},
    {"NoPixelsDisplaced", with_pixels({}, Bump::displacement)},
    {"ShortPixels", with_pixels({2, 2, 4, Component::u8, false, zeros(15)})},
    {"ShortPixelsDisplaced", with_pixels({2, 2, 4, Component::u8, false, zeros(15)}, Bump::displacement)},
    {"ShortPixelsHeight", with_pixels({4, 4, 1, Component::f32, true, zeros(3)}, Bump::occlusion)},
    {"EmptyBytes", with_pixels({64, 64, 3, Component::u16, false, {}})},
    {"LongPixels", with_pixels({1, 1, 4, Component::u8, false, zeros(400)})},
    {"NegativeSize", with_pixels({-2, -2, 4, Component::u8, false, zeros(16)})},
    {"NoChannels", with_pixels({2, 2, 0, Component::u8, false, {}})},
    {"FiveChannels", with_pixels({2, 2, 5, Component::u8, false, zeros(20)})},
    {"NegativeChannels", with_pixels({2, -2, -4, Component::u8, false, zeros(16)})},
    {"NoComponent", with_pixels({2, 2, 4, no_such<Component>(), false, zeros(64)})},
    {"SizeThatOverflows", with_pixels({1 << 30, 1 << 30, 4, Component::f32, true, {}})},
    {"LargestSize", with_pixels({2147483647, 2147483647, 4, Component::f32, true, zeros(16)})},
};

const Fault extremes[] = {
    {"Nothing", [](Scene& s) { s = {}; }},
    {"EmptyMesh", [](Scene& s) { s.meshes[0] = {}; }},
    {"NoNodes", [](Scene& s) { s.nodes.clear(); }},
    {"NanPosition",
     [](Scene& s) {
         s.meshes[0].positions = Points{{nan_f, 0, 0}, {1, 0, 0}, {0, 1, 0}};
     }},
    {"LargestPositions",
     [](Scene& s) {
         s.meshes[0].positions = Points{{3e38f, 0, 0}, {-3e38f, 3e38f, 0}, {0, -3e38f, 3e38f}};
     }},
    {"SmallestPositions",
     [](Scene& s) {
         s.meshes[0].positions = Points{{1e-45f, 0, 0}, {0, 1e-45f, 0}, {0, 0, 0}};
     }},
    {"NanNormals",
     [](Scene& s) {
         s.meshes[0].normals = Points(3, {nan_f, inf_f, 0});
     }},
    {"NanTangents",
     [](Scene& s) {
         s.meshes[0].tangents = std::vector<vec4>(3, {nan_f, inf_f, 0, nan_f});
     }},
    {"NanTexcoords",
     [](Scene& s) {
         s.meshes[0].texcoords = {std::vector<vec2>(3, {nan_f, inf_f})};
     }},
    {"LargeTexcoords",
     [](Scene& s) {
         s.meshes[0].texcoords = {std::vector<vec2>{{3e38f, 0}, {-3e38f, 0}, {0, 3e38f}}};
     }},
    {"NanColors",
     [](Scene& s) {
         s.meshes[0].colors = std::vector<vec4>(3, {nan_f, -1, 3e38f, nan_f});
     }},
    {"LargeColors",
     [](Scene& s) {
         s.materials[0].base_color = {3e38f, -3e38f, 3e38f, 9}, s.materials[0].emission = {3e38f, 3e38f, 3e38f};
     }},
    {"StrangeParameters",
     [](Scene& s) {
         MetallicRoughnessParameters& p = s.materials[0].metallic_roughness;
         p.roughness = -3e38f, p.metallic = 3e38f, p.ior = 0, p.clearcoat = 1e30f, p.anisotropy = -1e30f,
         p.sheen_roughness = -5;
     }},
    {"StrangeRelief",
     [](Scene& s) {
         s.materials[0].bump = Bump::occlusion;
         s.materials[0].relief =
             Relief{.depth = 3e38f, .bias = -3e38f, .min_steps = -5, .max_steps = 2147483647, .refinement_steps = -1};
         use_image(
             s,
             {.decode = [](const EncodedImage&, Context&) { return Pixels{2, 2, 1, Component::u8, false, zeros(4)}; }},
             Bump::occlusion);
     }},
    {"NoSuchTexcoordSet",
     [](Scene& s) {
         use_image(
             s,
             {.decode = [](const EncodedImage&, Context&) { return Pixels{2, 2, 1, Component::u8, false, zeros(4)}; }},
             Bump::automatic);
         s.materials[0].base_color_texture.texcoord_set = no_index;
         s.materials[0].normal_texture.texcoord_set = 1u << 31;
     }},
    {"ZeroScale",
     [](Scene& s) {
         s.nodes[0].local.scale = {0, 0, 0};
     }},
    {"LargestScale",
     [](Scene& s) {
         s.nodes[0].local.scale = {1e300, 1e300, 1e300};
     }},
    {"FarAway",
     [](Scene& s) {
         s.nodes[0].local.translation = {1e300, -1e300, 1e300};
     }},
    {"ZeroQuaternion",
     [](Scene& s) {
         s.nodes[0].local.rotation = {0, 0, 0, 0};
     }},
    {"ProjectiveMatrix", [](Scene& s) { (*(s.nodes[0].local.matrix = dmat4{}))[2].w = 1; }},
    {"MeshTwice",
     [](Scene& s) {
         s.nodes[0].meshes = {0, 0};
     }},
    {"FewMorphWeights", [](Scene& s) { add_target(s, Points(3), {}); }},
    {"ManyMorphWeights",
     [](Scene& s) {
         add_target(s, Points(3, {nan_f, 0, 0}), {1, 2, 3});
     }},
    {"SingularBind",
     [](Scene& s) {
         add_skin(s, follow(0), {"", {0}, {dmat4{}}});
         s.skins[0].inverse_bind = {dmat4{{{}, {}, {}, {}}}};
     }},
    {"SkinWithoutInfluences",
     [](Scene& s) {
         add_skin(s, follow(0), {"", {0}, {dmat4{}}});
         s.meshes[0].influences = {};
     }},
    {"JointOfNoWeight",
     [](Scene& s) {
         add_skin(s, {{65535, 65535, 65535, 65535}, {}}, {"", {0}, {dmat4{}}});
     }},
    {"SubdividedPolygons",
     [](Scene& s) {
         s.meshes[0].polygons = Numbers{no_index};
         s.meshes[0].subdivision.emplace().level = 2;
     }},
    {"StrangeSpot",
     [](Scene& s) {
         Light& l = s.lights[0];
         l.type = LightType::spot, l.cutoff_rad = -3e38f, l.exponent = -3e38f, l.outer_cone_rad = 1e30f,
         l.inner_cone_rad = -1e30f;
         l.range = 0, l.constant = l.linear = l.quadratic = 0, l.diffuse = {3e38f, -3e38f, 0};
         s.lights.push_back(l);
         s.lights[1].units = LightUnits::photometric, s.lights[1].intensity = -3e38f;
     }},
    {"FarLight",
     [](Scene& s) {
         s.lights[0].position = {1e308, 1e308, -1e308};
     }},
    {"FarSun",
     [](Scene& s) {
         s.lights[0].type = LightType::directional, s.lights[0].direction = {1e300, 1e-300, 0};
     }},
    {"EmptyFogRange",
     [](Scene& s) {
         s.fog = {FogKind::linear, {3e38f, 0, 0}, 5, 5, 3e38f};
     }},
    {"LargeEnvironment",
     [](Scene& s) {
         s.environment = Environment{nullptr, 3e38f, 1e300};
     }},
    {"SingularCamera",
     [](Scene& s) {
         s.cameras[0].to_world = {{{}, {}, {}, {}}};
     }},
    {"FarCamera",
     [](Scene& s) {
         s.cameras[0].to_world[3] = {1e300, 1e300, 1e300, 1};
     }},
    {"WidestCamera", [](Scene& s) { s.cameras[0].vertical_fov_rad = std::nextafter(pi, 0.0); }},
    {"NarrowestCamera", [](Scene& s) { s.cameras[0].vertical_fov_rad = 5e-324; }},
    {"EndlessParallelCamera",
     [](Scene& s) {
         s.cameras[0].projection = Projection::orthographic, s.cameras[0].z_far = inf_d, s.cameras[0].z_near = -1e300;
     }},
    {"SmallestParallelCamera",
     [](Scene& s) {
         s.cameras[0].projection = Projection::orthographic;
         s.cameras[0].half_height = 5e-324, s.cameras[0].half_width = 1e308;
     }},
    {"DeepestNear", [](Scene& s) { s.cameras[0].z_near = 5e-324, s.cameras[0].z_far = 1e308; }},
    {"NamesOfBytes", [](Scene& s) { s.nodes[0].name = s.meshes[0].name = s.materials[0].name = "\xff\n\x1b[31m"; }},
};

INSTANTIATE_TEST_SUITE_P(Pictures, StrangeScene, testing::ValuesIn(pictures), name_of_fault);
INSTANTIATE_TEST_SUITE_P(Extremes, StrangeScene, testing::ValuesIn(extremes), name_of_fault);

TEST(StrangePicture, WhatIsWrongWithItIsARemark) {
    Scene scene = triangle_scene();
    use_image(scene, {.name = "picture", .file = "model"}, Bump::automatic);
    Context context;
    (void)render(scene, small_settings(), context);
    bool is_said = false;
    for (const ReportEntry& entry : context.report().entries())
        is_said = is_said ||
                  (entry.remark == Remark::warning && entry.message == "texture left out: the image has no decoder");
    EXPECT_TRUE(is_said);
}

}  // namespace
}  // namespace rakelight
