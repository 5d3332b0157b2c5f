// SPDX-License-Identifier: Apache-2.0
#include "tools/creases/solid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {

std::vector<Surface> Solid::new_surfaces(std::span<const int> labels) {
    std::map<int, Surface> known;
    std::vector<Surface> out;
    for (const int label : labels) {
        const auto [at, is_new] = known.try_emplace(label, surfaces_);
        if (is_new) ++surfaces_;
        out.push_back(at->second);
    }
    return out;
}

void Solid::add(const Solid& other, const std::function<dvec3(dvec3)>& moved) {
    const auto place = [&](dvec3 p) { return moved ? moved(p) : p; };
    for (Polygon polygon : other.polygons_) {
        for (dvec3& p : polygon.points) p = place(p);
        polygon.surface += surfaces_;
        polygons_.push_back(std::move(polygon));
    }
    for (const auto& [a, b] : other.creases_) crease(place(a), place(b));
    surfaces_ += other.surfaces_;
}

void Solid::add_fan(const Loop& loop, Surface surface) {
    dvec3 middle{};
    for (const dvec3& p : loop) middle += p * (1.0 / double(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i) add({middle, loop[i], loop[(i + 1) % loop.size()]}, surface);
}

void Solid::add_flat(const Loop& loop, const std::vector<Loop>& holes, Surface surface) {
    dvec3 normal{};  // Newell
    for (std::size_t i = 0; i < loop.size(); ++i) normal += cross(loop[i], loop[(i + 1) % loop.size()]);
    normal = normalize_or(normal, dvec3{0, 0, 1});
    const dvec3 x = normalize_or(cross(std::fabs(normal.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0}, normal), dvec3{}),
                y = cross(normal, x);
    const auto flat = [&](const Loop& from) {
        std::vector<dvec2> to;
        for (const dvec3& p : from) to.push_back({dot(p, x), dot(p, y)});
        return to;
    };
    Loop points = loop;
    std::vector<std::vector<dvec2>> flat_holes;
    for (const Loop& hole : holes)
        points.insert(points.end(), hole.begin(), hole.end()), flat_holes.push_back(flat(hole));
    for (const auto& t : triangulated(flat(loop), flat_holes)) add({points[t[0]], points[t[1]], points[t[2]]}, surface);
}

void Solid::add_band(const Loop& low, const Loop& high, std::span<const Surface> sides) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::size_t next = (i + 1) % low.size();
        add({low[i], low[next], high[next], high[i]}, sides[i]);
    }
}

void Solid::add_band(const Loop& low, const Loop& high, Surface surface) {
    add_band(low, high, std::vector<Surface>(low.size(), surface));
}

void Solid::add_loft(const std::vector<Loop>& sections, std::span<const int> labels, bool is_ring) {
    const std::vector<Surface> sides = new_surfaces(labels);
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) add_band(sections[i], sections[i + 1], sides);
    if (is_ring) add_band(sections.back(), sections.front(), sides);
}

void Solid::add_walls(const Path& outline, double z0, double z1, bool outwards) {
    const Loop low = at_height(outline.points(), z0), high = at_height(outline.points(), z1);
    const std::vector<Surface> sides = new_surfaces(outline.labels());
    outwards ? add_band(low, high, sides) : add_band(high, low, sides);
}

void Solid::add_extruded(const Path& outline, double z0, double z1, const std::vector<Path>& holes) {
    add_walls(outline, z0, z1);
    std::vector<Loop> high, low;
    for (const Path& hole : holes) {
        add_walls(hole, z0, z1, false);
        high.push_back(at_height(hole.points(), z1)), low.push_back(at_height(hole.points(), z0));
    }
    add_flat(at_height(outline.points(), z1), high, new_surface());
    Loop bottom = at_height(outline.points(), z0);
    std::ranges::reverse(bottom);
    for (Loop& hole : low) std::ranges::reverse(hole);
    add_flat(bottom, low, new_surface());
}

void Solid::add_revolved(const Path& profile, int sides, double first_turn) {
    add_revolved(profile, even_turns(sides, first_turn));
}

