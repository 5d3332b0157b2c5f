// SPDX-License-Identifier: Apache-2.0
#include "image/compare/flip_color.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "math/functions.h"

namespace rakelight::flip {
namespace {

// Linear sRGB to XYZ relative to white, and back: from the primaries of BT.709 and D65 = (0.3127, 0.3290). Rows sum to
// 1.
constexpr double to_xyz[3][3] = {{0.43388734556603986, 0.3762240091374987, 0.1898886452964614},
                                 {0.21263900587151036, 0.7151686787677559, 0.07219231536073371},
                                 {0.01775004007097326, 0.10944762085523849, 0.8728023390737882}};
constexpr double to_rgb[3][3] = {{3.0803990906794647, -1.5373831775700935, -0.543015913109371},
                                 {-0.921223358860277, 1.8759675015077206, 0.0452558573525563},
                                 {0.052873938970364444, -0.20397695888897657, 1.151103019918612}};

dvec3 times(const double (&m)[3][3], dvec3 v) {
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/// Of 0.008 < x <= 1.01, to 1e-12. The exponent is divided by three in the float's bits (5 % off), then Halley's iteration twice, which
/// triples the digits. A pow() a channel would be two thirds of all the time.
double cube_root(double x) {
    double r = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2a9f7893782da1ceULL);
    for (int i = 0; i < 2; ++i) {
        const double cube = r * r * r;
        r = r * (cube + 2 * x) / (2 * cube + x);
    }
    return r;
}

double lab_curve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? cube_root(t) : t / (3 * delta * delta) + 4.0 / 29;
}

dvec3 lab_of_linear(dvec3 rgb) {
    const dvec3 xyz = times(to_xyz, rgb);
    const double x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z);
    const double lightness = 116 * y - 16, hunt = 0.01 * lightness;
    return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

/// Abasi, Amani Tehran, Fairchild 2019, "Distance metrics for very large color differences"; to the power of q_c.
double compressed_distance(dvec3 p, dvec3 q) {
    const double da = p.y - q.y, db = p.z - q.z;
    const double hyab = std::fabs(p.x - q.x) + std::sqrt(da * da + db * db);
    return hyab == 0 ? 0 : math::pow(hyab, 0.7);
}

}  // namespace

dvec3 opponent_from_linear(dvec3 rgb) {
    const dvec3 xyz = times(to_xyz, rgb);
    return {xyz.y, xyz.x - xyz.y, xyz.y - xyz.z};
}

dvec3 lab_of_opponent(dvec3 o) {
    const dvec3 rgb = times(to_rgb, {o.x + o.y, o.x, o.x - o.z});
    return lab_of_linear({std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0), std::clamp(rgb.z, 0.0, 1.0)});
}

double color_error(dvec3 lab_a, dvec3 lab_b) {
    constexpr double p_c = 0.4, p_t = 0.95;
    static const double largest = compressed_distance(lab_of_linear({0, 1, 0}), lab_of_linear({0, 0, 1}));
    const double distance = compressed_distance(lab_a, lab_b), knee = p_c * largest;
    if (distance < knee) return p_t / knee * distance;
    return std::min(1.0, p_t + (distance - knee) / (largest - knee) * (1 - p_t));
}

}  // namespace rakelight::flip
