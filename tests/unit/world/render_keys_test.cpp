// SPDX-License-Identifier: Apache-2.0
// Keys of [render] read and write the same fields.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include <cmath>

#include <map>

#include <rakelight/world/render_keys.h>
#include <rakelight/world/request.h>

#include "scene/faults.h"
#include "support/shared.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

WorldValue value(const std::string& key, std::vector<std::string> words) {
    return {.key = key, .words = std::move(words)};
}

PictureRequest read(std::span<const WorldValue> values) {
    PictureRequest request;
    request.output = "picture.exr";
    read_render_keys(values, request);
    return request;
}

/// For each key words that are not its default, as they are written.
const std::map<std::string, std::vector<std::string>> examples = {
    {"preset", {"fixed-function"}},
    {"bitangents", {"attribute"}},
    {"engine", {"gl"}},
    {"resolution", {"640,360"}},
    {"window", {"1,2,30,40"}},
    {"samples", {"4"}},
    {"anisotropy", {"8"}},
    {"method", {"cast"}},
    {"max-depth", {"3"}},
    {"naive", {"on"}},
    {"naive-limit", {"1000"}},
    {"radiosity-elements", {"1000"}},
    {"radiosity-unshot", {"0.05"}},
    {"tessellate", {"on"}},
    {"seed", {"7"}},
    {"max-seconds", {"2.5"}},
    {"noise", {"0.02"}},
    {"clamp", {"10"}},
    {"light-sampling", {"lights"}},
    {"denoise", {"on"}},
    {"background", {"#204080"}},
    {"channels", {"depth,normal"}},
    {"channel-files", {"layers,png"}},
    {"exr-colors", {"half"}},
    {"shading", {"gouraud", "material:a=b=flat", "object:wheel=unlit"}},
    {"front-face", {"cw"}},
    {"cull", {"back"}},
    {"visibility", {"painter"}},
    {"interpolation", {"screen"}},
    {"edges", {"on"}},
    {"wireframe", {"on"}},
    {"point-sprites", {"on"}},
    {"points", {"square"}},
    {"grid", {"on"}},
    {"axis", {"on"}},
    {"filename", {"on"}},
    {"metadata", {"on"}},
    {"line-width", {"1.5"}},
    {"point-size", {"0.1"}},
    {"line-color", {"0.25,0.5,1"}},
    {"lighting", {"oren-nayar"}},
    {"vertex-shader", {(test::source_dir() / "examples/shaders/waves.vertex.glsl").string()}},
    {"uniform", {"height=0.25", "speed=-2"}},
    {"specular", {"normalized"}},
    {"specular-horizon", {"off"}},
    {"ward-form", {"duer"}},
    {"multiple-scattering", {"on"}},
    {"viewer-infinity", {"on"}},
    {"bump", {"parallax-limited"}},
    {"bump-terms", {"diffuse"}},
    {"bump-depth", {"0.1"}},
    {"bump-bias", {"0.3"}},
    {"bump-polarity", {"depth"}},
    {"bump-steps", {"4,16"}},
    {"bump-refinement", {"7"}},
    {"bump-self-shadow", {"on"}},
    {"bump-silhouette", {"on"}},
    {"tangent-space", {"vertex"}},
    {"normalize-frames", {"off"}},
    {"shadows", {"on"}},
    {"shadow-size", {"512"}},
    {"shadow-bias", {"0.7"}},
    {"shadow-filter", {"3"}},
    {"ambient-occlusion", {"on"}},
    {"ambient-occlusion-radius", {"0.25"}},
    {"ambient-occlusion-samples", {"64"}},
    {"normals", {"model"}},
    {"crease-angle", {"33.3"}},
    {"crease", {"angle"}},
    {"weight", {"angle-area"}},
    {"weld-distance", {"0.001"}},
    {"border-distance", {"0.002"}},
    {"tangents", {"mikktspace"}},
    {"orthogonalize", {"shader"}},
    {"keep-instances", {"on"}},
    {"uv", {"box"}},
    {"displacement-edge", {"0.01"}},
    {"displacement-triangles", {"5000"}},
    {"subdivide-edge", {"0.2"}},
    {"subdivide", {"3"}},
    {"subdivide-scheme", {"loop"}},
    {"subdivide-crease", {"30"}},
    {"subdivide-sharpness", {"2.5"}},
    {"subdivide-boundary", {"edge"}},
    {"subdivide-uv", {"smooth"}},
    {"view", {"isometric"}},
    {"camera-index", {"front 2"}},
    {"camera-position", {"1,2.5,-3e+20"}},
    {"camera-focal-point", {"0,0.1,0"}},
    {"camera-view-up", {"0,0,1"}},
    {"up", {"+Z"}},
    {"camera-direction", {"1,0,-2"}},
    {"camera-azimuth-angle", {"30"}},
    {"camera-elevation-angle", {"-15"}},
    {"camera-zoom-factor", {"0.5"}},
    {"camera-view-angle", {"40"}},
    {"camera-horizontal-angle", {"66.6"}},
    {"near", {"0.25"}},
    {"far", {"1000"}},
    {"camera-orthographic", {"on"}},
    {"color", {"#ff8000"}},
    {"opacity", {"0.5"}},
    {"roughness", {"0.25"}},
    {"metallic", {"1"}},
    {"texture-base-color", {"a.png"}},
    {"texture-normal", {"b.png"}},
    {"height-map", {"c.png"}},
    {"normal-scale", {"-2"}},
    {"normal-map-green", {"down"}},
    {"normal-map-zero", {"128"}},
    {"material", {"clearcoat=0.5", "sheen_color=0.1,0.2,0.3"}},
    {"scalar-coloring", {"on"}},
    {"scalars", {"intensity of it"}},
    {"coloring-component", {"2"}},
    {"coloring-range", {"-1.5,20"}},
    {"colormap", {"coolwarm"}},
    {"animation-index", {"3"}},
    {"animation-name", {"Walking_A"}},
    {"animation-time", {"0.25"}},
    {"animation-autoplay", {"on"}},
    {"bar", {"on"}},
    {"look", {"default"}},
    {"light-intensity", {"2"}},
    {"light-cutoff", {"0.001"}},
    {"light",
     {"point:0,2,3:color=1,0.9,0.8:specular=0,0,0:ambient=0.1,0.1,0.1:attenuation=1,0,0.25:range=7.5:shadow=off",
      "directional:0,-1,0:color=0.5,0.5,0.5", "spot:1,2,3:direction=0,-1,0:cutoff=30:exponent=4", "ambient:0.1,0.2,0.3",
      "photometric-spot:0,1,2:color=1,0,0:intensity=400:inner=10:outer=20",
      "photometric-directional:0,0,-1:intensity=3"}},
    {"fog", {"linear:2,30:color=#c0c8d0"}},
    {"hdri-file", {"sky.hdr"}},
    {"hdri-ambient", {"on"}},
    {"hdri-skybox", {"off"}},
    {"hdri-intensity", {"0.5"}},
    {"hdri-rotation", {"-45"}},
    {"tone-mapping", {"aces"}},
    {"exposure", {"-1.5"}},
};

