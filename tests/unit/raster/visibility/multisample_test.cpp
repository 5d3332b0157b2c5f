// SPDX-License-Identifier: Apache-2.0
// Multisampled pictures where the number of covered samples is known: edges, thin lines, masks, blended surfaces.
#include "engines/raster/multisample.h"

#include <gtest/gtest.h>

#include <cstring>

#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int size = 64;
constexpr vec4 white{1, 1, 1, 1}, black{0, 0, 0, 1}, color{0.3f, 0.6f, 0.9f, 1};

struct Drawn {
    Frame frame;
    RenderStats stats;
    vec4 at(int x, int y) const { return frame.color[std::size_t(y * size + x)]; }
    float red(int x, int y) const { return at(x, y).x; }
    double sum() const {
        double s = 0;
        for (const vec4& c : frame.color) s += double(c.x);
        return s;
    }
};

RenderSettings settings_of(int samples) {
    return {.width = size, .height = size, .samples = samples, .background = black};
}

Drawn draw(const Scene& scene, const RenderSettings& settings, const Camera& camera = flat_camera()) {
    Drawn drawn;
    drawn.frame = test::draw(scene, camera, settings, 1, &drawn.stats);
    return drawn;
}

/// A fan of triangles, corners in pixels of the picture that flat_camera() sees, y down.
void add_polygon(Scene& scene, std::uint32_t material, const std::vector<dvec2>& corners_px, float z = 0) {
    Mesh mesh;
    std::vector<std::uint32_t> indices;
    std::vector<vec3> positions;
    for (const dvec2& c : corners_px) positions.push_back({float(c.x / 32 - 1), float(1 - c.y / 32), z});
    for (std::uint32_t k = 2; k < corners_px.size(); ++k) indices.insert(indices.end(), {0, k - 1, k});
    mesh.normals = std::vector<vec3>(positions.size(), vec3{0, 0, 1});
    mesh.positions = std::move(positions);
    mesh.indices = indices;
    mesh.material = material;
    add_object(scene, std::move(mesh));
}

Scene polygon(vec4 c, const std::vector<dvec2>& corners_px, AlphaMode mode = AlphaMode::opaque) {
    Scene scene;
    const std::uint32_t material = add_unlit(scene, c, mode);
    add_polygon(scene, material, corners_px);
    return scene;
}

/// How many samples of pixel (x, y) are where `inside` says so.
template <class Inside>
int count(int samples, int x, int y, const Inside& inside) {
    int n = 0;
    for (const shading::SamplePosition& p : shading::sample_positions(samples))
        n += inside(x + 0.5 + p.x / 16.0, y + 0.5 + p.y / 16.0) ? 1 : 0;
    return n;
}

}  // namespace

TEST(Multisample, PositionsAreAllDifferentInRowsAndColumnsAndTheirMeanIsTheCenter) {
    for (const int samples : {4, 8}) {
        const auto positions = shading::sample_positions(samples);
        ASSERT_EQ(int(positions.size()), samples);
        int x = 0, y = 0, reach = 0;
        for (const auto& a : positions) {
            x += a.x, y += a.y;
            reach = std::max({reach, std::abs(a.x), std::abs(a.y)});
            for (const auto& b : positions) EXPECT_TRUE(&a == &b || (a.x != b.x && a.y != b.y));
        }
        EXPECT_EQ(x, 0);
        EXPECT_EQ(y, 0);
        EXPECT_EQ(shading::sample_reach(samples), reach * shading::fixed_per_position);
    }
}

TEST(Multisample, APixelAtAStraightEdgeHasTheShareOfItsSamplesOnTheInnerSide) {
    for (const int samples : {4, 8})
        for (const auto& [top, bottom] :
             {std::pair{20.03125, 20.03125}, {31.0, 47.0}, {10.25, 55.5}, {50.0, 49.0}, {60.0, 3.75}}) {
            const Scene scene = polygon(white, {{0, 0}, {top, 0}, {bottom, 64}, {0, 64}});
            const Drawn drawn = draw(scene, settings_of(samples));
            const double a = top, slope = (bottom - top) / 64;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const int n = count(samples, x, y, [&](double px, double py) { return px < a + slope * py; });
                    ASSERT_EQ(drawn.red(x, y), float(n) / float(samples))
                        << x << ", " << y << ", " << top << " to " << bottom;
                }
            EXPECT_NEAR(drawn.sum(), 32 * (top + bottom), 0.004 * 32 * (top + bottom)) << "the area in pixels";
        }
}

