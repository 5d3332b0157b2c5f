// SPDX-License-Identifier: Apache-2.0
#include "bake/low/texel_owners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "unit/bake/bake_scenes.h"

namespace rakelight::bake {
namespace {

using namespace test;

struct Baked {
    explicit Baked(const Scene& scene, int width, int height, int samples)
        : low(scene, 0, context),
          charts(find_map_charts(low, context)),
          owners(low, charts, width, height, samples, context) {}
    Context context{{.threads = 1}};
    LowSurface low;
    MapCharts charts;
    TexelOwners owners;
    OwnerBand band(int number) const { return owners.band(number, context); }
};

Scene square_at(std::vector<vec2> uv) {
    Mesh mesh = square_mesh();
    mesh.texcoords[0] = std::move(uv);
    return scene_of(std::move(mesh));
}

TEST(TexelOwners, ASquareOfTwoTrianglesCoversEachSampleOnce) {
    for (const int samples : {1, 4, 16}) {
        Baked baked(square_at({{0, 1}, {1, 1}, {1, 0}, {0, 0}}), 20, 33, samples);
        int rows = 0;
        for (int b = 0; b < baked.owners.bands(); ++b) {
            const OwnerBand band = baked.band(b);
            EXPECT_EQ(band.first_row, rows);
            rows += band.rows;
            for (const std::uint32_t owner : band.owner) EXPECT_LT(owner, 2u);
        }
        EXPECT_EQ(baked.owners.overlaps(baked.context).texels, 0u);
        EXPECT_EQ(rows, 33);
        EXPECT_EQ(baked.charts.is_mirrored, std::vector<std::uint8_t>{0});
    }
}

TEST(TexelOwners, WeightsGiveThePlaceOfTheSample) {
    Baked baked(square_at({{0.1f, 0.8f}, {0.7f, 0.9f}, {0.9f, 0.2f}, {0.2f, 0.1f}}), 16, 16, 4);
    const OwnerBand band = baked.band(0);
    int covered = 0;
    for (int i = 0; i < 16 * 16 * 4; ++i) {
        const std::uint32_t owner = band.owner[std::size_t(i)];
        if (owner == no_index) continue;
        ++covered;
        const dvec2 at = baked.owners.sample_at(i / 4 % 16, i / 64, i % 4);
        const CornerWeights w = baked.owners.weights(owner, at);
        const MapTriangle t = on_map(baked.low, owner, 16, 16);
        const dvec2 back = t.at[0] * w[0] + t.at[1] * w[1] + t.at[2] * w[2];
        EXPECT_NEAR(back.x, at.x, 1e-9);
        EXPECT_NEAR(back.y, at.y, 1e-9);
        EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
    }
    EXPECT_NEAR(covered / 1024.0, 0.47, 0.01);  // the area
}

TEST(TexelOwners, TexelsThatAreTouchedButNotCoveredKnowTheirTriangle) {
    Baked baked(square_at({{0.51f, 0.99f}, {0.515f, 0.99f}, {0.515f, 0.01f}, {0.51f, 0.01f}}), 16, 16, 1);
    const OwnerBand band = baked.band(0);
    for (const std::uint32_t owner : band.owner) EXPECT_EQ(owner, no_index);
    for (int y = 0; y < 16; ++y) EXPECT_NE(band.nearest[std::size_t(16 * y + 8)], no_index) << y;
    EXPECT_EQ(band.nearest[16 * 5 + 11], no_index);
}

TEST(TexelOwners, MapsRepeat) {
    Baked beyond(square_at({{2.25f, -0.25f}, {3.25f, -0.25f}, {3.25f, -1.25f}, {2.25f, -1.25f}}), 16, 16, 4);
    const OwnerBand band = beyond.band(0);
    for (const std::uint32_t owner : band.owner) EXPECT_LT(owner, 2u);
    EXPECT_EQ(beyond.owners.overlaps(beyond.context).texels, 0u);
}

TEST(TexelOwners, ChartsOverOneAnotherAreCounted) {
    Scene scene = square_at({{0, 1}, {0.5f, 1}, {0.5f, 0}, {0, 0}});
    Mesh other = square_mesh();
    other.texcoords[0] = std::vector<vec2>{{0.75f, 1}, {0.25f, 1}, {0.25f, 0}, {0.75f, 0}};
    add_object(scene, std::move(other), translation(dvec3{3, 0, 0}));
    Baked baked(scene, 16, 16, 4);
    const Overlaps overlaps = baked.owners.overlaps(baked.context);
    EXPECT_EQ(baked.charts.is_mirrored, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(overlaps.texels, 4u * 16u);
    EXPECT_EQ(overlaps.charts, 1u);
}

TEST(TexelOwners, AMirroredPlacementOfAMirroredChartIsNotMirrored) {
    Scene scene = square_at({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
    scene.nodes[0].local.matrix = scaling(dvec3{-1, 1, 1});
    EXPECT_EQ(Baked(scene, 16, 16, 1).charts.is_mirrored, std::vector<std::uint8_t>{0});
}

/// One triangle for each three texture coordinates, all side by side in space.
Scene triangles_at(const std::vector<vec2>& uv) {
    Mesh mesh;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < uv.size(); ++i) {
        positions.push_back({float(i / 3) + (i % 3 == 1 ? 0.5f : 0.0f), i % 3 == 2 ? 0.5f : 0.0f, 0});
        indices.push_back(i);
    }
    mesh.positions = std::move(positions), mesh.indices = std::move(indices);
    mesh.texcoords.emplace_back(std::vector<vec2>(uv));
    return scene_of(std::move(mesh));
}

/// The same by asking each sample about each triangle.
struct Asked {
    std::vector<std::uint32_t> owner, nearest;
    std::vector<bool> texels, charts;  ///< with overlaps
};

Asked ask_all(const Baked& baked, int size, int samples) {
    const std::size_t texels = std::size_t(size) * std::size_t(size);
    Asked out{.owner = std::vector<std::uint32_t>(texels * std::size_t(samples), no_index),
              .nearest = std::vector<std::uint32_t>(texels, no_index),
              .texels = std::vector<bool>(texels),
              .charts = std::vector<bool>(baked.charts.is_mirrored.size())};
    std::vector<double> distance(texels, 1.0);
    const auto each = [&](const auto& visit) {
        for (const std::uint8_t mirrored : {0, 1})
            for (std::uint32_t t = 0; t < baked.low.triangle_count(); ++t)
                for (int k = 0; k < 4 && baked.charts.is_mirrored[baked.charts.of_triangle[t]] == mirrored; ++k) {
                    MapTriangle at = on_map(baked.low, t, size, size);
                    for (dvec2& p : at.at) p = p - dvec2{k / 2 * double(size), k % 2 * double(size)};
                    for (std::size_t i = 0; i < texels; ++i) visit(t, at.at, i);
                }
    };
    each([&](std::uint32_t t, const dvec2(&at)[3], std::size_t i) {
        const double area = signed_area(at);
        for (int s = 0; s < samples && area != 0; ++s) {
            const dvec2 p = baked.owners.sample_at(int(i) % size, int(i) / size, s);
            if (!is_covered(at, area > 0 ? 1 : -1, p)) continue;
            std::uint32_t& owner = out.owner[i * std::size_t(samples) + std::size_t(s)];
            if (owner != no_index) out.texels[i] = out.charts[baked.charts.of_triangle[t]] = true;
            if (owner == no_index) owner = t;
        }
    });
    each([&](std::uint32_t t, const dvec2(&at)[3], std::size_t i) {
        const auto own = out.owner.begin() + std::ptrdiff_t(i) * samples;
        if (std::count(own, own + samples, no_index) < samples) return;
        const dvec2 middle{double(int(i) % size) + 0.5, double(int(i) / size) + 0.5},
            off = blend(at, weights_at(at, middle)) - middle;
        if (dot(off, off) < distance[i]) distance[i] = dot(off, off), out.nearest[i] = t;
    });
    return out;
}

TEST(TexelOwners, AreThoseOfAskingEachSampleAboutEachTriangle) {
    constexpr int size = 40;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> wide(-0.4f, 1.4f), narrow(-0.03f, 0.03f);
    for (const int samples : {1, 4, 16}) {
        std::vector<vec2> uv;
        for (int t = 0; t < 30; ++t) {  // large ones, small ones, long thin ones
            const vec2 at{wide(random), wide(random)}, other{wide(random), wide(random)};
            uv.push_back(at);
            uv.push_back(t % 3 == 1 ? at + vec2{narrow(random), narrow(random)} : other);
            uv.push_back(t % 10 == 0 ? vec2{wide(random), wide(random)} : at + vec2{narrow(random), narrow(random)});
        }
        uv.insert(uv.end(), {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.75f}});  // edges through samples
        Baked baked(triangles_at(uv), size, size, samples);
        const Asked asked = ask_all(baked, size, samples);
        std::vector<std::uint32_t> owner, nearest;
        for (int b = 0; b < baked.owners.bands(); ++b) {
            const OwnerBand band = baked.band(b);
            owner.insert(owner.end(), band.owner.begin(), band.owner.end());
            nearest.insert(nearest.end(), band.nearest.begin(), band.nearest.end());
        }
        EXPECT_EQ(owner, asked.owner) << samples;
        EXPECT_EQ(nearest, asked.nearest) << samples;
        const Overlaps overlaps = baked.owners.overlaps(baked.context);
        EXPECT_EQ(overlaps.texels, std::uint64_t(std::ranges::count(asked.texels, true)));
        EXPECT_EQ(overlaps.charts, std::uint32_t(std::ranges::count(asked.charts, true)));
        EXPECT_GT(std::ranges::count(owner, no_index), samples * 4);  // and some have only a near one
        EXPECT_GT(std::ranges::count_if(nearest, [](std::uint32_t n) { return n != no_index; }), 4);
    }
}

std::uint64_t tests_of(Baked& baked) {
    std::uint64_t tests = baked.owners.overlaps(baked.context).tests;
    for (int b = 0; b < baked.owners.bands(); ++b) tests += baked.band(b).tests;
    return tests;
}

/// `count` times the same triangle, and the tests of its samples.
std::uint64_t tests_of_pile(std::size_t count, std::array<vec2, 3> triangle) {
    std::vector<vec2> uv;
    for (std::size_t i = 0; i < count; ++i) uv.insert(uv.end(), triangle.begin(), triangle.end());
    Baked baked(triangles_at(uv), 64, 64, 4);
    return tests_of(baked);
}

TEST(TexelOwners, TrianglesOverTrianglesCostAboutTheirRowsNotTheirSamples) {
    constexpr std::size_t count = 2000;
    constexpr std::uint64_t samples = 64 * 64 * 4, rows = 128;
    // the whole map, so that all is decided after two; half of it, with a border whose texels stay free; a thin one
    for (const std::array<vec2, 3>& triangle : {std::array<vec2, 3>{{{-1, -1}, {3, -1}, {-1, 3}}},
                                                {{{0, 0}, {1, 0}, {0, 1}}},
                                                {{{0.1f, 0}, {0.9f, 1}, {0.9001f, 1}}}})
        EXPECT_LT(tests_of_pile(count, triangle), 8 * samples + 32 * rows * count);
}

TEST(TexelOwners, AreCancelledWithinABand) {
    Baked baked(triangles_at(std::vector<vec2>(3 * 20000, vec2{0.5f, 0.5f})), 16, 16, 1);
    baked.context.cancel();
    EXPECT_THROW(baked.band(0), Error);
    EXPECT_THROW((void)baked.owners.overlaps(baked.context), Error);
}

}  // namespace
}  // namespace rakelight::bake
