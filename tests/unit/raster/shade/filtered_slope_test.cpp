// SPDX-License-Identifier: Apache-2.0
// Slopes of height maps that are seen small or at a grazing angle, against the closed form of a wave: a filter leaves a
// wave a wave and multiplies its slope by a number that is known. Of k waves over the map: a box of width w (a level of the
// mip chain) by sinc(k w), a linear filter of that spacing by sinc(k w)^2 in the mean over where its texels lie, a
// difference over w by sinc(k w), n probes over the length L by sin(pi k L) / (n sin(pi k L / n)).
#include <gtest/gtest.h>

#include <cmath>

#include "engines/raster/inspect/inspection.h"
#include "unit/raster/shade/relief_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int texels = 1024;
constexpr double depth = 0.01, shrink = 0.93;  // what the square shows of the map: pixels and texels never fall in step
constexpr double pixel_width = shrink / size;  // [widths of the map], seen from above

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

enum class Axis { u, v };

/// Texels of a map.
struct Size {
    int width = texels, height = texels;
};

/// A square whose height map is a wave of slope cos(2 pi k x), x along the axis; or the normal map of that along u.
Scene wave(Axis axis, double k, Bump bump, Size of = {}) {
    const auto at = [axis](float u, float v) { return double(axis == Axis::u ? u : v); };
    const auto height = [&](float u, float v) {
        const float h = float(0.5 + std::sin(2 * pi * k * at(u, v)) / (2 * pi * k));
        return vec3{h, h, h};
    };
    const auto normal = [&](float u, float v) {
        return vec3{float(0.5 - 0.5 * depth * std::cos(2 * pi * k * at(u, v))), 0.5f, 1};
    };
    Scene scene =
        square_with(bump == Bump::normal ? field(of.width, of.height, normal) : field(of.width, of.height, height));
    Material& m = scene.materials[0];
    m.base_color_texture = {};
    scene.textures.back().sampler = {};
    m.height_texture.transform.scale = {float(shrink), float(shrink)};
    if (bump == Bump::normal) m.normal_texture = m.height_texture, m.height_texture = {};
    return scene;
}

/// Parallel, turned from the square's normal upwards by that angle; sees its middle as flat_camera() does.
Camera tilted(double angle) {
    Camera camera = flat_camera();
    camera.to_world = look_at(dvec3{0, -5 * std::sin(angle), 5 * std::cos(angle)}, dvec3{0, 0, 0}, dvec3{0, 1, 0});
    return camera;
}

/// What is left of the slope: the cosine's share in what the pixels show, 1 without any filter.
double kept(Axis axis, double k, Bump bump, double angle = 0, int anisotropy = 1, MipFilter mip = MipFilter::linear,
            Size of = {}) {
    RenderSettings s = settings_of({bump, {.depth = float(depth)}});
    s.channels |= channel_uv;
    s.anisotropy = anisotropy;
    Scene scene = wave(axis, k, bump, of);
    scene.textures.back().sampler.mip = mip;
    const Frame f = draw(scene, tilted(angle), s);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < f.normal.size(); ++i) {
        if (f.object[i] == no_index) continue;
        const vec3 n = f.normal[i];
        const double x = shrink * double(axis == Axis::u ? f.uv[i].x : f.uv[i].y), c = std::cos(2 * pi * k * x);
        sum += c * double(axis == Axis::u ? -n.x / n.z : n.y / n.z);
        squares += c * c;
    }
    return sum / squares / depth;
}

/// Of a slope that is read at that level [texels of it: 2^level].
/// @param across  texels of the map along the wave
double expected_slope(double k, double level, double across = texels) {
    const double lower = std::floor(level), share = level - lower, difference = std::exp2(level) / across;
    const auto filter = [&](double l) { return std::pow(sinc(k * std::exp2(l) / across), 3); };
    return sinc(k * difference) * ((1 - share) * filter(lower) + share * filter(lower + 1));
}
double level_of(double width, double across = texels) {
    return std::log2(width * across) + std::log2(std::sqrt(3.0) / 2);
}

}  // namespace

TEST(FilteredSlope, AMinifiedHeightMapKeepsTheShareOfItsSlopeThatItsFiltersLeave) {
    for (const double pixels_a_wave : {24.0, 12.0, 8.0, 5.0}) {
        const double k = std::round(1 / (pixels_a_wave * pixel_width)),
                     expected = expected_slope(k, level_of(pixel_width));
        for (const Axis axis : {Axis::u, Axis::v})
            EXPECT_NEAR(kept(axis, k, Bump::height), expected, 0.01) << pixels_a_wave;
    }
}

