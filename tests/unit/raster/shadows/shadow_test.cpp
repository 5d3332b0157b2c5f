// SPDX-License-Identifier: Apache-2.0
// Shadows against the exact ones, on scenes where nothing else throws any, at default settings.
#include <gtest/gtest.h>

#include <limits>

#include <rakelight/base/error.h>

#include "engines/raster/inspect/inspection.h"
#include "math/isa.h"
#include "unit/raster/shadows/shadow_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 160, height = 120;

RenderSettings settings_with(bool shadows) {
    return {.width = width, .height = height, .shadows = shadows, .background = {0, 0, 0, 1}};
}

Scene scene_with(const Light& light) {
    Scene scene;
    Material white = matte();
    white.classical.specular = {};
    scene.materials = {white};
    scene.lights = {light};
    return scene;
}

Scene sphere_on_plane(const Light& light) {
    Scene scene = scene_with(light);
    add_square(scene, 4, lying());
    add_object(scene, sphere_mesh(48, 96), translation(dvec3{0, 1, 0}));
    return scene;
}

/// Share of the light that each pixel gets, by the pictures with and without shadows; -1 where there is none to get.
std::vector<float> seen(const Scene& scene, const Camera& camera, RenderSettings settings = settings_with(true)) {
    settings.shadows = true;
    const Frame with = draw(scene, camera, settings);
    settings.shadows = false;
    const Frame without = draw(scene, camera, settings);
    std::vector<float> share;
    for (std::size_t i = 0; i < with.color.size(); ++i)
        share.push_back(without.color[i].x > 0.004f ? with.color[i].x / without.color[i].x : -1.0f);
    return share;
}

struct Difference {
    int compared = 0, leaks = 0, acne = 0;  ///< pixels; lit in the shadow; dark in the light
};

/// Pixels whose exact shadow is the same `away` meters round about.
Difference compare(const Scene& scene, const Camera& camera, double away) {
    const std::vector<float> share = seen(scene, camera);
    const RayCast exact(scene);
    const Light& light = scene.lights[0];
    Difference out;
    const double h = std::tan(camera.vertical_fov_rad / 2);
    const dmat4& m = camera.to_world;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float is = share[std::size_t(y * width + x)];
            if (is < 0) continue;
            const double u = ((x + 0.5) / width * 2 - 1) * h * width / height, v = (1 - (y + 0.5) / height * 2) * h;
            const auto hit = exact.nearest(m[3].xyz(), m[0].xyz() * u + m[1].xyz() * v - m[2].xyz());
            if (!hit) continue;
            const dvec3 to_light =
                light.type == LightType::directional ? light.direction * -1000.0 : light.position - hit->position;
            if (dot(normalize_or(to_light, dvec3{0, 0, 1}), hit->normal) < 0.03) continue;  // where the terminator is
            const dvec3 side = normalize_or(cross(to_light, dvec3{0.3, 0.5, 0.8}), dvec3{1, 0, 0}),
                        up = normalize_or(cross(side, to_light), dvec3{0, 1, 0});
            int hidden = 0, asked = 0;
            for (int k = -1; k < 8; ++k) {
                const double a = k * pi / 4, r = k < 0 ? 0 : away;
                const dvec3 from = hit->position + hit->normal * 1e-6;
                const dvec3 shift = side * (r * std::cos(a)) + up * (r * std::sin(a));
                // The surface a little aside on the map: move within the plane of the surface.
                const double along = dot(shift, hit->normal) / dot(to_light, hit->normal);
                const dvec3 at = from + shift - to_light * along;
                const dvec3 way = light.type == LightType::directional ? to_light : light.position - at;
                hidden += exact.is_hidden(at, way), ++asked;
            }
            if (hidden != 0 && hidden != asked) continue;
            ++out.compared;
            if (hidden == asked && is > 0.01f) ++out.leaks;
            if (hidden == 0 && is < 0.99f) ++out.acne;
        }
    return out;
}

const Camera above = looking({2, 4, 6}, {0, 0.6, 0});

TEST(Shadows, OfASphereOnAPlaneAreTheExactOnesForEveryKindOfLight) {
    const struct {
        const char* name;
        Light light;
        double away;  // [m] filter and half texel
    } cases[] = {{"directional", directional({-1, -1.5, -0.5}), 0.04},
                 {"point", lamp({2, 4, 1}), 0.04},
                 {"spot", spot_at({2, 5, 1}, {0, 0, 0}, 0.6), 0.03},
                 {"wide spot", spot_at({2, 5, 1}, {0, 0, 0}, 1.4), 0.04}};
    for (const auto& c : cases) {
        const Difference d = compare(sphere_on_plane(c.light), above, c.away);
        EXPECT_GT(d.compared, 5000) << c.name;
        EXPECT_EQ(d.leaks, 0) << c.name << " of " << d.compared;
        EXPECT_LE(d.acne, d.compared / 1000) << c.name << " of " << d.compared;
    }
}

