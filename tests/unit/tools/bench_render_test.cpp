// SPDX-License-Identifier: Apache-2.0
// The scene that pictures are measured with is what its documentation says, and what is measured is reported. No time
// is judged.
#include <gtest/gtest.h>
#include <rakelight/scene/validate.h>
#include <rakelight_internal/tools/bench_render.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include <rakelight/render/picture.h>

#include "math/linear.h"
#include "scene/placement.h"
#include "support/temporary_folder.h"
#include "tools/bench/bench_scene.h"
#include "tools/bench/bench_shapes.h"
#include "tools/bench/bench_textures.h"

namespace rakelight::test {
namespace {

constexpr BenchShape shapes[] = {BenchShape::sphere, BenchShape::knot, BenchShape::torus};

TEST(BenchShape, HasAboutTheTrianglesAskedForAndNoneIsDegenerate) {
    for (const BenchShape shape : shapes)
        for (const std::uint64_t triangles : {20ull, 100ull, 1000ull, 10'000ull}) {
            const Mesh mesh = make_bench_shape(shape, triangles, 0.5, Context());
            EXPECT_NEAR(double(mesh.triangle_count()), double(triangles), 0.1 * double(triangles) + 12);
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                           c = mesh.positions[mesh.indices[i + 2]];
                EXPECT_GT(length(cross(b - a, c - a)), 0) << "triangle " << i / 3;
            }
        }
}

TEST(BenchShape, NormalsPointToTheSideThatTrianglesAreCounterClockwiseSeenFrom) {
    for (const BenchShape shape : shapes) {
        const Mesh mesh = make_bench_shape(shape, 4000, 0.5, Context());
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t* const v = &mesh.indices[i];
            const vec3 a = mesh.positions[v[0]],
                       face = normalize_or(cross(mesh.positions[v[1]] - a, mesh.positions[v[2]] - a), vec3{});
            EXPECT_GT(dot(face, mesh.normals[v[0]]), 0.5f) << "shape " << int(shape) << ", triangle " << i / 3;
        }
    }
}

TEST(BenchShape, TangentsAreUnitAndPerpendicularAndFollowTheTexture) {
    for (const BenchShape shape : shapes) {
        const Mesh mesh = make_bench_shape(shape, 4000, 0.5, Context());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const vec3 t = mesh.tangents[v].xyz();
            EXPECT_NEAR(length(t), 1, 1e-5);
            EXPECT_NEAR(length(mesh.normals[v]), 1, 1e-5);
            EXPECT_NEAR(dot(t, mesh.normals[v]), 0, 1e-5);
        }
        for (std::size_t i = 0; i < mesh.indices.size();
             i += 3) {  // the upper triangles: corner 2 is one step of u from corner 0
            const std::uint32_t* const v = &mesh.indices[i];
            const vec2 a = mesh.texcoords[0][v[0]], b = mesh.texcoords[0][v[1]], c = mesh.texcoords[0][v[2]];
            const vec3 to_b = mesh.positions[v[1]] - mesh.positions[v[0]],
                       to_c = mesh.positions[v[2]] - mesh.positions[v[0]];
            const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            ASSERT_NE(area, 0);
            const vec3 along_u = (to_b * (c.y - a.y) - to_c * (b.y - a.y)) / area,
                       along_v = (to_c * (b.x - a.x) - to_b * (c.x - a.x)) / area;
            EXPECT_GT(dot(along_u, mesh.tangents[v[0]].xyz()), 0);
            const vec3 up = cross(mesh.normals[v[0]], mesh.tangents[v[0]].xyz()) * mesh.tangents[v[0]].w;
            EXPECT_LT(dot(up, along_v), 0) << "green is up, v is down";
        }
    }
}

TEST(BenchTextures, RepeatAndHoldUnitNormalsThatPointOut) {
    const BenchTextures made = make_bench_textures();
    EXPECT_EQ(made.color.width, 1024);
    std::set<int> colors;
    for (int y = 0; y < 1024; y += 3)
        for (int x = 0; x < 1024; x += 3) {
            const auto* n = reinterpret_cast<const std::uint8_t*>(made.normal.row(y)) + 3 * x;
            const double nx = n[0] / 127.5 - 1, ny = n[1] / 127.5 - 1, nz = n[2] / 127.5 - 1;
            EXPECT_NEAR(nx * nx + ny * ny + nz * nz, 1, 0.03);
            EXPECT_GT(nz, 0);
            colors.insert(int(made.color.row(y)[3 * x]));
        }
    EXPECT_GT(colors.size(), 50u);
}

