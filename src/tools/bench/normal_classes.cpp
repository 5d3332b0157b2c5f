// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/normal_classes.h"

#include <cmath>
#include <functional>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr dvec3 ellipsoid_axes{1, 0.6, 0.35};

/// Whether a vertex is judged.
using Chosen = std::function<bool(std::uint32_t vertex)>;

class Classes {
public:
    explicit Classes(std::uint64_t seed) : random_(seed) {}
    std::vector<NormalClass> make() {
        closed();
        grids();
        fields();
        irregular();
        coarse();
        bevels();
        round_parts();
        tapers();
        thin();
        noise();
        borders();
        return std::move(classes_);
    }

private:
    NormalClass& add(std::string name, KnownSurface surface, const Chosen& chosen = {},
                     NormalKind kind = NormalKind::smooth) {
        NormalClass c{.name = std::move(name), .kind = kind, .surface = std::move(surface)};
        for (const auto& t : c.surface.triangles)
            for (const std::uint32_t v : t) {
                c.corner_normals.push_back(c.surface.normals[v]);
                c.counts.push_back(!chosen || chosen(v));
            }
        classes_.push_back(std::move(c));
        return classes_.back();
    }
    /// Hard at 60 degrees: what is exact at a corner depends on its face.
    void make_hard(NormalClass& c, const std::function<dvec3(dvec3 face, dvec3 vertex)>& normal_of) {
        c.crease_angle_rad = radians(60);
        const KnownSurface& s = c.surface;
        for (std::size_t t = 0; t < s.triangles.size(); ++t) {
            const auto& v = s.triangles[t];
            const dvec3 face = normalize_or(
                cross(s.positions[v[1]] - s.positions[v[0]], s.positions[v[2]] - s.positions[v[0]]), dvec3{});
            for (std::size_t k = 0; k < 3; ++k) c.corner_normals[3 * t + k] = normal_of(face, s.normals[v[k]]);
        }
    }

    void closed() {
        adaptive_ = refined_sphere(icosphere(2), 4, 0.25, random_);
        add("sphere, refined here and there", adaptive_);
        add("ellipsoid, refined here and there", stretched(adaptive_, ellipsoid_axes));
        add("torus, jittered", known_torus(64, 32, 0.3, random_));
        add("torus, triangles 4:1", known_torus(32, 64, 0.3, random_));
        KnownSurface sphere = icosphere(4);
        jitter_sphere(sphere, 0.25, random_);
        add("sphere, jittered", sphere);
        add("ellipsoid, jittered", stretched(sphere, ellipsoid_axes));
    }
    void grids() {
        add("UV sphere 48 x 24", uv_sphere(48, 24));
        add("UV sphere 16 x 8", uv_sphere(16, 8));
        add("UV ellipsoid 48 x 24", stretched(uv_sphere(48, 24), ellipsoid_axes));
        add("UV torus 32 x 16", known_torus(32, 16, 0, random_));
    }

    KnownSurface field(std::uint32_t columns, const std::function<double(double, double)>& height, double jitter) {
        const auto at = [&](double x, double y) {
            const double h = 1e-5;
            const double dx = (height(x + h, y) - height(x - h, y)) / (2 * h),
                         dy = (height(x, y + h) - height(x, y - h)) / (2 * h);
            return KnownPoint{{x, y, height(x, y)}, normalize_or(dvec3{-dx, -dy, 1}, dvec3{})};
        };
        return height_field(columns, at, jitter, random_);
    }
    void add_field(const std::string& name, const KnownSurface& s, bool with_border) {
        const std::vector<std::uint8_t> border = is_at_border(s);
        add(name + ", inner", s, [&](std::uint32_t v) { return border[v] == 0; });
        if (with_border)
            add(
                name + ", border", s, [&](std::uint32_t v) { return border[v] != 0; }, NormalKind::border);
    }
    void fields() {
        add_field("saddle",
                  field(
                      24, [](double x, double y) { return x * x - y * y; }, 0.25),
                  true);
        add_field("monkey saddle",
                  field(
                      24, [](double x, double y) { return x * x * x - 3 * x * y * y; }, 0.25),
                  false);
        struct Wave {
            double frequency, direction, phase;
        };
        std::vector<Wave> waves(12);
        for (Wave& w : waves) w = {random_.within(1, 9), random_.within(0, 6.3), random_.within(0, 6.3)};
        const auto terrain = [&](double x, double y) {
            double h = 0;
            for (const Wave& w : waves)
                h += 0.25 / w.frequency *
                     math::sin(w.frequency * (x * math::cos(w.direction) + y * math::sin(w.direction)) + w.phase);
            return h;
        };
        add_field("terrain, coarse", field(20, terrain, 0.25), true);
        add_field("terrain", field(60, terrain, 0.25), false);
    }