/// What another key has to say, too, for one to be taken.
std::vector<WorldValue> with_company(const std::string& key) {
    std::vector<WorldValue> values = {value(key, examples.at(key))};
    if (key.starts_with("coloring-") || key == "colormap" || key == "bar")
        values.push_back(value("scalar-coloring", {"on"}));
    if (key == "uniform") values.push_back(value("vertex-shader", examples.at("vertex-shader")));
    if (key == "bitangents") values.push_back(value("tangents", {"published"}));
    if (key == "channel-files") values.push_back(value("channels", {"depth"}));
    if (key.starts_with("subdivide-") && key != "subdivide-edge") values.push_back(value("subdivide", {"1"}));
    return values;
}

TEST(RenderKeys, AreReadAndWrittenAgainEachByEach) {
    for (const RenderKey& key : render_keys()) {
        ASSERT_TRUE(examples.contains(key.name)) << key.name << " has no example here";
        const PictureRequest request = read(with_company(key.name));
        EXPECT_EQ(key.write(request), examples.at(key.name)) << key.name;
        EXPECT_TRUE(key.write(PictureRequest{}).empty()) << key.name << " is as by default";
        const std::vector<WorldValue> written = written_render_keys(request);
        EXPECT_EQ(written_render_keys(read(written)), written) << key.name;
    }
    EXPECT_EQ(render_keys().size(), examples.size());
}

