// SPDX-License-Identifier: Apache-2.0
// Limits the range of attenuated lights where they become negligible, to reduce the cost of many lights.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// [m] the distance beyond which a light is at most `cutoff`, by its brightest channel on its axis: ambient plus the
/// larger of diffuse and specular, or intensity / pi for photometric lights. At least min_light_range. Infinity: it is
/// brighter at 1e30 m, or not attenuated.
/// @param cutoff > 0 [radiance of a white Lambert surface facing the light]
///
/// With the window 1 - (d / r)^4 of this range r, the light lost by a surface is at most `cutoff` at every distance d:
/// it is b A(d) beyond r, where b A falls; b A(d) (d / r)^4 within, which grows with d (d^4 / (c + l d + q d^2) does for c,
/// l, q >= 0) up to b A(r) = cutoff at r.
double reach_of(const Light& light, double cutoff);

/// Statistics of lights.
struct CutLights {
    std::size_t cut = 0;        ///< got a range
    std::size_t endless = 0;    ///< point and spot lights that stay brighter
    float least = 0, most = 0;  ///< [m] of the assigned ranges
};

/// Sets the range of point and spot lights without one to reach_of(). Other lights are unchanged.
CutLights cut_lights(std::vector<Light>& lights, double cutoff);

/// Whether the light has the range of cut_lights().
/// @param cutoff  0: none is
bool is_cut(const Light& light, double cutoff);

/// A sentence for reports, without a full stop.
std::string said(const CutLights& result, double cutoff);

}  // namespace rakelight
