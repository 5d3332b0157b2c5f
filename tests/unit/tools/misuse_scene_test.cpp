// SPDX-License-Identifier: Apache-2.0
// Scenes made in memory by somebody who makes mistakes: every function that takes one says what is wrong, and none goes
// on.
#include "support/thrown_error.h"
#include "unit/tools/misuse_support.h"

namespace rakelight {
namespace {

using namespace test;

class MisusedScene : public testing::TestWithParam<Fault> {};

TEST_P(MisusedScene, IsRefusedByEveryDoor) {
    Scene scene = triangle_scene();
    GetParam().spoil(scene);
    const std::string wanted = GetParam().message;
    for (const Door& door : doors()) {
        Context context({.threads = 2});
        const Error error = error_of([&] { door.open(scene, context); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << door.name << ": " << error.what();
        EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << door.name << ": " << error.what();
    }
}

void add_channel(Scene& s, AnimationChannel channel) { s.animations.push_back({"", {std::move(channel)}}); }

const Fault indices_and_sizes[] = {
    {"IndexOutOfRange",
     [](Scene& s) {
         s.meshes[0].indices = Numbers{0, 1, 3};
     },
     "index 3 at corner 2 exceeds 3 vertices"},
    {"LargestIndex",
     [](Scene& s) {
         s.meshes[0].indices = Numbers{0, 1, no_index};
     },
     "index 4294967295 at corner 2"},
    {"TwoIndices",
     [](Scene& s) {
         s.meshes[0].indices = Numbers{0, 1};
     },
     "2 indices are not a multiple of 3"},
    {"NoPositions", [](Scene& s) { s.meshes[0].positions = {}, s.meshes[0].texcoords.clear(); }, "index 0 at corner 0"},
    {"LinesOutOfRange",
     [](Scene& s) {
         s.meshes[0].topology = Topology::lines, s.meshes[0].indices = Numbers{0, 7};
     },
     "index 7 at corner 1"},
    {"PointsOutOfRange",
     [](Scene& s) { s.meshes[0].topology = Topology::points, s.meshes[0].indices = Numbers{1u << 31}; },
     "index 2147483648"},
    {"ShortNormals",
     [](Scene& s) {
         s.meshes[0].normals = Points{{0, 0, 1}};
     },
     "1 normals for 3 vertices"},
    {"LongTangents", [](Scene& s) { s.meshes[0].tangents = std::vector<vec4>(4); }, "4 tangents for 3 vertices"},
    {"ShortTexcoords", [](Scene& s) { s.meshes[0].texcoords = {std::vector<vec2>(1)}; }, "1 texture coordinates for 3"},
    {"ShortColors", [](Scene& s) { s.meshes[0].colors = std::vector<vec4>(2); }, "2 colors for 3"},
    {"LongSmoothing", [](Scene& s) { s.meshes[0].smoothing = Numbers(4); }, "4 smoothing groups for 1 triangles"},
    {"ShortHint", [](Scene& s) { s.meshes[0].smoothing_hint = Points(1); }, "1 smoothing hints for 3 corners"},
    {"LongPolygons", [](Scene& s) { s.meshes[0].polygons = Numbers(2); }, "2 polygon numbers for 1 triangles"},
    {"ShortInfluences", [](Scene& s) { s.meshes[0].influences = std::vector<JointInfluence>(1); },
     "1 joint influences for 3"},
    {"ShortTarget", [](Scene& s) { add_target(s, Points(1), {1}); }, "1 morph positions for 3"},
    {"MeshOutOfRange",
     [](Scene& s) {
         s.nodes[0].meshes = {0, 44};
     },
     "mesh 44 does not exist"},
    {"MeshNone", [](Scene& s) { s.nodes[0].meshes = {no_index}; }, "mesh 4294967295 does not exist"},
    {"MaterialOutOfRange", [](Scene& s) { s.meshes[0].material = 1; }, "material 1 does not exist"},
    {"ParentItself", [](Scene& s) { s.nodes[0].parent = 0; }, "parent 0 does not come before its child"},
    {"ParentOutOfRange", [](Scene& s) { s.nodes[0].parent = 12; }, "parent 12 does not come"},
    {"ParentsInACircle",
     [](Scene& s) {
         s.nodes.push_back(s.nodes[0]);
         s.nodes[0].parent = 1, s.nodes[1].parent = 0;
     },
     "node 0: parent 1 does not come"},
    {"SkinOutOfRange", [](Scene& s) { s.nodes[0].skin = 7; }, "skin 7 does not exist"},
    {"JointOutOfRange",
     [](Scene& s) {
         add_skin(s, follow(9), {"", {0}, {dmat4{}}});
     },
     "joint 9 exceeds the 1 joints"},
    {"JointNodeOutOfRange",
     [](Scene& s) {
         add_skin(s, follow(0), {"", {99}, {dmat4{}}});
     },
     "joint 99 does not exist"},
    {"SkinWithoutBind",
     [](Scene& s) {
         add_skin(s, follow(0), {"", {0}, {}});
     },
     "0 inverse bind matrices for 1 joints"},
    {"LightNodeOutOfRange", [](Scene& s) { s.lights[0].node = 7; }, "light 0: node 7 does not exist"},
    {"CameraNodeOutOfRange", [](Scene& s) { s.cameras[0].node = 9; }, "camera 0: node 9 does not exist"},
    {"TextureOutOfRange", [](Scene& s) { s.materials[0].normal_texture.texture = 3; },
     "normal texture 3 does not exist"},
    {"TextureWithoutImage", [](Scene& s) { s.textures.emplace_back(); }, "texture 0: it has no image"},
    {"ChannelNodeOutOfRange", [](Scene& s) { add_channel(s, {.element = 5}); }, "animation 0: node 5 does not exist"},
    {"ChannelOfOtherSize",
     [](Scene& s) {
         add_channel(s, {.element = 0, .times = std::vector<float>{0}, .values = std::vector<float>{1, 2}});
     },
     "2 values of a channel for 3 expected"},
};

const Fault numbers[] = {
    {"NanScale",
     [](Scene& s) {
         s.nodes[0].local.scale = {nan_d, 1, 1};
     },
     "the scale is not finite"},
    {"NanMatrix", [](Scene& s) { (*(s.nodes[0].local.matrix = dmat4{}))[1].y = nan_d; }, "the matrix is not finite"},
    {"NanRotation", [](Scene& s) { s.nodes[0].local.rotation.x = nan_d; }, "the rotation is not finite"},
    {"NanOrigin", [](Scene& s) { s.meshes[0].origin.x = nan_d; }, "the origin is not finite"},
    {"NanStep", [](Scene& s) { s.meshes[0].position_step = nan_d; }, "the step of the positions"},
    {"NegativeStep", [](Scene& s) { s.meshes[0].position_step = -1; }, "the step of the positions is negative"},
    {"NanColor", [](Scene& s) { s.materials[0].base_color.x = nan_f; }, "the base color is not finite"},
    {"NanRoughness", [](Scene& s) { s.materials[0].metallic_roughness.roughness = nan_f; }, "roughness is not finite"},
    {"NanReliefDepth", [](Scene& s) { s.materials[0].relief.emplace().depth = nan_f; }, "the relief is not finite"},
    {"InfiniteReliefBias", [](Scene& s) { s.materials[0].relief.emplace().bias = inf_f; }, "the relief is not finite"},
    {"NanTextureTransform", [](Scene& s) { s.materials[0].height_texture.transform.offset.x = nan_f; },
     "a texture transform"},
    {"NanLight", [](Scene& s) { s.lights[0].position.x = nan_d; }, "light 0: the position is not finite"},
    {"NanCutoff", [](Scene& s) { s.lights[0].cutoff_rad = nan_f; }, "light 0: a parameter is not finite"},
    {"SpotWithoutDirection", [](Scene& s) { s.lights[0].type = LightType::spot, s.lights[0].direction = {}; },
     "the direction is zero"},
    {"NanFog", [](Scene& s) { s.fog.density = nan_f; }, "fog 0: a parameter is not finite"},
    {"NanEnvironment", [](Scene& s) { s.environment.emplace().intensity = nan_f; },
     "the intensity is not a number >= 0"},
    {"NegativeEnvironment", [](Scene& s) { s.environment.emplace().intensity = -1; },
     "the intensity is not a number >= 0"},
    {"InfiniteTurn", [](Scene& s) { s.environment.emplace().rotation_rad = inf_d; }, "the rotation is not finite"},
    {"NanCamera", [](Scene& s) { s.cameras[0].vertical_fov_rad = nan_d; }, "the field of view"},
    {"NanNear", [](Scene& s) { s.cameras[0].z_near = nan_d; }, "camera 0: near must be"},
    {"NearBeyondFar", [](Scene& s) { s.cameras[0].z_near = 10, s.cameras[0].z_far = 1; }, "camera 0: near must be"},
    {"NanCameraMatrix", [](Scene& s) { s.cameras[0].to_world[3].x = nan_d; }, "camera 0: the matrix is not finite"},
    {"NanMorphWeight", [](Scene& s) { add_target(s, Points(3), {nan_f}); }, "a morph weight is not finite"},
    {"NanJointWeight",
     [](Scene& s) {
         add_skin(s, {{}, {nan_f, 0, 0, 0}}, {"", {0}, {dmat4{}}});
     },
     "a joint weight is not finite"},
    {"NanBind",
     [](Scene& s) {
         add_skin(s, follow(0), {"", {0}, {dmat4{}}});
         dmat4 bind;
         bind[0].x = nan_d;
         s.skins[0].inverse_bind = {bind};
     },
     "an inverse bind matrix is not finite"},
    {"SubdivisionBelowZero", [](Scene& s) { s.meshes[0].subdivision.emplace().level = -1; },
     "mesh 0: subdivision goes by 0 to 8"},
    {"SubdivisionTooDeep", [](Scene& s) { s.meshes[0].subdivision.emplace().level = 99; },
     "mesh 0: subdivision goes by 0 to 8"},
    {"NanSubdivisionEdge", [](Scene& s) { s.meshes[0].subdivision.emplace().edge = nan_d; },
     "the edge of a subdivision"},
    {"NanSharpness", [](Scene& s) { s.meshes[0].subdivision.emplace().sharpness = nan_d; }, "the sharpness of creases"},
    {"NanCrease", [](Scene& s) { s.meshes[0].normal_choice.emplace().crease_angle_rad = nan_d; },
     "the crease angle is not 0 to pi"},
    {"CreaseBelowZero", [](Scene& s) { s.meshes[0].normal_choice.emplace().crease_angle_rad = -0.1; },
     "the crease angle is not 0 to pi"},
    {"CreaseAbovePi", [](Scene& s) { s.meshes[0].normal_choice.emplace().crease_angle_rad = 3.2; },
     "the crease angle is not 0 to pi"},
    {"NanSubdivisionCrease", [](Scene& s) { s.meshes[0].subdivision.emplace().crease_angle_rad = nan_d; },
     "the crease angle"},
};

template <class E>
Fault enumerator(const char* name, const char* message, E Material::*member) {
    return {name, [member](Scene& s) { s.materials[0].*member = no_such<E>(); }, message};
}

const Fault enumerators[] = {
    {"NoTopology", [](Scene& s) { s.meshes[0].topology = no_such<Topology>(); }, "mesh 0: there is no topology 99"},
    {"NoSmoothingKind", [](Scene& s) { s.meshes[0].smoothing_kind = no_such<SmoothingKind>(); },
     "no kind of smoothing 99"},
    {"NoNormalSource", [](Scene& s) { s.meshes[0].normal_choice.emplace().source = no_such<NormalSource>(); },
     "choice of normals"},
    {"NoScheme", [](Scene& s) { s.meshes[0].subdivision.emplace().scheme = no_such<SubdivisionScheme>(); },
     "no such scheme of subdivision"},
    {"NoSubdivisionUv", [](Scene& s) { s.meshes[0].subdivision.emplace().uv = no_such<SubdivisionUv>(); },
     "no such rule for texture coordinates"},
    enumerator("NoModel", "material 0: there is no model 99", &Material::model),
    enumerator("NoAlphaMode", "no alpha mode 99", &Material::alpha_mode),
    enumerator("NoLighting", "no lighting 99", &Material::lighting),
    enumerator("NoSpecularForm", "no specular form 99", &Material::specular_form),
    enumerator("NoBump", "no bump technique 99", &Material::bump),
    enumerator("NoBumpTerms", "no bump terms 99", &Material::bump_terms),
    {"NoWardForm", [](Scene& s) { s.materials[0].ward_form = no_such<WardForm>(); }, "no Ward form 99"},
    {"NoShading", [](Scene& s) { s.materials[0].shading = no_such<Shading>(); }, "material 0: there is no shading 99"},
    {"NoShadingOfNode", [](Scene& s) { s.nodes[0].shading = no_such<Shading>(); }, "node 0: there is no shading 99"},
    {"NoWrap",
     [](Scene& s) {
         s.textures.push_back({"", std::make_shared<const EncodedImage>(), {}});
         s.textures[0].sampler.wrap_v = no_such<Wrap>();
     },
     "texture 0: there is no wrap 99"},
    {"NoFilter",
     [](Scene& s) {
         s.textures.push_back({"", std::make_shared<const EncodedImage>(), {}});
         s.textures[0].sampler.minify = no_such<Filter>();
     },
     "texture 0: there is no filter 99"},
    {"NoMipFilter",
     [](Scene& s) {
         s.textures.push_back({"", std::make_shared<const EncodedImage>(), {}});
         s.textures[0].sampler.mip = no_such<MipFilter>();
     },
     "texture 0: there is no filter 99"},
    {"NoLightType", [](Scene& s) { s.lights[0].type = no_such<LightType>(); }, "light 0: there is no type 99"},
    {"NoUnits", [](Scene& s) { s.lights[0].units = no_such<LightUnits>(); }, "light 0: there is no kind of units 99"},
    {"NoFog", [](Scene& s) { s.fog.kind = no_such<FogKind>(); }, "there is no kind 99"},
    {"NoProjection", [](Scene& s) { s.cameras[0].projection = no_such<Projection>(); },
     "camera 0: there is no projection 99"},
    {"NoPath", [](Scene& s) { add_channel(s, {.element = 0, .path = no_such<AnimationPath>()}); }, "no path 99"},
    {"NoInterpolation", [](Scene& s) { add_channel(s, {.element = 0, .interpolation = no_such<Interpolation>()}); },
     "no interpolation 99"},
};

INSTANTIATE_TEST_SUITE_P(IndicesAndSizes, MisusedScene, testing::ValuesIn(indices_and_sizes), name_of_fault);
INSTANTIATE_TEST_SUITE_P(Numbers, MisusedScene, testing::ValuesIn(numbers), name_of_fault);
INSTANTIATE_TEST_SUITE_P(Enumerators, MisusedScene, testing::ValuesIn(enumerators), name_of_fault);

TEST(MisusedScene, AValidOneIsTakenByEveryDoor) {
    for (const Door& door : doors()) {
        Context context({.threads = 2});
        EXPECT_NO_THROW(door.open(triangle_scene(), context)) << door.name;
    }
}

}  // namespace
}  // namespace rakelight