    void irregular() {
        const KnownSurface hull = hull_of_sphere(1500, random_);
        add("sphere, irregular hull", hull);
        add("ellipsoid, irregular hull", stretched(hull, ellipsoid_axes));
        add("sphere, decimated hull", hull_of_sphere(150, random_));
    }

    static dvec3 lump_at(dvec3 p) {
        return p * (1 + 0.25 * math::sin(3 * p.x + 1) * math::cos(2 * p.y) + 0.2 * p.z * p.z);
    }
    /// Soft limbs, as of a character.
    static KnownSurface lump(int levels) {
        KnownSurface s = icosphere(levels);
        for (std::size_t v = 0; v < s.positions.size(); ++v) {
            const dvec3 p = s.positions[v];
            const dvec3 t = normalize_or(cross(p, std::fabs(p.x) < 0.8 ? dvec3{1, 0, 0} : dvec3{0, 1, 0}), dvec3{}),
                        b = cross(p, t);
            const double h = 1e-5;
            const auto along = [&](dvec3 d) {
                return lump_at(normalize_or(p + d * h, p)) - lump_at(normalize_or(p - d * h, p));
            };
            const dvec3 n = normalize_or(cross(along(t), along(b)), p);
            s.positions[v] = lump_at(p), s.normals[v] = dot(n, p) < 0 ? -n : n;
        }
        return s;
    }
    void coarse() {
        for (const int levels : {1, 2}) add("icosphere of level " + std::to_string(levels), icosphere(levels));
        add("ellipsoid of level 2", stretched(icosphere(2), ellipsoid_axes));
        for (const int levels : {2, 3, 4}) add("lump of level " + std::to_string(levels), lump(levels));
    }

