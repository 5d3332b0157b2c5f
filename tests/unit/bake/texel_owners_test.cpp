// SPDX-License-Identifier: Apache-2.0
#include "bake/texel_owners.h"

#include <gtest/gtest.h>

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
};

Scene square_at(std::vector<vec2> uv) {
    Mesh mesh = square_mesh();
    mesh.texcoords[0] = std::move(uv);
    return scene_of(std::move(mesh));
}

TEST(TexelOwners, ASquareOfTwoTrianglesCoversEachSampleOnce) {
    for (const int samples : {1, 4, 16}) {
        const Baked baked(square_at({{0, 1}, {1, 1}, {1, 0}, {0, 0}}), 20, 33, samples);
        int rows = 0;
        for (int b = 0; b < baked.owners.bands(); ++b) {
            const OwnerBand band = baked.owners.band(b);
            EXPECT_EQ(band.first_row, rows);
            rows += band.rows;
            EXPECT_EQ(band.overlapping_texels, 0u);
            for (const std::uint32_t owner : band.owner) EXPECT_LT(owner, 2u);
        }
        EXPECT_EQ(rows, 33);
        EXPECT_EQ(baked.charts.is_mirrored, std::vector<std::uint8_t>{0});
    }
}

TEST(TexelOwners, WeightsGiveThePlaceOfTheSample) {
    const Baked baked(square_at({{0.1f, 0.8f}, {0.7f, 0.9f}, {0.9f, 0.2f}, {0.2f, 0.1f}}), 16, 16, 4);
    const OwnerBand band = baked.owners.band(0);
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
    const Baked baked(square_at({{0.51f, 0.99f}, {0.515f, 0.99f}, {0.515f, 0.01f}, {0.51f, 0.01f}}), 16, 16, 1);
    const OwnerBand band = baked.owners.band(0);
    for (const std::uint32_t owner : band.owner) EXPECT_EQ(owner, no_index);
    for (int y = 0; y < 16; ++y) EXPECT_NE(band.nearest[std::size_t(16 * y + 8)], no_index) << y;
    EXPECT_EQ(band.nearest[16 * 5 + 11], no_index);
}

TEST(TexelOwners, MapsRepeat) {
    const Baked beyond(square_at({{2.25f, -0.25f}, {3.25f, -0.25f}, {3.25f, -1.25f}, {2.25f, -1.25f}}), 16, 16, 4);
    const OwnerBand band = beyond.owners.band(0);
    for (const std::uint32_t owner : band.owner) EXPECT_LT(owner, 2u);
    EXPECT_EQ(band.overlapping_texels, 0u);
}

TEST(TexelOwners, ChartsOverOneAnotherAreCounted) {
    Scene scene = square_at({{0, 1}, {0.5f, 1}, {0.5f, 0}, {0, 0}});
    Mesh other = square_mesh();
    other.texcoords[0] = std::vector<vec2>{{0.75f, 1}, {0.25f, 1}, {0.25f, 0}, {0.75f, 0}};
    add_object(scene, std::move(other), translation(dvec3{3, 0, 0}));
    const Baked baked(scene, 16, 16, 4);
    const OwnerBand band = baked.owners.band(0);
    EXPECT_EQ(baked.charts.is_mirrored, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(band.overlapping_texels, 4u * 16u);
    EXPECT_EQ(band.overlapping_charts, std::vector<std::uint32_t>{1});
}

TEST(TexelOwners, AMirroredPlacementOfAMirroredChartIsNotMirrored) {
    Scene scene = square_at({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
    scene.nodes[0].local.matrix = scaling(dvec3{-1, 1, 1});
    EXPECT_EQ(Baked(scene, 16, 16, 1).charts.is_mirrored, std::vector<std::uint8_t>{0});
}

}  // namespace
}  // namespace rakelight::bake
