// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include <rakelight/geometry/creases.h>
#include <rakelight_internal/tools/bench_creases.h>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/creases/model_families.h"
#include "tools/report_json.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

using Decisions = std::vector<std::uint8_t>;  ///< [edges] whether it is hard

/// [edges] Equal where edges are alike before rounding.
std::vector<std::uint32_t> kinds_of(const CreaseModel& model, const std::vector<ModelEdge>& edges) {
    // Steps far over what symmetric edges of a model differ by, and far under what its kinds of edges differ by.
    const auto steps = [](double value) { return std::llround(value * 1e5); };
    std::vector<double> faces, surfaces;  // areas
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
        const auto& v = model.triangles[t];
        const dvec3 a = model.exact[v[0]];
        faces.push_back(0.5 * length(cross(model.exact[v[1]] - a, model.exact[v[2]] - a)));
        surfaces.resize(std::max(surfaces.size(), std::size_t(model.surfaces[t]) + 1), 0);
        surfaces[model.surfaces[t]] += faces.back();
    }
    std::map<std::array<std::int64_t, 7>, std::uint32_t> known;
    std::vector<std::uint32_t> out;
    for (const ModelEdge& edge : edges) {
        std::array<std::int64_t, 7> kind{edge.is_hard, steps(edge.bend_deg), steps(edge.length)};
        for (std::size_t side = 0; side < 2; ++side) {
            kind[3 + side] = steps(faces[edge.triangles[side]]);
            kind[5 + side] = steps(surfaces[model.surfaces[edge.triangles[side]]]);
        }
        if (kind[3] > kind[4]) std::swap(kind[3], kind[4]);
        if (kind[5] > kind[6]) std::swap(kind[5], kind[6]);
        out.push_back(known.try_emplace(kind, std::uint32_t(known.size())).first->second);
    }
    return out;
}

/// A model as its file would bring it: objects, positions in float.
class LoadedModel {
public:
    explicit LoadedModel(const CreaseModel& model)
        : model_(model), edges_(edges_of(model)), kinds_(kinds_of(model, edges_)) {
        for (const dvec3& p : model.positions) positions_.push_back({float(p.x), float(p.y), float(p.z)});
        for (std::uint32_t t = 0; t < model.triangles.size(); ++t) add(t);
    }
    const std::vector<ModelEdge>& edges() const { return edges_; }
    const std::vector<std::uint32_t>& kinds() const { return kinds_; }  ///< [edges]

    /// As AttributeOptions::crease_angle_rad decides.
    Decisions by_angle(double deg) const {
        Decisions out;
        for (const ModelEdge& edge : edges_) {
            const dvec3 n = doubled_area(edge.triangles[0]), m = doubled_area(edge.triangles[1]);
            out.push_back(math::atan2(length(cross(n, m)), dot(n, m)) > radians(deg) + 1e-5);
        }
        return out;
    }
    Decisions by_rule(Context& context) const {
        std::vector<AttributeMesh> meshes;
        for (std::uint32_t o = 0; o < objects_.size(); ++o)
            meshes.push_back({.object = o,
                              .positions = objects_[o].positions,
                              .indices = objects_[o].indices,
                              .position_step = model_.is_quantized ? model_.step : 0});
        const Creases found = find_creases(meshes, {}, context);
        Decisions out;
        for (const ModelEdge& edge : edges_) {
            const Place at = places_[edge.triangles[0]];
            out.push_back((found.hard[at.object][at.triangle] >> edge.corners[0]) & 1);
        }
        return out;
    }

private:
    struct Object {
        std::vector<vec3> positions;
        std::vector<std::uint32_t> indices;
        std::map<std::uint32_t, std::uint32_t> vertices;  ///< by the model's
    };
    struct Place {
        std::uint32_t object = 0, triangle = 0;
    };

