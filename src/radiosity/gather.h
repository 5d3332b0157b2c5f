// SPDX-License-Identifier: Apache-2.0
// Final gathering: light of elements from all patches and lights after the solution.
#pragma once
#include "radiosity/direct_light.h"

namespace rakelight::radiosity {

class Gather {
public:
    /// @param radiance  [patches]
    Gather(const Patches& patches, std::vector<dvec3> radiance, const FormFactors& form_factors,
           const DirectLight& direct);

    /// Irradiance / pi.
    dvec3 operator()(const Element& element) const;
    /// Approximate mean irradiance of an element.
    double mean_luminance() const { return mean_; }

private:
    std::vector<dvec3> radiance_;
    std::vector<double> weight_;         ///< [patches] luminance divided by the mean
    std::vector<std::uint32_t> bright_;  ///< patches with nonzero radiance
    const FormFactors& form_factors_;
    const DirectLight& direct_;
    double mean_ = 0;
};

/// Gathers the selected [elements] in parallel; earlier results are kept.
void gather_all(const Elements& elements, const Gather& gather, std::vector<dvec3>& light,
                const std::vector<std::uint32_t>& wanted, Context& context);

}  // namespace rakelight::radiosity
