// SPDX-License-Identifier: Apache-2.0
// The engines soft, gl and trace draw one picture: scenes of every lighting model and bump technique, at equal settings. Judged are the
// interiors, pixels whose 3 x 3 neighborhood shows one object and mesh without a step of depth in both; what lies on the border
// of a shadow is left out. On llvmpipe where there is no GPU; skipped where there is no OpenGL.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <rakelight/render/render.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

#include "render/prepared_scene.h"
#include "render/shot.h"
#include "support/shared.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// What is let pass, and why it may be more than a rounding.
struct Limits {
    double share;    ///< of interior pixels that differ by at most 2/255
    double rmse;     ///< [1/255] of interior pixels
    double psnr_db;  ///< of all pixels; 0: not judged
};
constexpr Limits plain = {0.995, 0.5, 0};
/// A ray that grazes a layer of the relief meets it or the next one by the last bit of a height.
constexpr Limits layered = {0.98, 1.5, 0};
/// The number of probes steps with the footprint: by its last bit one more.
constexpr Limits probed = {0.98, 1.0, 0};
/// Half floats round after each layer.
constexpr Limits blended = {0.995, 0.7, 0};
/// What is behind glass is kept in half floats, and its borders fall to one pixel or the next.
constexpr Limits seen_through = {0.98, 1.0, 0};
/// A pixel at an edge is the mean of few samples, any of which may fall to the other side.
constexpr Limits sampled = {0, 100, 48};

/// A pixel's surface is known to lines by its depth alone, so they are hidden a little earlier or later; borders are judged, too.
constexpr Limits marked = {0.995, 1, 40};

struct ParityScene {
    const char* name;
    Limits limits;
    const char* words;  ///< MODEL KEY=VALUE ...
};

void PrintTo(const ParityScene& scene, std::ostream* to) { *to << scene.name; }

#define RL_TEAPOT                                                                                                    \
    "builtin:teapot camera-position=0.6,1.5,2.6 camera-focal-point=0.05,0.45,0 light=point:2,3,2:color=0.8,0.8,0.8 " \
    "light=ambient:0.1,0.1,0.1 "
#define RL_HEAD                                                                                            \
    "data/head/head.obj camera-position=0.1,0.29,0.5 camera-focal-point=0,0.282,0.1 camera-view-angle=30 " \
    "light=point:0.5,0.5,0.6:color=0.9,0.85,0.8:attenuation=0.6,0.2,0.4 light=ambient:0.02,0.02,0.02 "
#define RL_KNIGHT                                                                                          \
    "data/knight/Knight_noNormals.glb normals=model camera-position=1.2,2,4.5 camera-focal-point=0,1.2,0 " \
    "camera-view-angle=38 light=directional:-1,-0.5,-0.6:color=0.9,0.9,0.9 light=ambient:0.15,0.15,0.15 "
#define RL_WALL                                                                                           \
    "data/maps/wall.obj texture-normal=data/maps/brick_normal.png height-map=data/maps/brick_height.png " \
    "camera-position=1.6,-1.2,1.6 camera-focal-point=0,0,0 light=directional:-1,-0.6,-0.8 light=ambient:0.1,0.1,0.1 "
#define RL_FLOOR                                                                                             \
    "tests/golden/models/floor.obj camera-position=0,1.2,4 camera-focal-point=0,0.8,0 camera-view-angle=60 " \
    "light=directional:-1,-1,-1 light=ambient:0.1,0.1,0.1 "

