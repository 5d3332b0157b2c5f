// SPDX-License-Identifier: Apache-2.0
// Blended surfaces that cross: the order of each pixel, and of each of its samples, against closed forms and a search
// through all triangles.
#include "engines/raster/shade/blended_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engines/raster/inspect/inspection.h"
#include "unit/raster/marks/marked_scene.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr vec4 white{1, 1, 1, 1}, red{1, 0, 0, 0.5f}, blue{0, 0, 1, 0.5f};

vec4 over(vec4 c, vec4 under) {
    const vec3 sum = c.xyz() * c.w + under.xyz() * (1 - c.w);
    return {sum.x, sum.y, sum.z, 1};
}

void expect_near(vec4 a, vec4 b, const std::string& what, float within = 1e-6f) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], within) << what << ", component " << c;
}

std::string name_of(std::size_t i, int samples) {
    return std::to_string(i % side) + ", " + std::to_string(i / side) + " of " + std::to_string(samples) + " samples";
}

/// A pane over all of the picture through x = at_x: nearer by `slope` per meter to the right.
void add_leaning(Scene& scene, vec4 color, float slope, float at_x = 0) {
    Mesh mesh = square_mesh(add_unlit(scene, color, AlphaMode::blend));
    const float left = (-2 - at_x) * slope, right = (2 - at_x) * slope;
    mesh.positions = std::vector<vec3>{{-2, -2, left}, {2, -2, right}, {2, 2, right}, {-2, 2, left}};
    add_object(scene, std::move(mesh));
}

/// Red is nearer to the right of x = at_x.
Scene crossing_panes(float at_x = 0, bool red_first = true) {
    Scene scene;
    if (red_first) add_leaning(scene, red, 0.5f, at_x);
    add_leaning(scene, blue, -0.5f, at_x);
    if (!red_first) add_leaning(scene, red, 0.5f, at_x);
    return scene;
}

RenderSettings on_white(int samples = 1) {
    RenderSettings s = settings();
    s.background = white;
    s.samples = samples;
    return s;
}

void add_box(Scene& scene, vec4 color, const dmat4& place) {
    const std::uint32_t material = add_unlit(scene, color, AlphaMode::blend);
    Mesh mesh;
    std::vector<vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.push_back({float(k & 1) - 0.5f, float(k >> 1 & 1) - 0.5f, float(k >> 2) - 0.5f});
    mesh.positions = std::move(corners);
    mesh.indices = std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                              2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    mesh.material = material;
    add_object(scene, std::move(mesh), place);
}

/// Two boxes of 50 %, one of which sticks in the other.
Scene two_boxes() {
    Scene scene;
    add_box(scene, red, compose({-0.15, 0.1, 0}, {0.2, 0.3, 0.1, 0.9}, {0.9, 0.9, 0.9}));
    add_box(scene, blue, compose({0.2, -0.05, 0.1}, {-0.3, 0.15, 0.4, 0.8}, {0.8, 1.0, 0.7}));
    return scene;
}

struct Met {
    double z;
    vec4 color;
    std::size_t triangle;
};

/// What a ray along -z through a place of flat_camera()'s picture meets, far to near, by looking at every triangle.
std::vector<Met> met_at(const Scene& scene, double px, double py) {
    const dvec2 p{px / 32 - 1, 1 - py / 32};
    std::vector<Met> met;
    std::size_t number = 0;
    for (std::size_t n = 0; n < scene.meshes.size(); ++n) {
        const Mesh& mesh = scene.meshes[n];
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t, ++number) {
            dvec3 v[3];
            for (std::size_t k = 0; k < 3; ++k)
                v[k] = transform_point(*scene.nodes[n].local.matrix,
                                       cast<double>(mesh.positions[mesh.indices[3 * t + k]]));
            const auto area = [](dvec2 a, dvec2 b, dvec2 c) {
                return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            };
            const dvec2 a{v[0].x, v[0].y}, b{v[1].x, v[1].y}, c{v[2].x, v[2].y};
            const double whole = area(a, b, c);
            const double w[3] = {area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole};
            if (!(w[0] >= 0 && w[1] >= 0 && w[2] >= 0)) continue;
            met.push_back(
                {w[0] * v[0].z + w[1] * v[1].z + w[2] * v[2].z, scene.materials[mesh.material].base_color, number});
        }
    }
    std::sort(met.begin(), met.end(), [](const Met& x, const Met& y) { return x.z < y.z; });
    return met;
}

