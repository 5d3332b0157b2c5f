// SPDX-License-Identifier: Apache-2.0
#include "image/compare/compare.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "base/format_text.h"
#include "math/functions.h"

namespace rakelight {
namespace {

/// The code of component i of integers.
int code_at(const Pixels& pixels, std::size_t i) {
    if (pixels.component == Component::u8) return int(pixels.bytes[i]);
    std::uint16_t value = 0;
    std::memcpy(&value, pixels.bytes.data() + 2 * i, sizeof(value));
    return value;
}

double difference(double a, double b) {
    if (a == b || (a != a && b != b)) return 0;
    const double d = std::fabs(a - b);
    return d == d ? d : std::numeric_limits<double>::infinity();
}

/// Exact for codes: 102 / 255 - 100 / 255 in floating point exceeds 2 / 255.
double difference_at(const Pixels& a, const Pixels& b, std::size_t i) {
    if (a.component != b.component || a.component == Component::f32)
        return difference(component_at(a, i), component_at(b, i));
    return std::abs(code_at(a, i) - code_at(b, i)) / (a.component == Component::u8 ? 255.0 : 65535.0);
}

std::string size_text(const Pixels& p) { return format_text("{} x {} x {}", p.width, p.height, p.channels); }

}  // namespace

double component_at(const Pixels& pixels, std::size_t i) {
    if (pixels.component != Component::f32)
        return code_at(pixels, i) / (pixels.component == Component::u8 ? 255.0 : 65535.0);
    float value = 0;
    std::memcpy(&value, pixels.bytes.data() + 4 * i, sizeof(value));
    return double(value);
}

PictureDifference compare_pictures(const Pixels& a, const Pixels& b, double threshold) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw Error(ErrorCode::usage, "pictures of different size: " + size_text(a) + " and " + size_text(b));
    const std::size_t count = a.bytes.size() / size_of(a.component);
    PictureDifference result;
    double squares = 0;
    const std::size_t channels = std::size_t(a.channels);
    for (std::size_t first = 0; first < count; first += channels) {
        std::size_t over = 0;
        for (std::size_t i = first; i < first + channels; ++i) {
            const double d = difference_at(a, b, i);
            if (d > result.max_absolute) result.max_absolute = d;
            if (d > threshold) ++over;
            squares += d * d;
        }
        result.differing += over;
        result.differing_pixels += over > 0;
    }
    const double mean = count == 0 ? 0 : squares / double(count);
    result.rmse = std::sqrt(mean);
    constexpr double decibels_per_log2 = 3.010299956639812;  // 10 log10(2)
    result.psnr_db = mean == 0 ? std::numeric_limits<double>::infinity() : -decibels_per_log2 * math::log2(mean);
    result.differing_share = count == 0 ? 0 : double(result.differing) / double(count);
    return result;
}

}  // namespace rakelight
