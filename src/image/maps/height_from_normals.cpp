// SPDX-License-Identifier: Apache-2.0
#include "image/maps/height_from_normals.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <rakelight/math/vector.h>

#include "image/convert.h"
#include "image/maps/fourier.h"
#include "math/flush_denormals.h"

namespace rakelight {
namespace {

constexpr int largest_side = 2048;
constexpr double steepest = 20;

/// Real: change of height to the right, imaginary: downwards, per texel. Row by row.
struct Slopes {
    std::size_t width = 0, height = 0;
    std::vector<Complex> values;
    MemoryCharge charge{};
};

Slopes slopes_of(const Pixels& normals, bool green_down, Context& context) {
    Slopes s{std::size_t(normals.width), std::size_t(normals.height), {}};
    const std::size_t largest = std::max(s.width * s.height, good_fft_size(s.width) * good_fft_size(s.height));
    s.charge = MemoryCharge(context.memory(), largest * sizeof(Complex) * 2,
                            "height map");  // input and output of every step
    const MemoryCharge texels_charge(context.memory(), s.width * s.height * sizeof(vec4), "height map");
    s.values.resize(s.width * s.height);
    const std::vector<vec4> texels = to_rgba32f(normals, ColorSpace::linear, context);
    context.parallel_for(s.height, [&](std::size_t y) {
        const FlushDenormals guard;
        for (std::size_t i = y * s.width; i < (y + 1) * s.width; ++i) {
            const double x = 2 * double(texels[i].x) - 1, up = (2 * double(texels[i].y) - 1) * (green_down ? -1 : 1);
            const double z = std::max(2 * double(texels[i].z) - 1, 1e-3);
            s.values[i] = {std::clamp(-x / z, -steepest, steepest), std::clamp(up / z, -steepest, steepest)};
        }
    });
    return s;
}

/// Half the size: a texel is twice as wide, so height differences per texel double.
Slopes halved(const Slopes& s, const Context& context) {
    Slopes to{std::max<std::size_t>(s.width / 2, 1), std::max<std::size_t>(s.height / 2, 1), {}};
    to.values.resize(to.width * to.height);
    for (std::size_t y = 0; y < to.height; ++y) {
        context.throw_if_cancelled();
        for (std::size_t x = 0; x < to.width; ++x) {
            Complex sum;
            for (std::size_t k = 0; k < 4; ++k)
                sum = sum +
                      s.values[std::min(2 * y + k / 2, s.height - 1) * s.width + std::min(2 * x + k % 2, s.width - 1)];
            to.values[y * to.width + x] = {sum.re * 0.5, sum.im * 0.5};
        }
    }
    return to;
}

/// Interpolation between two texels of a periodic row or column.
struct Between {
    std::size_t low, high;
    double share;
};
Between between(std::size_t i, std::size_t from, std::size_t to) {
    const double at = (double(i) + 0.5) * double(from) / double(to) + double(from) - 0.5, whole = std::floor(at);
    return {std::size_t(whole) % from, (std::size_t(whole) + 1) % from, at - whole};
}

/// Resampled linearly to sizes with a fast transform. Texels are narrower, so height differences per texel decrease.
Slopes with_friendly_sides(Slopes s, const Context& context) {
    Slopes to{good_fft_size(s.width), good_fft_size(s.height), {}};
    if (to.width == s.width && to.height == s.height) return s;
    to.values.resize(to.width * to.height);
    const double x_scale = double(s.width) / double(to.width), y_scale = double(s.height) / double(to.height);
    for (std::size_t y = 0; y < to.height; ++y) {
        context.throw_if_cancelled();
        for (std::size_t x = 0; x < to.width; ++x) {
            const Between u = between(x, s.width, to.width), v = between(y, s.height, to.height);
            const auto row = [&](std::size_t r) {
                const Complex a = s.values[r * s.width + u.low], b = s.values[r * s.width + u.high];
                return Complex{a.re + (b.re - a.re) * u.share, a.im + (b.im - a.im) * u.share};
            };
            const Complex a = row(v.low), b = row(v.high);
            to.values[y * to.width + x] = {(a.re + (b.re - a.re) * v.share) * x_scale,
                                           (a.im + (b.im - a.im) * v.share) * y_scale};
        }
    }
    return to;
}

/// The transform of both axes, in place.
void transform(Slopes& s, Context& context) {
    const Fourier along_rows(s.width), along_columns(s.height);
    context.parallel_for(s.height, [&](std::size_t y) {
        const FlushDenormals guard;
        std::vector<Complex> row(s.width);
        along_rows.transform(s.values.data() + y * s.width, 1, row.data());
        std::copy(row.begin(), row.end(), s.values.begin() + std::ptrdiff_t(y * s.width));
    });
    context.parallel_for(s.width, [&](std::size_t x) {
        const FlushDenormals guard;
        std::vector<Complex> column(s.height);
        along_columns.transform(s.values.data() + x, s.width, column.data());
        for (std::size_t y = 0; y < s.height; ++y) s.values[y * s.width + x] = column[y];
    });
}

/// [rad per texel] of the k-th of n frequencies; 0 for the Nyquist frequency, which has no direction.
double frequency(std::size_t k, std::size_t n) {
    if (2 * k == n) return 0;
    return 2 * pi * (2 * k < n ? double(k) : double(k) - double(n)) / double(n);
}

/// Transformed slopes -> the conjugate of the transformed heights.
void divide(Slopes& s, const Context& context) {
    std::vector<Complex> heights(s.values.size());
    for (std::size_t y = 0; y < s.height; ++y) {
        context.throw_if_cancelled();
        for (std::size_t x = 0; x < s.width; ++x) {
            const Complex z = s.values[y * s.width + x];
            const Complex opposite = s.values[(s.height - y) % s.height * s.width + (s.width - x) % s.width];
            const Complex p = {(z.re + opposite.re) / 2, (z.im - opposite.im) / 2};  // what the real parts were
            const Complex q = {(z.im + opposite.im) / 2, (opposite.re - z.re) / 2};  // what the imaginary ones were
            const double u = frequency(x, s.width), v = frequency(y, s.height), square = u * u + v * v;
            if (square == 0) continue;
            const Complex sum = {(u * p.re + v * q.re) / square, (u * p.im + v * q.im) / square};
            heights[y * s.width + x] = {sum.im, sum.re};  // conjugate of -i sum
        }
    }
    s.values = std::move(heights);
}

Pixels gray(const Slopes& heights, double low, double range) {
    Pixels out;
    out.width = int(heights.width), out.height = int(heights.height);
    out.channels = 1;
    out.component = Component::u16;
    out.bytes.resize(heights.values.size() * 2);
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const double share = range > 0 ? (heights.values[i].re - low) / range : 1;
        const auto code = std::uint16_t(std::clamp(share, 0.0, 1.0) * 65535 + 0.5);
        std::memcpy(out.bytes.data() + 2 * i, &code, 2);
    }
    return out;
}

}  // namespace

HeightsFromNormals heights_from_normals(const Pixels& normals, bool green_down, Context& context) {
    if (normals.width <= 0 || normals.height <= 0) return {};
    Slopes s = slopes_of(normals, green_down, context);
    const MemoryCharge charge = std::move(s.charge);
    while (s.width > largest_side || s.height > largest_side) s = halved(s, context);
    s = with_friendly_sides(std::move(s), context);
    transform(s, context);
    divide(s, context);
    transform(s, context);  // of the conjugate: n times the conjugate of the heights, which are real
    const auto [low, high] = std::minmax_element(s.values.begin(), s.values.end(),
                                                 [](const Complex& a, const Complex& b) { return a.re < b.re; });
    const double bottom = low->re, range = high->re - bottom;
    const double depth = range / double(s.values.size()) / double(normals.width);  // heights count texels of the map
    const bool is_flat = depth < 1e-6;
    SharedCharge heights = share(MemoryCharge(context.memory(), s.values.size() * sizeof(std::uint16_t), "height map"));
    HeightsFromNormals out{gray(s, bottom, is_flat ? 0 : range), is_flat ? 0 : depth};
    out.heights.charge = std::move(heights);
    return out;
}

}  // namespace rakelight
