// SPDX-License-Identifier: Apache-2.0
// Authored normals of parts joined by the rule of creases: hard edges by construction keep their bits, soft ones close.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "unit/geometry/creases/hard_shapes.h"
#include "unit/geometry/groups/joined_shapes.h"

namespace rakelight::test {
namespace {

constexpr double closed_deg = 5e-5;  // 0.0000

/// A shape of parts with authored normals: every vertex belongs to one surface.
struct Parts {
    std::vector<Shape> shapes;
    std::vector<std::vector<int>> surface;  ///< [parts][T]
    std::vector<double> step;               ///< [parts] AttributeMesh::position_step
};

Joined join_by_rule(const Parts& parts, int threads = 2) {
    Context context({.threads = threads});
    std::vector<AttributeMesh> meshes = views(parts.shapes);
    for (std::size_t m = 0; m < parts.step.size(); ++m) meshes[m].position_step = parts.step[m];
    Joined out;
    out.meshes = join_seams(meshes, {.creases = Creasing::automatic}, out.report, context);
    return out;
}

/// Cuts a shape, and gives each part the normals that it has alone, surface by surface.
Parts authored(const HardShape& whole, std::uint32_t count, const std::function<std::uint32_t(std::size_t)>& part) {
    Parts out;
    out.surface.resize(count);
    std::vector<std::uint32_t> of(whole.surface.size());
    for (std::size_t t = 0; t < of.size(); ++t) out.surface[of[t] = part(t)].push_back(whole.surface[t]);
    for (const Shape& s : cut(whole.shape, count, [&](std::size_t t) { return of[t]; })) {
        const std::vector<int>& surface = out.surface[out.shapes.size()];
        Shape& made = out.shapes.emplace_back();
        made.object = s.object;
        std::map<std::tuple<float, float, float, int>, std::uint32_t> number;
        std::vector<dvec3> sums;
        for (std::size_t c = 0; c < s.indices.size(); ++c) {
            const auto at_corner = [&](std::size_t k) { return s.positions[s.indices[c - c % 3 + (c % 3 + k) % 3]]; };
            const vec3 p = at_corner(0);
            const auto [at, is_new] = number.try_emplace({p.x, p.y, p.z, surface[c / 3]}, std::uint32_t(sums.size()));
            if (is_new) made.positions.push_back(p), sums.emplace_back();
            made.indices.push_back(at->second);
            const auto to = [&](std::size_t k) {
                return normalize_or(cast<double>(at_corner(k)) - cast<double>(p), dvec3{});
            };
            sums[at->second] += normalize_or(edge_product(s, c / 3), dvec3{}) * angle_between(to(1), to(2));
        }
        for (const dvec3 sum : sums) made.normals.push_back(cast<float>(normalize_or(sum, {0, 0, 1})));
    }
    return out;
}
Parts at_random(const HardShape& whole, std::uint32_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    return authored(whole, count, [&](std::size_t) { return random() % count; });
}
/// By the angle around z.
Parts in_sectors(const HardShape& whole, std::uint32_t count) {
    return authored(whole, count, [&](std::size_t t) {
        const dvec3 c = centroid(whole.shape, t);
        return std::min(count - 1, std::uint32_t((std::atan2(c.y, c.x) / (2 * pi) + 0.5) * count));
    });
}
Parts by_surface(const HardShape& whole) {
    std::map<int, std::uint32_t> number;
    for (const int s : whole.surface) number.try_emplace(s, std::uint32_t(number.size()));
    return authored(whole, std::uint32_t(number.size()), [&](std::size_t t) { return number[whole.surface[t]]; });
}

dvec3 in_world(const Shape& s, vec3 p) {
    const dvec3 q = cast<double>(p);
    return s.to_world[0].xyz() * q.x + s.to_world[1].xyz() * q.y + s.to_world[2].xyz() * q.z + s.to_world[3].xyz();
}
dvec3 normal_in_world(const Shape& s, vec3 n) {
    const dmat3 m = upper_left(s.to_world);
    const double side = determinant(m) < 0 ? -1 : 1;
    const dvec3 q = cast<double>(n);
    return normalize_or((cross(m[1], m[2]) * q.x + cross(m[2], m[0]) * q.y + cross(m[0], m[1]) * q.z) * side, dvec3{});
}

struct Check {
    double widest_deg = 0;    ///< between normals of one surface at one position
    std::size_t changed = 0;  ///< normals of surfaces that are planes
    std::size_t pairs = 0;    ///< of normals of different parts
};

/// @param is_curved  of a surface
Check check(const Parts& parts, const Joined& joined, const std::function<bool(int)>& is_curved, double grid = 1e-4) {
    const std::vector<Shape> after = applied(parts.shapes, joined);
    Check out;
    std::map<std::tuple<long, long, long, int>, std::vector<std::pair<std::size_t, dvec3>>> at;
    for (std::size_t m = 0; m < after.size(); ++m)
        for (std::size_t c = 0; c < after[m].indices.size(); ++c) {
            const std::uint32_t v = after[m].indices[c];
            const int surface = parts.surface[m][c / 3];
            if (!is_curved(surface)) out.changed += after[m].normals[v] != parts.shapes[m].normals[v];
            const dvec3 p = in_world(after[m], after[m].positions[v]);
            at[{std::lround(p.x / grid), std::lround(p.y / grid), std::lround(p.z / grid), surface}].emplace_back(
                m, normal_in_world(after[m], after[m].normals[v]));
        }
    for (const auto& [place, normals] : at)
        for (const auto& [part, normal] : normals) {
            out.widest_deg = std::max(out.widest_deg, degrees_between(normal, normals[0].second));
            out.pairs += part != normals[0].first;
        }
    return out;
}
bool no_surface(int) { return false; }
bool hole_of_nut(int surface) { return surface == 50; }

void expect_as_meant(const Parts& parts, const std::function<bool(int)>& is_curved, const std::string& what,
                     double grid = 1e-4) {
    const Joined joined = join_by_rule(parts);
    const Check found = check(parts, joined, is_curved, grid);
    EXPECT_EQ(found.changed, 0u) << what;
    EXPECT_LT(found.widest_deg, closed_deg) << what;
    Parts after = parts;
    after.shapes = applied(parts.shapes, joined);
    EXPECT_EQ(join_by_rule(after).report.turned, 0u) << what << ", a second time";
}

TEST(SeamRule, ANutInPartsKeepsItsHardEdgesAndItsHoleIsClosed) {
    for (const double turn : {0.0, 0.1, 0.4}) {
        const HardShape nut = make_nut(0, turn);
        const std::string name = "nut turned by " + std::to_string(turn);
        for (const std::uint32_t count : {2u, 3u, 5u, 7u}) expect_as_meant(in_sectors(nut, count), hole_of_nut, name);
        for (const std::uint32_t seed : {1u, 2u, 3u}) {  // parts of single sides of the hole are flat
            const Parts parts = at_random(nut, 4, seed);
            EXPECT_EQ(check(parts, join_by_rule(parts), hole_of_nut).changed, 0u) << name;
        }
        EXPECT_EQ(join_by_rule(by_surface(nut)).report.turned, 0u);
        const Parts parts = in_sectors(nut, 5);
        EXPECT_GT(join_by_rule(parts).report.turned, 0u) << "the hole was open";
        EXPECT_GT(check(parts, join_by_rule(parts), hole_of_nut).pairs, 0u);
    }
}

TEST(SeamRule, AChamferedBoxInPartsKeepsItsBits) {
    for (const double chamfer : {0.05, 0.15, 0.3}) {
        const HardShape box = make_chamfered_box(chamfer);
        EXPECT_EQ(join_by_rule(by_surface(box)).report.turned, 0u);
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            const Parts parts = at_random(box, 4, seed);
            const Joined joined = join_by_rule(parts);
            EXPECT_EQ(check(parts, joined, no_surface).changed, 0u);
        }
    }
}

TEST(SeamRule, FilletsAreClosedAndTheirLidsStayFlat) {
    for (const int strips : {3, 4, 8}) {
        const HardShape body = make_fillets(strips, 0.2);
        for (const std::uint32_t count : {2u, 3u, 5u})
            expect_as_meant(
                in_sectors(body, count), [](int surface) { return surface == 0; }, "fillet");
    }
}

/// Parts that were smoothed one by one up to 60 degrees: over their hard edges too.
Parts smoothed_apart(Parts parts) {
    Context context;
    AttributeOptions options;
    options.scope = Scope::object;
    const std::vector<MeshAttributes> own = compute_attributes(views(parts.shapes), options, context);
    for (std::size_t m = 0; m < parts.shapes.size(); ++m) {
        Shape& s = parts.shapes[m];
        for (const std::uint32_t v : own[m].source_vertex) s.positions.push_back(s.positions[v]);
        if (!own[m].indices.empty()) s.indices = own[m].indices;
        s.normals = own[m].normals;
    }
    return parts;
}

TEST(SeamRule, HardEdgesBetweenPartsStayThoughTheNormalsOfThePartsLean) {
    // Three parts of two sides each. Inside of a part, the edge of 60 degrees is smooth.
    const HardShape nut = make_nut(0, 0);
    const Parts parts = smoothed_apart(in_sectors(nut, 3));
    const std::vector<Shape> after = applied(parts.shapes, join_by_rule(parts));
    std::size_t rim = 0;
    for (std::size_t m = 0; m < after.size(); ++m)
        for (std::size_t c = 0; c < after[m].indices.size(); ++c) {
            const std::uint32_t v = after[m].indices[c];
            if (parts.surface[m][c / 3] >= 6) continue;
            EXPECT_EQ(after[m].normals[v], parts.shapes[m].normals[v]);
            rim += degrees_between(cast<double>(after[m].normals[v]),
                                   normalize_or(edge_product(after[m], c / 3), dvec3{})) < 0.01;
        }
    EXPECT_GT(rim, 0u) << "corners at the edges between parts are those of flat sides";
    EXPECT_GT(join(parts.shapes, 61).report.turned, join_by_rule(parts).report.turned) << "the angle joins them";
}

/// A dome with the normals of its sphere on a flat ring: rows of `row_deg` end `slope_deg` above the plane.
Parts dome(double slope_deg, double row_deg, int rows) {
    Parts out;
    Shape ring, cap;
    const std::uint32_t n = 24;
    const auto add = [&](Shape& s, double radius, double height, double tilt_deg) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * pi * i / n, t = radians(tilt_deg);
            s.positions.push_back({float(radius * std::cos(a)), float(radius * std::sin(a)), float(height)});
            s.normals.push_back(
                {float(std::sin(t) * std::cos(a)), float(std::sin(t) * std::sin(a)), float(std::cos(t))});
        }
    };
    const auto wall = [&](Shape& s, std::vector<int>& surface, std::uint32_t row, int number) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = row * n + i, b = row * n + (i + 1) % n;
            s.indices.insert(s.indices.end(), {a, b, b + n, a, b + n, a + n});
            surface.insert(surface.end(), 2, number);
        }
    };
    out.surface.resize(2);
    const double first = slope_deg + row_deg / 2;  // of the sphere's normal where the dome begins
    add(ring, 2 * std::sin(radians(first)), 0, 0);
    add(ring, std::sin(radians(first)), 0, 0);
    wall(ring, out.surface[0], 0, 0);
    for (int r = 0; r <= rows; ++r) {
        const double tilt = first - r * row_deg;
        add(cap, std::sin(radians(tilt)), std::cos(radians(tilt)) - std::cos(radians(first)), tilt);
        if (r > 0) wall(cap, out.surface[1], std::uint32_t(r) - 1, 1);
    }
    cap.object = 1;
    out.shapes = {ring, cap};
    return out;
}

