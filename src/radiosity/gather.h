// SPDX-License-Identifier: Apache-2.0
// The light that elements receive from all patches and lights, once the patches' radiosity is known.
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
    /// Of the scene: what an element receives on the mean, about.
    double mean_luminance() const { return mean_; }

private:
    std::vector<dvec3> radiance_;
    std::vector<double> weight_;         ///< [patches] luminance over the mean
    std::vector<std::uint32_t> bright_;  ///< those that send out light
    const FormFactors& form_factors_;
    const DirectLight& direct_;
    double mean_ = 0;
};

/// What has been gathered stays; [elements] which are to be gathered. In parallel.
void gather_all(const Elements& elements, const Gather& gather, std::vector<dvec3>& light,
                const std::vector<std::uint32_t>& wanted, Context& context);

}  // namespace rakelight::radiosity
