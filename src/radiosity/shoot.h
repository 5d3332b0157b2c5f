// SPDX-License-Identifier: Apache-2.0
// Progressive refinement (Cohen, Chen, Wallace & Greenberg 1988): the patch with the largest unshot power shoots to all
// others until little is left.
#pragma once
#include <rakelight/radiosity/radiosity.h>

#include "radiosity/direct_light.h"

namespace rakelight::radiosity {

/// Each patch receives at up to four points, whose mean is used, and shoots its reflected light later. Order of shots:
/// largest power first, ties by index.
/// @param report gets shots, emitted, absorbed, unshot and escaped
/// @return [patches] radiance, including unshot light
/// @throws Error bad_file: over the memory budget
std::vector<dvec3> shoot(const Elements& elements, const Patches& patches, const FormFactors& form_factors,
                         const DirectLight& direct, double unshot, RadiosityReport& report, Context& context);

}  // namespace rakelight::radiosity