constexpr ParityScene scenes[] = {
    {"own_color", plain, RL_HEAD "shading=unlit"},
    {"flat", plain, RL_KNIGHT "shading=flat"},
    {"flat_in_environment", plain, RL_KNIGHT "shading=flat hdri-ambient hdri-skybox"},
    {"gouraud_in_environment", plain, RL_KNIGHT "shading=gouraud hdri-ambient"},
    {"gouraud", plain, RL_HEAD "shading=gouraud"},
    {"gouraud_two_sides", plain, "data/materials/sides.gltf shading=gouraud light=directional:0.6,-0.7,-0.8"},
    {"lambert", plain, RL_TEAPOT "lighting=lambert"},
    {"phong", plain, RL_TEAPOT "lighting=phong"},
    {"phong_normalized", plain, RL_TEAPOT "lighting=phong specular=normalized"},
    {"blinn_phong", plain, RL_TEAPOT "lighting=blinn-phong"},
    {"oren_nayar", plain, RL_TEAPOT "lighting=oren-nayar material=sigma_deg=30"},
    {"oren_nayar_full", plain, RL_TEAPOT "lighting=oren-nayar-full material=sigma_deg=40 color=0.9,0.4,0.3"},
    {"oren_nayar_full_at_vertices", plain, RL_TEAPOT "lighting=oren-nayar-full material=sigma_deg=40 shading=gouraud"},
    {"ward", plain, RL_TEAPOT "lighting=ward material=ward_alpha=0.1,0.4 material=specular=0.6,0.6,0.6"},
    {"pbr", plain, RL_KNIGHT "lighting=pbr"},
    {"pbr_models", plain, "data/lighting/pbr.scene.toml samples=1"},
    {"layers_in_environment", plain,
     "data/materials/layers.gltf hdri-ambient hdri-skybox light=directional:-1,-1,-1 multiple-scattering"},
    {"environment", plain, "data/environment/spheres.scene.toml samples=1"},
    {"transmission", seen_through, "data/lighting/transmission.scene.toml samples=1"},
    {"iridescence", plain, "data/lighting/iridescence.scene.toml samples=1"},
    {"environment_ramp", plain,
     RL_KNIGHT "hdri-file=data/environment/ramp.hdr hdri-ambient hdri-skybox hdri-rotation=70"},
    {"classical_in_environment", plain, RL_HEAD "hdri-ambient"},
    {"sky_in_parallel_view", plain, RL_TEAPOT "hdri-skybox camera-orthographic"},
    {"normal_map", plain, RL_HEAD "bump=normal"},
    {"normal_map_in_pixels_space", plain, RL_HEAD "tangent-space=pixel"},
    {"normal_map_in_vertices_space", plain, RL_HEAD "tangent-space=vertex"},
    {"normal_map_transposed", plain, RL_HEAD "tangent-space=transposed"},
    {"own_bitangents", plain, RL_HEAD "normals=model tangents=published bitangents=attribute"},
    {"own_bitangents_in_vertices_space", plain,
     RL_HEAD "normals=model tangents=published bitangents=attribute tangent-space=vertex"},
    {"fixed_function", plain, RL_HEAD "preset=fixed-function"},
    {"fixed_function_of_metals", plain, RL_KNIGHT "preset=fixed-function"},
    {"specular_bumps", plain, RL_HEAD "bump-terms=specular"},
    {"height_map", plain, RL_WALL "bump=height"},
    {"parallax", plain, RL_WALL "bump=parallax"},
    {"parallax_limited", plain, RL_WALL "bump=parallax-limited"},
    {"steep", layered, RL_WALL "bump=steep"},
    {"steep_self_shadow", layered, RL_WALL "bump=steep bump-self-shadow"},
    {"occlusion", layered, RL_WALL "bump=occlusion bump-self-shadow"},
    {"displacement", plain, RL_WALL "bump=displacement"},
    {"shadows", plain, "data/world/room.scene.toml samples=1"},
    {"shadows_of_a_point_light", plain,
     "data/knight/Knight_noNormals.glb normals=model shadows light=point:2,4,3 light=ambient:0.1,0.1,0.1"},
    {"fog", plain, RL_FLOOR "fog=exp:0.15:color=0.5,0.6,0.7"},
    {"spot_lights", plain, RL_FLOOR "light=spot:-1,4,3:direction=0.3,-1,-0.4:cutoff=25:exponent=12"},
    {"blended_panes", blended, RL_FLOOR},
    {"masked_and_blended", blended, "data/materials/alpha.gltf"},
    {"vertex_colors_and_texture_sets", plain, "data/materials/colors.gltf"},
    {"anisotropic_filter", probed,
     "data/visibility/floor.obj texture-base-color=data/bricks/normal.png shading=unlit camera-position=0,0.3,3.3 "
     "camera-focal-point=0,0,0 camera-view-angle=16 anisotropy=8"},
    {"anisotropic_slopes", probed,
     "data/visibility/floor.obj height-map=data/maps/brick_height.png bump=height bump-depth=0.03 "
     "light=directional:-1,-0.5,-0.3 camera-position=0,0.3,3.3 camera-focal-point=0,0,0 camera-view-angle=16 "
     "anisotropy=16"},
    {"screen_interpolation", plain,
     "data/visibility/floor.obj texture-base-color=tests/golden/models/checker.png shading=unlit "
     "camera-position=0,1.6,5.5 "
     "camera-focal-point=0,0,0 camera-view-angle=45 interpolation=screen"},
    {"screen_interpolation_past_the_picture", plain,
     "data/visibility/floor.obj texture-base-color=tests/golden/models/checker.png shading=unlit "
     "camera-position=0.7,0.9,1.6 camera-focal-point=-0.3,0,0 camera-view-angle=50 interpolation=screen"},
    {"screen_interpolation_behind_the_eye", plain,
     "data/visibility/floor.obj texture-base-color=tests/golden/models/checker.png shading=unlit near=0.05 far=2.5 "
     "camera-position=0.3,0.25,0.4 camera-focal-point=-0.2,0.1,-1 camera-view-angle=70 interpolation=screen"},
    {"screen_interpolation_of_light_and_normals", plain,
     "data/visibility/floor.obj camera-position=0.3,0.25,0.4 camera-focal-point=-0.2,0.1,-1 camera-view-angle=70 "
     "near=0.1 light=point:0,0.3,-0.4 light=ambient:0.1,0.1,0.1 shading=gouraud interpolation=screen samples=4"},
    {"screen_interpolation_in_a_window", plain,
     "data/visibility/floor.obj texture-base-color=tests/golden/models/checker.png shading=flat window=40,60,180,120 "
     "camera-position=0.3,0.25,0.4 camera-focal-point=-0.2,0.1,-1 camera-view-angle=70 light=directional:-1,-1,-1 "
     "interpolation=screen"},
    {"automatic_shading", plain,
     "data/materials/spheres.gltf shading=auto light=directional:-1,-1,-1 light=ambient:0.1,0.1,0.1"},
    {"samples", sampled, RL_KNIGHT "samples=4"},
    {"samples_and_panes", sampled, RL_FLOOR "samples=4"},
    {"transparent_background", plain, RL_TEAPOT "background=transparent"},
    {"parallel_view", plain, RL_TEAPOT "camera-orthographic"},
    {"viewer_at_infinity", plain, RL_TEAPOT "viewer-infinity"},
    {"clockwise_fronts", plain, RL_TEAPOT "front-face=cw cull=back"},
    {"window", plain, RL_HEAD "window=60,40,200,150"},
    {"edges", marked, RL_KNIGHT "edges line-width=1.5 line-color=0.1,0.9,0.1"},
    {"wide_edges_in_parallel_view", marked, RL_TEAPOT "edges line-width=5 camera-orthographic"},
    {"points_and_edges", marked, RL_TEAPOT "edges points=disc point-size=5"},
    {"wireframe", marked, RL_TEAPOT "wireframe line-width=0.7"},
};

