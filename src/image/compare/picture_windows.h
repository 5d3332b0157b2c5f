// SPDX-License-Identifier: Apache-2.0
// Means over a picture processed in windows, with separable filters in each: memory for one window per thread, and sums
// in an order that no number of threads changes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <rakelight/base/context.h>

namespace rakelight {

/// A rectangle of pixels of a result.
struct PictureWindow {
    int x = 0, y = 0, width = 0, height = 0;  ///< [px]
};

inline constexpr int window_width = 256, window_height = 128;  ///< [px] what is filtered of it stays in the L2 cache

/// The sum of sum_of(window) over windows that tile width * height, added in the order of rows of windows.
template <class SumOf>
double sum_over_windows(int width, int height, Context& context, const SumOf& sum_of) {
    const std::size_t across = std::size_t((width + window_width - 1) / window_width);
    const std::size_t down = std::size_t((height + window_height - 1) / window_height);
    std::vector<double> sums(across * down, 0);
    context.parallel_for(sums.size(), [&](std::size_t i) {
        const int x = int(i % across) * window_width, y = int(i / across) * window_height;
        sums[i] = sum_of(PictureWindow{x, y, std::min(window_width, width - x), std::min(window_height, height - y)});
    });
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum;
}

/// One value per pixel, row by row.
template <class Number>
struct Plane {
    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    int width = 0, height = 0;
    std::vector<Number> values{};

    Number* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
    const Number* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
};

/// to[x] = sum of kernel[k] * from(k)[x]. Four terms at a time: with one, reading and writing `to` takes most of the time.
template <class Number, class From>
void weighted_sum(const From& from, std::span<const Number> kernel, int count, Number* __restrict to) {
    std::size_t k = 0;
    for (; k + 4 <= kernel.size(); k += 4) {
        const Number *const a = from(k), *const b = from(k + 1), *const c = from(k + 2), *const d = from(k + 3);
        const Number p = kernel[k], q = kernel[k + 1], r = kernel[k + 2], s = kernel[k + 3];
        for (int x = 0; x < count; ++x) to[x] += (p * a[x] + q * b[x]) + (r * c[x] + s * d[x]);
    }
    for (; k < kernel.size(); ++k) {
        const Number* const a = from(k);
        for (int x = 0; x < count; ++x) to[x] += kernel[k] * a[x];
    }
}

/// out(x, y) = sum of kernel[k] * in(x + k, y); narrower by kernel.size() - 1.
template <class Number>
Plane<Number> filter_rows(const Plane<Number>& in, std::span<const Number> kernel) {
    Plane<Number> out(in.width - int(kernel.size()) + 1, in.height);
    for (int y = 0; y < out.height; ++y)
        weighted_sum([&](std::size_t k) { return in.row(y) + k; }, kernel, out.width, out.row(y));
    return out;
}

/// out(x, y) = sum of kernel[k] * in(x, y + k); lower by kernel.size() - 1.
template <class Number>
Plane<Number> filter_columns(const Plane<Number>& in, std::span<const Number> kernel) {
    Plane<Number> out(in.width, in.height - int(kernel.size()) + 1);
    for (int y = 0; y < out.height; ++y)
        weighted_sum([&](std::size_t k) { return in.row(y + int(k)); }, kernel, out.width, out.row(y));
    return out;
}

}  // namespace rakelight