TEST(Shadows, APlaneInGrazingLightHasNoneOfItsOwn) {
    for (const double degrees : {30.0, 2.0, 0.5})
        for (const double turn : {0.0, 0.3}) {
            const double a = radians(degrees);
            const dvec3 down = {std::cos(a) * std::cos(turn), -std::sin(a), std::cos(a) * std::sin(turn)};
            Light lights[2] = {directional(down, {100, 100, 100}), lamp(down * -10.0)};
            lights[1].diffuse = {100, 100, 100};
            for (const Light& light : lights) {
                Scene scene = scene_with(light);
                add_square(scene, 4, lying());
                for (const float s : seen(scene, above)) ASSERT_TRUE(s < 0 || s > 0.9999f) << degrees << ' ' << s;
            }
        }
}

TEST(Shadows, AWallWithoutThicknessHidesTheLightRightDownToItsFoot) {
    Scene scene = scene_with(directional({0, -1, -2}));
    add_square(scene, 4, lying());
    add_square(scene, 1, translation(dvec3{0, 1, 0}));  // from y = 0 to 2 at z = 0; its shadow falls to z = -4
    const Camera behind = looking({0, 3, -5}, {0, 0, 0});
    const Difference d = compare(scene, behind, 0.03);
    EXPECT_GT(d.compared, 3000);
    EXPECT_EQ(d.leaks, 0);
    EXPECT_EQ(d.acne, 0);
    // The floor behind it is dark to within two texels (25 mm each on the floor) of its foot.
    Scene close = scene;
    const Camera near_foot = looking({0, 0.5, -0.4}, {0, 0, -0.02}, 0.2);
    const Frame frame = draw(close, near_foot, settings_with(true));
    const RayCast exact(close);
    const double h = std::tan(0.1);
    int dark = 0;
    for (int y = 0; y < height; ++y) {
        const double v = (1 - (y + 0.5) / height * 2) * h;
        const dmat4& m = near_foot.to_world;
        const auto hit = exact.nearest(m[3].xyz(), m[1].xyz() * v - m[2].xyz());
        if (!hit || hit->normal.y < 0.5 || hit->position.z > -0.05) continue;
        EXPECT_EQ(pixel(frame, width / 2, y).x, 0) << hit->position.z;
        ++dark;
    }
    EXPECT_GT(dark, 20);
}

/// Six squares that share their edges.
Scene closed_box(const Light& light) {
    Scene scene = scene_with(light);
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double sign = face % 2 ? -1 : 1;
        dvec3 n, u, v;
        n[std::size_t(axis)] = sign, u[std::size_t((axis + 1) % 3)] = sign, v[std::size_t((axis + 2) % 3)] = 1;
        dmat4 m;
        m[0] = {u.x, u.y, u.z, 0}, m[1] = {v.x, v.y, v.z, 0}, m[2] = {n.x, n.y, n.z, 0}, m[3] = {n.x, n.y + 1, n.z, 1};
        add_square(scene, 1, m);
    }
    return scene;
}

TEST(Shadows, ALampInAClosedBoxLightsAllOfItsInsideAndNothingOutside) {
    for (const dvec3 at : {dvec3{0, 1, 0}, dvec3{0.6, 1.5, -0.7}, dvec3{-0.9, 0.2, 0.9}}) {
        Scene scene = closed_box(lamp(at));
        int dark = 0, all = 0;
        for (const float s : seen(scene, looking({0.8, 1.2, 0.7}, {-1, 0.7, -1}, 1.6))) {
            all += s >= 0;
            dark += s >= 0 && s < 0.99f;
        }
        EXPECT_GT(all, width * height * 9 / 10);
        EXPECT_LE(dark, all / 200) << at.x;  // pixels that touch an edge of the box
        add_square(scene, 6, lying());
        const Frame outside = draw(scene, looking({5, 6, 7}, {0, 0.5, 0}), settings_with(true));
        const Frame unshadowed = draw(scene, looking({5, 6, 7}, {0, 0.5, 0}), settings_with(false));
        double sum = 0, lit = 0;
        for (std::size_t i = 0; i < outside.color.size(); ++i) {
            sum += outside.color[i].x, lit += unshadowed.color[i].x;
        }
        EXPECT_LT(sum, lit / 1000) << at.x;  // along the foot of the walls, which have no thickness, by the filter
        EXPECT_GT(lit, 100);
    }
}

/// A square with holes between the lamp and the floor.
Scene holed(AlphaMode mode) {
    Scene scene = scene_with(directional({0, -1, 0}));
    Material m = matte();
    m.alpha_mode = mode;
    m.opacity_texture = add_texture(scene, picture(rgb_pixels(8, 8, [](int x, int) {
                                        return std::array<int, 3>{x < 4 ? 255 : 0, 0, 0};
                                    })));
    scene.materials.push_back(m);
    add_square(scene, 4, lying());
    dmat4 up = lying();
    up[3] = {0, 2, 0, 1};
    add_object(scene, square_mesh(1), up);
    return scene;
}