std::vector<WorldValue> values_of(std::istream& words) {
    std::vector<WorldValue> values;
    for (std::string word; words >> word;) {
        const std::string key = word.substr(0, word.find('='));
        auto value = std::ranges::find(values, key, &WorldValue::key);
        if (value == values.end()) value = values.insert(values.end(), {.key = key});
        std::string text = key.size() < word.size() ? word.substr(key.size() + 1) : "on";
        if (key == "hdri-file" || key == "height-map" || key.starts_with("texture-"))
            text = (test::source_dir() / text).string();
        value->words.push_back(text);
    }
    return values;
}

PictureRequest request_of(const ParityScene& scene, Context& context) {
    std::istringstream words(scene.words);
    std::string model;
    words >> model;
    if (!model.starts_with("builtin:")) model = (test::source_dir() / model).string();
    std::vector<WorldValue> values = values_of(words);
    values.push_back({.key = "resolution", .words = {"320,240"}});
    PictureRequest request;
    if (is_world_file(model))
        request = read_world_request(model, {}, {.values = values}, context).picture;
    else
        read_render_keys(values, request);
    request.input = model;
    return request;
}

/// One scene, ready to be drawn by any engine.
struct Drawable {
    PictureRequest request;
    Scene scene;  ///< as engines get it
    Camera camera;