bool is_same_order(const std::vector<Met>& a, const std::vector<Met>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Met& x, const Met& y) { return x.triangle == y.triangle; });
}

/// Close beside it are other surfaces or another order: rounding decides.
bool is_at_edge(const Scene& scene, const std::vector<Met>& here, double px, double py) {
    constexpr double step = 0.02;
    for (const dvec2 d : {dvec2{-step, -step}, {step, -step}, {-step, step}, {step, step}})
        if (!is_same_order(here, met_at(scene, px + d.x, py + d.y))) return true;
    return false;
}

/// Panes that all cross in x = at_x: to the left of it the first is the nearest, to the right the last.
Scene pencil(int count, float opacity = 0.1f, float at_x = 0) {
    Scene scene;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> part(0, 1);
    for (int i = 0; i < count; ++i)
        add_leaning(scene, {part(random), part(random), part(random), opacity}, 0.05f + 0.02f * float(i), at_x);
    return scene;
}

vec4 pencil_color(const Scene& scene, bool is_left) {
    vec4 sum = white;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        sum = over(scene.materials[is_left ? scene.materials.size() - 1 - i : i].base_color, sum);
    return sum;
}

std::vector<std::string> warnings(const Scene& scene, const RenderSettings& s) {
    Context context({.threads = 2});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(flat_camera(), s, frame, context);
    std::vector<std::string> texts;
    for (const ReportEntry& e : context.report().entries())
        if (e.remark == Remark::warning) texts.push_back(e.message);
    return texts;
}

void draw_within(const Scene& scene, std::uint64_t bytes, int samples = 1) {
    Context context({.threads = 1, .max_memory = bytes});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(flat_camera(), on_white(samples), frame, context);
}

}  // namespace

TEST(CrossingLayers, OfTwoPanesTheNearerOneLiesOnTopOnBothSidesOfTheirLine) {
    for (const int samples : {1, 4, 8})
        for (const bool red_first : {true, false}) {
            const Frame f = draw(crossing_panes(0, red_first), flat_camera(), on_white(samples));
            for (std::size_t i = 0; i < f.color.size(); ++i)
                expect_near(f.color[i], i % side < 32 ? over(blue, over(red, white)) : over(red, over(blue, white)),
                            name_of(i, samples));
        }
}

TEST(CrossingLayers, SamplesOnEitherSideOfTheLineHaveTheirOwnOrder) {
    constexpr double line = 20.3;  // [px]
    for (const int samples : {4, 8}) {
        const Frame f = draw(crossing_panes(at(line)), flat_camera(), on_white(samples));
        vec4 mean{0, 0, 0, 1};
        for (const shading::SamplePosition p : shading::sample_positions(samples)) {
            const vec4 c = 20.5 + p.x / 16.0 < line ? over(blue, over(red, white)) : over(red, over(blue, white));
            for (std::size_t k = 0; k < 3; ++k) mean[k] += c[k] / float(samples);
        }
        for (int y = 0; y < side; ++y) expect_near(pixel(f, 20, y), mean, std::to_string(y));
    }
}

