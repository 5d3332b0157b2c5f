// SPDX-License-Identifier: Apache-2.0
#include "image/draw_line.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/assert.h"

namespace rakelight {
namespace {

double distance_to(dvec2 p, dvec2 a, dvec2 b) {
    const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
    const double t = squared > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / squared, 0.0, 1.0) : 0;
    const double dx = p.x - (a.x + t * x), dy = p.y - (a.y + t * y);
    return std::sqrt(dx * dx + dy * dy);
}

/// Blends in display codes with straight alpha, because overlays are not light.
void lay(std::byte* to, Code color, double cover) {
    const double under = double(std::to_integer<int>(to[3])) / 255 * (1 - cover), alpha = cover + under;
    const std::uint8_t codes[3] = {color.r, color.g, color.b};
    for (std::size_t c = 0; c < 3; ++c) {
        const double mixed = (double(codes[c]) * cover + double(std::to_integer<int>(to[c])) * under) / alpha;
        to[c] = std::byte(std::uint8_t(mixed + 0.5));
    }
    to[3] = std::byte(std::uint8_t(std::min(alpha, 1.0) * 255 + 0.5));
}

}  // namespace

void draw_line(Pixels& picture, dvec2 a, dvec2 b, double width_px, Code color) {
    RL_ASSERT(picture.component == Component::u8 && picture.channels == 4, "lines are drawn into RGBA of 8 bits");
    if (!std::isfinite(a.x + a.y + b.x + b.y + width_px)) return;
    const double reach = 0.5 * width_px + 1;
    const auto pixel = [](double v, int last) { return int(std::clamp(std::floor(v), 0.0, double(last))); };
    if (picture.width == 0 || picture.height == 0) return;
    const int left = pixel(std::min(a.x, b.x) - reach, picture.width - 1),
              right = pixel(std::max(a.x, b.x) + reach, picture.width - 1);
    const int top = pixel(std::min(a.y, b.y) - reach, picture.height - 1),
              bottom = pixel(std::max(a.y, b.y) + reach, picture.height - 1);
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const double cover = std::clamp(0.5 * width_px + 0.5 - distance_to({x + 0.5, y + 0.5}, a, b), 0.0, 1.0);
            if (cover > 0) lay(picture.row(y) + 4 * std::size_t(x), color, cover);
        }
}

}  // namespace rakelight
