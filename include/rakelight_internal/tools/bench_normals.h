// SPDX-License-Identifier: Apache-2.0
// Measures how far vertex normals are from exact ones.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>

namespace rakelight {

/// Options of bench_normals().
struct NormalBenchOptions {
    std::uint32_t repetitions = 3;  ///< 1 to 100: the random surfaces and the noise are made anew in each
};

/// The vertex normals of one class of surfaces, by each weight.
struct NormalBenchRow {
    struct Errors {
        double mean_deg = 0, largest_deg = 0;  ///< angle to the exact normal over all judged vertices
    };
    std::string surface{};         ///< for people
    std::string kind{};            ///< "smooth", "border", "noise" or "hard"
    std::uint64_t vertices = 0;    ///< that are judged, in each repetition
    std::vector<Errors> errors{};  ///< [NormalBenchReport::weights]
};

/// Result of bench_normals().
struct NormalBenchReport {
    std::vector<CornerWeight> weights{};
    std::vector<NormalBenchRow> rows{};
};

/// How far vertex normals are from the exact ones, on surfaces with known normals: round and irregular ones, open
/// borders, noise, bevels. Positions are rounded to float.
/// @throws Error usage: options out of range
RL_API NormalBenchReport bench_normals(const NormalBenchOptions& options, Context& context);
/// Schema rakelight.bench/1: {"schema", "rows": [{"surface", "kind", "vertices", "angle": {"mean_deg", "largest_deg"}, ...}]}.
RL_API std::string to_json(const NormalBenchReport& report);
/// A table for people.
RL_API std::string to_text(const NormalBenchReport& report);

}  // namespace rakelight
