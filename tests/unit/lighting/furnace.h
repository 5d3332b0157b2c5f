// SPDX-License-Identifier: Apache-2.0
// Energy: what a surface sends out of a beam, by quadrature over the outgoing directions; n is +z, the tangent +x.
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {

inline constexpr double pi_d = 3.14159265358979323846;
inline constexpr double furnace_degrees[] = {0, 15, 30, 45, 60, 70, 80, 85, 88, 89, 89.5, 89.9};

struct Direction {
    double x, y, z;
};
inline vec3 to_float(Direction d) { return {float(d.x), float(d.y), float(d.z)}; }
inline Direction beam(double degrees_in) { return {std::sin(radians(degrees_in)), 0, std::cos(radians(degrees_in))}; }

/// Outgoing directions with the solid angle that each stands for.
struct Outgoing {
    std::vector<Direction> v;
    std::vector<double> solid_angle;
};

/// Rings and sectors: z and the share of the solid angle of ring i in 0..rings-1.
template <class Ring>
Outgoing rings_of(int rings, int sectors, Ring ring) {
    Outgoing out;
    for (int i = 0; i < rings; ++i) {
        const auto [z, width] = ring(i);
        const double s = std::sqrt(1 - z * z);
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2 * pi_d * (k + 0.5) / sectors;
            out.v.push_back({s * std::cos(phi), s * std::sin(phi), z});
            out.solid_angle.push_back(width * 2 * pi_d / sectors);
        }
    }
    return out;
}

/// Denser at the horizon.
inline Outgoing whole_hemisphere() {
    constexpr int rings = 192;
    return rings_of(rings, 128, [](int i) {
        const double q = (i + 0.5) / rings;
        return std::pair{q * q, 2 * q / rings};
    });
}

/// Rings of equal angles, for lobes about the normal.
inline Outgoing even_hemisphere() {
    constexpr int rings = 256;
    return rings_of(rings, 64, [](int i) {
        const double step = pi_d / 2 / rings;
        return std::pair{std::cos((i + 0.5) * step), std::cos(i * step) - std::cos((i + 1) * step)};
    });
}

/// Mirror directions of l on facets of slope tan theta = alpha q / (1 - q), q even in 0..1: dense where lobes as wide
/// as alpha are high, with room for their tails.
inline Outgoing about_the_mirror(Direction l, double alpha, int rings = 256, int sectors = 192) {
    Outgoing out;
    for (int i = 0; i < rings; ++i) {
        const double q = (i + 0.5) / rings, tangent = alpha * q / (1 - q);
        const double z = 1 / std::sqrt(1 + tangent * tangent), s = tangent * z;
        const double step = alpha / ((1 - q) * (1 - q)) * z * z / rings;  // d theta
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2 * pi_d * (k + 0.5) / sectors;
            const Direction h = {s * std::cos(phi), s * std::sin(phi), z};
            const double l_dot_h = l.x * h.x + l.y * h.y + l.z * h.z;
            const Direction v = {2 * l_dot_h * h.x - l.x, 2 * l_dot_h * h.y - l.y, 2 * l_dot_h * h.z - l.z};
            if (l_dot_h <= 0 || v.z <= 0) continue;
            out.v.push_back(v);
            out.solid_angle.push_back(4 * l_dot_h * s * step * 2 * pi_d / sectors);
        }
    }
    return out;
}

/// `like` seen from all of `out`, lit from l.
inline Items items_of(Direction l, const Outgoing& out, Item like) {
    Items items;
    like.l = to_float(l), like.p = {1, 0, 0};
    for (const Direction& v : out.v) {
        like.v = to_float(v);
        items.push(like);
    }
    return items;
}

/// Integral over `out` of a column of radiances or BRDFs times the cosine.
inline double integral(const std::vector<float>& column, const Outgoing& out) {
    double sum = 0;
    for (std::size_t i = 0; i < out.v.size(); ++i) sum += double(column[i]) * out.v[i].z * out.solid_angle[i];
    return sum;
}

/// Share of the light from l that a BRDF of lighting_operations.inc sends out.
inline double albedo(const char* operation, Direction l, const Outgoing& out, const Item& like) {
    Items items = items_of(l, out, like);
    return integral(run(scalar::kernel, operation, items)[0], out);
}

/// The same of the terms of light_terms(): k_d's or k_s's by what arrives.
inline double albedo(Choice choice, Direction l, const Outgoing& out, const Item& like) {
    Items items = items_of(l, out, like);
    const Results r = terms(scalar::kernel, items, choice);
    return integral(r[choice.model == lambert ? 3 : 6], out) / (pi_d * l.z);
}

inline Item widths(double ax, double ay) {
    Item item;
    item.ka = {float(ax), float(ay), 0};
    return item;
}

inline double ggx_albedo(double degrees_in, double alpha) {
    const Direction l = beam(degrees_in);
    return albedo("ggx_brdf", l, about_the_mirror(l, alpha), widths(alpha, alpha));
}

}  // namespace rakelight::lighting_test
