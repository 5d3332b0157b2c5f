// SPDX-License-Identifier: Apache-2.0
#include "image/split_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <rakelight/vector.h>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr std::size_t samples = 256;

/// Points of a disc: radius and direction, evenly (Hammersley 1960).
struct DiscPoint {
    double radius, x, y;
};

std::array<DiscPoint, samples> make_disc() {
    std::array<DiscPoint, samples> out;
    for (std::size_t i = 0; i < samples; ++i) {
        double turn = 0, digit = 0.5;
        for (std::size_t bits = i; bits != 0; bits >>= 1, digit /= 2) turn += double(bits & 1u) * digit;
        const double phi = 2 * pi * (turn + 0.5 / samples);
        out[i] = {std::sqrt((double(i) + 0.5) / samples), math::cos(phi), math::sin(phi)};
    }
    return out;
}

/// Smith's Lambda for GGX (Heitz 2014, eq. 72); cosine > 0.
double lambda(double cosine, double alpha2) {
    return (std::sqrt(1 + alpha2 * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
}

}  // namespace

AlbedoOfGloss albedo_of_gloss(double n_dot_v, double roughness) {
    static const std::array<DiscPoint, samples> disc = make_disc();
    const double alpha = std::max(roughness * roughness, 1e-4), alpha2 = alpha * alpha;
    const double cosine = std::clamp(n_dot_v, 1e-3, 1.0), sine = std::sqrt(1 - cosine * cosine);
    const dvec3 v{sine, 0, cosine}, stretched = normalize_or(dvec3{alpha * sine, 0, cosine}, {0, 0, 1});
    const dvec3 t{0, 1, 0}, b = cross(stretched, t);  // perpendicular: its y is 0
    const double lambda_v = lambda(cosine, alpha2), split = (1 + stretched.z) / 2;
    double scale = 0, bias = 0;
    for (const DiscPoint& p : disc) {
        const double p1 = p.radius * p.x;
        const double p2 = (1 - split) * std::sqrt(std::max(1 - p1 * p1, 0.0)) + split * p.radius * p.y;
        const dvec3 n = t * p1 + b * p2 + stretched * std::sqrt(std::max(1 - p1 * p1 - p2 * p2, 0.0));
        const dvec3 h = normalize_or(dvec3{alpha * n.x, alpha * n.y, std::max(n.z, 0.0)}, {0, 0, 1});
        const double v_dot_h = dot(v, h);
        const dvec3 l = h * (2 * v_dot_h) - v;
        if (!(l.z > 0)) continue;
        const double weight = (1 + lambda_v) / (1 + lambda_v + lambda(l.z, alpha2));  // G2 / G1
        const double m = std::clamp(1 - v_dot_h, 0.0, 1.0), fresnel = m * m * m * m * m;
        scale += (1 - fresnel) * weight;
        bias += fresnel * weight;
    }
    return {float(scale / samples), float(bias / samples)};
}

std::vector<float> split_sum_table(int size) {
    std::vector<float> out;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const AlbedoOfGloss a = albedo_of_gloss(double(column) / (size - 1), double(row) / (size - 1));
            out.push_back(a.scale);
            out.push_back(a.bias);
        }
    return out;
}

}  // namespace rakelight
