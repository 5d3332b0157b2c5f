// SPDX-License-Identifier: Apache-2.0
// Lights that thin out for ever get an end where next to nothing is left of them, so that many cost little.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/scene.h>

namespace rakelight {

/// [m] from where on a light brings at most `cutoff`, measured by its brightest channel at its axis: ambient and the
/// larger of diffuse and specular together, of photometric lights intensity / pi. Infinity: it brings more at 1e30 m, or does not thin out at all; at
/// least min_light_range.
/// @param cutoff  > 0 [radiance of a white Lambert surface that faces the light]
///
/// With the window 1 - (d / range)^4 of a range r there, the light that a surface loses is at most `cutoff` at every
/// distance d, however the light thins out: b A(d) beyond r, where b A falls; b A(d) (d / r)^4 within, which grows with
/// d (d^4 / (c + l d + q d^2) does for c, l, q >= 0) up to b A(r) = cutoff at r.
double reach_of(const Light& light, double cutoff);

/// What became of lights.
struct CutLights {
    std::size_t cut = 0;        ///< got a range
    std::size_t endless = 0;    ///< point and spot lights that do not thin out so far
    float least = 0, most = 0;  ///< [m] of the ranges that were given
};

/// Sets the range of point and spot lights without one to reach_of(). Other lights are unchanged.
CutLights cut_lights(std::vector<Light>& lights, double cutoff);

/// Whether the light has the range of cut_lights().
/// @param cutoff  0: none is
bool is_cut(const Light& light, double cutoff);

/// A sentence about it without a full stop.
std::string said(const CutLights& result, double cutoff);

}  // namespace rakelight
