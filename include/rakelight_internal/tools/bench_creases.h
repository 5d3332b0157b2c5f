// SPDX-License-Identifier: Apache-2.0
// Measures how well rules find the hard edges of models.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>

namespace rakelight {

/// Options of bench_creases().
struct CreaseBenchOptions {
    std::vector<double> angles_deg = {30, 40, 60};  ///< [degrees] 0 to 180: crease angles beside the automatic rule
};

/// How well a rule finds the hard edges of a model. Lengths of edges count, not their number.
struct CreaseScore {
    double precision = 1;     ///< share of what is decided hard that is meant hard; 1 if nothing is decided hard
    double recall = 1;        ///< share of what is meant hard that is decided hard; 1 if nothing is meant hard
    std::uint64_t wrong = 0;  ///< edges that are decided otherwise than meant
    /// Kinds of edges of which some are decided hard and some soft, by a whim of the rounding. Edges of one kind are
    /// meant alike. Before rounding their lengths, their bends and the areas of their faces and surfaces are equal.
    std::uint64_t mixes = 0;
};

/// One model, by each rule.
struct CreaseBenchRow {
    std::string model{};                ///< for people
    bool is_decidable = true;           ///< false: its shape leaves open what is hard, so totals leave it out
    bool is_holdout = false;            ///< made without a look at the automatic rule, which is not tuned by it
    std::uint64_t triangles = 0;        ///< of the model
    double hard_share = 0;              ///< share of the length of its edges that is meant hard
    std::vector<CreaseScore> scores{};  ///< [CreaseBenchReport::rules]
};

/// Over several decidable models, by each rule.
struct CreaseBenchTotal {
    std::string what{};                   ///< "all", "tuned" or "holdout"
    std::uint64_t models = 0;             ///< number of models
    std::vector<CreaseScore> together{};  ///< [rules] over the lengths of all edges; mixes: models that have any
    std::vector<CreaseScore> means{};     ///< [rules] of the models' precision and recall; `wrong` and `mixes` are 0
};

/// Result of bench_creases().
struct CreaseBenchReport {
    std::vector<std::string> rules{};  ///< angles in degrees, then "auto"
    std::vector<CreaseBenchRow> rows{};
    std::vector<CreaseBenchTotal> totals{};
};

/// How well crease angles and find_creases() find hard edges, on models whose hard edges are known because the models
/// are made of surfaces. Positions are rounded to decimals or to bits.
/// @throws Error usage: options out of range
RL_API CreaseBenchReport bench_creases(const CreaseBenchOptions& options, Context& context);
/// Schema rakelight.bench/1: {"schema", "rules", "rows": [{"model", "60": {"precision", "recall", ...}, ...}], "totals"}.
RL_API std::string to_json(const CreaseBenchReport& report);
/// A table for people.
RL_API std::string to_text(const CreaseBenchReport& report);

}  // namespace rakelight