TEST(SeamRule, ADomeOnAFlatRingIsHardThoughItsNormalsLean) {
    const Parts parts = dome(42, 20, 2);
    EXPECT_EQ(join_by_rule(parts).report.turned, 0u);
    EXPECT_GT(join(parts.shapes).report.turned, 0u) << "42 degrees";
}

TEST(SeamRule, SmoothSurfacesInPartsAreJoinedAsByTheAngle) {
    for (const Shape& whole : {make_torus(24, 12), make_torus(48, 24), make_sphere(24, 12)}) {
        const HardShape made{whole, std::vector<int>(whole.indices.size() / 3, 0)};
        for (const std::uint32_t seed : {1u, 2u}) {
            const Parts parts = at_random(made, 3, seed);
            const Joined by_rule = join_by_rule(parts), by_angle = join(parts.shapes);
            EXPECT_EQ(by_rule.report, by_angle.report);
            for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(by_rule.meshes[m].normals, by_angle.meshes[m].normals);
        }
        const Parts parts = in_sectors(made, 5);
        expect_as_meant(
            parts, [](int) { return true; }, "smooth");
    }
}

/// Halves at x = 0; the second one is stored as a mirror image of its place.
Parts mirrored(const HardShape& whole) {
    Parts parts = authored(whole, 2, [&](std::size_t t) { return centroid(whole.shape, t).x < 0 ? 0u : 1u; });
    Shape& s = parts.shapes[1];
    for (vec3& p : s.positions) p.x = -p.x;
    for (vec3& n : s.normals) n.x = -n.x;
    s.to_world = scaling(dvec3{-1, 1, 1});
    for (std::size_t c = 0; c < s.indices.size(); c += 3) std::swap(s.indices[c + 1], s.indices[c + 2]);
    return parts;
}

