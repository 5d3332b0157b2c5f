// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <iterator>

#include <nlohmann/json.hpp>

#include <rakelight/prepare/prepare.h>
#include <rakelight_internal/tools/bench_normals.h>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/bench/normal_classes.h"
#include "tools/report_json.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

const char* name_of(NormalKind kind) {
    switch (kind) {
        case NormalKind::smooth:
            return "smooth";
        case NormalKind::border:
            return "border";
        case NormalKind::noise:
            return "noise";
        case NormalKind::hard:
            break;
    }
    return "hard";
}

const char* name_of(CornerWeight weight) {
    return std::ranges::find(corner_weight_words, weight, &Word<CornerWeight>::value)->name;
}

/// A class as floats, and what came out of it.
class Judged {
public:
    explicit Judged(const NormalClass& of) : of_(of) {
        for (const dvec3& p : of.surface.positions) positions_.push_back({float(p.x), float(p.y), float(p.z)});
        for (const auto& t : of.surface.triangles) indices_.insert(indices_.end(), t.begin(), t.end());
    }
    /// @return number of judged vertices
    std::uint64_t judge(CornerWeight weight, NormalBenchRow::Errors& to, Context& context) const {
        const AttributeMesh mesh{.positions = positions_, .indices = indices_};
        AttributeOptions options;
        options.weight = weight, options.crease_angle_rad = of_.crease_angle_rad, options.tangents = false;
        const MeshAttributes out = compute_attributes({&mesh, 1}, options, context).front();
        const std::vector<std::uint32_t>& indices = out.indices.empty() ? indices_ : out.indices;
        std::vector<double> worst(out.normals.size(), -1);  // of its corners
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (of_.counts[i] == 0) continue;
            const vec3 n = out.normals[indices[i]];
            const dvec3 is{n.x, n.y, n.z}, should = of_.corner_normals[i];
            worst[indices[i]] =
                std::max(worst[indices[i]], degrees(math::atan2(length(cross(is, should)), dot(is, should))));
        }
        std::uint64_t count = 0;
        double sum = 0;
        for (const double error : worst) {
            if (error < 0) continue;
            ++count, sum += error;
            to.largest_deg = std::max(to.largest_deg, error);
        }
        to.mean_deg += sum / double(count);
        return count;
    }

private:
    const NormalClass& of_;
    std::vector<vec3> positions_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace

NormalBenchReport bench_normals(const NormalBenchOptions& options, Context& context) {
    if (options.repetitions < 1 || options.repetitions > 100)
        throw Error(ErrorCode::usage, "repetitions: 1 to 100 are possible");
    NormalBenchReport report;
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max,
          CornerWeight::fit, CornerWeight::automatic})
        report.weights.push_back(weight);
    for (std::uint32_t seed = 1; seed <= options.repetitions; ++seed) {
        const std::vector<NormalClass> classes = normal_classes(seed);
        report.rows.resize(classes.size());
        for (std::size_t i = 0; i < classes.size(); ++i) {
            context.throw_if_cancelled();
            NormalBenchRow& row = report.rows[i];
            row.surface = classes[i].name, row.kind = name_of(classes[i].kind);
            row.errors.resize(report.weights.size());
            const Judged judged(classes[i]);
            for (std::size_t w = 0; w < report.weights.size(); ++w)
                row.vertices = judged.judge(report.weights[w], row.errors[w], context);
        }
        context.progress("bench", double(seed) / options.repetitions);
    }
    for (NormalBenchRow& row : report.rows)
        for (NormalBenchRow::Errors& errors : row.errors) errors.mean_deg /= options.repetitions;
    return report;
}

std::string to_json(const NormalBenchReport& report) {
    Json rows = Json::array();
    for (const NormalBenchRow& row : report.rows) {
        Json json = {{"surface", row.surface}, {"kind", row.kind}, {"vertices", row.vertices}};
        for (std::size_t w = 0; w < report.weights.size(); ++w)
            json[name_of(report.weights[w])] = {{"mean_deg", row.errors[w].mean_deg},
                                                {"largest_deg", row.errors[w].largest_deg}};
        rows.push_back(json);
    }
    return json_text({{"schema", "rakelight.bench/1"}, {"rows", rows}});
}

std::string to_text(const NormalBenchReport& report) {
    std::vector<std::string> head = {"surface", "kind", ">vertices"};
    for (const CornerWeight weight : report.weights) head.push_back(std::string(">") + name_of(weight));
    TextTable table(head);
    for (const NormalBenchRow& row : report.rows) {
        std::vector<std::string> cells = {row.surface, row.kind, std::to_string(row.vertices)};
        for (const NormalBenchRow::Errors& e : row.errors) {
            char text[64];
            std::snprintf(text, sizeof text, "%.2f/%-5.1f", e.mean_deg, e.largest_deg);
            cells.emplace_back(text);
        }
        table.add(cells);
    }
    return "mean/largest error of vertex normals in degrees, by weight\n" + table.text("");
}

}  // namespace rakelight
