// SPDX-License-Identifier: Apache-2.0
// Angles as colors that grow lighter with the angle, so that they are in order in gray too.
#include <rakelight/tools/inspect.h>

#include <algorithm>
#include <iterator>

#include "math/color.h"
#include "math/linear.h"

namespace rakelight {

vec3 heat_color(double seam_deg) {
    struct Stop {
        double deg;
        std::uint8_t srgb[3];
    };
    // Five samples of "plasma" (Nathaniel J. Smith and Stefan van der Walt 2015, CC0).
    constexpr Stop stops[] = {{continuous_deg, {13, 8, 135}},
                              {1, {126, 3, 168}},
                              {5, {204, 71, 120}},
                              {20, {248, 149, 64}},
                              {60, {240, 249, 33}}};
    const auto color = [](const Stop& s) {
        return vec3{linear_from_srgb8(s.srgb[0]), linear_from_srgb8(s.srgb[1]), linear_from_srgb8(s.srgb[2])};
    };
    const Stop* above = std::begin(stops) + 1;
    while (above + 1 != std::end(stops) && above->deg < seam_deg) ++above;
    const Stop& below = above[-1];
    const double t = std::clamp((seam_deg - below.deg) / (above->deg - below.deg), 0.0, 1.0);
    return color(below) * float(1 - t) + color(*above) * float(t);
}

}  // namespace rakelight
