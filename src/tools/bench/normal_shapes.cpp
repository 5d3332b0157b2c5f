// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/normal_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {

double Random::normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += next();
    return sum;
}

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

void add_square(KnownSurface& s, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                bool other_diagonal) {
    if (other_diagonal)
        s.triangles.push_back({a, b, d}), s.triangles.push_back({b, c, d});
    else
        s.triangles.push_back({a, b, c}), s.triangles.push_back({a, c, d});
}

dvec3 on_sphere(dvec3 p) { return normalize_or(p, dvec3{0, 0, 1}); }

}  // namespace

void orient(KnownSurface& s) {
    for (auto& t : s.triangles) {
        const dvec3 a = s.positions[t[0]], product = cross(s.positions[t[1]] - a, s.positions[t[2]] - a);
        if (dot(product, s.normals[t[0]] + s.normals[t[1]] + s.normals[t[2]]) < 0) std::swap(t[1], t[2]);
    }
}

KnownSurface uv_sphere(std::uint32_t columns, std::uint32_t rows) {
    KnownSurface s;
    s.positions.push_back({0, 0, 1});
    for (std::uint32_t j = 1; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double polar = pi * j / rows, turn = 2 * pi * i / columns;
            s.positions.push_back(
                {math::sin(polar) * math::cos(turn), math::sin(polar) * math::sin(turn), math::cos(polar)});
        }
    s.positions.push_back({0, 0, -1});
    const auto last = std::uint32_t(s.positions.size() - 1), below = last - columns;
    for (std::uint32_t i = 0; i < columns; ++i) {
        const std::uint32_t next = (i + 1) % columns;
        s.triangles.push_back({0, 1 + i, 1 + next});
        for (std::uint32_t j = 0; j + 2 < rows; ++j) {
            const std::uint32_t a = 1 + j * columns;
            add_square(s, a + i, a + columns + i, a + columns + next, a + next, true);
        }
        s.triangles.push_back({below + next, below + i, last});
    }
    s.normals = s.positions;
    return s;
}

KnownSurface known_torus(std::uint32_t columns, std::uint32_t rows, double jitter, Random& random) {
    KnownSurface s;
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const double u = 2 * pi * (i + random.within(-jitter, jitter)) / columns,
                         v = 2 * pi * (j + random.within(-jitter, jitter)) / rows;
            const dvec3 n{math::cos(v) * math::cos(u), math::cos(v) * math::sin(u), math::sin(v)};
            s.positions.push_back(dvec3{math::cos(u), math::sin(u), 0} + n * 0.4);
            s.normals.push_back(n);
        }
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const std::uint32_t next = (i + 1) % columns, above = (j + 1) % rows;
            add_square(s, i * rows + j, next * rows + j, next * rows + above, i * rows + above, random.next() < 0.5);
        }
    orient(s);
    return s;
}

KnownSurface icosphere(int levels) {
    KnownSurface s;
    const double t = (1 + std::sqrt(5.0)) / 2;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-t, t})
            for (const dvec3 p : {dvec3{a, b, 0}, dvec3{0, a, b}, dvec3{b, 0, a}}) s.positions.push_back(on_sphere(p));
    const double edge = 2 / std::sqrt(1 + t * t);
    const auto touch = [&](std::uint32_t a, std::uint32_t b) {
        return length(s.positions[a] - s.positions[b]) < 1.01 * edge;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c)
                if (touch(a, b) && touch(b, c) && touch(c, a)) s.triangles.push_back({a, b, c});
    Random all(0);
    return refined_sphere(std::move(s), levels, 2, all);
}

