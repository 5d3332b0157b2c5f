// SPDX-License-Identifier: Apache-2.0
#include "image/maps/fourier.h"

#include <rakelight/math/vector.h>

#include "math/functions.h"

namespace rakelight {
namespace {

std::size_t smallest_factor(std::size_t n) {
    for (std::size_t f = 2; f * f <= n; ++f)
        if (n % f == 0) return f;
    return n;
}

}  // namespace

std::size_t good_fft_size(std::size_t n) {
    for (;; ++n) {
        std::size_t rest = n;
        for (const std::size_t factor : {2u, 3u, 5u})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return n;
    }
}

Fourier::Fourier(std::size_t n) : n_(n), turns_(n) {
    for (std::size_t k = 0; k < n; ++k) {
        const double angle = -2 * pi * double(k) / double(n);
        turns_[k] = {math::cos(angle), math::sin(angle)};
    }
}

void Fourier::run(const Complex* in, std::size_t stride, Complex* out, std::size_t n, std::size_t step) const {
    if (n == 1) {
        *out = *in;
        return;
    }
    const std::size_t parts = smallest_factor(n), size = n / parts;
    for (std::size_t p = 0; p < parts; ++p) run(in + p * stride, stride * parts, out + p * size, size, step * parts);
    join(out, parts, size, step);
}

/// Combines `parts` transforms of `size` interleaved values to one.
void Fourier::join(Complex* out, std::size_t parts, std::size_t size, std::size_t step) const {
    if (parts == 2) {
        for (std::size_t k = 0; k < size; ++k) {
            const Complex a = out[k], b = out[size + k] * turns_[k * step];
            out[k] = a + b;
            out[size + k] = {a.re - b.re, a.im - b.im};
        }
        return;
    }
    std::vector<Complex> column(parts);
    for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t p = 0; p < parts; ++p) column[p] = out[p * size + k] * turns_[p * k * step % n_];
        for (std::size_t q = 0; q < parts; ++q) {
            Complex sum;
            for (std::size_t p = 0; p < parts; ++p) sum = sum + column[p] * turns_[p * q * size * step % n_];
            out[q * size + k] = sum;
        }
    }
}

}  // namespace rakelight