TEST(SeamRule, MirroredHalvesAreDecidedInTheWorld) {
    expect_as_meant(mirrored(make_nut(0, 0)), hole_of_nut, "nut");
    EXPECT_GT(join_by_rule(mirrored(make_nut(0, 0))).report.turned, 0u);
    const Shape torus = make_torus(24, 12);
    const Parts halves = mirrored({torus, std::vector<int>(torus.indices.size() / 3, 0)});
    expect_as_meant(
        halves, [](int) { return true; }, "torus");
    EXPECT_EQ(join_by_rule(halves).report, join(halves.shapes).report);
}

/// Positions of each part on a grid of its own.
Parts quantized(Parts parts, double step) {
    for (std::size_t m = 0; m < parts.shapes.size(); ++m) {
        Shape& s = parts.shapes[m];
        const dvec3 origin = dvec3{0.31, -0.17, 0.23} * (step * double(m));
        for (vec3& p : s.positions) {
            const dvec3 q = (cast<double>(p) - origin) / step;
            p = cast<float>(dvec3{std::round(q.x), std::round(q.y), std::round(q.z)} * step);
        }
        s.to_world = translation(origin);
        parts.step.push_back(step);
    }
    return parts;
}

TEST(SeamRule, QuantizedPartsAreDecidedWithinTheirSteps) {
    for (const double step : {2.0 / 16384, 2.0 / 4096, 2.0 / 65536})
        for (const double turn : {0.0, 0.1, 0.4})
            for (const std::uint32_t count : {2u, 3u, 5u}) {
                const Parts parts = quantized(in_sectors(make_nut(0, turn), count), step);
                expect_as_meant(parts, hole_of_nut,
                                "step " + std::to_string(step) + ", " + std::to_string(count) + " parts", 0.02);
            }
    const Shape torus = make_torus(24, 12);
    expect_as_meant(
        quantized(in_sectors({torus, std::vector<int>(torus.indices.size() / 3, 0)}, 4), 4.0 / 16384),
        [](int) { return true; }, "torus", 0.02);
}

