// SPDX-License-Identifier: Apache-2.0
// Discrete Fourier transform of any length, in double, without libm: the same bits everywhere.
#pragma once
#include <cstddef>
#include <vector>

namespace rakelight {

struct Complex {
    double re = 0, im = 0;
};
inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }

/// X_k = sum over j of x_j e^(-2 pi i j k / n). O(n times the sum of n's prime factors): Cooley & Tukey 1965, "An
/// Algorithm for the Machine Calculation of Complex Fourier Series".
class Fourier {
public:
    explicit Fourier(std::size_t n);  ///< >= 1
    /// @param in n values with a stride
    /// @param out  [n], not `in`
    void transform(const Complex* in, std::size_t stride, Complex* out) const { run(in, stride, out, n_, 1); }

private:
    void run(const Complex* in, std::size_t stride, Complex* out, std::size_t n, std::size_t step) const;
    void join(Complex* out, std::size_t parts, std::size_t size, std::size_t step) const;
    std::size_t n_;
    std::vector<Complex> turns_;  ///< e^(-2 pi i k / n)
};

/// The least length >= n (>= 1) that has no factor but 2, 3 and 5.
std::size_t good_fft_size(std::size_t n);

}  // namespace rakelight
