// SPDX-License-Identifier: Apache-2.0
// Shapes with hard and soft edges by construction: polygons of surfaces, welded after their points were rounded.
#pragma once
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "unit/geometry/shapes.h"

namespace rakelight::test {

/// Edges between faces of one surface are meant soft, all others hard.
struct HardShape {
    Shape shape;
    std::vector<int> surface;  ///< [T]
};

class HardBuilder {
public:
    /// @param step  points are rounded to multiples of it; 0: not
    explicit HardBuilder(double step = 0, double turn_rad = 0) : step_(step), turn_(turn_rad) {}

    void polygon(const std::vector<dvec3>& points, int surface) {
        std::vector<std::uint32_t> ring;
        for (const dvec3 p : points)
            if (const std::uint32_t v = vertex(p); ring.empty() || ring.back() != v) ring.push_back(v);
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            if (ring[0] == ring[i + 1]) continue;
            out_.shape.indices.insert(out_.shape.indices.end(), {ring[0], ring[i], ring[i + 1]});
            out_.surface.push_back(surface);
        }
    }
    /// Quads between two rings; `apart`: each is a surface.
    void wall(const std::vector<dvec3>& a, const std::vector<dvec3>& b, int surface, bool apart = false) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const std::size_t j = (i + 1) % a.size();
            polygon({a[i], a[j], b[j], b[i]}, apart ? surface + int(i) : surface);
        }
    }
    void cap(std::vector<dvec3> ring, int surface, bool up) {
        dvec3 center;
        for (const dvec3 p : ring) center += p / double(ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
            polygon({center, up ? a : b, up ? b : a}, surface);
        }
    }
    HardShape take() { return std::move(out_); }

private:
    std::uint32_t vertex(dvec3 p) {
        p = {p.x * std::cos(turn_) - p.y * std::sin(turn_), p.x * std::sin(turn_) + p.y * std::cos(turn_), p.z};
        if (step_ > 0)
            p = {step_ * std::round(p.x / step_), step_ * std::round(p.y / step_), step_ * std::round(p.z / step_)};
        const vec3 q{float(p.x) + 0.0f, float(p.y) + 0.0f, float(p.z) + 0.0f};
        const auto [at, is_new] = number_.try_emplace({q.x, q.y, q.z}, std::uint32_t(out_.shape.positions.size()));
        if (is_new) out_.shape.positions.push_back(q);
        return at->second;
    }

    double step_, turn_;
    std::map<std::tuple<float, float, float>, std::uint32_t> number_;
    HardShape out_;
};

inline std::vector<dvec3> circle(int sides, double radius, double height) {
    std::vector<dvec3> ring;
    for (int i = 0; i < sides; ++i) {
        const double a = 2 * pi * i / sides;
        ring.push_back({radius * std::cos(a), radius * std::sin(a), height});
    }
    return ring;
}

inline HardShape make_column(int sides, bool flat, double step = 0, double turn_rad = 0) {
    HardBuilder b(step, turn_rad);
    b.wall(circle(sides, 1, 0), circle(sides, 1, 2), 0, flat);
    b.cap(circle(sides, 1, 0), 1000, false);
    b.cap(circle(sides, 1, 2), 1001, true);
    return b.take();
}

/// A hexagon outside, a hole of 24 sides inside.
inline HardShape make_nut(double step, double turn_rad) {
    HardBuilder b(step, turn_rad);
    constexpr int per_side = 4;
    for (const double z : {0.0, 0.8}) {
        const std::vector<dvec3> outer = circle(6, 1, z), inner = circle(6 * per_side, 0.55, z);
        const auto face = [&](dvec3 p, dvec3 q, dvec3 r) {
            if (z > 0)
                b.polygon({p, q, r}, 100);
            else
                b.polygon({r, q, p}, 101);
        };
        for (int j = 0; j < 6; ++j) {
            const auto in = [&](int m) { return inner[std::size_t(j * per_side + m) % inner.size()]; };
            const dvec3 o = outer[std::size_t(j)], next = outer[std::size_t(j + 1) % 6];
            for (int m = 0; m < per_side; ++m) face(m < per_side / 2 ? o : next, in(m + 1), in(m));
            face(o, next, in(per_side / 2));
        }
    }
    b.wall(circle(6, 1, 0), circle(6, 1, 0.8), 0, true);
    b.wall(circle(6 * per_side, 0.55, 0.8), circle(6 * per_side, 0.55, 0), 50);
    return b.take();
}