void Solid::add_revolved(const Path& profile, std::span<const double> turns) {
    const std::vector<Surface> surfaces = new_surfaces(profile.labels());
    const auto& points = profile.points();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const dvec2 p = points[s], q = points[(s + 1) % points.size()];
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const double a = turns[i], b = turns[(i + 1) % turns.size()];
            const dvec3 pa = around(p.x, a, p.y), pb = around(p.x, b, p.y), qa = around(q.x, a, q.y),
                        qb = around(q.x, b, q.y);
            if (p.x == 0)
                add({pa, qb, qa}, surfaces[s]);
            else if (q.x == 0)
                add({pa, pb, qa}, surfaces[s]);
            else
                add({pa, pb, qb, qa}, surfaces[s]);
        }
    }
}

namespace {

bool is_before(dvec3 a, dvec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// Where the segment meets the plane, the same from both ends.
dvec3 at_plane(dvec3 a, double height_a, dvec3 b, double height_b) {
    if (is_before(b, a)) std::swap(a, b), std::swap(height_a, height_b);
    return a + (b - a) * (height_a / (height_a - height_b));
}

}  // namespace

void Solid::cut(dvec3 point, dvec3 normal) {
    const Surface end = new_surface();
    std::vector<Polygon> kept;
    const auto height = [&](dvec3 p) {
        const double h = dot(p - point, normal);
        return std::fabs(h) < 1e-9 ? 0 : h;
    };
    const auto take = [&](const Loop& loop, Surface surface) {
        Loop out;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const dvec3 a = loop[i], b = loop[(i + 1) % loop.size()];
            const double ha = height(a), hb = height(b);
            if (ha <= 0) out.push_back(a);
            if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) out.push_back(at_plane(a, ha, b, hb));
        }
        const auto is_at_plane = [&](dvec3 p) { return std::fabs(dot(p - point, normal)) < 1e-9; };
        if (out.size() < 3 || std::ranges::all_of(out, is_at_plane)) return;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const dvec3 a = out[i], b = out[(i + 1) % out.size()];
            if (is_at_plane(a) && is_at_plane(b)) kept.push_back({{point, b, a}, end});
        }
        kept.push_back({out, surface});
    };
    for (const Polygon& polygon : polygons_)  // triangles, for squares may be twisted
        for (std::size_t i = 1; i + 1 < polygon.points.size(); ++i)
            take({polygon.points[0], polygon.points[i], polygon.points[i + 1]}, polygon.surface);
    polygons_ = std::move(kept);
}

void Solid::move(const std::function<dvec3(dvec3)>& moved) {
    for (Polygon& polygon : polygons_)
        for (dvec3& p : polygon.points) p = moved(p);
    for (auto& [a, b] : creases_) a = moved(a), b = moved(b);
}

void Solid::turn(double x_deg, double y_deg, double z_deg) { move(turned(x_deg, y_deg, z_deg)); }

void Solid::flip() {
    for (Polygon& polygon : polygons_) std::ranges::reverse(polygon.points);
}

std::vector<double> even_turns(int sides, double first_turn) {
    std::vector<double> turns;
    for (int i = 0; i < sides; ++i) turns.push_back(first_turn + double(i) / sides);
    return turns;
}

Loop ring(double radius, double z, int sides, double first_turn) {
    Loop loop;
    for (const double turn : even_turns(sides, first_turn)) loop.push_back(around(radius, turn, z));
    return loop;
}

Loop reversed(Loop loop) {
    std::ranges::reverse(loop);
    return loop;
}

Loop at_height(const std::vector<dvec2>& points, double z) {
    Loop loop;
    for (const dvec2& p : points) loop.push_back({p.x, p.y, z});
    return loop;
}

dvec3 around(double radius, double turn, double z) {
    return {radius * math::cos(2 * pi * turn), radius * math::sin(2 * pi * turn), z};
}

std::function<dvec3(dvec3)> shift(double x, double y, double z) {
    return [=](dvec3 p) { return p + dvec3{x, y, z}; };
}

std::function<dvec3(dvec3)> turned(double x_deg, double y_deg, double z_deg) {
    const double cx = math::cos(radians(x_deg)), sx = math::sin(radians(x_deg)), cy = math::cos(radians(y_deg)),
                 sy = math::sin(radians(y_deg)), cz = math::cos(radians(z_deg)), sz = math::sin(radians(z_deg));
    return [=](dvec3 p) {
        p = {p.x, cx * p.y - sx * p.z, sx * p.y + cx * p.z};
        p = {cy * p.x + sy * p.z, p.y, cy * p.z - sy * p.x};
        return dvec3{cz * p.x - sz * p.y, sz * p.x + cz * p.y, p.z};
    };
}

}  // namespace rakelight
