// SPDX-License-Identifier: Apache-2.0
#include "render/output/scalar_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "image/draw_text.h"

namespace rakelight {
namespace {

std::string text_of(double number, double step) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", std::fabs(number) < step * 1e-6 ? 0.0 : number);
    return text;
}

/// The largest of 1, 2 and 5 times a power of ten that is not above; without libm, for pictures are the same everywhere.
double round_step(double most) {
    double power = 1;
    while (power * 10 <= most) power *= 10;
    while (power > most) power /= 10;
    return power * (5 * power <= most ? 5 : 2 * power <= most ? 2 : 1);
}

}  // namespace

std::vector<double> ticks(dvec2 range) {
    const double extent = range.y - range.x;
    if (!(extent > 0) || !std::isfinite(extent) || extent < 1e-290) return {range.x};
    const double step = round_step(extent / 3);
    std::vector<double> out;
    for (double k = std::ceil(range.x / step - 1e-9); k * step <= range.y + extent * 1e-9 && out.size() < 16; ++k)
        out.push_back(k * step);
    return out;
}

ScalarBar::ScalarBar(const Coloring& coloring, int width, int height) {
    const int scale = text_scale_for(height), dot = scale, bar_width = 10 * dot, margin = 6 * dot;
    const int bar_height = height * 3 / 5, digits = text_height("0", scale);
    const dvec2 range = coloring.range.value_or(dvec2{0, 1});
    const std::vector<double> at = ticks(range);
    const double step = at.size() > 1 ? at[1] - at[0] : 1;
    int words = text_width(coloring.array, scale);
    for (const double t : at) words = std::max(words, bar_width + 5 * dot + text_width(text_of(t, step), scale));
    const int title = digits + 5 * dot, own_width = words + 2 * dot, own_height = title + bar_height + digits;
    if (own_width + 2 * margin > width || own_height + 2 * margin > height || bar_height < 3 * digits) return;
    pixels = {.width = own_width, .height = own_height, .channels = 4, .component = Component::u8};
    pixels.bytes.resize(pixels.row_bytes() * std::size_t(own_height));
    x = width - margin - own_width, y = (height - own_height) / 2;
    const TextStyle style{.color = words_color, .scale = scale, .halo = halo_color};
    draw_text(pixels, dot, dot, coloring.array, style);
    fill_rectangle(pixels, 0, title - dot, bar_width + 2 * dot, bar_height + 2 * dot, halo_color);
    for (int row = 0; row < bar_height; ++row) {
        const double t = 1 - (row + 0.5) / bar_height;
        fill_rectangle(pixels, dot, title + row, bar_width, 1, code_of_light(color_of(coloring.map, t)));
    }
    for (const double t : at) {
        const double share = range.y > range.x ? (t - range.x) / (range.y - range.x) : 0.5;
        const int row = title + int(std::floor((1 - share) * (bar_height - 1) + 0.5));
        fill_rectangle(pixels, bar_width + dot, row, 3 * dot, dot, words_color);
        draw_text(pixels, bar_width + 5 * dot, std::max(0, row - digits / 2), text_of(t, step), style);
    }
}

}  // namespace rakelight
