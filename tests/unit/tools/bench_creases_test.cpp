// SPDX-License-Identifier: Apache-2.0
// Models whose hard edges are known: that they are sound, and what rules find on them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include <rakelight_internal/tools/bench_creases.h>

#include "math/linear.h"
#include "support/thrown_error.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

const std::vector<CreaseModel>& all_models() {
    static const std::vector<CreaseModel> made = crease_models();
    return made;
}
const CreaseModel& model_of(const std::string& name) {
    const auto at = std::ranges::find(all_models(), name, &CreaseModel::name);
    if (at == all_models().end()) throw Error(ErrorCode::failed, "no model is named " + name);
    return *at;
}

const CreaseBenchReport& crease_report() {
    static const CreaseBenchReport made = [] {
        Context context;
        return bench_creases({}, context);
    }();
    return made;
}
std::size_t rule_of(const std::string& rule) {
    return std::size_t(std::ranges::find(crease_report().rules, rule) - crease_report().rules.begin());
}
CreaseScore score_of(const std::string& model, const std::string& rule) {
    const auto row = std::ranges::find(crease_report().rows, model, &CreaseBenchRow::model);
    if (row == crease_report().rows.end()) throw Error(ErrorCode::failed, "no model is named " + model);
    return row->scores[rule_of(rule)];
}
const CreaseBenchTotal& total_of(const std::string& what) {
    return *std::ranges::find(crease_report().totals, what, &CreaseBenchTotal::what);
}

double hard_length(const CreaseModel& model) {
    double sum = 0;
    for (const ModelEdge& edge : edges_of(model)) sum += edge.is_hard ? edge.length : 0;
    return sum;
}

TEST(CreaseModels, AreManyAndHaveDifferentNames) {
    std::set<std::string> names;
    int decidable = 0, holdout = 0;
    for (const CreaseModel& model : all_models()) {
        names.insert(model.name);
        decidable += model.is_decidable, holdout += model.is_holdout && model.is_decidable;
    }
    EXPECT_EQ(names.size(), all_models().size());
    EXPECT_GE(decidable, 66);
    EXPECT_GE(holdout, 15);
}

TEST(CreaseModels, AreClosedAndRightSideOut) {
    for (const CreaseModel& model : all_models()) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;  // of directed edges
        double volume = 0;
        for (const auto& t : model.triangles) {
            for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
            volume += dot(model.positions[t[0]], cross(model.positions[t[1]], model.positions[t[2]])) / 6;
        }
        for (const auto& [edge, count] : uses) {
            ASSERT_EQ(count, 1) << model.name;
            ASSERT_TRUE(uses.contains({edge.second, edge.first})) << model.name;
        }
        EXPECT_GT(volume, 0) << model.name;
        EXPECT_EQ(edges_of(model).size(), 3 * model.triangles.size() / 2) << model.name;
    }
}

TEST(CreaseModels, LieOnTheirGridsAndNearTheirExactPositions) {
    for (const CreaseModel& model : all_models())
        for (std::size_t v = 0; v < model.positions.size(); ++v) {
            const dvec3 p = model.positions[v], exact = model.exact[v];
            for (const auto& [is, should] :
                 {std::pair(p.x, exact.x), std::pair(p.y, exact.y), std::pair(p.z, exact.z)}) {
                ASSERT_LE(std::fabs(is - should), 0.501 * model.step) << model.name;
                ASSERT_NEAR(is / model.step, std::round(is / model.step), 1e-4) << model.name;
            }
        }
}