TEST(RenderKeys, AreReadInTheTablesOrderWhateverTheirOwn) {
    const WorldValue edge = value("subdivide-edge", {"0.1"}), level = value("subdivide", {"2"});
    for (const auto& values : {std::vector{edge, level}, {level, edge}})
        EXPECT_EQ(read(values).prepare.subdivision.level, 2);
    EXPECT_EQ(read(std::vector{edge}).prepare.subdivision.level, 8);
    const WorldValue sprites = value("point-sprites", {"on"}), squares = value("points", {"square"});
    for (const auto& values : {std::vector{sprites, squares}, {squares, sprites}})
        EXPECT_EQ(read(values).settings.points, PointShape::square);
}

TEST(RenderKeys, WhatExcludesEachOtherNamesBoth) {
    const auto fault_of = [](std::vector<WorldValue> values) {
        PictureRequest request;
        request.output = "a.png";
        return test::error_of([&] { read_render_keys(values, request); });
    };
    const Error views = fault_of({value("view", {"top"}), value("camera-index", {"1"})});
    EXPECT_EQ(views.setting(), "view");
    EXPECT_EQ(views.related(), std::vector<std::string>{"camera-index"});
    EXPECT_EQ(fault_of({value("view", {"top"}), value("camera-position", {"1,2,3"})}).setting(), "view");
    EXPECT_EQ(fault_of({value("near", {"2"}), value("far", {"1"})}).setting(), "near");
    EXPECT_EQ(fault_of({value("samples", {"4"}), value("visibility", {"painter"})}).setting(), "samples");
    EXPECT_EQ(fault_of({value("window", {"0,0,2000,10"})}).setting(), "window");
    EXPECT_EQ(fault_of({value("channel-files", {"png"})}).setting(), "channel-files");
    EXPECT_EQ(fault_of({value("near", {"1"}), value("near", {"2"})}).setting(), "near");
    EXPECT_EQ(fault_of({value("edges", {"yes"})}).setting(), "edges");
    EXPECT_EQ(fault_of({value("edges", {})}).setting(), "edges");
    EXPECT_EQ(fault_of({value("colormap", {"turbo"})}).setting(), "colormap");
    EXPECT_EQ(fault_of({value("scalar-coloring", {"on"}), value("coloring-range", {"2,1"})}).setting(),
              "coloring-range");
    EXPECT_EQ(fault_of({value("subdivide-uv", {"smooth"})}).setting(), "subdivide-uv");
    EXPECT_EQ(fault_of({value("point-sprites", {"on"}), value("points", {"none"})}).setting(), "point-sprites");
    EXPECT_EQ(fault_of({value("light", {"none", "ambient:1,1,1"})}).setting(), "light");
    EXPECT_EQ(fault_of({value("light", {"default", "ambient:1,1,1"})}).setting(), "light");
    EXPECT_EQ(fault_of({value("light", {"point:0,0,0:exponent=2"})}).setting(), "light");
    EXPECT_EQ(fault_of({value("shading", {"flat", "phong"})}).setting(), "shading");
    EXPECT_EQ(fault_of({value("bitangents", {"attribute"})}).related(), std::vector<std::string>{"tangents"});
    EXPECT_EQ(fault_of({value("bitangents", {"attribute"}), value("tangents", {"averaged"})}).setting(), "bitangents");
    EXPECT_EQ(fault_of({value("material", {"nonsense=1"})}).setting(), "material");
    EXPECT_EQ(fault_of({value("channels", {"nonsense"})}).setting(), "channels");
    EXPECT_NE(std::string(fault_of({value("crease_angle", {"1"})}).what()).find("did you mean 'crease-angle'?"),
              std::string::npos);
}

TEST(RenderKeys, AutomaticCreasesGoBeforeTheAngle) {
    EXPECT_EQ(read(std::vector{value("crease-angle", {"40"})}).prepare.creases, Creasing::angle);
    for (const bool first : {true, false}) {
        std::vector<WorldValue> both = {value("crease", {"auto"}), value("crease-angle", {"40"})};
        if (first) std::swap(both[0], both[1]);
        const PictureRequest request = read(both);
        EXPECT_EQ(request.prepare.creases, Creasing::automatic);
        EXPECT_EQ(request.prepare.crease_angle_rad, radians(40));
    }
}

