// SPDX-License-Identifier: Apache-2.0
// The normal of a place by a height function that is fitted to its neighbors by least squares. Kin: Cazals & Pouget 2003,
// "Estimating differential quantities using polynomial fitting of osculating jets". Ours: the quadratic terms of a
// neighbor (x, y, z) are multiplied by (x^2 + y^2 + z^2) / (x^2 + y^2), so that normal sections are circles through the
// place, not parabolas. So spheres are exact, and cylinders across their axis.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/math/vector.h>

#include "geometry/fits/height_kernel_types.h"
#include "math/linear.h"

namespace rakelight::geometry {

/// - `quadric`, `cubic`: through the place; neighbors count by the inverse fourth power of their distance.
/// - `wide`: a quadric that need not meet the place, which is one neighbor of many: for noise. All count alike.
enum class HeightForm { quadric, cubic, wide };

/// Number of coefficients.
constexpr int terms_of(HeightForm form) { return form == HeightForm::cubic ? 9 : form == HeightForm::quadric ? 5 : 6; }

struct HeightFit {
    dvec3 normal;         ///< unit
    double residual = 0;  ///< sum of weight times the square of what is unexplained
    double weight = 0;    ///< sum of weights
    double bent = 0;      ///< sum of weight times the square of the heights above the tangent plane
    /// 0 to 1: how well the neighbors determine the slope: the variance that it would have if heights above a plane were
    /// fitted, by the one that it has. Independent of the axes. 0: they do not.
    double certainty = 0;
};

/// Places that are fitted together.
class HeightBatch {
public:
    HeightBatch();
    bool is_full() const { return size_ == height_lanes; }
    std::uint32_t size() const { return size_; }
    void clear() { size_ = 0; }
    /// @param neighbors  from the place; farther than 1e10 after scaling they weigh nothing
    /// @param scale      from their unit to about an edge
    /// @param normal     unit, a first guess, to which the heights are measured
    void add(std::span<const dvec3> neighbors, double scale, dvec3 normal);
    /// The same one by one.
    /// @param each  called with put(neighbor, is_taken), at most `most` times
    template <class Each>
    void add_place(std::size_t most, double scale, dvec3 normal, const Each& each) {
        double* const first = room_for(most, scale, normal);
        double* to = first;
        each([&to](dvec3 neighbor, bool is_taken) {  // without a branch: it could not be foretold
            to[0] = neighbor.x, to[height_lanes] = neighbor.y, to[2 * height_lanes] = neighbor.z;
            to += is_taken ? row : 0;
        });
        counts_[size_ - 1] = std::uint32_t(std::size_t(to - first) / row);
    }
    /// Of the last place.
    std::uint32_t neighbors() const { return counts_[size_ - 1]; }

    /// Fits all places.
    void fit();
    HeightFit cubic(std::uint32_t place) const { return fit_at(result_.cubic, place); }
    HeightFit quadric(std::uint32_t place) const { return fit_at(result_.quadric, place); }

    /// Fits a wide quadric to all places.
    void fit_wide();
    HeightFit wide(std::uint32_t place) const { return fit_at(wide_, place); }

private:
    static constexpr std::size_t row = 3 * height_lanes;

    double* room_for(std::size_t neighbors, double scale, dvec3 normal);
    HeightJob job();
    HeightFit fit_at(const HeightNumbers& numbers, std::uint32_t place) const;

    const HeightKernels& kernels_;
    std::vector<double> neighbors_;  ///< [rows][3][height_lanes]
    std::uint32_t counts_[height_lanes] = {}, size_ = 0;
    double normals_[3][height_lanes] = {}, scales_[height_lanes] = {};
    HeightNumbers wide_{};
    HeightResult result_{};
};

/// One place alone. The same numbers as in a batch.
HeightFit fit_height(std::span<const dvec3> neighbors, dvec3 normal, HeightForm form);

}  // namespace rakelight::geometry