/// A closed profile of points in x and y, convex, drawn along z. @param ids  [points] surface of the side from each
inline HardShape extrude(const std::vector<dvec2>& profile, const std::vector<int>& ids, double height,
                         double step = 0) {
    HardBuilder b(step);
    std::vector<dvec3> low, high;
    for (const dvec2 p : profile) low.push_back({p.x, p.y, 0}), high.push_back({p.x, p.y, height});
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        b.polygon({low[i], low[j], high[j], high[i]}, ids[i]);
    }
    b.cap(low, 1000, false);
    b.cap(high, 1001, true);
    return b.take();
}

/// A square with corners of a radius in strips, drawn along z.
inline HardShape make_fillets(int strips, double radius, double step = 0) {
    std::vector<dvec2> profile;
    const double c = 1 - radius;
    const dvec2 centers[] = {{c, c}, {-c, c}, {-c, -c}, {c, -c}};
    for (int q = 0; q < 4; ++q)
        for (int i = 0; i <= strips; ++i) {
            const double a = pi / 2 * (q + double(i) / strips);
            profile.push_back({centers[q].x + radius * std::cos(a), centers[q].y + radius * std::sin(a)});
        }
    return extrude(profile, std::vector<int>(profile.size(), 0), 1.5, step);
}

/// A cube of size 2 whose 12 edges are cut off at 45 degrees. Every face is a surface.
inline HardShape make_chamfered_box(double chamfer) {
    HardBuilder b;
    int surface = 0;
    const double c = 1 - chamfer;
    const auto at = [](std::size_t axis, double s, double p, double q) {
        dvec3 v;
        v[axis] = s, v[(axis + 1) % 3] = p, v[(axis + 2) % 3] = q;
        return v;
    };
    const auto face = [&](std::vector<dvec3> points) {
        dvec3 middle;
        for (const dvec3 p : points) middle += p;
        if (dot(cross(points[1] - points[0], points[2] - points[0]), middle) < 0)
            points = std::vector<dvec3>(points.rbegin(), points.rend());
        b.polygon(points, surface++);
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double s : {-1.0, 1.0}) {
            face({at(axis, s, c, c), at(axis, s, -c, c), at(axis, s, -c, -c), at(axis, s, c, -c)});
            for (const double p : {-1.0, 1.0}) {  // the edge between +-axis and +-the next axis
                const std::size_t next = (axis + 1) % 3;
                const auto side = [&](double along) { return at(axis, s, p * c, along); };
                const auto other = [&](double along) { return at(next, p, along, s * c); };
                face({side(-c), side(c), other(c), other(-c)});
            }
        }
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) face({{x, y * c, z * c}, {x * c, y, z * c}, {x * c, y * c, z}});
    return b.take();
}

inline HardShape make_gear(double step) {
    std::vector<dvec2> profile;
    std::vector<int> ids;
    for (int k = 0; k < 12; ++k)
        for (const auto& [turn, radius] : {std::pair(-0.30, 0.8), {-0.14, 1.0}, {0.14, 1.0}, {0.30, 0.8}}) {
            const double a = 2 * pi * (k + turn) / 12;
            profile.push_back({radius * std::cos(a), radius * std::sin(a)});
            ids.push_back(int(ids.size()));
        }
    return extrude(profile, ids, 0.4, step);
}

/// One of each kind.
inline std::vector<HardShape> all_shapes() {
    return {make_nut(1e-3, 0.1), make_gear(1e-2), make_fillets(4, 0.2), make_chamfered_box(0.15),
            make_column(9, false)};
}

}  // namespace rakelight::test