TEST(SeamRule, RoundedPositionsDoNotMixHardAndSoftEdges) {
    for (const double step : {1e-4, 1e-3, 1e-2})
        for (const double turn : {0.0, 0.1, 0.4})
            expect_as_meant(in_sectors(make_nut(step, turn), 3), hole_of_nut, "step " + std::to_string(step));
}

TEST(SeamRule, PartsThatAreFlatShadedOnBothSidesStaySo) {
    // The rule calls the edges of 9 sides soft. The author made them flat.
    const HardShape column = make_column(9, true);
    for (const Parts& parts : {by_surface(column), at_random(column, 4, 1)}) {
        const Joined joined = join_by_rule(parts);
        EXPECT_EQ(check(parts, joined, no_surface).changed, 0u);
        EXPECT_GT(joined.report.flat_pairs, 0u);
    }
    const Parts smooth = in_sectors(make_column(9, false), 3);
    expect_as_meant(
        smooth, [](int surface) { return surface == 0; }, "round column");
    EXPECT_GT(join_by_rule(smooth).report.turned, 0u);
}

/// Squares of a rough height field in two parts; each has one normal, and bends along its diagonal.
Parts bent_squares() {
    constexpr std::uint32_t n = 8;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> height(0, 0.4f);
    std::vector<float> z((n + 1) * (n + 1));
    for (float& h : z) h = height(random);
    Parts parts;
    parts.shapes.resize(2), parts.surface.resize(2);
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const std::uint32_t x = i % n, y = i / n, part = x < n / 2 ? 0 : 1;
        Shape& s = parts.shapes[part];
        s.object = part;
        const auto first = std::uint32_t(s.positions.size());
        for (const auto& [dx, dy] : {std::pair{0u, 0u}, {1u, 0u}, {1u, 1u}, {0u, 1u}})
            s.positions.push_back({float(x + dx), float(y + dy), z[(y + dy) * (n + 1) + x + dx]});
        const vec3* const p = &s.positions[first];
        const dvec3 normal = normalize_or(cross(cast<double>(p[2] - p[0]), cast<double>(p[3] - p[1])), dvec3{});
        s.normals.insert(s.normals.end(), 4, cast<float>(normal));
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) s.indices.push_back(first + k);
        parts.surface[part].insert(parts.surface[part].end(), 2, int(i));
    }
    return parts;
}