    Frame by(const char* engine, const RenderSettings& settings, Context& context) const {
        Session session(engine);
        session.set(std::make_shared<const PreparedScene>(PreparedScene{.scene = scene}));
        Frame frame;
        session.render({camera, settings, scene.lights}, frame, context);
        return frame;
    }
};

Drawable drawable(const ParityScene& scene, Context& context) {
    Drawable out{request_of(scene, context), {}, {}};
    out.request.prepare.tessellate = true;
    Session session("soft");
    Scene loaded = load(out.request.input, out.request.load, context);
    PictureRequest plain = out.request;
    plain.look = Look::plain;
    const Shot shot = decide_single(session, std::move(loaded), plain, {}, {}, context);
    out.scene = drawn_scene(*session.prepared_for(shot, context), shot, context), out.camera = shot.camera;
    return out;
}

/// Whether the neighborhoods of pixels show one smooth surface.
std::vector<bool> smooth_pixels(const Frame& f) {
    const int w = f.window.width, h = f.window.height;
    std::vector<bool> out(std::size_t(w) * std::size_t(h), false);
    const auto at = [w](int x, int y) { return std::size_t(y) * std::size_t(w) + std::size_t(x); };
    for (int y = 1; y + 1 < h; ++y)
        for (int x = 1; x + 1 < w; ++x) {
            const std::size_t c = at(x, y);
            bool is_smooth = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const std::size_t n = at(x + dx, y + dy), m = at(x - dx, y - dy);
                    is_smooth = is_smooth && f.object[n] == f.object[c] && f.mesh[n] == f.mesh[c];
                    if (f.object[c] == no_index || !is_smooth) continue;
                    is_smooth = std::fabs(0.5f * (f.depth[n] + f.depth[m]) - f.depth[c]) <= 0.002f * f.depth[c];
                }
            out[c] = is_smooth;
        }
    return out;
}

/// Pixels where soft's shadows are neither whole nor none, grown by the filter's radius.
std::vector<bool> shadow_borders(const Drawable& of, const Frame& lit, Context& context) {
    RenderSettings settings = of.request.settings;
    settings.shadows = false;
    settings.channels = channel_diffuse;
    const Frame all = of.by("soft", settings, context);
    const int w = lit.window.width, h = lit.window.height, radius = settings.shadow_filter + 1;
    std::vector<bool> out(lit.diffuse.size(), false);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const auto p = std::size_t(y * w + x);
            bool is_border = false;
            for (std::size_t c = 0; c < 3; ++c)
                is_border = is_border || (lit.diffuse[p][c] > 0 && lit.diffuse[p][c] < all.diffuse[p][c]);
            if (!is_border) continue;
            for (int v = std::max(0, y - radius); v <= std::min(h - 1, y + radius); ++v)
                for (int u = std::max(0, x - radius); u <= std::min(w - 1, x + radius); ++u)
                    out[std::size_t(v * w + u)] = true;
        }
    return out;
}

int component(std::uint32_t color, int c) { return int(color >> (8 * c) & 255u); }

struct Difference {
    std::uint64_t pixels = 0, near = 0;
    double squares = 0;
    void add(std::uint32_t a, std::uint32_t b) {
        int most = 0;
        for (int c = 0; c < 4; ++c) {
            const int d = std::abs(component(a, c) - component(b, c));
            most = std::max(most, d);
            if (c < 3) squares += double(d) * d;
        }
        ++pixels;
        near += most <= 2;
    }
    double share() const { return double(near) / double(pixels); }
    double rmse() const { return std::sqrt(squares / (3.0 * double(pixels))); }
    double psnr_db() const { return squares > 0 ? 20 * std::log10(255 / rmse()) : 1e9; }
};