TEST(CreaseModels, HardEdgesHaveTheLengthOfTheirDrawings) {
    const double hexagon = 6, hole = 24 * 2 * 0.55 * std::sin(pi / 24);
    for (const char* digits : {"6 decimals", "2 decimals", "12 bits"})
        EXPECT_NEAR(hard_length(model_of(std::string("hex nut, ") + digits)), 2 * (hexagon + hole) + 6 * 0.8, 1e-9)
            << digits;
    const double c = 0.15;
    EXPECT_NEAR(hard_length(model_of("chamfered box, 15 %")), 24 * (2 - 2 * c) + 24 * c * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(hard_length(model_of("cylinder of 16 sides, 3 decimals")), 64 * std::sin(pi / 16), 1e-9);
    EXPECT_NEAR(hard_length(model_of("stairs")), 2 * (2 * 4 + 2 * 2.4) + 10 * 2, 1e-9);
    EXPECT_NEAR(hard_length(model_of("toy brick with studs")), 12 * 0.6 * std::sin(pi / 12) * 8 + 16 + 4 * 1.2, 1e-9);
    for (const char* soft :
         {"capsule, 16 x 4", "UV sphere of 8 x 6", "torus of 12 x 8, six objects", "box with round edges and corners"})
        EXPECT_EQ(hard_length(model_of(soft)), 0) << soft;
}

TEST(CreaseModels, ObjectsAreInUseFromTheFirstToTheLast) {
    int several = 0;
    for (const CreaseModel& model : all_models()) {
        const std::set<std::uint32_t> objects(model.objects.begin(), model.objects.end());
        EXPECT_EQ(*objects.rbegin() + 1, objects.size()) << model.name;
        several += objects.size() > 1;
    }
    EXPECT_GE(several, 5);
}

TEST(CreaseModels, AreTheSameEachTime) {
    const std::vector<CreaseModel> again = crease_models();
    for (std::size_t i = 0; i < all_models().size(); ++i) {
        EXPECT_EQ(all_models()[i].triangles, again[i].triangles) << all_models()[i].name;
        EXPECT_EQ(all_models()[i].hard, again[i].hard) << all_models()[i].name;
    }
}

// A box with chamfers of 45 degrees: nothing is over 60, all is over 30.
TEST(CreaseBench, AnglesFindWhatTheyMust) {
    EXPECT_EQ(score_of("chamfered box, 15 %", "60").recall, 0);
    EXPECT_EQ(score_of("chamfered box, 15 %", "30").recall, 1);
    EXPECT_EQ(score_of("chamfered box, 15 %", "30").precision, 1);
    EXPECT_EQ(score_of("chamfered box, 15 %", "60").wrong, 48u);  // all but the diagonals
    // The edge in the middle of two strips bends by 45 degrees.
    const CreaseScore fillets = score_of("box, fillets of 2 strips", "40");
    const double meant = hard_length(model_of("box, fillets of 2 strips"));
    EXPECT_EQ(fillets.recall, 1);
    EXPECT_NEAR(fillets.precision, meant / (meant + 4 * 1.5), 1e-9);
    EXPECT_EQ(score_of("UV sphere of 8 x 6", "30").precision, 0);
    EXPECT_EQ(score_of("UV sphere of 8 x 6", "60").precision, 1);
}

TEST(CreaseBench, SixtyDegreesIsAWhimOfTheRoundingOnNuts) {
    EXPECT_GT(score_of("hex nut, 4 decimals", "60").mixes, 0u);
    EXPECT_GT(total_of("all").together[rule_of("60")].mixes, 5u);
}

TEST(CreaseBench, TheAutomaticRuleFindsWhatIsMeant) {
    const std::size_t rule = rule_of("auto");
    for (const char* what : {"all", "tuned", "holdout"}) {
        EXPECT_GE(total_of(what).together[rule].precision, 0.97) << what;
        EXPECT_GE(total_of(what).together[rule].recall, 0.95) << what;
        EXPECT_GE(total_of(what).means[rule].precision, 0.97) << what;
        EXPECT_GE(total_of(what).means[rule].recall, 0.95) << what;
    }
}

TEST(CreaseBench, NutsAndChamferedBoxesAreExactlyRight) {
    int seen = 0;
    for (const CreaseBenchRow& row : crease_report().rows) {
        if (!row.model.starts_with("hex nut") && !row.model.starts_with("chamfered box")) continue;
        EXPECT_EQ(row.scores[rule_of("auto")].wrong, 0u) << row.model;
        ++seen;
    }
    EXPECT_GE(seen, 13);
}

TEST(CreaseBench, TheAutomaticRuleDecidesEqualEdgesEqually) {
    for (const CreaseBenchRow& row : crease_report().rows) {
        if (!row.is_decidable) continue;
        EXPECT_EQ(row.scores[rule_of("auto")].mixes, 0u) << row.model;
    }
}

TEST(CreaseBench, TotalsAreOfTheDecidableModels) {
    std::uint64_t decidable = 0, holdout = 0, wrong = 0;
    for (const CreaseBenchRow& row : crease_report().rows) {
        if (!row.is_decidable) continue;
        ++decidable, holdout += row.is_holdout, wrong += row.scores.front().wrong;
    }
    EXPECT_EQ(total_of("all").models, decidable);
    EXPECT_EQ(total_of("holdout").models, holdout);
    EXPECT_EQ(total_of("tuned").models + holdout, decidable);
    EXPECT_EQ(total_of("all").together.front().wrong, wrong);
}

TEST(CreaseBench, IsTheSameForAnyNumberOfThreads) {
    Context one({.threads = 1});
    EXPECT_EQ(to_json(bench_creases({}, one)), to_json(crease_report()));
}

TEST(CreaseBench, ReportsNameTheRules) {
    const nlohmann::json json = nlohmann::json::parse(to_json(crease_report()));
    EXPECT_EQ(json["schema"], "rakelight.bench/1");
    EXPECT_EQ(json["rules"], nlohmann::json({"30", "40", "60", "auto"}));
    for (const char* rule : {"30", "40", "60", "auto"}) {
        EXPECT_TRUE(json["rows"][0][rule].contains("mixes")) << rule;
        EXPECT_TRUE(json["totals"][2][rule].contains("mean_recall")) << rule;
    }
    EXPECT_NE(to_text(crease_report()).find("mean of the models"), std::string::npos);
}

TEST(CreaseBench, AnglesAreInTheirRange) {
    Context context;
    for (const double deg : {-1.0, 181.0, std::nan("")})
        EXPECT_EQ(test::error_of([&] { bench_creases({.angles_deg = {deg}}, context); }).code(), ErrorCode::usage);
}

}  // namespace
}  // namespace rakelight
