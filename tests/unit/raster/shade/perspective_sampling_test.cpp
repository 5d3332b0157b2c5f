// SPDX-License-Identifier: Apache-2.0
// Texture filtering on a floor in perspective, where everything has a closed form: the place that a pixel's ray meets,
// the derivatives of the texture coordinates there, the level of detail, and the color of a ramp, which every filter
// must leave as it is.
//
// The eye is `h` above a floor and looks along -z; b pixels below the middle of the picture and a to its right, with k
// pixels for an angle whose tangent is 1, a ray meets the floor at distance d = h k / b and x = h a / b.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "engines/raster/inspect/inspection.h"
#include "engines/raster/raster_engine.h"
#include "math/functions.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 160, height = 120;
constexpr double eye_height = 1.5, half_floor = 40;  // [m]
const double pixels_per_slope = height / 2 / math::tan(radians(25.0));

/// The floor's texture covers it once: u to the right, v away from the viewer.
Scene floor_with(Pixels pixels, Sampler sampler, double turn = 0) {
    Scene scene;
    Material m = matte();
    m.model = MaterialModel::unlit;
    m.double_sided = true;
    m.base_color_texture = add_texture(scene, picture(std::move(pixels)), sampler);
    m.base_color_texture.transform.rotation_rad = float(turn);
    scene.materials = {m};
    Mesh floor = square_mesh(0);
    const float s = float(half_floor);
    floor.positions = std::vector<vec3>{{-s, 0, s}, {s, 0, s}, {s, 0, -s}, {-s, 0, -s}};
    floor.texcoords[0] = std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    floor.tangents = {};
    add_object(scene, std::move(floor));
    return scene;
}

Camera above() {
    Camera camera;
    camera.vertical_fov_rad = radians(50);
    camera.z_near = 0.1;
    camera.z_far = 1000;
    camera.to_world = translation(dvec3{0, eye_height, 0});
    return camera;
}

RenderSettings settings() {
    return {.width = width, .height = height, .shading = Shading::unlit, .background = {0, 0, 0, 0}};
}

/// A pixel's place on the floor, and how its texture coordinates change.
struct OnFloor {
    double u, v, u_x, u_y, v_x, v_y;  ///< u_x: change of u by one pixel to the right

    OnFloor(int x, int y) {
        const double a = x + 0.5 - width / 2.0, b = y + 0.5 - height / 2.0, h = eye_height, side = 2 * half_floor;
        u = 0.5 + h * a / b / side;
        v = 0.5 + h * pixels_per_slope / b / side;
        u_x = h / b / side;
        u_y = -h * a / (b * b) / side;
        v_x = 0;
        v_y = -h * pixels_per_slope / (b * b) / side;
    }
    /// log2 of the longer side of the footprint [texels]
    double level_of_detail(double texels_u, double texels_v) const {
        return std::log2(
            std::fmax(std::hypot(u_x * texels_u, v_x * texels_v), std::hypot(u_y * texels_u, v_y * texels_v)));
    }
};

/// Linear values that rise evenly: red with u, green with v.
Pixels ramp(int w, int h) {
    Pixels p;
    p.width = w;
    p.height = h;
    p.channels = 3;
    p.component = Component::f32;
    p.bytes.resize(std::size_t(w) * std::size_t(h) * 12);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const float texel[3] = {(float(x) + 0.5f) / float(w), (float(y) + 0.5f) / float(h), 0.25f};
            std::memcpy(&p.bytes[(std::size_t(y) * std::size_t(w) + std::size_t(x)) * 12], texel, 12);
        }
    return p;
}

Frame draw(const Scene& scene) {
    Context context({.threads = 2});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(above(), settings(), frame, context);
    return frame;
}

}  // namespace

TEST(PerspectiveSampling, TheLevelOfDetailIsThatOfTheDerivatives) {
    for (const auto& [w, h] : {std::pair(512, 512), std::pair(64, 512), std::pair(512, 16)}) {
        const Scene scene = floor_with(ramp(w, h), {});
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, above(), settings(), context);
        for (int y = height / 2 + 6; y < height; y += 5)
            for (int x = 3; x < width; x += 19) {
                const raster::PixelExplanation pixel = inspection.explain(x, y, context);
                const OnFloor exact(x, y);
                ASSERT_EQ(pixel.layers.size(), 1u);
                const raster::TracedTexture& map = pixel.layers[0].trace.map[role_base_color];
                EXPECT_NEAR(double(map.u), exact.u, 2e-5) << x << ", " << y;
                EXPECT_NEAR(double(map.v), exact.v, 2e-5) << x << ", " << y;
                const double level = exact.level_of_detail(w, h);
                EXPECT_NEAR(double(map.level_of_detail), level, 2e-3) << x << ", " << y;
                EXPECT_NEAR(double(map.level), std::fmin(std::fmax(level, 0), std::log2(std::max(w, h))), 2e-3)
                    << x << ", " << y;
            }
    }
}