namespace {

/// Three triangles and the new points at the middles of edges, where there are any.
class Refinement {
public:
    explicit Refinement(KnownSurface& s) : s_(s) {}
    void cut_all_edges(const std::array<std::uint32_t, 3>& t) {
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edge_of(t[std::size_t(k)], t[std::size_t(k + 1) % 3]);
            const auto [at, is_new] = middle_.try_emplace(edge, std::uint32_t(s_.positions.size()));
            if (is_new) s_.positions.push_back(on_sphere(s_.positions[edge.first] + s_.positions[edge.second]));
        }
    }
    void replace(const std::array<std::uint32_t, 3>& t, std::vector<std::array<std::uint32_t, 3>>& out) const {
        std::uint32_t middles[3];
        int count = 0, which = 0, other = 0;
        for (int k = 0; k < 3; ++k) {
            const auto at = middle_.find(edge_of(t[std::size_t(k)], t[std::size_t(k + 1) % 3]));
            middles[k] = at == middle_.end() ? none : at->second;
            if (middles[k] == none)
                other = k;
            else
                ++count, which = k;
        }
        if (count == 0) return out.push_back(t);
        if (count == 3) {
            for (int k = 0; k < 3; ++k) out.push_back({t[std::size_t(k)], middles[k], middles[(k + 2) % 3]});
            return out.push_back({middles[0], middles[1], middles[2]});
        }
        const int k = count == 1 ? which : other;
        const std::uint32_t u = t[std::size_t(k)], v = t[std::size_t(k + 1) % 3], w = t[std::size_t(k + 2) % 3];
        if (count == 1) {
            out.push_back({u, middles[k], w}), out.push_back({middles[k], v, w});
            return;
        }
        const std::uint32_t x = middles[(k + 1) % 3], y = middles[(k + 2) % 3];  // of v-w and of w-u
        out.push_back({w, y, x}), out.push_back({u, v, x}), out.push_back({u, x, y});
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    KnownSurface& s_;
    std::map<Edge, std::uint32_t> middle_;
};

}  // namespace

KnownSurface refined_sphere(KnownSurface s, int rounds, double share, Random& random) {
    for (int round = 0; round < rounds; ++round) {
        Refinement refinement(s);
        for (const auto& t : s.triangles)
            if (random.next() < share) refinement.cut_all_edges(t);
        std::vector<std::array<std::uint32_t, 3>> out;
        for (const auto& t : s.triangles) refinement.replace(t, out);
        s.triangles = std::move(out);
    }
    s.normals = s.positions;
    orient(s);
    return s;
}

namespace {

double mean_edge(const KnownSurface& s) {
    double sum = 0;
    for (const auto& t : s.triangles) sum += length(s.positions[t[0]] - s.positions[t[1]]);
    return sum / double(s.triangles.size());
}

}  // namespace

void jitter_sphere(KnownSurface& s, double jitter, Random& random) {
    const double most = jitter * mean_edge(s);
    for (dvec3& p : s.positions)
        p = on_sphere(p + dvec3{random.within(-most, most), random.within(-most, most), random.within(-most, most)});
    s.normals = s.positions;
    orient(s);
}

KnownSurface stretched(KnownSurface s, dvec3 axes) {
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
        const dvec3 p = s.positions[v];
        s.positions[v] = {p.x * axes.x, p.y * axes.y, p.z * axes.z};
        s.normals[v] = on_sphere({p.x / axes.x, p.y / axes.y, p.z / axes.z});
    }
    return s;
}

KnownSurface height_field(std::uint32_t columns, const PointAt& at, double jitter, Random& random) {
    KnownSurface s;
    for (std::uint32_t i = 0; i <= columns; ++i)
        for (std::uint32_t j = 0; j <= columns; ++j) {
            const auto along = [&](std::uint32_t k) { return -1 + 2 * (k + random.within(-jitter, jitter)) / columns; };
            const double u = along(i), v = along(j);
            const KnownPoint p = at(u, v);
            s.positions.push_back(p.position), s.normals.push_back(p.normal);
        }
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * (columns + 1) + j, b = a + columns + 1;
            add_square(s, a, b, b + 1, a + 1, random.next() < 0.5);
        }
    orient(s);
    return s;
}

KnownSurface extruded(const std::vector<KnownPoint>& profile, std::uint32_t rows, double length) {
    KnownSurface s;
    const auto count = std::uint32_t(profile.size());
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (const KnownPoint& p : profile) {
            s.positions.push_back(p.position + dvec3{0, length * j / rows, 0});
            s.normals.push_back(p.normal);
        }
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            const std::uint32_t a = j * count + i;
            add_square(s, a, a + 1, a + 1 + count, a + count, false);
        }
    orient(s);
    return s;
}

