// SPDX-License-Identifier: Apache-2.0
#include "image/compare/flip_kernels.h"

#include <cmath>
#include <cstddef>

#include "math/functions.h"

namespace rakelight::flip {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A term of a contrast sensitivity function: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
struct Term {
    double a, b;
};
constexpr Term achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow[2] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double widest = 0.04;  ///< the largest b: all filters get its radius

/// Scales positive and negative weights, each to a sum of 1.
Kernel normalized(const std::vector<double>& weights) {
    double positive = 0, negative = 0;
    for (const double w : weights) (w > 0 ? positive : negative) += std::fabs(w);
    Kernel kernel;
    for (const double w : weights) kernel.push_back(w > 0 ? w / positive : w == 0 ? 0 : w / negative);
    return kernel;
}

std::vector<double> gaussian(double b, int radius, double pixels_per_degree) {
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        weights.push_back(math::exp(-pi * pi * x * x / b));
    }
    return weights;
}

double sum_of(const std::vector<double>& weights) {
    double sum = 0;
    for (const double w : weights) sum += w;
    return sum;
}

}  // namespace

ContrastKernels contrast_kernels(double pixels_per_degree) {
    ContrastKernels k;
    k.radius = int(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
    const auto weights = [&](const Term& term) { return gaussian(term.b, k.radius, pixels_per_degree); };
    k.achromatic = normalized(weights(achromatic));
    k.red_green = normalized(weights(red_green));
    double volume[2];
    for (int i = 0; i < 2; ++i) {
        const std::vector<double> w = weights(blue_yellow[i]);
        k.blue_yellow[i] = normalized(w);
        volume[i] = blue_yellow[i].a * std::sqrt(pi / blue_yellow[i].b) * sum_of(w) * sum_of(w);
    }
    for (int i = 0; i < 2; ++i) k.blue_yellow_share[i] = volume[i] / (volume[0] + volume[1]);
    return k;
}

FeatureKernels feature_kernels(double pixels_per_degree) {
    constexpr double width_deg = 0.082;
    const double sigma = 0.5 * width_deg * pixels_per_degree;
    FeatureKernels k;
    k.radius = int(std::ceil(3 * sigma));
    std::vector<double> bell, first, second;
    for (int x = -k.radius; x <= k.radius; ++x) {
        const double square = double(x) * x / (sigma * sigma);
        bell.push_back(math::exp(-0.5 * square));
        first.push_back(-x * bell.back());
        second.push_back((square - 1) * bell.back());
    }
    k.gaussian = normalized(bell);
    k.edge = normalized(first);
    k.point = normalized(second);
    return k;
}

}  // namespace rakelight::flip
