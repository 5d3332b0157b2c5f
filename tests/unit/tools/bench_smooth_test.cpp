// SPDX-License-Identifier: Apache-2.0
// What the measurement measures: the right model, all rows, and results that are what they should be. No time is
// judged.
#include <gtest/gtest.h>
#include <rakelight_internal/tools/bench_smooth.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "tools/bench/bench_model.h"

namespace rakelight::test {
namespace {

std::set<std::tuple<float, float, float>> places(const BenchModel& model) {
    std::set<std::tuple<float, float, float>> all;
    for (const BenchPart& part : model.parts)
        for (const vec3 p : part.positions) all.emplace(p.x, p.y, p.z);
    return all;
}

TEST(BenchModel, HasAboutTheTrianglesAndExactlyThePartsAskedFor) {
    for (const std::uint32_t parts : {1u, 16u, 256u, 1000u})
        for (const std::uint64_t triangles : {40'000ull, 100'000ull}) {
            const BenchModel model = make_bench_sphere(triangles, parts, false);
            EXPECT_EQ(model.parts.size(), parts);
            EXPECT_NEAR(double(model.triangles()), double(triangles), 0.02 * double(triangles));
            for (const BenchPart& part : model.parts) EXPECT_FALSE(part.indices.empty());
        }
}

TEST(BenchModel, CutsAndOrderChangeNoPlace) {
    const auto whole = places(make_bench_sphere(20'000, 1, false));
    EXPECT_EQ(whole.size(), 71u * 140u);  // 70 rows of quads; 140 columns that close
    EXPECT_EQ(places(make_bench_sphere(20'000, 64, false)), whole);
    EXPECT_EQ(places(make_bench_sphere(20'000, 16, true)), whole);
}

TEST(BenchSmooth, ReportsEveryRowWithTimesAndMemory) {
    SmoothBenchOptions options;
    options.triangles = 5000;
    options.repetitions = 3;
    options.brute_force = true;
    for (const bool shuffled : {false, true}) {
        options.shuffled = shuffled;
        Context context({.threads = 2});
        const auto json = nlohmann::json::parse(to_json(bench_smooth(options, context)));
        EXPECT_EQ(json["schema"], "rakelight.bench/1");
        EXPECT_EQ(json["order"], shuffled ? "shuffled" : "coherent");
        EXPECT_EQ(json["objects"], 16);
        std::vector<std::string> rows;
        for (const auto& row : json["rows"]) {
            rows.push_back(row["what"]);
            EXPECT_GT(row["ns_per_triangle"].get<double>(), 0);
            EXPECT_GT(row["cold_ns_per_triangle"].get<double>(), 0);
            EXPECT_LE(row["fastest_ns_per_triangle"].get<double>(), row["slowest_ns_per_triangle"].get<double>());
            EXPECT_GE(row["bytes_per_triangle"].get<double>(), 0);
        }
        EXPECT_EQ(rows, (std::vector<std::string>{"plain loop, normals", "normals", "normals + tangents",
                                                  "brute force, normals"}));
        EXPECT_EQ(json["rows"][0]["ratio_to_plain"], 1);
        EXPECT_EQ(json["rows"][3]["ratio_to_brute_force"], 1);
    }
}

TEST(BenchSmooth, RowsThatAreAskedForComeBesides) {
    SmoothBenchOptions options;
    options.triangles = 5000;
    options.repetitions = 1;
    options.crease = options.tolerance = options.order = options.plan = true;
    Context context({.threads = 2});
    const SmoothBenchReport report = bench_smooth(options, context);
    std::vector<std::string> rows;
    for (const BenchRow& row : report.rows) {
        rows.push_back(row.what);
        EXPECT_GT(row.ns_per_triangle, 0) << row.what;
        EXPECT_GT(row.ratio_to_plain, 0) << row.what;
    }
    EXPECT_EQ(rows, (std::vector<std::string>{"plain loop, normals", "normals", "normals + tangents",
                                              "crease 60, normals", "crease 60, normals + tangents",
                                              "tolerance 0.1 edges, normals", "tolerance 0.1 edges, normals + tangents",
                                              "crease 60, group + accumulate", "crease 60, accumulate only (pose)",
                                              "crease 60, regroup + accumulate", "crease 60, group",
                                              "crease 60, regroup (crease moved)", "shuffled, plain loop, normals",
                                              "shuffled, normals", "shuffled, normals + tangents"}));
    EXPECT_NE(to_text(report).find("regroup (crease moved)"), std::string::npos);
}

TEST(BenchSmooth, RefusesWhatItCannotMeasure) {
    Context context({.threads = 1});
    const auto refused = [&](auto change) {
        SmoothBenchOptions options;
        options.triangles = 5000;
        change(options);
        EXPECT_THROW(bench_smooth(options, context), Error);
    };
    refused([](auto& o) { o.triangles = 10; });
    refused([](auto& o) { o.objects = 0; });
    refused([](auto& o) { o.objects = 4000; });
    refused([](auto& o) { o.repetitions = 0; });
    refused([](auto& o) { o.weld_distance = 3; });
    refused([](auto& o) { o.crease_angle_rad = 4; });
    refused([](auto& o) {
        o.triangles = 60'000;
        o.brute_force = true;
    });
}

}  // namespace
}  // namespace rakelight::test