TEST(Multisample, ALineThinnerThanAPixelKeepsItsLightWhereverItLies) {
    for (const int samples : {4, 8}) {
        const double width = 1.0 / samples;  // as far as the samples' columns, and rows, lie apart
        for (int shift = 0; shift < 32; ++shift) {
            const double x = 30 + shift / 32.0;
            const Drawn upright =
                draw(polygon(white, {{x, 0}, {x + width, 0}, {x + width, 64}, {x, 64}}), settings_of(samples));
            const Drawn level =
                draw(polygon(white, {{0, x}, {64, x}, {64, x + width}, {0, x + width}}), settings_of(samples));
            for (int k = 0; k < size; ++k) {
                float row = 0, column = 0;
                for (int i = 0; i < size; ++i) row += upright.red(i, k), column += level.red(k, i);
                ASSERT_EQ(row, float(width)) << shift;
                ASSERT_EQ(column, float(width)) << shift;
            }
        }
        const Drawn leaning = draw(polygon(white, {{20, 0}, {20.5, 0}, {43.5, 64}, {43, 64}}), settings_of(samples));
        EXPECT_NEAR(leaning.sum(), 32, 0.5);
        for (int y = 0; y < size; ++y) {
            float row = 0;
            for (int x = 0; x < size; ++x) row += leaning.red(x, y);
            EXPECT_GE(row, 0.25f) << y;
        }
    }
}

TEST(Multisample, ATriangleBetweenThePixelCentersIsDrawn) {
    for (const int samples : {4, 8})
        for (const shading::SamplePosition& p : shading::sample_positions(samples)) {
            const double x = 17.5 + p.x / 16.0, y = 40.5 + p.y / 16.0, r = 1.0 / 64;
            const Drawn drawn =
                draw(polygon(white, {{x - r, y - r}, {x + 2 * r, y - r}, {x - r, y + 2 * r}}), settings_of(samples));
            EXPECT_EQ(drawn.red(17, 40), 1.0f / float(samples));
            EXPECT_EQ(drawn.sum(), 1.0 / samples) << "and nowhere else";
            EXPECT_EQ(drawn.stats.pixels_covered, 1u);
            EXPECT_EQ(drawn.stats.samples_covered, 1u);
        }
}

TEST(Multisample, TrianglesOfOneColorHaveNoSeamAndPixelsAreShadedOnceForEachThatTheyShow) {
    const std::vector<dvec2> fan = {{0, 0}, {64, 0}, {64, 23}, {64, 64}, {41.25, 64}, {0, 64}};
    for (const int samples : {4, 8}) {
        const Drawn drawn = draw(polygon(color, fan), settings_of(samples));
        for (const vec4& c : drawn.frame.color) ASSERT_EQ(c, color);
    }
    const RenderStats stats = draw(polygon(color, {{0, 0}, {64, 0}, {64, 64}, {0, 64}}), settings_of(4)).stats;
    EXPECT_EQ(stats.pixels_covered, 64u * 64u);
    EXPECT_EQ(stats.samples_covered, 4u * 64u * 64u);
    EXPECT_EQ(stats.pixels_shaded, 64u * 64u + 64u) << "twice on the diagonal";
    EXPECT_EQ(stats.overdraw(), 1.0);
}

TEST(Multisample, APixelOfOneTriangleIsThatOfOneSampleToTheBit) {
    Scene scene;
    scene.materials = {matte({0.8f, 0.5f, 0.3f})};
    scene.materials[0].base_color_texture = add_texture(scene, picture(rgb_pixels(16, 16, [](int x, int y) {
                                                            return std::array<int, 3>{x * 16, y * 16, (x ^ y) * 16};
                                                        })));
    add_object(scene, square_mesh(0));
    scene.lights = {directional({0.3, -0.2, -1})};
    const Drawn one = draw(scene, settings_of(1)), four = draw(scene, settings_of(4));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (x != size - 1 - y) {
                ASSERT_EQ(one.at(x, y), four.at(x, y));
            }
    for (int y = 0; y < size; ++y)
        EXPECT_NEAR(one.red(size - 1 - y, y), four.red(size - 1 - y, y), 0.05) << "on the diagonal";
}

TEST(Multisample, WhatChangesEvenlyOverASurfaceIsThatOfThePixelsCenterWhateverEdgesPass) {
    for (const int samples : {4, 8}) {
        Scene scene =
            polygon(white, {{0, 0}, {23.25, 0}, {64, 0}, {64, 23}, {64, 64}, {41.25, 64}, {9.75, 64}, {0, 64}});
        std::vector<vec4> colors;
        for (const vec3& p : scene.meshes[0].positions)
            colors.push_back({(p.x + 1) / 2, (p.y + 1) / 2, (2 + p.x - p.y) / 4, 1});
        scene.meshes[0].colors = std::move(colors);
        const Drawn drawn = draw(scene, settings_of(samples));
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float across = (float(x) + 0.5f) / size, up = 1 - (float(y) + 0.5f) / size;
                EXPECT_NEAR(drawn.at(x, y).x, across, 1e-6f) << x << ", " << y;
                EXPECT_NEAR(drawn.at(x, y).y, up, 1e-6f) << x << ", " << y;
                EXPECT_NEAR(drawn.at(x, y).z, (1 + across - up) / 2, 1e-6f) << x << ", " << y;
            }
    }
}

