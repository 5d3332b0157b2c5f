// SPDX-License-Identifier: Apache-2.0
#include "scene/light_cutoff.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <rakelight/scene/light_limits.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"

namespace rakelight {
namespace {

constexpr double farthest = 1e30;  // [m] limits of a range

double largest(vec3 color) { return double(std::max({color.x, color.y, color.z})); }

double brightest(const Light& light) {
    if (light.units == LightUnits::photometric) return largest(light.color) * double(light.intensity) / pi;
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, double(light.ambient[c]) + double(std::max(light.diffuse[c], light.specular[c])));
    return most;
}

/// Solves c + l d + q d^2 = `wanted` for d, by the root formula without cancellation.
double distance_of(double c, double l, double q, double wanted) {
    if (!(wanted > c)) return 0;
    const double beyond = wanted - c;
    return 2 * beyond / (l + std::sqrt(l * l + 4 * q * beyond));  // l = q = 0: infinity
}

/// The range for a finite reach.
float range_of(double reach) { return std::nextafter(float(reach), std::numeric_limits<float>::infinity()); }

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

}  // namespace

double reach_of(const Light& light, double cutoff) {
    const double wanted = brightest(light) / cutoff;
    const double distance =
        light.units == LightUnits::photometric
            ? std::sqrt(wanted)
            : distance_of(double(light.constant), double(light.linear), double(light.quadratic), wanted);
    if (!(distance <= farthest)) return std::numeric_limits<double>::infinity();
    return std::max(distance, min_light_range);
}

bool is_cut(const Light& light, double cutoff) {
    const bool has_range = light.type == LightType::point || light.type == LightType::spot;
    return cutoff > 0 && has_range && std::isfinite(light.range) && light.range == range_of(reach_of(light, cutoff));
}

CutLights cut_lights(std::vector<Light>& lights, double cutoff) {
    CutLights out;
    for (Light& light : lights) {
        if ((light.type != LightType::point && light.type != LightType::spot) || std::isfinite(light.range)) continue;
        const double reach = reach_of(light, cutoff);
        if (!std::isfinite(reach)) {
            ++out.endless;
            continue;
        }
        light.range = range_of(reach);
        out.least = out.cut == 0 ? light.range : std::min(out.least, light.range);
        out.most = std::max(out.most, light.range);
        ++out.cut;
    }
    return out;
}

std::string said(const CutLights& result, double cutoff) {
    std::string text = "light cutoff " + number(cutoff) + ": ";
    if (result.cut == 0)
        text += "no light is cut";
    else if (result.least == result.most)
        text += counted(result.cut, "light") + " cut at " + number(double(result.least)) + " m";
    else
        text += counted(result.cut, "light") + " cut at " + number(double(result.least)) + " to " +
                number(double(result.most)) + " m";
    if (result.endless != 0) text += format_text("; without an end, since they stay brighter: {}", result.endless);
    return text;
}

}  // namespace rakelight