TEST(RenderKeys, WhatNoKeySaysIsNotLeftOutInSilence) {
    const auto is_refused = [](void (*change)(PictureRequest&)) {
        const auto request = std::make_unique<PictureRequest>();
        change(*request);
        return test::error_of([&] { written_render_keys(*request); }).code() == ErrorCode::usage;
    };
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.lights.emplace(1)[0].node = 3; }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.settings.surfaces = false; }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.settings.material_shading = false; }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.settings.background.w = 0.5f; }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.materials.opacity = std::numeric_limits<double>::quiet_NaN(); }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.settings.width = 0; }));
    EXPECT_TRUE(is_refused([](PictureRequest& r) { r.prepare.displacement.is_on = true; }));
}

TEST(RenderKeys, LightsKeepWhatTheirTypeDoesNotHaveToThemselves) {
    PictureRequest request;
    for (const LightUnits units : {LightUnits::classical, LightUnits::photometric})
        for (const LightType type : {LightType::ambient, LightType::directional, LightType::point, LightType::spot}) {
            if (type == LightType::ambient && units == LightUnits::photometric) continue;
            // As of a spot in either units that was made a light of another type.
            Light light{.type = type, .units = units, .position = {1, 2, 3}, .direction = {0, -1, 0}};
            light.ambient = {0.1f, 0.2f, 0.3f}, light.diffuse = {0.5f, 0.5f, 0.5f}, light.color = {1, 0, 0};
            light.quadratic = 2, light.cutoff_rad = 0.5f, light.exponent = 3, light.range = 7, light.intensity = 4;
            light.inner_cone_rad = 0.25f, light.outer_cone_rad = 0.5f;
            request.lights = {light};
            PictureRequest back;
            ASSERT_NO_THROW(read_render_keys(written_render_keys(request), back)) << int(type) << int(units);
            EXPECT_EQ(back.lights->at(0).type, type);
        }
}

TEST(RenderKeys, ColorsComeBackAsNearAsDisplayValuesAre) {
    PictureRequest request;
    request.settings.background = {0.1234567f, 0.5f, 0.9f, 1};
    std::vector<Light> lights(1);
    lights[0].type = LightType::spot, lights[0].direction = {1, 2, 3};
    request.lights = lights;
    PictureRequest back;
    read_render_keys(written_render_keys(request), back);
    EXPECT_NEAR(back.settings.background.x, 0.1234567f, 1e-6);
    EXPECT_NEAR(back.lights->at(0).direction.z, 3 / std::sqrt(14.0), 1e-15);
}

TEST(RenderKeys, NumbersThatAreNotOrOutOfRangeAreRefused) {
    for (const auto& [key, word] : std::vector<std::pair<std::string, std::string>>{{"crease-angle", "181"},
                                                                                    {"near", "0"},
                                                                                    {"near", "nan"},
                                                                                    {"camera-view-angle", "180"},
                                                                                    {"line-width", "257"},
                                                                                    {"bump-steps", "9,8"},
                                                                                    {"resolution", "0,1"},
                                                                                    {"resolution", "65537,1"},
                                                                                    {"exposure", "31"},
                                                                                    {"shadow-size", "15"},
                                                                                    {"color", "1,2,0"},
                                                                                    {"fog", "linear:3,2"}}) {
        const std::vector<WorldValue> values = {value(key, {word})};
        EXPECT_EQ(test::error_of([&] { read(values); }).setting(), key) << word;
    }
    const std::vector<WorldValue> two = {value("near", {"1", "2"})};
    EXPECT_EQ(test::error_of([&] { read(two); }).setting(), "near");
}

TEST(RenderKeys, PathsTakeManySamplesUnlessItIsSaid) {
    PictureRequest r = read(std::vector{value("method", {"path"})});
    EXPECT_EQ(r.settings.samples, 64);
    r = read(std::vector{value("samples", {"1"}), value("method", {"path"})});
    EXPECT_EQ(r.settings.samples, 1);
    const std::vector<WorldValue> written = written_render_keys(r);
    EXPECT_EQ(read(written).settings.samples, 1);
    r.settings.samples = 64;
    EXPECT_EQ(read(written_render_keys(r)).settings.samples, 64);
}

TEST(RenderKeys, NoLightIsNotTheDefaultOne) {
    const PictureRequest r = read(std::vector{value("light", {"none"})});
    ASSERT_TRUE(r.lights.has_value());
    EXPECT_TRUE(r.lights->empty());
    EXPECT_FALSE(r.default_lights);
    const PictureRequest again = read(written_render_keys(r));
    ASSERT_TRUE(again.lights.has_value());
    EXPECT_TRUE(again.lights->empty());
}

}  // namespace
}  // namespace rakelight
