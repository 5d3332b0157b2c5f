// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/height_fit.h"

#include <algorithm>

#include "math/isa.h"

namespace rakelight::geometry {

HeightBatch::HeightBatch() : kernels_(*RL_BY_ISA(isa_from_environment(), height_kernels())) {}

void HeightBatch::add(std::span<const dvec3> neighbors, double scale, dvec3 normal) {
    add_place(neighbors.size(), scale, normal, [&](const auto& put) {
        for (const dvec3& neighbor : neighbors) put(neighbor, true);
    });
}

/// A place more. @return where its first neighbor is put; there is room for one beyond the last
double* HeightBatch::room_for(std::size_t neighbors, double scale, dvec3 normal) {
    if (neighbors_.size() < (neighbors + 1) * row) neighbors_.resize((neighbors + 1) * row);
    counts_[size_] = 0, scales_[size_] = scale;
    for (int axis = 0; axis < 3; ++axis) normals_[axis][size_] = normal[std::size_t(axis)];
    return neighbors_.data() + size_++;
}

HeightJob HeightBatch::job() {
    HeightJob job{.neighbors = neighbors_.data()};
    for (std::uint32_t place = 0; place < size_; ++place) {
        job.count[place] = counts_[place], job.scale[place] = scales_[place];
        job.rows = std::max(job.rows, counts_[place]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        std::fill(normals_[axis] + size_, normals_[axis] + height_lanes, axis == 2 ? 1.0 : 0.0);
        std::copy(normals_[axis], normals_[axis] + height_lanes, job.normal[axis]);
    }
    return job;
}

void HeightBatch::fit() { kernels_.fit(job(), result_); }
void HeightBatch::fit_wide() { kernels_.wide(job(), wide_, result_.weight); }

HeightFit HeightBatch::fit_at(const HeightNumbers& numbers, std::uint32_t place) const {
    return {{numbers.normal[0][place], numbers.normal[1][place], numbers.normal[2][place]},
            numbers.residual[place],
            result_.weight[place],
            numbers.bent[place],
            numbers.certainty[place]};
}

HeightFit fit_height(std::span<const dvec3> neighbors, dvec3 normal, HeightForm form) {
    HeightBatch batch;
    batch.add(neighbors, 1, normal);
    if (form == HeightForm::wide) {
        batch.fit_wide();
        return batch.wide(0);
    }
    batch.fit();
    return form == HeightForm::cubic ? batch.cubic(0) : batch.quadric(0);
}

}  // namespace rakelight::geometry