    void add(std::uint32_t triangle) {
        const std::uint32_t o = model_.objects[triangle];
        if (objects_.size() <= o) objects_.resize(o + 1);
        Object& object = objects_[o];
        places_.push_back({o, std::uint32_t(object.indices.size() / 3)});
        for (const std::uint32_t v : model_.triangles[triangle]) {
            const auto [at, is_new] = object.vertices.try_emplace(v, std::uint32_t(object.positions.size()));
            if (is_new) object.positions.push_back(positions_[v]);
            object.indices.push_back(at->second);
        }
    }
    dvec3 doubled_area(std::uint32_t triangle) const {
        const auto at = [&](std::size_t k) {
            const vec3 p = positions_[model_.triangles[triangle][k]];
            return dvec3{p.x, p.y, p.z};
        };
        return cross(at(1) - at(0), at(2) - at(0));
    }

    const CreaseModel& model_;
    std::vector<ModelEdge> edges_;
    std::vector<std::uint32_t> kinds_;
    std::vector<vec3> positions_;
    std::vector<Object> objects_;
    std::vector<Place> places_;  ///< [T]
};

/// [model units] of edges
struct Lengths {
    double meant = 0, decided = 0, both = 0;
    void add(const Lengths& other) { meant += other.meant, decided += other.decided, both += other.both; }
    CreaseScore score() const {
        CreaseScore out;
        if (decided > 0) out.precision = both / decided;
        if (meant > 0) out.recall = both / meant;
        return out;
    }
};

struct Outcome {
    Lengths lengths;
    CreaseScore score;
};

std::uint64_t count_mixes(const std::vector<std::uint32_t>& kinds, const Decisions& decisions) {
    std::vector<int> which(kinds.size(), 0);  // decisions of a kind: 1 soft, 2 hard
    for (std::size_t e = 0; e < kinds.size(); ++e) which[kinds[e]] |= decisions[e] != 0 ? 2 : 1;
    return std::uint64_t(std::ranges::count(which, 3));
}

Outcome judge(const LoadedModel& model, const Decisions& decisions) {
    const std::vector<ModelEdge>& edges = model.edges();
    Outcome out;
    std::uint64_t wrong = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const bool is_meant = edges[e].is_hard, is_decided = decisions[e] != 0;
        if (is_meant) out.lengths.meant += edges[e].length;
        if (is_decided) out.lengths.decided += edges[e].length;
        if (is_meant && is_decided) out.lengths.both += edges[e].length;
        wrong += is_meant != is_decided;
    }
    out.score = out.lengths.score();
    out.score.wrong = wrong, out.score.mixes = count_mixes(model.kinds(), decisions);
    return out;
}

double hard_share(const std::vector<ModelEdge>& edges) {
    double hard = 0, all = 0;
    for (const ModelEdge& edge : edges) all += edge.length, hard += edge.is_hard ? edge.length : 0;
    return all > 0 ? hard / all : 0;
}

/// Sums of some of the models.
class Sum {
public:
    Sum(const char* what, std::size_t rules) : total_{.what = what}, lengths_(rules) {
        total_.together.resize(rules), total_.means.resize(rules, {.precision = 0, .recall = 0});
    }
    void add(const std::vector<Outcome>& by_rule) {
        ++total_.models;
        for (std::size_t r = 0; r < by_rule.size(); ++r) {
            const CreaseScore& score = by_rule[r].score;
            lengths_[r].add(by_rule[r].lengths);
            total_.together[r].wrong += score.wrong, total_.together[r].mixes += score.mixes != 0;
            total_.means[r].precision += score.precision, total_.means[r].recall += score.recall;
        }
    }
    CreaseBenchTotal total() {
        for (std::size_t r = 0; r < lengths_.size(); ++r) {
            const CreaseScore score = lengths_[r].score();
            total_.together[r].precision = score.precision, total_.together[r].recall = score.recall;
            total_.means[r].precision /= double(total_.models), total_.means[r].recall /= double(total_.models);
        }
        return total_;
    }

private:
    CreaseBenchTotal total_;
    std::vector<Lengths> lengths_;
};

std::string word_of(double deg) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", deg);
    return text;
}

}  // namespace