TEST(BenchScene, IsValidAndHasWhatWasAskedFor) {
    Context context({.threads = 2});
    const Scene scene = make_bench_scene(20'000, 100, 8, context);
    EXPECT_NO_THROW(validate(scene));
    EXPECT_NEAR(double(triangle_count(scene)), 20'000, 400);
    EXPECT_EQ(scene.nodes.size(), 100u);
    EXPECT_EQ(scene.lights.size(), 8u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    for (const Material& m : scene.materials) {
        EXPECT_EQ(m.model, MaterialModel::classical);
        EXPECT_EQ(m.classical.shininess, 48);
    }
}

TEST(BenchScene, IsTheSameForAnyNumberOfThreads) {
    Context one({.threads = 1}), four({.threads = 4});
    const Scene a = make_bench_scene(5000, 30, 1, one), b = make_bench_scene(5000, 30, 1, four);
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_TRUE(std::ranges::equal(a.meshes[i].positions, b.meshes[i].positions));
        EXPECT_TRUE(std::ranges::equal(a.meshes[i].indices, b.meshes[i].indices));
    }
}

RenderBenchOptions small() {
    RenderBenchOptions options;
    options.triangles = 5000;
    options.frames = 3;
    options.settings.width = 320;
    options.settings.height = 180;
    return options;
}

TEST(BenchRender, CountsOneThingInTheSingular) {
    RenderBenchReport report;
    report.objects = 2;
    report.lights = report.frames = 1;
    EXPECT_NE(to_text(report).find("2 objects, 1 light, "), std::string::npos);
    EXPECT_NE(to_text(report).find(", 1 frame\n"), std::string::npos);
}

TEST(BenchRender, ReportsARowForEachEngineWithTimesAndStages) {
    Context context({.threads = 2});
    RenderBenchOptions options = small();
    options.engines = {"soft", "soft"};
    options.triangles = 30'000;  // coarser ones cover less
    const auto json = nlohmann::json::parse(to_json(bench_render(options, context)));
    EXPECT_EQ(json["schema"], "rakelight.bench/1");
    EXPECT_EQ(json["objects"], 100);
    EXPECT_EQ(json["lights"], 2);
    ASSERT_EQ(json["rows"].size(), 2u);
    for (const auto& row : json["rows"]) {
        EXPECT_EQ(row["engine"], "soft");
        EXPECT_LE(row["fastest_ms"].get<double>(), row["median_ms"].get<double>());
        EXPECT_LE(row["median_ms"].get<double>(), row["slowest_ms"].get<double>());
        for (const char* stage : {"front_end", "tiles", "visibility", "shading", "delivery"})
            EXPECT_GT(row["stages_ms"][stage].get<double>(), 0) << stage;
        const auto& stats = row["stats"];
        EXPECT_EQ(stats["triangles_in"], json["triangles"]);
        const double share = stats["pixels_covered"].get<double>() / (320 * 180);
        EXPECT_GT(share, 0.55);
        EXPECT_LT(share, 0.65);
        EXPECT_EQ(stats["lighting_evaluations"], stats["pixels_shaded"]);
        EXPECT_GE(stats["overdraw"].get<double>(), 1.0);
        EXPECT_GT(stats["culled_back"].get<double>(), 0.35 * json["triangles"].get<double>());
    }
    EXPECT_EQ(json["rows"][0]["stats"], json["rows"][1]["stats"]);
}

TEST(BenchRender, WritesThePictureAndTheSceneWhichIsReadBackWhole) {
    Context context({.threads = 2});
    const test::TemporaryFolder folder;
    RenderBenchOptions options = small();
    options.output = folder.file("picture.png");
    options.export_file = folder.file("scene.glb");
    const RenderBenchReport report = bench_render(options, context);
    EXPECT_GT(std::filesystem::file_size(options.output), 1000u);
    const Scene read = load(options.export_file, {}, context);
    EXPECT_EQ(triangle_count(read), report.triangles);
    EXPECT_EQ(read.lights.size(), 2u);
    EXPECT_EQ(read.cameras.size(), 1u);
    EXPECT_EQ(read.textures.size(), 2u);
    EXPECT_EQ(read.materials.size(), 100u);
    for (const Mesh& mesh : read.meshes) EXPECT_EQ(mesh.tangents.size(), mesh.positions.size());
    RenderBenchOptions again = small();
    again.scene = options.export_file;
    const RenderBenchReport file = bench_render(again, context);
    EXPECT_EQ(file.triangles, report.triangles);
    EXPECT_EQ(file.rows[0].stats.pixels_covered, report.rows[0].stats.pixels_covered);
}

TEST(BenchRender, RefusesWhatItCannotDo) {
    Context context;
    const auto refused = [&](auto change) {
        RenderBenchOptions options = small();
        change(options);
        EXPECT_THROW(bench_render(options, context), Error);
    };
    refused([](RenderBenchOptions& o) { o.triangles = 99; });
    refused([](RenderBenchOptions& o) { o.objects = 0; });
    refused([](RenderBenchOptions& o) { o.objects = 1000; });
    refused([](RenderBenchOptions& o) { o.lights = 10'001; });
    refused([](RenderBenchOptions& o) { o.frames = 0; });
    refused([](RenderBenchOptions& o) { o.engines = {"hard"}; });
    refused([](RenderBenchOptions& o) { o.engines = {}; });
    refused([](RenderBenchOptions& o) { o.settings.width = 0; });
    refused([](RenderBenchOptions& o) { o.export_file = "scene.obj"; });
}

}  // namespace
}  // namespace rakelight::test
