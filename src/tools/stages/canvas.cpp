// SPDX-License-Identifier: Apache-2.0
#include "tools/stages/canvas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "image/draw_text.h"

namespace rakelight::stages {
namespace {

std::uint8_t code(double v) { return code_of(v); }

/// Liang & Barsky 1984: the part of a + t (b - a) with low <= coordinate <= high.
bool clip(double a, double b, double low, double high, double& t0, double& t1) {
    const double d = b - a;
    if (d == 0) return a >= low && a <= high;
    const double u = (low - a) / d, v = (high - a) / d;
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
    return t0 <= t1;
}

/// Calls visit(x, y) for the pixels of a line; parts outside are left out.
void walk(dvec2 a, dvec2 b, int width, int height, const auto& visit) {
    if (!std::isfinite(a.x) || !std::isfinite(a.y) || !std::isfinite(b.x) || !std::isfinite(b.y)) return;
    double t0 = 0, t1 = 1;
    if (!clip(a.x, b.x, 0, width, t0, t1) || !clip(a.y, b.y, 0, height, t0, t1)) return;
    const dvec2 d = {b.x - a.x, b.y - a.y};
    const dvec2 p = {a.x + d.x * t0, a.y + d.y * t0}, q = {a.x + d.x * t1, a.y + d.y * t1};
    const int steps = int(std::ceil(std::max(std::fabs(q.x - p.x), std::fabs(q.y - p.y))));
    for (int i = 0; i <= steps; ++i) {
        const double t = steps == 0 ? 0 : double(i) / steps;
        const int x = int(std::floor(p.x + (q.x - p.x) * t)), y = int(std::floor(p.y + (q.y - p.y) * t));
        // Ends lie on the far border, and by rounding a little outside of the near one.
        if (x >= 0 && y >= 0 && x < width && y < height) visit(x, y);
    }
}

}  // namespace

Canvas::Canvas(int width, int height, Code ground) {
    pixels_.width = width;
    pixels_.height = height;
    pixels_.channels = 3;
    pixels_.bytes.resize(pixels_.row_bytes() * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) set(x, y, ground);
}

void Canvas::set(int x, int y, Code c) {
    if (x < 0 || y < 0 || x >= pixels_.width || y >= pixels_.height) return;
    std::byte* const at = pixels_.row(y) + 3 * std::size_t(x);
    at[0] = std::byte(c.r), at[1] = std::byte(c.g), at[2] = std::byte(c.b);
}

Code Canvas::at(int x, int y) const {
    const std::byte* const from = pixels_.row(y) + 3 * std::size_t(x);
    return {std::uint8_t(from[0]), std::uint8_t(from[1]), std::uint8_t(from[2])};
}

void Canvas::line(dvec2 a, dvec2 b, Code color) {
    walk(a, b, pixels_.width, pixels_.height, [&](int x, int y) { set(x, y, color); });
}

void Canvas::fill(dvec2 a, dvec2 b, dvec2 c, Code color) {
    const dvec2 corner[3] = {a, b, c};
    for (const dvec2& p : corner)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    const double top = std::max(0.0, std::min({a.y, b.y, c.y})),
                 bottom = std::min(double(pixels_.height), std::max({a.y, b.y, c.y}));
    for (int y = int(std::ceil(top - 0.5)); y + 0.5 < bottom; ++y) {
        double left = pixels_.width, right = 0;
        for (int k = 0; k < 3; ++k) {  // where the row of centers meets the edges
            dvec2 p = corner[k], q = corner[(k + 1) % 3];
            if ((p.y <= y + 0.5) == (q.y <= y + 0.5)) continue;
            if (p.y > q.y) std::swap(p, q);  // the same number for both triangles of an edge
            const double x = p.x + (q.x - p.x) * ((y + 0.5 - p.y) / (q.y - p.y));
            left = std::min(left, x);
            right = std::max(right, x);
        }
        left = std::max(left, 0.0);
        right = std::min(right, double(pixels_.width));
        for (int x = int(std::ceil(left - 0.5)); x + 0.5 < right; ++x) set(x, y, color);
    }
}

void Canvas::write(int x, int y, std::string_view text, Code color, Align align) {
    const int width = text_width(text, letter_dot);
    const int left = align == Align::left ? x : align == Align::center ? x - width / 2 : x - width;
    draw_text(pixels_, left, y, text, {.color = color, .scale = letter_dot});
}

LineCounts::LineCounts(int width, int height)
    : width_(width), height_(height), counts_(std::size_t(width) * std::size_t(height), 0) {}

void LineCounts::line(dvec2 a, dvec2 b) {
    walk(a, b, width_, height_,
         [&](int x, int y) { ++counts_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; });
}

double LineCounts::mean() const {
    std::uint64_t lines = 0, pixels = 0;
    for (const std::uint32_t n : counts_) lines += n, pixels += n > 0;
    return pixels > 0 ? double(lines) / double(pixels) : 0;
}

double LineCounts::often() const {
    std::vector<std::uint32_t> counts;
    std::copy_if(counts_.begin(), counts_.end(), std::back_inserter(counts), [](std::uint32_t n) { return n > 0; });
    if (counts.empty()) return 1;
    const auto at = counts.begin() + std::ptrdiff_t(counts.size() - 1 - counts.size() / 50);
    std::nth_element(counts.begin(), at, counts.end());
    return double(*at);
}

void LineCounts::draw(Canvas& canvas, Code color) const {
    const bool all_alike = !is_crowded();
    const double full = often();
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const std::uint32_t n = counts_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
            if (n == 0) continue;
            const double share = all_alike ? 1 : std::min(1.0, 0.1 + 0.9 * std::sqrt(double(n) / full));
            const Code under = canvas.at(x, y);
            const auto mix = [&](std::uint8_t a, std::uint8_t b) {
                return std::uint8_t(std::lround(double(a) + (double(b) - double(a)) * share));
            };
            canvas.set(x, y, {mix(under.r, color.r), mix(under.g, color.g), mix(under.b, color.b)});
        }
}

Code gray(double v) { return {code(v), code(v), code(v)}; }

Code color_of_normal(vec3 n) {
    return {code(double(n.x) * 0.5 + 0.5), code(double(n.y) * 0.5 + 0.5), code(double(n.z) * 0.5 + 0.5)};
}

}  // namespace rakelight::stages