TEST(CrossingLayers, OfTwoBoxesThatCrossAreThoseOfASearchThroughAllTriangles) {
    const Scene scene = two_boxes();
    for (const Visibility method : {Visibility::z_reversed, Visibility::z24, Visibility::z_float}) {
        RenderSettings s = on_white();
        s.visibility = method;
        const Frame f = draw(scene, flat_camera(), s);
        std::size_t judged = 0, deep = 0;
        for (std::size_t i = 0; i < f.color.size(); ++i) {
            const double px = double(i % side) + 0.5, py = double(i / side) + 0.5;
            const std::vector<Met> met = met_at(scene, px, py);
            if (is_at_edge(scene, met, px, py)) continue;
            vec4 sum = white;
            for (const Met& m : met) sum = over(m.color, sum);
            expect_near(f.color[i], sum, name_of(i, 1), 1e-5f);
            ++judged;
            deep += met.size() >= 4;
        }
        EXPECT_GT(judged, 3600u);
        EXPECT_GT(deep, 500u);
    }
}

TEST(CrossingLayers, MethodsWithoutDepthKeepTheOrderOfTriangles) {
    for (const Visibility method : {Visibility::painter, Visibility::none, Visibility::back_face}) {
        RenderSettings s = on_white();
        s.visibility = method;
        for (const bool red_first : {true, false}) {
            const Frame f = draw(crossing_panes(0, red_first), flat_camera(), s);
            const vec4 red_on_top = over(red, over(blue, white)), blue_on_top = over(blue, over(red, white));
            for (std::size_t i = 0; i < f.color.size(); i += 7) {
                if (i % side + i / side == side - 1) continue;  // on the diagonal
                // Painter's: of the lower right triangles red has the nearer mean, of the upper left ones blue.
                const bool is_red = method == Visibility::painter ? i % side + i / side >= side : !red_first;
                expect_near(f.color[i], is_red ? red_on_top : blue_on_top, name_of(i, 1));
            }
        }
    }
}

TEST(CrossingLayers, InOnePlaneKeepTheOrderOfTheSceneHoweverTheyAreCutIntoTriangles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> part(-1, 1);
    const auto on_plane = [](float x, float y) { return vec3{x, y, 0.4f * x - 0.3f * y}; };
    for (const bool whole_first : {true, false})
        for (const int samples : {1, 4}) {
            Scene scene;
            const auto add_whole = [&] {
                Mesh mesh = square_mesh(add_unlit(scene, red, AlphaMode::blend));
                mesh.positions = std::vector<vec3>{on_plane(-3, -3), on_plane(3, -3), on_plane(3, 3), on_plane(-3, 3)};
                add_object(scene, std::move(mesh));
            };
            if (whole_first) add_whole();
            for (int n = 0; n < 30; ++n) {
                Mesh mesh;
                mesh.material = add_unlit(scene, blue, AlphaMode::blend);
                mesh.positions =
                    std::vector<vec3>{on_plane(part(random), part(random)), on_plane(part(random), part(random)),
                                      on_plane(part(random), part(random))};
                mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
                add_object(scene, std::move(mesh));
            }
            if (!whole_first) add_whole();
            const Frame f = draw(scene, eye(), on_white(samples));
            std::size_t covered = 0;
            for (const vec4& c : f.color) {
                if (whole_first)
                    EXPECT_NEAR(c.x, 2 * c.y, 1e-6f);  // 1 and 1 / 2, then both halved by each blue one
                else
                    EXPECT_NEAR(c.z, 0.5f, 1e-6f);  // 1, then red
                covered += c.y < 0.26f;
            }
            EXPECT_GT(covered, 1000u);
        }
}

TEST(CrossingLayers, HaveTheSameBitsForAnyThreadsWindowsAndInstructionSets) {
    Scene scene = two_boxes();
    std::mt19937 random(9);
    std::uniform_real_distribution<float> part(-1, 1);
    const auto anywhere = [&] { return vec3{part(random), part(random), part(random)}; };
    for (int n = 0; n < 25; ++n) {
        Mesh mesh = square_mesh(add_unlit(scene, {0.2f, 0.6f, 0.1f, 0.3f}, AlphaMode::blend));
        mesh.positions = std::vector<vec3>{anywhere(), anywhere(), anywhere(), anywhere()};
        add_object(scene, std::move(mesh));
    }
    RenderSettings s = settings();
    s.width = 150, s.height = 140;
    for (const Scene& of : {scene, pencil(70)})
        for (const int samples : {1, 4, 8})
            for (const bool edges : {false, true}) {
                s.samples = samples;
                s.edges = edges;
                s.line_width = 1.5f;
                expect_same_bits_everywhere(of, s);
            }
}