    /// Two planes at right angles with a rounding between them.
    static std::vector<KnownPoint> rounding(double width, int strips) {
        std::vector<KnownPoint> profile = {{{-1, 0, 0}, {0, 0, 1}}};
        for (int i = 0; i <= strips; ++i) {
            const double a = 0.5 * pi * i / strips;
            profile.push_back(
                {{-width + width * math::sin(a), 0, -width + width * math::cos(a)}, {math::sin(a), 0, math::cos(a)}});
        }
        profile.push_back({{0, 0, -1}, {1, 0, 0}});
        return profile;
    }
    void add_rounding(const std::string& name, double width, int strips, std::uint32_t rows) {
        const KnownSurface s = extruded(rounding(width, strips), rows, 1);
        const std::vector<std::uint8_t> border = is_at_border(s);
        add(
            name, s, [&](std::uint32_t v) { return border[v] == 0; }, NormalKind::hard);
    }
    void bevels() {
        add_rounding("bevel 0.03, 3 strips", 0.03, 3, 6);
        add_rounding("bevel 0.1, 3 strips", 0.1, 3, 6);
        add_rounding("bevel 0.1, 1 strip", 0.1, 1, 2);
        add_rounding("fillet 0.2, 6 strips", 0.2, 6, 4);
        add("chamfered box", chamfered_box(0.1), {}, NormalKind::hard);
    }
    /// 24 vertices, each with the normal of the flat side that it belongs to.
    static KnownSurface chamfered_box(double c) {
        KnownSurface s;
        const auto at = [&](int axis, int side, int p, int q) {
            double v[3];
            v[axis] = side, v[(axis + 1) % 3] = p * (1 - c), v[(axis + 2) % 3] = q * (1 - c);
            return dvec3{v[0], v[1], v[2]};
        };
        const auto vertex = [&](int axis, int side, int p, int q) {
            return std::uint32_t(axis * 8 + (side > 0) * 4 + (p > 0) * 2 + (q > 0));
        };
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1})
                for (const int p : {-1, 1})
                    for (const int q : {-1, 1}) {
                        double n[3] = {};
                        n[axis] = side;
                        s.positions.push_back(at(axis, side, p, q)), s.normals.push_back({n[0], n[1], n[2]});
                    }
        const auto square = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d, std::uint32_t e) {
            s.triangles.push_back({a, b, d}), s.triangles.push_back({a, d, e});
        };
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1})
                square(vertex(axis, side, -1, -1), vertex(axis, side, 1, -1), vertex(axis, side, 1, 1),
                       vertex(axis, side, -1, 1));
            for (const int a : {-1, 1})  // between the sides of this axis and of the next one
                for (const int b : {-1, 1})
                    square(vertex(axis, a, b, -1), vertex(axis, a, b, 1), vertex((axis + 1) % 3, b, 1, a),
                           vertex((axis + 1) % 3, b, -1, a));
        }
        for (const int x : {-1, 1})
            for (const int y : {-1, 1})
                for (const int z : {-1, 1})
                    s.triangles.push_back({vertex(0, x, y, z), vertex(1, y, z, x), vertex(2, z, x, y)});
        for (auto& t : s.triangles) {
            const dvec3 a = s.positions[t[0]], b = s.positions[t[1]], d = s.positions[t[2]];
            if (dot(cross(b - a, d - a), a + b + d) < 0) std::swap(t[1], t[2]);
        }
        return s;
    }

    static KnownSurface cylinder(std::uint32_t sides, std::uint32_t rings, bool has_caps) {
        KnownSurface s;
        for (std::uint32_t k = 0; k <= rings; ++k)
            for (std::uint32_t i = 0; i < sides; ++i) {
                const double a = 2 * pi * i / sides;
                s.positions.push_back({math::cos(a), math::sin(a), 4.0 * k / rings});
                s.normals.push_back({math::cos(a), math::sin(a), 0});
            }
        for (std::uint32_t k = 0; k < rings; ++k)
            for (std::uint32_t i = 0; i < sides; ++i) {
                const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
                s.triangles.push_back({a, b, b + sides}), s.triangles.push_back({a, b + sides, a + sides});
            }
        if (!has_caps) return s;
        const auto low = std::uint32_t(s.positions.size());
        s.positions.push_back({0, 0, 0}), s.normals.push_back({0, 0, -1});
        s.positions.push_back({0, 0, 4}), s.normals.push_back({0, 0, 1});
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t next = (i + 1) % sides;
            s.triangles.push_back({low, next, i});
            s.triangles.push_back({low + 1, rings * sides + i, rings * sides + next});
        }
        return s;
    }
    void round_parts() {
        for (const auto& [sides, rings] : {std::pair{24u, 1u}, {8u, 1u}, {24u, 6u}}) {
            NormalClass& c = add("cylinder, " + std::to_string(sides) + " sides, " + std::to_string(rings) + " rings",
                                 cylinder(sides, rings, true));
            make_hard(c, [](dvec3 face, dvec3 vertex) { return std::fabs(face.z) > 0.5 ? face : vertex; });
        }
        const KnownSurface open = cylinder(24, 2, false);
        const std::vector<std::uint8_t> border = is_at_border(open);
        add(
            "cylinder, open ends", open, [&](std::uint32_t v) { return border[v] != 0; }, NormalKind::border);
        cone();
        stairs();
    }
    void cone() {
        std::vector<double> angles(24);
        double sum = 0;
        for (double& a : angles) a = sum += random_.within(0.6, 1.4);
        KnownSurface s;
        s.positions.push_back({0, 0, 1}), s.normals.push_back({0, 0, 1});
        for (int j = 1; j < 6; ++j)
            for (const double a : angles) {
                const double turn = 2 * pi * a / sum, r = j / 6.0;
                s.positions.push_back({r * math::cos(turn), r * math::sin(turn), 1 - r});
                s.normals.push_back(normalize_or(dvec3{math::cos(turn), math::sin(turn), 1}, dvec3{}));
            }
        for (std::uint32_t i = 0; i < 24; ++i) {
            const std::uint32_t next = (i + 1) % 24;
            s.triangles.push_back({0, 1 + i, 1 + next});
            for (std::uint32_t j = 0; j < 4; ++j) {
                const std::uint32_t a = 1 + j * 24 + i, b = 1 + j * 24 + next;
                s.triangles.push_back({a, a + 24, b + 24}), s.triangles.push_back({a, b + 24, b});
            }
        }
        add("cone, wall", s, [](std::uint32_t v) { return v >= 1 && v < 97; });
        add("cone, tip", s, [](std::uint32_t v) { return v == 0; });
    }
    /// Walls that taper, mostly between two hard edges.
    void tapers() {
        const auto circle = [](std::uint32_t sides) { return elliptic_outline(sides, 1); };
        add("frustum, 10 sides, 1 row", tapered(circle(10), 0.6, 1, 1));
        add("frustum, 16 sides, 1 row", tapered(circle(16), 0.3, 1, 1));
        add("frustum, 12 sides, 3 rows", tapered(circle(12), 0.6, 1, 3));
        add("chamfer of a rod of 12 sides", tapered(circle(12), 0.9, 0.1, 1));
        add("elliptic cup, 16 sides, 2 rows", tapered(elliptic_outline(16, 0.6), 0.8, 1, 2));
        add("elliptic cup, 32 sides, 4 rows", tapered(elliptic_outline(32, 0.6), 0.8, 1, 4));
        add("rounded box with draft, 1 row", tapered(rounded_square(4), 0.8, 1, 1));
        add("rounded box with draft, 4 rows", tapered(rounded_square(8), 0.8, 1, 4));
    }
    void stairs() {
        std::vector<KnownPoint> profile;
        for (int k = 0; k < 5; ++k)
            for (const int z : {k, k + 1}) profile.push_back({{double(k), 0, double(z)}, {-1, 0, 1}});
        NormalClass& c = add("staircase", extruded(profile, 3, 3), {}, NormalKind::hard);
        make_hard(c, [](dvec3 face, dvec3) { return face; });
    }

    /// A bent plate, 0.02 thick; its upper side.
    void thin() {
        const KnownSurface sheet = field(
            16, [](double x, double) { return 0.3 * x * x; }, 0.2);
        const auto count = std::uint32_t(sheet.positions.size()), side = 17u;
        KnownSurface s = sheet;
        for (std::uint32_t v = 0; v < count; ++v) {
            s.positions[v] += sheet.normals[v] * 0.01;
            s.positions.push_back(sheet.positions[v] - sheet.normals[v] * 0.01);
            s.normals.push_back(-sheet.normals[v]);
        }
        for (const auto& t : sheet.triangles) s.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
        const auto wall = [&](std::uint32_t a, std::uint32_t b) {
            s.triangles.push_back({b, a, a + count}), s.triangles.push_back({b, a + count, b + count});
        };
        for (std::uint32_t k = 0; k + 1 < side; ++k) {
            wall(k + 1, k), wall(side * (side - 1) + k, side * (side - 1) + k + 1);
            wall(k * side, (k + 1) * side), wall((k + 1) * side + side - 1, k * side + side - 1);
        }
        NormalClass& c = add("thin sheet", s);
        c.crease_angle_rad = radians(60);
        for (std::size_t i = 0; i < c.counts.size(); ++i) c.counts[i] = i / 3 < sheet.triangles.size();
    }

    void noise() {
        for (const auto& [share, name] : {std::pair{0.005, "0.5 %"}, {0.02, "2 %"}, {0.05, "5 %"}, {0.1, "10 %"}}) {
            KnownSurface s = adaptive_;
            add_noise(s, share, random_);
            add(std::string("sphere, noise of ") + name + " of an edge", s, {}, NormalKind::noise);
        }
        for (const auto& [share, name] : {std::pair{0.05, "5 %"}, {0.2, "20 %"}}) {
            KnownSurface s = known_torus(64, 32, 0.2, random_);
            add_noise(s, share, random_);
            add(std::string("torus, noise of ") + name + " of an edge", s, {}, NormalKind::noise);
        }
    }

    void add_half(const std::string& name, const KnownSurface& whole) {
        const KnownSurface s = half_of(whole);
        const std::vector<std::uint8_t> border = is_at_border(s);
        add(
            "border of half a" + std::string(name.starts_with("e") ? "n " : " ") + name, s,
            [&](std::uint32_t v) { return border[v] != 0; }, NormalKind::border);
    }
    void borders() {
        KnownSurface sphere = icosphere(4);
        jitter_sphere(sphere, 0.25, random_);
        add_half("sphere", sphere);
        add_half("ellipsoid", stretched(sphere, ellipsoid_axes));
        add_half("torus 64 x 32", known_torus(64, 32, 0.3, random_));
        add_half("torus 24 x 12", known_torus(24, 12, 0.05, random_));
    }

    Random random_;
    KnownSurface adaptive_;
    std::vector<NormalClass> classes_;
};

}  // namespace

std::vector<NormalClass> normal_classes(std::uint64_t seed) { return Classes(seed).make(); }

}  // namespace rakelight
