// SPDX-License-Identifier: Apache-2.0
// Assimp's generators of normals and tangents, over the model of the measurements.
#pragma once
#include "tools/bench/bench_model.h"

namespace rakelight::bench {

struct AssimpSeconds {
    double normals = 0;   ///< aiProcess_GenSmoothNormals
    double tangents = 0;  ///< aiProcess_CalcTangentSpace, after it
};

/// One run of both. The model is given as Assimp's own readers give theirs: three vertices a triangle, objects apart.
/// Reading is not in the times. @throws std::runtime_error
AssimpSeconds assimp_generators(const BenchModel& model);

}  // namespace rakelight::bench