TEST(CrossingLayers, AreExplainedAsTheyAreDrawn) {
    for (const Scene& scene : {two_boxes(), crossing_panes(at(20.3))})
        for (const int samples : {1, 4, 8}) {
            const RenderSettings s = on_white(samples);
            const Frame f = draw(scene, flat_camera(), s);
            Context context({.threads = 1});
            const raster::Inspection inspection(scene, flat_camera(), s, context);
            for (int y = 1; y < side; y += 4)
                for (int x = 0; x < side; x += x == 20 ? 1 : 4) {
                    const raster::PixelExplanation e = inspection.explain(x, y, context);
                    ASSERT_EQ(e.sum, pixel(f, x, y)) << x << ", " << y;
                    ASSERT_EQ(e.color, pixel(f, x, y)) << x << ", " << y;
                }
        }
}

TEST(CrossingLayers, AsManyAsMayWaitAndOneAreInOrder) {
    const Scene scene = pencil(int(raster::BlendedLayers::most_waiting) + 1);
    EXPECT_TRUE(warnings(scene, on_white()).empty());
    for (const int samples : {1, 4}) {
        const Frame f = draw(scene, flat_camera(), on_white(samples));
        for (int x = 0; x < side; ++x)
            if (x < 31 || x > 32)  // beside the line: equal depths
                expect_near(pixel(f, x, 40), pencil_color(scene, x < 32), std::to_string(x), 1e-5f);
    }
}

TEST(CrossingLayers, OfMoreThanMayWaitNoneIsLostAndTheReportSaysIt) {
    constexpr int line = 20;  // in the right part of a quarter of the tile, whose middle is to its left
    const Scene scene = pencil(70, 0.05f, at(line));
    const std::vector<std::string> texts = warnings(scene, on_white());
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_NE(texts[0].find("more than 32"), std::string::npos) << texts[0];
    for (const int samples : {1, 4}) {
        RenderSettings s = settings();
        s.background = {0, 0, 0, 0};
        s.samples = samples;
        const Frame f = draw(scene, flat_camera(), s);
        for (int x = 0; x < side; ++x)
            EXPECT_NEAR(pixel(f, x, 20).w, 1 - std::pow(0.95, 70), 1e-5) << x;  // in any order
        s.background = white;
        const Frame g = draw(scene, flat_camera(), s);
        for (int x = 0; x < side; ++x) {
            if (std::abs(x - line) < 2) continue;  // equal depths
            const bool is_unsorted = x > line && x < side / 2;
            expect_near(pixel(g, x, 20), pencil_color(scene, x < line), std::to_string(x), is_unsorted ? 0.25f : 1e-5f);
        }
    }
}

TEST(CrossingLayers, WhatWaitsCountsAsMemoryOfThePicture) {
    EXPECT_NO_THROW(draw_within(pencil(33), std::uint64_t(64) << 20));
    EXPECT_THROW(draw_within(pencil(33), std::uint64_t(2) << 20), Error);
}

TEST(CrossingLayers, LeaningPanesOneBehindAnotherDoNotWait) {
    Scene scene;
    for (int i = 0; i < 33; ++i) add_leaning(scene, {1, 0, 0, 0.1f}, 0.5f, 0.05f * float(i));
    for (const int samples : {1, 4}) EXPECT_NO_THROW(draw_within(scene, std::uint64_t(2) << 20, samples)) << samples;
}