TEST(FilteredSlope, HeightsOfASlopeLieATexelApartOfTheLevelThatIsRead) {
    const double k = std::round(1 / (5 * pixel_width)), level = level_of(pixel_width);
    EXPECT_NEAR(kept(Axis::u, k, Bump::height, 0, 1, MipFilter::none), expected_slope(k, 0), 0.01);
    EXPECT_NEAR(kept(Axis::u, k, Bump::height, 0, 1, MipFilter::nearest), expected_slope(k, std::round(level)), 0.01);
}

TEST(FilteredSlope, OfAMapTwiceAsWideAsHighAndTheOtherWayIsThatOfItsOwnTexelsWhateverTheMips) {
    for (const Size of : {Size{2 * texels, texels}, Size{texels, 2 * texels}})
        for (const double pixels_a_wave : {24.0, 12.0})
            for (const Axis axis : {Axis::u, Axis::v}) {
                const double k = std::round(1 / (pixels_a_wave * pixel_width));
                const double across = axis == Axis::u ? of.width : of.height;
                const double level = level_of(pixel_width, 2 * texels);  // of the side where texels are smaller
                // Texels are square: what is deep by widths of the map falls along v by as many heights more.
                const double heights = axis == Axis::u ? 1.0 : double(of.width) / of.height;
                const auto of_mips = [&](MipFilter mip) {
                    return kept(axis, k, Bump::height, 0, 1, mip, of) / heights;
                };
                EXPECT_NEAR(of_mips(MipFilter::linear), expected_slope(k, level, across), 0.01) << of.width << ' ' << k;
                EXPECT_NEAR(of_mips(MipFilter::none), expected_slope(k, 0, across), 0.01) << of.width << ' ' << k;
                EXPECT_NEAR(of_mips(MipFilter::nearest), expected_slope(k, std::round(level), across), 0.01) << k;
            }
}

TEST(FilteredSlope, AHeightMapIsAsSharpAsTheNormalMapOfItsSlopes) {
    for (const double pixels_a_wave : {24.0, 12.0, 8.0, 5.0}) {
        const double k = std::round(1 / (pixels_a_wave * pixel_width));
        const double of_normals = kept(Axis::u, k, Bump::normal);
        EXPECT_NEAR(kept(Axis::u, k, Bump::height) / of_normals, 1, 0.02) << pixels_a_wave;
    }
}

TEST(FilteredSlope, AtAGrazingAngleProbesKeepTheSlopeAcross) {
    const double angle = radians(80.0), k = std::round(1 / (8 * pixel_width));
    EXPECT_LT(std::fabs(kept(Axis::u, k, Bump::height, angle)), 0.1);
    const double ratio = 1 / std::cos(angle), probe = pixel_width * ratio / std::ceil(ratio);
    const double expected = expected_slope(k, level_of(probe));
    EXPECT_GT(expected, 0.75);
    EXPECT_NEAR(kept(Axis::u, k, Bump::height, angle, 16), expected, 0.01);
    EXPECT_NEAR(kept(Axis::u, k, Bump::height, angle, 16), kept(Axis::u, k, Bump::normal, angle, 16), 0.02);
}

TEST(FilteredSlope, AtAGrazingAngleProbesAverageTheSlopeAlongTheirLine) {
    const double angle = radians(80.0), ratio = 1 / std::cos(angle), count = std::ceil(ratio);
    const double length = pixel_width * ratio, k = std::round(1 / (4 * length));
    const double probes = std::sin(pi * k * length) / (count * std::sin(pi * k * length / count));
    const double expected = probes * expected_slope(k, level_of(length / count));
    EXPECT_LT(expected, 0.9);
    EXPECT_NEAR(kept(Axis::v, k, Bump::height, angle, 16), expected, 0.01);
}

namespace {

/// The height map of the pixel in the middle.
raster::ShadedLayer explained(const Scene& scene, RenderSettings s, const Camera& camera) {
    Context context({.threads = 1});
    const raster::Inspection inspection(scene, camera, s, context);
    return inspection.explain(size / 2, size / 2, context).layers.at(0);
}

}  // namespace

