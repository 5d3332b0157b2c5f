// SPDX-License-Identifier: Apache-2.0
// Measures poses of animations, beside a plain copy of the vertices that is measured in the same run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>

namespace rakelight {

/// Options of bench_pose(): a generated character, or the first clip of a model file.
struct PoseBenchOptions {
    std::string scene{};  ///< model file; empty: a character generated from the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 1'000'000;  ///< approximate number of triangles, 100 to 10^8
    std::uint32_t objects = 16;           ///< 1 to 100 000, at most one for each 32 triangles
    std::uint32_t joints = 64;            ///< 2 to 1000
    std::uint32_t repetitions = 10;       ///< 1 to 1000, after one run that is not counted
    PictureRequest picture{};             ///< settings of the last row; its input is ignored
};

/// One measurement over all animated vertices. Times are wall clock; repetitions of all rows are interleaved.
struct PoseBenchRow {
    std::string what{};                                                ///< for people
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0, cpu_ms = 0;  ///< [ms]
    double ns_per_vertex = 0;                                          ///< from the median
    double ratio_to_copy = 0;                                          ///< median divided by that of the plain copy
};

/// Result of bench_pose().
struct PoseBenchReport {
    std::string scene{};                        ///< description of the scene
    std::uint64_t triangles = 0, vertices = 0;  ///< of the animated meshes
    std::uint32_t objects = 0, joints = 0;      ///< of the scene
    int threads = 1;                            ///< threads used
    std::vector<PoseBenchRow> rows{};
};

/// Measures at moments spread over the clip. The rows are:
/// - a plain copy of positions, normals and tangents (memcpy on all threads);
/// - skinning only;
/// - the whole pose with given normals;
/// - the whole pose with recomputed normals and tangents, with the corner groups of the bind pose;
/// - whole pictures, from the pose to display values.
/// @throws Error usage: options out of range, a scene without animation
RL_API PoseBenchReport bench_pose(const PoseBenchOptions& options, Context& context);
/// Schema rakelight.bench/1.
RL_API std::string to_json(const PoseBenchReport& report);
/// A table for people.
RL_API std::string to_text(const PoseBenchReport& report);

}  // namespace rakelight