TEST(Shadows, MaskedSurfacesThrowTheShapeOfTheirMaskAndBlendedOnesNone) {
    const auto at = [&](const Scene& scene, double x) {
        const Frame f = draw(scene, looking({x, 0.5, 2}, {x, 0, 0}, 0.1), settings_with(true));
        return pixel(f, width / 2, height / 2).x;
    };
    EXPECT_EQ(at(holed(AlphaMode::mask), -0.5), 0);
    EXPECT_NEAR(at(holed(AlphaMode::mask), 0.5), 1, 1e-4);
    EXPECT_NEAR(at(holed(AlphaMode::mask), 1.5), 1, 1e-4);
    EXPECT_NEAR(at(holed(AlphaMode::blend), -0.5), 1, 1e-4);
}

TEST(Shadows, AreThrownByNoLightThatDoesNotCastThemNorByAmbientLight) {
    Light quiet = directional({-1, -1.5, -0.5});
    quiet.casts_shadow = false;
    Light ambient;
    ambient.type = LightType::ambient;
    ambient.ambient = {0.3f, 0.3f, 0.3f};
    for (const Light& light : {quiet, ambient}) {
        const Scene scene = sphere_on_plane(light);
        EXPECT_TRUE(same_bits(draw(scene, above, settings_with(true)), draw(scene, above, settings_with(false))));
    }
}

Scene many_shadows() {
    Scene scene = sphere_on_plane(directional({-1, -1.5, -0.5}, {0.4f, 0.4f, 0.4f}));
    scene.lights.push_back(lamp({2, 4, 1}));
    scene.lights.push_back(spot_at({-2, 3, 2}, {0, 0, 0}, 0.5));
    scene.lights[1].linear = 0.2f;
    scene.lights[1].range = 6;
    return scene;
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

TEST(Shadows, HaveTheSameBitsForAnyThreadsInstructionSetAndWindow) {
    const Scene scene = many_shadows();
    RenderSettings settings = settings_with(true);
    settings.shadow_size = 256;
    const Frame whole = draw(scene, above, settings);
    EXPECT_TRUE(same_bits(whole, draw(scene, above, settings, 3)));
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        EXPECT_TRUE(same_bits(whole, draw(scene, above, settings))) << name(isa);
    }
    settings.window = {37, 21, 90, 70};
    const Frame part = draw(scene, above, settings);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 90; ++x) ASSERT_EQ(pixel(part, x, y), pixel(whole, x + 37, y + 21)) << x << ' ' << y;
}

TEST(Shadows, AnExplainedPixelHasThemToo) {
    const Scene scene = many_shadows();
    RenderSettings settings = settings_with(true);
    settings.shadow_size = 128;
    const Frame frame = draw(scene, above, settings);
    Context context({.threads = 1});
    const raster::Inspection inspection(scene, above, settings, context);
    for (const auto& [x, y] : {std::pair(30, 60), {70, 80}, {80, 50}, {95, 70}, {120, 100}})
        EXPECT_EQ(inspection.explain(x, y, context).color, pixel(frame, x, y)) << x << ' ' << y;
}

TEST(Shadows, OfAFlatGouraudOrMonstrousSceneAreLeftOutAndTheReportSaysSo) {
    const auto remarks = [](const Scene& scene, Shading shading) {
        Context context({.threads = 1});
        auto engine = raster::make_engine();
        engine->prepare(scene, context);
        RenderSettings settings = settings_with(true);
        settings.shading = shading, settings.shadow_size = 64;
        Frame frame;
        engine->render(above, settings, frame, context);
        std::string all;
        for (const ReportEntry& entry : context.report().entries())
            if (entry.message.find("a texel of its shadow map") == std::string::npos) all += entry.message + '\n';
        return all;
    };
    Scene scene = many_shadows();
    EXPECT_EQ(remarks(scene, Shading::phong), "");
    EXPECT_NE(remarks(scene, Shading::gouraud).find("shadows do not fall on flat and Gouraud"), std::string::npos);
    EXPECT_NE(remarks(scene, Shading::flat).find("shadows do not fall on flat and Gouraud"), std::string::npos);
    EXPECT_EQ(remarks(scene, Shading::automatic).find("Gouraud"), std::string::npos);
    scene.nodes[0].local.matrix = scaling(dvec3{1e200, 1e200, 1e200});
    EXPECT_NE(remarks(scene, Shading::phong).find("too large for shadows"), std::string::npos);
}

TEST(Shadows, MapsThatCannotBeAreUsageErrors) {
    const Scene scene = many_shadows();
    RenderSettings settings = settings_with(true);
    for (const int size : {0, 15, 8193}) {
        settings.shadow_size = size;
        EXPECT_THROW(draw(scene, above, settings), Error) << size;
    }
    settings.shadow_size = 8192;  // 8 maps of 512 MiB
    try {
        draw(scene, above, settings);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::usage);
        EXPECT_NE(std::string(e.what()).find("8 shadow maps of 8192 x 8192"), std::string::npos) << e.what();
    }
    settings.shadow_size = 64;
    settings.shadow_filter = 5;
    EXPECT_THROW(draw(scene, above, settings), Error);
    settings.shadow_filter = 1;
    settings.shadow_bias = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(draw(scene, above, settings), Error);
}

}  // namespace
