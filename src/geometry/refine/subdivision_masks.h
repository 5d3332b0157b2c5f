// SPDX-License-Identifier: Apache-2.0
// The weights of Loop's and Catmull and Clark's schemes that depend on the number of faces at a vertex.
//
// Sources: Loop 1987, "Smooth Subdivision Surfaces Based on Triangles"; Halstead, Kass & DeRose 1993, "Efficient, Fair
// Interpolation using Catmull-Clark Surfaces" (limit point and tangents); Hoppe et al. 1994, "Piecewise Smooth Surface
// Reconstruction" (creases). The weights across a crease are the eigenvector of the very rules that are used here,
// which for other than regular vertices are not those of Biermann, Levin & Zorin 2000.
#pragma once
#include <cmath>

#include <rakelight/math/vector.h>

#include "math/functions.h"

namespace rakelight::geometry {

/// Of one neighbor, when an inner vertex with n of them moves; the vertex itself keeps 1 - n times that. Loop 1987.
inline double loop_beta(int n) {
    const double t = 0.375 + 0.25 * math::cos(2 * pi / n);
    return (0.625 - t * t) / n;
}

/// Of one neighbor in the limit point of an inner vertex; the vertex itself has 1 - n times that. Loop 1987.
inline double loop_limit_weight(int n) { return 1 / (n + 3 / (8 * loop_beta(n))); }

/// Of edge i in the limit tangents of an inner vertex, times cos(i phi) and sin(i phi), where a face between the edges
/// i and i + 1 has the sum of their cosines and sines; phi = 2 pi / n. Halstead et al. 1993, appendix A.
inline double catmull_clark_edge_weight(int n) {
    const double c = math::cos(2 * pi / n), half = math::cos(pi / n);
    return 1 + c + half * std::sqrt(2 * (9 + c));
}

/// The vector across a crease or boundary, into a smooth sector of k >= 2 faces whose edges are 0..k: weights of the
/// first and the last edge, of edge i in units of sin(i theta), of the face between the edges i - 1 and i in units of
/// sin((i - 1/2) theta), for differences from the vertex; theta = pi / k.
struct AcrossWeights {
    double ends, edge, face;
};

/// Left eigenvector of the largest eigenvalue but 1 that is even about the sector's middle. With l the eigenvalue, the
/// inner edges obey x_i' = 3/8 x_i + (x_i-1 + x_i+1) / 8 - (x_0 + x_k) / 8, the ends x' = x / 2 - (x_0 + x_k) / 8.
inline AcrossWeights loop_across_weights(int k) {
    const double theta = pi / k, c = math::cos(theta), s = math::sin(theta);
    return {-c * (1 + c) / (s * (1 + 2 * c)), 1, 0};
}

/// The same for quads, whose far corners have weights too.
inline AcrossWeights catmull_clark_across_weights(int k) {
    const double theta = pi / k, c = math::cos(theta), half = math::cos(theta / 2), half_sine = math::sin(theta / 2);
    const double eigenvalue = (5 + c + half * std::sqrt(2 * (9 + c))) / 16;
    const double face = half / (8 * (eigenvalue - 0.25));
    const double into_end = math::sin(theta) / 16 + face * half_sine / 4;
    const double sum = half / half_sine + face / half_sine;  // of all inner weights
    return {(into_end - sum / 8) / (eigenvalue - 0.25), 1, face};
}

}  // namespace rakelight::geometry