TEST(FilteredSlope, ExplainListsTheHeightsThatTheSlopeReadsAndNoOthers) {
    RenderSettings s = settings_of({Bump::height, {.depth = 0.1f}});
    s.anisotropy = 8;
    const Camera camera = tilted(radians(70.0));
    const auto with = [](const Pixels& heights) {
        Scene scene = square_with(heights);
        scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
        return scene;
    };
    const Pixels map = field(16, [](float u, float v) {
        const float h = u * (1 - v);
        return vec3{h, h, h};
    });
    const raster::ShadedLayer layer = explained(with(map), s, camera);
    EXPECT_FALSE(layer.trace.map[role_normal].is_used);
    const raster::TracedTexels& listed = layer.texels[role_height];
    ASSERT_GT(listed.count, 4);
    double sum = 0, weights = 0;
    Pixels others = map, one = map;
    const auto is_listed = [&](int x, int y) {
        for (int i = 0; i < listed.count; ++i)
            if (listed.texel[i].x == x && listed.texel[i].y == y) return true;
        return false;
    };
    for (int i = 0; i < listed.count; ++i) {
        sum += double(listed.texel[i].weight * listed.texel[i].value[0]);
        weights += double(listed.texel[i].weight);
    }
    EXPECT_NEAR(weights, 1, 1e-5);
    EXPECT_NEAR(sum, double(layer.trace.map[role_height].value[0]), 1e-5);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            auto* const texel = reinterpret_cast<vec3*>((is_listed(x, y) ? one : others).bytes.data()) + y * 16 + x;
            texel->x += 0.3f * float((x * 5 + y * 3) % 7);
        }
    const auto normal = [&](const Pixels& heights) {
        const raster::ShadedLayer l = explained(with(heights), s, camera);
        return vec3{l.trace.normal[0], l.trace.normal[1], l.trace.normal[2]};
    };
    EXPECT_EQ(normal(map), normal(others));
    EXPECT_NE(normal(map), normal(one));
}

TEST(FilteredSlope, ExplainSaysTheHeightThatTheRayMeetsAndNotTheMeanOfThoseOfItsSlope) {
    RenderSettings s = settings_of({Bump::occlusion, {.depth = 0.1f}});
    const Pixels map = field(8, [](float u, float) {
        const float h = u < 0.5f ? 0.2f : 0.8f;
        return vec3{h, h, h};
    });
    const auto at = [](float u) { return 0.2f + 0.6f * std::clamp(u * 8 - 3.5f, 0.0f, 1.0f); };  // between texels 3, 4
    for (const bool holds_depth : {false, true}) {
        s.relief.holds_depth = holds_depth;
        Context context({.threads = 1});
        const raster::Inspection inspection(square_with(map), looking_from({-2, 0, 3}), s, context);
        int mean_is_off = 0;
        for (int x = 0; x < size; ++x) {
            const raster::PixelExplanation e = inspection.explain(x, size / 2, context);
            if (e.layers.empty()) continue;
            const raster::PixelTrace& t = e.layers[0].trace;
            const float met = at(t.relief_texcoord[0][0]);
            EXPECT_NEAR(t.relief_height, met, 0.01f) << x;  // bisections leave a 32nd of a layer
            mean_is_off += std::fabs(t.map[role_height].value[0] - met) > 0.05f;
        }
        EXPECT_GT(mean_is_off, 2);
    }
}

TEST(FilteredSlope, ExplainSaysTheProbesOfTheSlopeAndOneWhereANormalMapIsLit) {
    RenderSettings s = settings_of({Bump::height, {.depth = 0.1f}});
    s.anisotropy = 16;
    Scene scene = wave(Axis::u, 8, Bump::height);
    const Camera camera = tilted(radians(80.0));
    const auto height_of = [&] { return explained(scene, s, camera).trace.map[role_height]; };
    EXPECT_EQ(height_of().probes, 6);
    EXPECT_NEAR(height_of().level, level_of(pixel_width / std::cos(radians(80.0)) / 6), 0.05);
    s.bump = Bump::occlusion;
    EXPECT_EQ(height_of().probes, 6);
    scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
    EXPECT_EQ(height_of().probes, 1);  // met along the ray, at the level of the whole pixel
    EXPECT_NEAR(height_of().level, std::log2(pixel_width / std::cos(radians(80.0)) * texels), 0.05);
}