KnownSurface tapered(const std::vector<KnownPoint>& outline, double top, double height, std::uint32_t rows) {
    KnownSurface s;
    const auto sides = std::uint32_t(outline.size());
    for (std::uint32_t k = 0; k <= rows; ++k)
        for (const KnownPoint& p : outline) {
            const double t = double(k) / rows;
            const dvec3 n = p.normal;  // perpendicular to the outline and to the line up to the apex
            s.positions.push_back(p.position * (1 - (1 - top) * t) + dvec3{0, 0, height * t});
            s.normals.push_back(normalize_or(dvec3{n.x * height, n.y * height, (1 - top) * dot(n, p.position)}, n));
        }
    for (std::uint32_t k = 0; k < rows; ++k)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
            s.triangles.push_back({a, b, b + sides}), s.triangles.push_back({a, b + sides, a + sides});
        }
    return s;
}

std::vector<KnownPoint> elliptic_outline(std::uint32_t sides, double half_axis) {
    std::vector<KnownPoint> outline;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double x = math::cos(2 * pi * i / sides), y = math::sin(2 * pi * i / sides);
        outline.push_back({{x, half_axis * y, 0}, normalize_or(dvec3{x, y / half_axis, 0}, dvec3{})});
    }
    return outline;
}

std::vector<KnownPoint> rounded_square(std::uint32_t segments) {
    std::vector<KnownPoint> outline;
    for (int corner = 0; corner < 4; ++corner)
        for (std::uint32_t i = 0; i <= segments; ++i) {
            const double middle = pi * (0.25 + 0.5 * corner), turn = pi * (0.5 * corner + 0.5 * i / segments);
            const dvec3 n{math::cos(turn), math::sin(turn), 0};
            const double inside = 0.6 * std::sqrt(2.0);
            outline.push_back({dvec3{math::cos(middle), math::sin(middle), 0} * inside + n * 0.4, n});
        }
    return outline;
}

KnownSurface half_of(const KnownSurface& whole) {
    KnownSurface s;
    std::vector<std::uint32_t> number(whole.positions.size(), 0xffffffffu);
    for (auto t : whole.triangles) {
        if (!(whole.positions[t[0]].x + whole.positions[t[1]].x + whole.positions[t[2]].x > 0)) continue;
        for (std::uint32_t& v : t) {
            if (number[v] == 0xffffffffu) {
                number[v] = std::uint32_t(s.positions.size());
                s.positions.push_back(whole.positions[v]), s.normals.push_back(whole.normals[v]);
            }
            v = number[v];
        }
        s.triangles.push_back(t);
    }
    return s;
}

void add_noise(KnownSurface& s, double share, Random& random) {
    const double size = share * mean_edge(s);
    for (dvec3& p : s.positions) p += dvec3{random.normal(), random.normal(), random.normal()} * size;
}

std::vector<std::uint8_t> is_at_border(const KnownSurface& s) {
    std::map<Edge, int> uses;
    for (const auto& t : s.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[edge_of(t[k], t[(k + 1) % 3])];
    std::vector<std::uint8_t> out(s.positions.size(), 0);
    for (const auto& [edge, count] : uses)
        if (count == 1) out[edge.first] = out[edge.second] = 1;
    return out;
}

KnownSurface hull_of_sphere(std::uint32_t points, Random& random) {
    KnownSurface s;
    for (std::uint32_t i = 0; i < points; ++i)
        s.positions.push_back(on_sphere({random.normal(), random.normal(), 0.5 * random.normal()}));
    s.normals = s.positions;
    s.triangles = {{0, 1, 2}, {0, 2, 1}};  // of the points so far
    for (std::uint32_t p = 3; p < points; ++p) {
        std::map<Edge, Edge> rim;  // edges between faces that the point sees and others, in the order of the seen one
        std::vector<std::array<std::uint32_t, 3>> kept;
        for (const auto& t : s.triangles) {
            const dvec3 a = s.positions[t[0]], b = s.positions[t[1]], c = s.positions[t[2]];
            if (!(dot(cross(b - a, c - a), s.positions[p] - a) > 0)) {
                kept.push_back(t);
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const Edge edge = edge_of(t[k], t[(k + 1) % 3]);
                if (!rim.try_emplace(edge, t[k], t[(k + 1) % 3]).second) rim.erase(edge);
            }
        }
        for (const auto& [edge, order] : rim) kept.push_back({order.first, order.second, p});
        s.triangles = std::move(kept);
    }
    return s;
}

}  // namespace rakelight