class Parity : public testing::TestWithParam<ParityScene> {
protected:
    static void SetUpTestSuite() {
        ::setenv("GALLIVM_PERF", "no_aos_sampling", 1);  // llvmpipe filters in 8 bits otherwise
        ::setenv("RAKELIGHT_GL_CACHE", "off", 1);
    }
    virtual const char* engine() const { return "gl"; }
    void SetUp() override {
        try {
            make_engine(engine());
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }

    void compare(bool with_shadows = true) {
        Context context;
        const Drawable of = drawable(GetParam(), context);
        RenderSettings settings = of.request.settings;
        if (!with_shadows) settings.shadows = false;
        settings.channels = channel_object | channel_mesh | channel_depth | (settings.shadows ? channel_diffuse : 0u);
        settings.max_depth = 0;
        const Frame soft = of.by("soft", settings, context), other = of.by(engine(), settings, context);
        const std::vector<bool> in_soft = smooth_pixels(soft), in_other = smooth_pixels(other);
        std::vector<bool> border(in_soft.size(), false);
        if (settings.shadows) border = shadow_borders(of, soft, context);
        const std::vector<std::uint32_t> a = to_srgb8(soft, of.request.tone), b = to_srgb8(other, of.request.tone);
        ASSERT_EQ(a.size(), b.size());
        Difference inside, all;
        for (std::size_t p = 0; p < a.size(); ++p) {
            all.add(a[p], b[p]);
            if (in_soft[p] && in_other[p] && !border[p]) inside.add(a[p], b[p]);
        }
        const Limits limits = GetParam().limits;
        ASSERT_GT(inside.pixels, a.size() / 4) << "the scene has too few interiors to be judged by";
        RecordProperty("share_within_2", std::to_string(inside.share()));
        RecordProperty("rmse_of_255", std::to_string(inside.rmse()));
        RecordProperty("psnr_db_of_all", std::to_string(all.psnr_db()));
        EXPECT_GE(inside.share(), limits.share) << "of " << inside.pixels << " interior pixels";
        EXPECT_LE(inside.rmse(), limits.rmse);
        EXPECT_GE(all.psnr_db(), limits.psnr_db);
    }
};

TEST_P(Parity, OpenGlDrawsWhatTheSoftEngineDraws) { compare(); }

/// The same in OpenGL ES 3.0.
class ParityOfEs : public Parity {
protected:
    static void SetUpTestSuite() {
        Parity::SetUpTestSuite();
        ::setenv("RAKELIGHT_GL", "es", 1);
    }
    static void TearDownTestSuite() { ::unsetenv("RAKELIGHT_GL"); }
};

TEST_P(ParityOfEs, OpenGlDrawsWhatTheSoftEngineDraws) { compare(); }

/// Rays, without shadows: those of rays are none of a map's.
class ParityOfRays : public Parity {
protected:
    const char* engine() const override { return "trace"; }
};

TEST_P(ParityOfRays, TracedPicturesAreThoseOfTheSoftEngine) {
    const std::string words = GetParam().words;
    if (words.find("interpolation=screen") != words.npos) GTEST_SKIP() << "rays know no interpolation on the screen";
    if (words.find("transmission") != words.npos) GTEST_SKIP() << "rays go through glass";
    if (GetParam().limits.psnr_db == marked.psnr_db)
        GTEST_SKIP() << "rays meet lines or do not: tests/unit/raytrace has their own limits";
    compare(false);
}

const auto name_of = [](const auto& scene) { return std::string(scene.param.name); };
INSTANTIATE_TEST_SUITE_P(Scenes, Parity, testing::ValuesIn(scenes), name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, ParityOfEs, testing::ValuesIn(scenes), name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, ParityOfRays, testing::ValuesIn(scenes), name_of);

}  // namespace
}  // namespace rakelight
