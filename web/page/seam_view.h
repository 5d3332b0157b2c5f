// SPDX-License-Identifier: Apache-2.0
// Where a seam is seen from, and from where a light grazes the surface there.
#pragma once
#include "examined_model.h"

namespace rakelight::web {

struct SeamView {
    dvec3 place{};     ///< [m] world, of the seam's largest angle
    dvec3 eye{};       ///< [m] world, with nothing between
    dvec3 to_light{};  ///< unit, across the border and a little above the surface
};

/// @param border  into inspection.borders. @throws Error usage: there is no such border
SeamView view_of_seam(const ExaminedModel& model, std::size_t border);

}  // namespace rakelight::web
