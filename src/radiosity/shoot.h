// SPDX-License-Identifier: Apache-2.0
// Progressive refinement (Cohen, Chen, Wallace & Greenberg 1988): the patch with the most unshot power shoots to all others,
// until little is left.
#pragma once
#include <rakelight/radiosity.h>

#include "radiosity/direct_light.h"

namespace rakelight::radiosity {

/// Each patch receives at up to four places, the mean counts; what it reflects it shoots later. The order of shots: most
/// power first, of equal ones the lower number.
/// @param report  shots, emitted, absorbed, unshot and left are set
/// @return [patches] radiance of each, what is still unshot included
/// @throws Error bad_file: over the memory budget
std::vector<dvec3> shoot(const Elements& elements, const Patches& patches, const FormFactors& form_factors,
                         const DirectLight& direct, double unshot, RadiosityReport& report, Context& context);

}  // namespace rakelight::radiosity