CreaseBenchReport bench_creases(const CreaseBenchOptions& options, Context& context) {
    CreaseBenchReport report;
    for (const double deg : options.angles_deg) {
        if (!(deg >= 0 && deg <= 180)) throw Error(ErrorCode::usage, "crease angles: 0 to 180 degrees are possible");
        report.rules.push_back(word_of(deg));
    }
    report.rules.emplace_back("auto");
    Sum all("all", report.rules.size()), tuned("tuned", report.rules.size()), holdout("holdout", report.rules.size());
    const std::vector<CreaseModel> models = crease_models();
    for (const CreaseModel& model : models) {
        context.throw_if_cancelled();
        const LoadedModel loaded(model);
        std::vector<Outcome> by_rule;
        for (const double deg : options.angles_deg) by_rule.push_back(judge(loaded, loaded.by_angle(deg)));
        by_rule.push_back(judge(loaded, loaded.by_rule(context)));
        CreaseBenchRow row{.model = model.name, .is_decidable = model.is_decidable, .is_holdout = model.is_holdout};
        row.triangles = model.triangles.size(), row.hard_share = hard_share(loaded.edges());
        for (const Outcome& outcome : by_rule) row.scores.push_back(outcome.score);
        report.rows.push_back(std::move(row));
        if (model.is_decidable) all.add(by_rule), (model.is_holdout ? holdout : tuned).add(by_rule);
        context.progress("bench", double(report.rows.size()) / double(models.size()));
    }
    report.totals = {all.total(), tuned.total(), holdout.total()};
    return report;
}

std::string to_json(const CreaseBenchReport& report) {
    const auto json_of = [](const CreaseScore& score) {
        return Json{
            {"precision", score.precision}, {"recall", score.recall}, {"wrong", score.wrong}, {"mixes", score.mixes}};
    };
    Json rows = Json::array(), totals = Json::array();
    for (const CreaseBenchRow& row : report.rows) {
        Json json = {{"model", row.model},
                     {"is_decidable", row.is_decidable},
                     {"is_holdout", row.is_holdout},
                     {"triangles", row.triangles},
                     {"hard_share", row.hard_share}};
        for (std::size_t r = 0; r < report.rules.size(); ++r) json[report.rules[r]] = json_of(row.scores[r]);
        rows.push_back(json);
    }
    for (const CreaseBenchTotal& total : report.totals) {
        Json json = {{"what", total.what}, {"models", total.models}};
        for (std::size_t r = 0; r < report.rules.size(); ++r) {
            json[report.rules[r]] = json_of(total.together[r]);
            json[report.rules[r]]["mean_precision"] = total.means[r].precision;
            json[report.rules[r]]["mean_recall"] = total.means[r].recall;
        }
        totals.push_back(json);
    }
    return json_text({{"schema", "rakelight.bench/1"}, {"rules", report.rules}, {"rows", rows}, {"totals", totals}});
}

std::string to_text(const CreaseBenchReport& report) {
    std::vector<std::string> head = {"model", "kind", ">triangles"};
    for (const std::string& rule : report.rules) head.push_back(">" + rule);
    TextTable table(head);
    const auto cell = [](const CreaseScore& score, const char* mark) {
        char text[64];
        std::snprintf(text, sizeof text, "%.3f/%.3f%s", score.precision, score.recall, mark);
        return std::string(text);
    };
    for (const CreaseBenchRow& row : report.rows) {
        std::vector<std::string> cells = {row.model, row.is_decidable ? row.is_holdout ? "holdout" : "tuned" : "open",
                                          std::to_string(row.triangles)};
        for (const CreaseScore& score : row.scores) cells.push_back(cell(score, score.mixes > 0 ? " *" : "  "));
        table.add(cells);
    }
    for (const CreaseBenchTotal& total : report.totals) {
        const auto add = [&](const std::string& what, const std::vector<CreaseScore>& scores) {
            std::vector<std::string> cells = {what, total.what, std::to_string(total.models) + " models"};
            for (const CreaseScore& score : scores) cells.push_back(cell(score, "  "));
            table.add(cells);
        };
        add("all edges together", total.together), add("mean of the models", total.means);
        std::vector<std::string> mixes = {"models with a random mix", total.what, ""};
        for (const CreaseScore& score : total.together) mixes.push_back(std::to_string(score.mixes) + "  ");
        table.add(mixes);
    }
    return "precision/recall of hard edges by crease angle in degrees and by the automatic rule, weighted by length;\n"
           "*: edges that are alike before rounding are decided differently; open: the shape leaves open what is hard, "
           "totals leave it out\n" +
           table.text("");
}

}  // namespace rakelight