TEST(Multisample, DataChannelsAreThoseOfThePixelsCenters) {
    constexpr std::uint32_t channels_of_centers =
        channel_depth | channel_normal | channel_object | channel_material | channel_overdraw | channel_triangle;
    RenderSettings settings = settings_of(1);
    settings.channels = channels_of_centers;
    Camera camera;
    camera.vertical_fov_rad = 1;
    camera.z_near = 0.5;
    camera.z_far = 50;
    camera.to_world = translation(dvec3{0.2, 0.1, 4});
    const Frame one = draw(busy_scene(), settings, camera).frame;
    for (const int samples : {4, 8}) {
        settings.samples = samples;
        const Frame more = draw(busy_scene(), settings, camera).frame;
        EXPECT_EQ(one.depth, more.depth);
        EXPECT_EQ(one.object, more.object);
        EXPECT_EQ(one.material, more.material);
        EXPECT_EQ(one.overdraw, more.overdraw);
        EXPECT_EQ(one.triangle, more.triangle);
        EXPECT_EQ(0, std::memcmp(one.normal.data(), more.normal.data(), one.normal.size() * sizeof(vec3)));
        EXPECT_FALSE(same_bits(one.color, more.color));
        settings.channels = 0;
        EXPECT_TRUE(same_bits(draw(busy_scene(), settings, camera).frame.color, more.color)) << "colors do not ask";
        settings.channels = channels_of_centers;
    }
}

TEST(Multisample, MasksAreAskedAtEachSample) {
    Scene scene;
    Sampler sharp;
    sharp.magnify = Filter::nearest;
    sharp.wrap_u = Wrap::clamp_to_edge;
    const std::uint32_t material = add_unlit(scene, white, AlphaMode::mask);
    scene.materials[material].opacity_texture =
        add_texture(scene,
                    picture(rgb_pixels(2, 1,
                                       [](int x, int) {
                                           return std::array<int, 3>{x * 255, x * 255, x * 255};
                                       })),
                    sharp);
    for (const int samples : {4, 8})
        for (const int shift : {-7, -2, 1, 5}) {
            Scene moved = scene;
            // The border between the texels lies `shift` + 1/2 sixteenths right of the center of column 32.
            add_object(moved, square_mesh(material, 2), translation(dvec3{(0.5 + (shift + 0.5) / 16) / 32, 0, 0}));
            const Drawn drawn = draw(moved, settings_of(samples));
            const double border = 32.5 + (shift + 0.5) / 16;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const int n = count(samples, x, y, [&](double px, double) { return px > border; });
                    ASSERT_EQ(drawn.red(x, y), float(n) / float(samples)) << x << ", " << y;
                }
        }
}

TEST(Multisample, BlendedSurfacesHaveNoSeamAndCoverByTheirSamplesTimesTheirAlpha) {
    const vec4 glass = {0.5f, 0.25f, 1, 0.5f};
    for (const int samples : {4, 8}) {
        const Drawn whole =
            draw(polygon(glass, {{0, 0}, {64, 0}, {64, 23}, {64, 64}, {41.25, 64}, {0, 64}}, AlphaMode::blend),
                 settings_of(samples));
        for (const vec4& c : whole.frame.color) ASSERT_EQ(c, (vec4{0.25f, 0.125f, 0.5f, 1}));

        const double border = 20.5 + 1.0 / 32;
        Scene scene = polygon(glass, {{0, 0}, {border, 0}, {border, 64}, {0, 64}}, AlphaMode::blend);
        add_polygon(scene, add_unlit(scene, white), {{0, 40}, {64, 40}, {64, 64}, {0, 64}},
                    0.5f);  // before it, below row 40
        add_polygon(scene, add_unlit(scene, white), {{0, 0}, {20.25, 0}, {20.25, 8}, {0, 8}}, -0.5f);  // behind it
        const Drawn part = draw(scene, settings_of(samples));
        const int n = count(samples, 20, 20, [&](double px, double) { return px < border; });
        EXPECT_EQ(part.at(20, 20).x, 0.25f * float(n) / float(samples));
        EXPECT_EQ(part.at(20, 50), white) << "hidden";
        const int both = count(samples, 20, 4, [&](double px, double) { return px < 20.25; });
        EXPECT_EQ(part.at(20, 4).x, (0.75f * float(both) + 0.25f * float(n - both)) / float(samples))
            << "each sample over its own ground";
    }
}

TEST(Multisample, TheBackgroundsAlphaIsAveragedAndItsColorWeighsByIt) {
    RenderSettings settings = settings_of(4);
    settings.background = {0.5f, 0.5f, 0.5f, 0};
    const Drawn drawn = draw(polygon(color, {{0, 0}, {20.5, 0}, {20.5, 64}, {0, 64}}), settings);
    EXPECT_EQ(drawn.at(20, 9), (vec4{color.x, color.y, color.z, 0.5f}));
    EXPECT_EQ(drawn.at(40, 9), settings.background);
}

TEST(Multisample, NumbersOfSamplesThatThereAreNotAreRefusedAndSoAreOtherWaysOfVisibility) {
    const Scene scene = polygon(white, {{0, 0}, {64, 0}, {64, 64}});
    for (const int samples : {-4, 0, 2, 3, 5, 16}) EXPECT_THROW(draw(scene, settings_of(samples)), Error) << samples;
    for (const Visibility method : {Visibility::z16, Visibility::painter, Visibility::none}) {
        RenderSettings settings = settings_of(4);
        settings.visibility = method;
        EXPECT_THROW(draw(scene, settings), Error);
    }
}
