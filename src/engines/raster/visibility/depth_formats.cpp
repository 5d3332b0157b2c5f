// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/visibility/depth_formats.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rakelight::raster {
namespace {

/// Largest whole number of a format; 0 for floats.
double largest_code(Visibility format) {
    switch (format) {
        case Visibility::z16:
            return 65535.0;
        case Visibility::z24:
            return 16777215.0;
        case Visibility::z32:
            return 4294967295.0;
        default:
            return 0;
    }
}

/// far / (far - near), the standard depth of what is infinitely far.
double limit_of(const DepthRange& r) { return std::isinf(r.z_far) ? 1.0 : r.z_far / (r.z_far - r.z_near); }

/// From a float of 0..1 to the next one towards 0: what a change needs to be seen.
double last_bit(double value) {
    const float v = float(value);
    return v > 0 ? double(v) - double(std::nextafter(v, 0.0f)) : double(std::numeric_limits<float>::denorm_min());
}

}  // namespace

bool has_depth(Visibility m) { return m != Visibility::painter && m != Visibility::none && m != Visibility::back_face; }

double reversed_depth(double distance, const DepthRange& r) {
    return r.orthographic ? 1 - (distance - r.z_near) / (r.z_far - r.z_near) : r.z_near / distance;
}

double standard_of_reversed(double reversed, const DepthRange& r) {
    return r.orthographic ? 1 - reversed : limit_of(r) * (1 - reversed);
}

double standard_depth(double distance, const DepthRange& r) {
    if (r.orthographic) return (distance - r.z_near) / (r.z_far - r.z_near);
    return limit_of(r) * (distance - r.z_near) / distance;
}

double stored_depth(Visibility format, double reversed, const DepthRange& r) {
    if (format == Visibility::z_reversed) return -double(float(reversed));
    const double z = std::clamp(standard_of_reversed(reversed, r), 0.0, 1.0), largest = largest_code(format);
    return largest > 0 ? std::floor(z * largest + 0.5) : double(float(z));
}

double depth_step(Visibility format, double distance, const DepthRange& r) {
    const bool is_reversed = format == Visibility::z_reversed;
    const double largest = largest_code(format),
                 z = is_reversed ? reversed_depth(distance, r) : standard_depth(distance, r);
    const double change = largest > 0 ? 1 / largest : last_bit(z);
    if (r.orthographic) return change * (r.z_far - r.z_near);
    return change * distance * distance / (r.z_near * (is_reversed ? 1.0 : limit_of(r)));
}

}  // namespace rakelight::raster