TEST(SeamRule, BentPolygonsOfOneNormalStayFlatShaded) {
    const Parts parts = bent_squares();
    const Joined joined = join_by_rule(parts);
    EXPECT_EQ(joined.report.turned, 0u);
    EXPECT_GT(joined.report.flat_pairs, 0u);
    SeamReport report;
    Context context;
    (void)join_seams(views(parts.shapes), {.crease_angle_rad = radians(60)}, report, context);
    EXPECT_EQ(report.turned, 0u);
}

/// A box whose chamfers have the normals of the sides beside them, with some digits.
Parts weighted_box(double off) {
    const HardShape box = make_chamfered_box(0.1);
    Parts parts = authored(box, 2, [&](std::size_t t) {
        const dvec3 n = normalize_or(edge_product(box.shape, t), dvec3{});
        return std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) > 0.99 ? 0u : 1u;
    });
    Shape& chamfers = parts.shapes[1];
    for (std::size_t v = 0; v < chamfers.positions.size(); ++v) {
        const vec3 p = chamfers.positions[v];
        dvec3 n{std::fabs(p.x) > 0.99f ? p.x : 0, std::fabs(p.y) > 0.99f ? p.y : 0, std::fabs(p.z) > 0.99f ? p.z : 0};
        chamfers.normals[v] = cast<float>(normalize_or(n + dvec3{off, -off, off}, dvec3{}));
    }
    return parts;
}

TEST(SeamRule, NormalsThatAgreeAcrossAHardEdgeWereAuthoredSmooth) {
    EXPECT_EQ(join_by_rule(weighted_box(0)).report.turned, 0u);
    const Parts parts = weighted_box(0.005);
    const Joined joined = join_by_rule(parts);
    EXPECT_GT(joined.report.turned, 0u);
    EXPECT_LT(joined.report.max_deg, 0.5);
    EXPECT_LT(check(parts, joined, [](int) { return true; }).widest_deg, closed_deg);
}

TEST(SeamRule, APartWithAnAngleOfItsOwnIsJoinedWhereBothAgree) {
    const Parts parts = in_sectors(make_nut(0, 0), 2);
    Context context;
    std::vector<AttributeMesh> meshes = views(parts.shapes);
    const SeamOptions by_rule{.creases = Creasing::automatic};
    SeamReport report;
    for (const auto& [own_deg, is_joined] : {std::pair(10.0, false), {20.0, true}}) {
        meshes[0].crease_angle_rad = radians(own_deg);
        join_seams(meshes, by_rule, report, context);
        EXPECT_EQ(report.turned > 0, is_joined) << "sides of the hole turn by 15 degrees";
    }
    for (AttributeMesh& mesh : meshes) mesh.crease_angle_rad = radians(60);
    const std::vector<MeshSeams> own = join_seams(meshes, by_rule, report, context);
    const Joined by_angle = join(parts.shapes);
    EXPECT_EQ(report, by_angle.report) << "nobody follows the rule";
    for (std::size_t m = 0; m < 2; ++m) EXPECT_EQ(own[m].normals, by_angle.meshes[m].normals);
}

TEST(SeamRule, ThreadsDoNotMatter) {
    const Shape torus = make_torus(300, 150);
    const Parts parts = in_sectors({torus, std::vector<int>(torus.indices.size() / 3, 0)}, 7);
    const Joined one = join_by_rule(parts, 1), four = join_by_rule(parts, 4);
    EXPECT_EQ(one.report, four.report);
    for (std::size_t m = 0; m < 7; ++m) EXPECT_EQ(one.meshes[m].normals, four.meshes[m].normals);
}

}  // namespace
}  // namespace rakelight::test
