// SPDX-License-Identifier: Apache-2.0
// Settings, cameras, options, sinks and results that are wrong: an error that says what, where the scene is a good one.
#include <filesystem>

#include "support/thrown_error.h"
#include "unit/tools/misuse_support.h"

namespace rakelight {
namespace {

using namespace test;

// --- settings: by the facade, by an engine, by a request

struct WrongSettings {
    const char* name;
    std::function<void(RenderSettings&)> spoil;
    const char* message;
};

void draw_directly(const RenderSettings& settings, const Camera& camera) {
    Context context;
    const std::unique_ptr<Engine> engine = make_engine("soft");
    engine->prepare(triangle_scene(), context);
    Frame frame;
    engine->render(camera, settings, frame, context);
}

class MisusedSettings : public testing::TestWithParam<WrongSettings> {};

TEST_P(MisusedSettings, AreRefusedByEveryDoor) {
    const auto& [name, spoil, message] = GetParam();
    RenderSettings settings = small_settings();
    spoil(settings);
    Context context;
    PictureRequest request{.input = "builtin:plane", .output = unwritten(), .settings = settings};
    RenderBenchOptions bench{.triangles = 100, .objects = 1, .frames = 1, .settings = settings};
    expect_usage("render", message, [&] { (void)render(triangle_scene(), settings, context); });
    expect_usage("render by a camera", message, [&] { (void)render(triangle_scene(), Camera{}, settings, context); });
    expect_usage("Engine::render", message, [&] { draw_directly(settings, triangle_scene().cameras[0]); });
    expect_usage("draw_seams", message, [&] { (void)draw_seams(triangle_scene(), {}, {}, {}, settings, context); });
    expect_usage("check_picture", message, [&] { check_picture(triangle_scene(), request, context); });
    expect_usage("check_request", message, [&] { check_request(request); });
    expect_usage("render_picture", message, [&] { (void)render_picture(request, context); });
    expect_usage("bench_render", message, [&] { (void)bench_render(bench, context); });
}

const WrongSettings wrong_settings[] = {
    {"NoWidth", [](auto& s) { s.width = 0; }, "the resolution must be 1 to 65536"},
    {"NegativeHeight", [](auto& s) { s.height = -1; }, "the resolution must be 1 to 65536"},
    {"LargestSize", [](auto& s) { s.width = s.height = most; }, "the resolution must be 1 to 65536"},
    {"WindowOutside",
     [](auto& s) {
         s.window = {20, 0, 5, 5};
     },
     "the window does not lie inside"},
    {"WindowBeforeZero",
     [](auto& s) {
         s.window = {-1, 0, 5, 5};
     },
     "the window does not lie inside"},
    {"WindowOfNegativeSize",
     [](auto& s) {
         s.window = {5, 5, -3, -3};
     },
     "the window does not lie inside"},
    {"WindowThatOverflows",
     [](auto& s) {
         s.window = {most, most, most, most};
     },
     "the window does not lie inside"},
    {"WindowFromTheLowest",
     [](auto& s) {
         s.window = {-most - 1, -most - 1, most, most};
     },
     "the window does not lie inside"},
    {"WindowWithoutWidth",
     [](auto& s) {
         s.window = {1, 1, 0, 5};
     },
     "the window does not lie inside"},
    {"ThreeSamples", [](auto& s) { s.samples = 3; }, "the samples of a pixel"},
    {"NegativeSamples", [](auto& s) { s.samples = -8; }, "the samples of a pixel"},
    {"SamplesOfAnotherMethod", [](auto& s) { s.samples = 4, s.visibility = Visibility::painter; },
     "more than one sample a pixel"},
    {"SmallShadows", [](auto& s) { s.shadow_size = 0; }, "the size of a shadow map"},
    {"LargeShadows", [](auto& s) { s.shadow_size = most; }, "the size of a shadow map"},
    {"ShadowFilter", [](auto& s) { s.shadow_filter = -1; }, "the radius of the shadow filter"},
    {"ShadowBias", [](auto& s) { s.shadow_bias = nan_f; }, "the shadow bias"},
    {"Anisotropy", [](auto& s) { s.anisotropy = 0; }, "anisotropy must be"},
    {"NanLineWidth", [](auto& s) { s.edges = true, s.line_width = nan_f; }, "the width of lines"},
    {"WideLines", [](auto& s) { s.edges = true, s.line_width = 1e30f; }, "the width of lines"},
    {"NoPointSize", [](auto& s) { s.points = PointShape::disc, s.point_size = 0; }, "the size of points"},
    {"NanLineColor", [](auto& s) { s.line_color.w = nan_f; }, "the color of lines"},
    {"NanBackground", [](auto& s) { s.background.y = nan_f; }, "the background is not finite"},
    {"NanRelief", [](auto& s) { s.relief.depth = nan_f; }, "the relief is not finite"},
    {"NoShading", [](auto& s) { s.shading = no_such<Shading>(); }, "there is no shading 99"},
    {"NoLighting", [](auto& s) { s.lighting = no_such<Lighting>(); }, "there is no lighting 99"},
    {"NoSpecularForm", [](auto& s) { s.specular_form = no_such<SpecularForm>(); }, "there is no specular form 99"},
    {"NoWardForm", [](auto& s) { s.ward_form = no_such<WardForm>(); }, "there is no Ward form 99"},
    {"NoBump", [](auto& s) { s.bump = no_such<Bump>(); }, "there is no bump technique 99"},
    {"NoBumpTerms", [](auto& s) { s.bump_terms = no_such<BumpTerms>(); }, "there is no bump terms 99"},
    {"NoSpace", [](auto& s) { s.tangent_space = no_such<TangentSpace>(); }, "there is no space for normal maps 99"},
    {"NoFrontFace", [](auto& s) { s.front_face = no_such<FrontFace>(); }, "there is no front face 99"},
    {"NoCull", [](auto& s) { s.cull = no_such<Cull>(); }, "there is no culling 99"},
    {"NoVisibility", [](auto& s) { s.visibility = no_such<Visibility>(); }, "there is no visibility 99"},
    {"NoInterpolation", [](auto& s) { s.interpolation = no_such<AttributeInterpolation>(); },
     "there is no interpolation 99"},
    {"NoMethod", [](auto& s) { s.method = no_such<RayMethod>(); }, "there is no method 99"},
    {"NegativeDepth", [](auto& s) { s.max_depth = -1; }, "the depth of rays"},
    {"LargeDepth", [](auto& s) { s.max_depth = 65; }, "the depth of rays"},
    {"NaiveReflections", [](auto& s) { s.naive = true; }, "needs the method cast"},
    {"NanLimit", [](auto& s) { s.naive_limit = double(nan_f); }, "must be 0 or more"},
    {"NoPointShape", [](auto& s) { s.points = no_such<PointShape>(); }, "there is no shape of points 99"},
    {"NoRule",
     [](auto& s) {
         s.shading_rules = {{no_such<ShadingRule::Of>(), "a", Shading::flat}};
     },
     "there is no rule"},
    {"NoShadingOfRule",
     [](auto& s) {
         s.shading_rules = {{ShadingRule::Of::object, "a", no_such<Shading>()}};
     },
     "there is no shading 99"},
};

void PrintTo(const WrongSettings& wrong, std::ostream* out) { *out << wrong.name; }
std::string name_of_settings(const testing::TestParamInfo<WrongSettings>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(All, MisusedSettings, testing::ValuesIn(wrong_settings), name_of_settings);

TEST(MisusedSettings, ChannelsThatThereAreNotAreRefused) {
    RenderSettings settings = small_settings();
    settings.channels = ~0u;
    Context context;
    expect_usage("channels", "there is no such data channel",
                 [&] { (void)render(triangle_scene(), settings, context); });
}

// --- cameras

struct WrongCamera {
    const char* name;
    std::function<void(Camera&)> spoil;
    const char* message;
};

class MisusedCamera : public testing::TestWithParam<WrongCamera> {};

TEST_P(MisusedCamera, IsRefusedByEveryDoor) {
    const auto& [name, spoil, message] = GetParam();
    Camera camera = triangle_scene().cameras[0];
    spoil(camera);
    Context context;
    expect_usage("render", message, [&] { (void)render(triangle_scene(), camera, small_settings(), context); });
    expect_usage("Engine::render", message, [&] { draw_directly(small_settings(), camera); });
}

void make_parallel(Camera& c) { c.projection = Projection::orthographic; }

const WrongCamera wrong_cameras[] = {
    {"NodeOutOfRange", [](Camera& c) { c.node = 1; }, "the camera's node 1 does not exist (there are 1)"},
    {"NanMatrix", [](Camera& c) { c.to_world[1].x = nan_d; }, "the matrix is not finite"},
    {"NanAngle", [](Camera& c) { c.vertical_fov_rad = nan_d; }, "the field of view"},
    {"NoAngle", [](Camera& c) { c.vertical_fov_rad = 0; }, "the field of view"},
    {"HalfTurn", [](Camera& c) { c.vertical_fov_rad = pi; }, "the field of view"},
    {"NanWidth", [](Camera& c) { c.horizontal_fov_rad = nan_d; }, "the horizontal field of view"},
    {"NanAspect", [](Camera& c) { c.aspect = nan_d; }, "the aspect"},
    {"NoAspect", [](Camera& c) { c.aspect = 0; }, "the aspect"},
    {"NanNear", [](Camera& c) { c.z_near = nan_d; }, "near must be"},
    {"NoNear", [](Camera& c) { c.z_near = 0; }, "near must be greater than 0"},
    {"NanFar", [](Camera& c) { c.z_far = nan_d; }, "near must be"},
    {"FarBeforeNear", [](Camera& c) { c.z_far = 0.05; }, "near must be"},
    {"NoProjection", [](Camera& c) { c.projection = no_such<Projection>(); }, "there is no such projection"},
    {"NoHeight", [](Camera& c) { make_parallel(c), c.half_height = 0; }, "the visible height"},
    {"InfiniteWidth", [](Camera& c) { make_parallel(c), c.half_width = inf_d; }, "the visible width"},
    {"EndlessParallel", [](Camera& c) { make_parallel(c), c.z_far = inf_d; }, "far of a parallel projection"},
};

void PrintTo(const WrongCamera& wrong, std::ostream* out) { *out << wrong.name; }
std::string name_of_camera(const testing::TestParamInfo<WrongCamera>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(All, MisusedCamera, testing::ValuesIn(wrong_cameras), name_of_camera);

TEST(MisusedCamera, APictureWithoutAnAspectHasNone) {
    Context context;
    for (const double aspect : {0.0, -1.0, nan_d, inf_d})
        expect_usage("choose_camera", "the picture's aspect",
                     [&] { (void)choose_camera(triangle_scene(), {}, aspect, context); });
}

TEST(MisusedCamera, AViewThatCannotBeIsRefused) {
    Context context;
    const ViewRequest views[] = {{.side = "nowhere"},
                                 {.camera = "7"},
                                 {.side = "front", .camera = "0"},
                                 {.position = dvec3{nan_d, 0, 0}},
                                 {.focal_point = dvec3{0, inf_d, 0}},
                                 {.up = dvec3{0, 0, 0}},
                                 {.vertical_fov_rad = nan_d},
                                 {.horizontal_fov_rad = -1.0},
                                 {.z_near = nan_d},
                                 {.z_near = 5.0, .z_far = 1.0}};
    for (const ViewRequest& view : views)
        expect_usage("a view", "", [&] { (void)choose_camera(triangle_scene(), view, 1.5, context); });
}

// --- options

struct WrongOptions {
    const char* name;
    std::function<void(PrepareOptions&)> spoil;
};

class MisusedOptions : public testing::TestWithParam<WrongOptions> {};

TEST_P(MisusedOptions, AreRefusedByEveryDoor) {
    PrepareOptions options;
    GetParam().spoil(options);
    Context context;
    expect_usage("prepare_scene", "", [&] { (void)prepare_scene(triangle_scene(), options, context); });
    expect_usage("inspect", "", [&] { (void)inspect(triangle_scene(), {.prepare = options}, context); });
    expect_usage("draw_seams", "",
                 [&] { (void)draw_seams(triangle_scene(), {}, {.prepare = options}, {}, small_settings(), context); });
}

const WrongOptions wrong_options[] = {
    {"NanCrease", [](auto& o) { o.crease_angle_rad = nan_d; }},
    {"NegativeCrease", [](auto& o) { o.crease_angle_rad = -1; }},
    {"NoNormals", [](auto& o) { o.normals = no_such<NormalSource>(); }},
    {"NoWeight", [](auto& o) { o.weight = no_such<CornerWeight>(); }},
    {"NoProjection", [](auto& o) { o.uv = no_such<UvProjection>(); }},
    {"NoTangents", [](auto& o) { o.tangents = no_such<TangentMode>(); }},
    {"NoOrthogonalize", [](auto& o) { o.orthogonalize = no_such<Orthogonalize>(); }},
    {"NoBump", [](auto& o) { o.bump = no_such<Bump>(); }},
    {"DeepSubdivision", [](auto& o) { o.subdivision.level = 9; }},
    {"NoScheme", [](auto& o) { o.subdivision.scheme = no_such<SubdivisionScheme>(); }},
    {"NanDisplacementEdge", [](auto& o) { o.displacement.edge = nan_d; }},
    {"NanRelief", [](auto& o) { o.displacement.relief.bias = nan_f; }},
};

void PrintTo(const WrongOptions& wrong, std::ostream* out) { *out << wrong.name; }
std::string name_of_options(const testing::TestParamInfo<WrongOptions>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(All, MisusedOptions, testing::ValuesIn(wrong_options), name_of_options);

TEST(MisusedOptions, OfAttributesAreRefused) {
    Context context;
    const std::vector<AttributeOptions> wrong = {{.scope = no_such<Scope>()},
                                                 {.weight = no_such<CornerWeight>()},
                                                 {.crease_angle_rad = nan_d},
                                                 {.crease_angle_rad = -1},
                                                 {.weld_distance = nan_d},
                                                 {.weld_distance = inf_d},
                                                 {.tangent_mode = no_such<TangentMode>()},
                                                 {.orthogonalize = no_such<Orthogonalize>()}};
    const Scene scene = triangle_scene();
    const AttributeMesh mesh{.positions = scene.meshes[0].positions, .indices = scene.meshes[0].indices};
    AttributeWorkspace workspace;
    std::vector<vec3> normals(3);
    const AttributeBuffers out{normals, {}};
    for (const AttributeOptions& options : wrong) {
        expect_usage("compute_attributes", "", [&] { (void)compute_attributes({&mesh, 1}, options, context); });
        expect_usage("group", "", [&] { (void)group({&mesh, 1}, options, context); });
        expect_usage("smooth", "", [&] { (void)smooth(scene, options, context); });
        expect_usage("compute_attributes_into", "", [&] {
            (void)compute_attributes_into({&mesh, 1}, options, {&out, 1}, workspace, context);
        });
    }
    expect_usage("inspect", "the weld distance", [&] { (void)inspect(scene, {.weld_distance = nan_d}, context); });
}

TEST(MisusedOptions, MeshesOfAttributesAreRefused) {
    const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, one{{0, 0, 1}};
    const Numbers triangle{0, 1, 2}, wrong_index{0, 1, 9}, two{0, 1};
    const std::vector<std::uint8_t> lock{1};
    const std::vector<vec2> texcoord{{0, 0}};
    const std::function<void(AttributeMesh&)> faults[] = {
        [&](AttributeMesh& m) { m.indices = wrong_index; },
        [&](AttributeMesh& m) { m.indices = two; },
        [&](AttributeMesh& m) { m.positions = {}; },
        [&](AttributeMesh& m) { m.normals = one; },
        [&](AttributeMesh& m) { m.texcoords = texcoord; },
        [&](AttributeMesh& m) { m.locked = lock; },
        [&](AttributeMesh& m) { m.smoothing = two; },
        [&](AttributeMesh& m) { m.smoothing_hint = one; },
        [&](AttributeMesh& m) { m.position_step = nan_d; },
        [&](AttributeMesh& m) { m.to_world[2].y = nan_d; },
        [&](AttributeMesh& m) { m.group_kind = no_such<GroupKind>(); },
    };
    for (const auto& spoil : faults)
        for (const double crease : {radians(60), pi}) {
            AttributeMesh mesh{.positions = points, .indices = triangle};
            spoil(mesh);
            Context context;
            const AttributeOptions options{
                .weight = CornerWeight::uniform, .crease_angle_rad = crease, .weld_distance = 0};
            const Error error = error_of([&] { (void)compute_attributes({&mesh, 1}, options, context); });
            EXPECT_EQ(error.code(), ErrorCode::bad_file) << error.what();
        }
}

TEST(MisusedOptions, FactorsOfMaterialsThatAreNoNumbersAreRefused) {
    Context context;
    const MaterialOverrides wrong[] = {{.normal_scale = nan_d},
                                       {.color = vec3{nan_f, 0, 0}},
                                       {.opacity = inf_d},
                                       {.roughness = nan_d},
                                       {.values = {{.key = "no such key", .words = {"1"}, .numbers = {1}}}},
                                       {.values = {{.key = "roughness"}}},
                                       {.values = {{.key = "base_color", .words = {"1"}, .numbers = {1}}}}};
    for (const MaterialOverrides& overrides : wrong)
        EXPECT_THROW((void)override_materials(triangle_scene(), overrides, context), Error);
}

TEST(MisusedOptions, LightsAndFogOfARequestAreCheckedAsThoseOfAScene) {
    Light astray, nowhere;
    astray.node = 1u << 30;
    nowhere.position.x = nan_d;
    PictureRequest request{.input = "builtin:plane", .output = unwritten(), .settings = small_settings()};
    for (const Light& light : {astray, nowhere}) {
        request.lights = {light};
        Context context;
        EXPECT_EQ(error_of([&] { (void)render_picture(request, context); }).code(), ErrorCode::bad_file);
        EXPECT_EQ(error_of([&] { (void)explain(request, 1, 1, context); }).code(), ErrorCode::bad_file);
    }
    request.lights.reset();
    request.fog = Fog{.kind = no_such<FogKind>()};
    Context context;
    EXPECT_EQ(error_of([&] { (void)render_picture(request, context); }).code(), ErrorCode::bad_file);
    request.fog.reset();
    request.light_intensity = nan_d;
    expect_usage("an intensity", "light-intensity: must be a number", [&] { (void)render_picture(request, context); });
    request.light_intensity = 1;
    request.tone.exposure_ev = nan_d;
    expect_usage("an exposure", "", [&] { (void)render_picture(request, context); });
    EXPECT_FALSE(std::filesystem::exists(unwritten()));
}

TEST(MisusedOptions, ThreadsOutOfRangeAreRefused) {
    for (const int threads : {-1, 1025, std::numeric_limits<int>::max()})
        expect_usage("a context", "threads must be", [&] { Context context({.threads = threads}); });
}

}  // namespace
}  // namespace rakelight