/// The footprint of a turned texture of square texels is turned too: its level stays.
TEST(PerspectiveSampling, TurningTheTextureLeavesTheLevelAsItIs) {
    for (const double turn : {0.3, 1.1, pi / 2, 2.5}) {
        const Scene scene = floor_with(ramp(256, 256), {}, turn);
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, above(), settings(), context);
        for (int y = height / 2 + 6; y < height; y += 11)
            for (int x = 5; x < width; x += 37) {
                const raster::TracedTexture map =
                    inspection.explain(x, y, context).layers.at(0).trace.map[role_base_color];
                EXPECT_NEAR(double(map.level_of_detail), OnFloor(x, y).level_of_detail(256, 256), 2e-3)
                    << turn << ": " << x << ", " << y;
            }
    }
}

/// Bilinear and trilinear filters interpolate linearly, and halving keeps a ramp a ramp: whatever the level, the color
/// is the coordinate. Only near the border, where a coarse level's texels end, it is not.
TEST(PerspectiveSampling, ARampKeepsItsColorsThroughEveryLinearFilter) {
    for (const MipFilter mip : {MipFilter::none, MipFilter::nearest, MipFilter::linear})
        for (const auto& [w, h] : {std::pair(256, 256), std::pair(512, 64)}) {
            const Sampler sampler{.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge, .mip = mip};
            const Frame frame = draw(floor_with(ramp(w, h), sampler));
            int compared = 0, shrunk = 0;
            for (int y = height / 2 + 5; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const OnFloor exact(x, y);
                    const double level = std::ceil(std::fmax(exact.level_of_detail(w, h), 0)), texel = std::exp2(level);
                    const auto is_inside = [&](double at, int size) {
                        return at * size > texel && at * size < size - texel;
                    };
                    if (!is_inside(exact.u, w) || !is_inside(exact.v, h)) continue;
                    const vec4 c = frame.color[std::size_t(y * width + x)];
                    EXPECT_NEAR(double(c.x), exact.u, 4e-5) << x << ", " << y << " level " << level;
                    EXPECT_NEAR(double(c.y), exact.v, 4e-5) << x << ", " << y << " level " << level;
                    EXPECT_NEAR(double(c.z), 0.25, 1e-6);
                    ++compared;
                    shrunk += level > 0;
                }
            EXPECT_GT(compared, 3000) << w << " x " << h;
            EXPECT_GT(shrunk, 200) << w << " x " << h;
        }
}

/// The nearest filter shows the texel that the ray meets: the ramp in steps, off by at most half a texel.
TEST(PerspectiveSampling, TheNearestFilterIsOffByAtMostHalfATexel) {
    const Sampler sampler{.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::none};
    const Frame frame = draw(floor_with(ramp(128, 128), sampler));
    double worst = 0;
    for (int y = height / 2 + 5; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const OnFloor exact(x, y);
            if (exact.u < 0.01 || exact.u > 0.99 || exact.v < 0.01 || exact.v > 0.99) continue;
            const vec4 c = frame.color[std::size_t(y * width + x)];
            worst = std::fmax(worst, std::fmax(std::fabs(double(c.x) - exact.u), std::fabs(double(c.y) - exact.v)));
        }
    EXPECT_LE(worst, 0.5 / 128 + 4e-5);
    EXPECT_GT(worst, 0.49 / 128);
}

namespace {

/// White stripes of 4 texels that run away from the viewer.
Pixels stripes() {
    return rgb_pixels(512, 512, [](int x, int) {
        const int v = x / 4 % 2 == 0 ? 255 : 0;
        return std::array<int, 3>{v, v, v};
    });
}

Frame draw(const Scene& scene, int anisotropy) {
    Context context({.threads = 2});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    RenderSettings s = settings();
    s.anisotropy = anisotropy;
    engine->render(above(), s, frame, context);
    return frame;
}

/// Difference of the lightest and the darkest of a row's middle.
float contrast(const Frame& f, int y) {
    float low = 2, high = -1;
    for (int x = width / 2 - 30; x < width / 2 + 30; ++x) {
        const float v = f.color[std::size_t(y * width + x)].x;
        low = std::fmin(low, v);
        high = std::fmax(high, v);
    }
    return high - low;
}

}  // namespace

TEST(PerspectiveSampling, AnisotropicFilteringKeepsStripesThatRunAwayAndSquaresBlurThem) {
    // 12.5 pixels below the horizon a pixel is 0.8 texels wide and 7.9 long.
    const Scene scene = floor_with(stripes(), {});
    const int row = height / 2 + 12;
    EXPECT_LT(contrast(draw(scene, 1), row), 0.1f);
    EXPECT_GT(contrast(draw(scene, 4), row), 0.4f);
    EXPECT_GT(contrast(draw(scene, 16), row), 0.7f);
}

TEST(PerspectiveSampling, AnisotropicFilteringLeavesARampAsItIs) {
    const Scene scene = floor_with(ramp(256, 256), {});
    const Frame f = draw(scene, 16);
    for (int y = height / 2 + 20; y < height; y += 7)
        for (int x = width / 2 - 20; x < width / 2 + 20; x += 5) {
            const OnFloor p(x, y);
            const vec4 c = f.color[std::size_t(y * width + x)];
            EXPECT_NEAR(c.x, p.u, 2e-3) << x << ", " << y;
            EXPECT_NEAR(c.y, p.v, 2e-3) << x << ", " << y;
        }
}

TEST(PerspectiveSampling, AnisotropyOutOfRangeIsRefused) {
    const Scene scene = floor_with(stripes(), {});
    EXPECT_THROW(draw(scene, 0), Error);
    EXPECT_THROW(draw(scene, 17), Error);
}
