// SPDX-License-Identifier: Apache-2.0
// What bake_maps() refuses.
#include <rakelight/bake/bake.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/thrown_error.h"
#include "unit/bake/bake_scenes.h"

namespace rakelight {
namespace {

using namespace test;

Error refused(const BakeOptions& options, const Scene& high = scene_of(square_mesh()),
              const Scene& low = scene_of(square_mesh()), std::uint64_t memory = 0) {
    Context context({.threads = 1, .max_memory = memory});
    return error_of([&] { (void)bake_maps(high, low, options, context); });
}

TEST(BakeMaps, OptionsOutOfTheirRangeAreRefused) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::pair<const char*, void (*)(BakeOptions&)> wrong[] = {
        {"maps", [](BakeOptions& o) { o.maps.clear(); }},
        {"maps",
         [](BakeOptions& o) {
             o.maps = {BakeMap::height, BakeMap::height};
         }},
        {"maps", [](BakeOptions& o) { o.maps = {BakeMap(9)}; }},
        {"size", [](BakeOptions& o) { o.width = 0; }},
        {"size", [](BakeOptions& o) { o.height = 16385; }},
        {"distance", [](BakeOptions& o) { o.distance = -1; }},
        {"samples", [](BakeOptions& o) { o.samples = 2; }},
        {"padding", [](BakeOptions& o) { o.padding = -1; }},
        {"chart-margin", [](BakeOptions& o) { o.chart_margin = 0; }},
        {"rays", [](BakeOptions& o) { o.rays = 0; }},
        {"crease-angle", [](BakeOptions& o) { o.crease_angle_rad = 4; }},
        {"high-normals", [](BakeOptions& o) { o.high_normals = NormalSource::seams; }},
        {"normals", [](BakeOptions& o) { o.low_normals = NormalSource::flat; }},
    };
    for (const auto& [setting, change] : wrong) {
        BakeOptions options;
        change(options);
        const Error error = refused(options);
        EXPECT_EQ(error.code(), ErrorCode::usage) << setting;
        EXPECT_EQ(error.setting(), setting);
    }
    BakeOptions options;
    options.occlusion_distance = infinite;
    EXPECT_EQ(refused(options).setting(), "occlusion-distance");
}

TEST(BakeMaps, ABuildWithoutRaysSaysSo) {
    if (can_bake()) GTEST_SKIP() << "this build follows rays";
    EXPECT_EQ(refused({}).code(), ErrorCode::failed);
}

class BakeMapsOfScenes : public testing::Test {
protected:
    void SetUp() override {
        if (!can_bake()) GTEST_SKIP() << "this build follows no rays";
    }
};

TEST_F(BakeMapsOfScenes, ScenesWithoutTrianglesAreRefused) {
    EXPECT_EQ(refused({}, scene_of(square_mesh()), Scene{}).code(), ErrorCode::bad_file);
    EXPECT_EQ(refused({}, Scene{}).code(), ErrorCode::bad_file);
}

TEST_F(BakeMapsOfScenes, ModelsAtDifferentPlacesAreRefused) {
    BakeOptions options;
    options.width = options.height = 32;
    const Error error = refused(options, scene_of(square_mesh(), translation(dvec3{100, 0, 0})));
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(error.reason().find("no ray"), std::string::npos);
}

TEST_F(BakeMapsOfScenes, MapsTooSmallForTheirChartsAreRefused) {
    Mesh sphere = plain_sphere(8, 16);
    sphere.texcoords.clear();
    BakeOptions options;
    options.width = options.height = 16;
    const Error error = refused(options, scene_of(sphere), scene_of(sphere));
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_EQ(error.setting(), "size");
}

TEST_F(BakeMapsOfScenes, MemoryIsAskedForBeforeItIsTaken) {
    BakeOptions options;
    options.width = options.height = 16384;
    const Error error = refused(options, scene_of(square_mesh()), scene_of(square_mesh()), std::uint64_t(64) << 20);
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(error.reason().find("baked maps"), std::string::npos);
}

TEST_F(BakeMapsOfScenes, CoordinatesThatAreNoNumbersBakeWhatIsLeft) {
    Mesh odd = square_mesh();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    odd.texcoords[0] = std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {nan, 1e30f}};
    Context context({.threads = 1});
    BakeOptions options;
    options.width = options.height = 8;
    const BakeResult result = bake_maps(scene_of(square_mesh()), scene_of(odd), options, context);
    for (const float v : result.maps[0].values) EXPECT_TRUE(v >= -1 && v <= 1);
}

}  // namespace
}  // namespace rakelight
