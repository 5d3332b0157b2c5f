// SPDX-License-Identifier: Apache-2.0
// Authored normals joined where meshes meet: closed forms with bent borders, hard edges that keep their bits, a brute force over
// random models, mirrors, other orders and threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include <rakelight/geometry/seams.h>

#include "unit/geometry/groups/joined_shapes.h"

namespace rakelight::test {
namespace {

/// Authored as its faces: every triangle has its own vertices.
Shape flat(const Shape& s) {
    Shape out;
    out.object = s.object, out.to_world = s.to_world;
    for (std::size_t t = 0; t < s.indices.size() / 3; ++t) {
        const vec3 n = cast<float>(normalize_or(edge_product(s, t), dvec3{}));
        for (std::size_t k = 0; k < 3; ++k) {
            out.indices.push_back(std::uint32_t(out.positions.size()));
            out.positions.push_back(s.positions[s.indices[3 * t + k]]);
            out.normals.push_back(n);
        }
    }
    return out;
}

/// A sphere in two halves at x = 0, exact normals but for the border, where each half's lean by some degrees to its side.
std::vector<Shape> bent_sphere(double lean_deg) {
    std::vector<Shape> halves = cut(make_sphere(32, 16), 2, [&](std::size_t t) {
        static const Shape whole = make_sphere(32, 16);
        return centroid(whole, t).x < 0 ? 0u : 1u;
    });
    for (Shape& s : halves)
        for (const vec3 p : s.positions) {
            dvec3 n = normalize_or(cast<double>(p), dvec3{});
            const bool at_border = std::fabs(p.x) < 1e-6f;
            if (at_border)
                n = normalize_or(n + dvec3{std::tan(radians(lean_deg)) * (s.object == 0 ? -1 : 1), 0, 0}, dvec3{});
            s.normals.push_back(cast<float>(n));
        }
    return halves;
}

TEST(JoinSeams, HalvesOfASphereHaveItsNormalsAgainAtTheBorderAndAllOthersKeepTheirBits) {
    const std::vector<Shape> before = bent_sphere(7);
    const Joined joined = join(before);
    const std::vector<Shape> after = applied(before, joined);
    std::size_t border = 0;
    for (std::size_t m = 0; m < 2; ++m) {
        const std::set<std::uint32_t> turned(joined.meshes[m].vertices.begin(), joined.meshes[m].vertices.end());
        for (std::uint32_t v = 0; v < before[m].positions.size(); ++v) {
            const vec3 p = before[m].positions[v];
            EXPECT_EQ(turned.contains(v), std::fabs(p.x) < 1e-6f);
            border += turned.contains(v);
            EXPECT_LT(degrees_between(cast<double>(after[m].normals[v]), normalize_or(cast<double>(p), dvec3{})), 1e-4);
        }
    }
    EXPECT_EQ(joined.report.turned, border);
    EXPECT_EQ(joined.report.normals, before[0].positions.size() + before[1].positions.size());
    EXPECT_NEAR(joined.report.max_deg, 7, 1e-4);
    EXPECT_NEAR(joined.report.mean_deg, 7, 0.01);
    EXPECT_EQ(joined.report.flat_pairs, 0u);
    EXPECT_EQ(join(after).report.turned, 0u) << "a second time nothing is left to do";
}

TEST(JoinSeams, CommonNormalIsTheSumByTheAnglesOfTheCorners) {
    // Three quarters of a disc lie in one mesh, one quarter in the other; their normals lean to different sides.
    Shape a, b;
    b.object = 1;
    a.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}};
    a.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4};
    b.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    b.indices = {0, 1, 2};
    const dvec3 left = normalize_or(dvec3{-0.3, 1, 0}, dvec3{}), right = normalize_or(dvec3{0.2, 1, 0.1}, dvec3{});
    a.normals.assign(5, cast<float>(left));
    b.normals.assign(3, cast<float>(right));
    const Joined joined = join({a, b});
    const dvec3 wanted = normalize_or(left * 3.0 + right, dvec3{});
    ASSERT_EQ(joined.meshes[0].vertices[0], 0u);
    EXPECT_LT(degrees_between(cast<double>(joined.meshes[0].normals[0]), wanted), 1e-5);
    EXPECT_EQ(joined.meshes[0].normals[0], joined.meshes[1].normals[0]) << "one matrix: the same bits";
}

TEST(JoinSeams, HardEdgesOfABoxInTwoPartsStayWhateverTheCreaseAngle) {
    const Shape box = make_cube();
    std::vector<Shape> parts = cut(box, 2, [](std::size_t t) { return std::uint32_t(t >= 6); });
    for (Shape& s : parts) s = flat(s);
    for (const double crease : {60.0, 180.0}) {
        const Joined joined = join(parts, crease);
        EXPECT_EQ(joined.report.turned, 0u);
        EXPECT_TRUE(joined.meshes[0].vertices.empty() && joined.meshes[1].vertices.empty());
        // z = 0, z = 1 and y = 0 against y = 1, x = 0 and x = 1: 12 edges less those inside a part (2 and 2).
        EXPECT_EQ(joined.report.flat_pairs, crease == 180 ? 8u : 0u);
    }
}

TEST(JoinSeams, FlatFacesOfOnePlaneAreJoinedWithASmoothNeighbor) {
    std::vector<Shape> hinge = make_hinge(radians(30));
    hinge[0] = flat(hinge[0]), hinge[1] = flat(hinge[1]);
    hinge[1].object = 1;
    EXPECT_EQ(join(hinge).report.turned, 0u);
    EXPECT_EQ(join(hinge).report.flat_pairs, 1u);
    for (vec3& n : hinge[1].normals) n = cast<float>(normalize_or(cast<double>(n) + dvec3{0.2, 0, 0.1}, dvec3{}));
    EXPECT_GT(join(hinge).report.turned, 0u) << "one side is not flat";
    EXPECT_EQ(join(hinge, 20).report.turned, 0u) << "sharper than the crease angle";
}

TEST(JoinSeams, AFaceWithACornerWithoutANormalIsNotAuthoredFlat) {
    std::vector<Shape> hinge = make_hinge(radians(30));
    hinge[0] = flat(hinge[0]), hinge[1] = flat(hinge[1]);
    hinge[1].object = 1;
    hinge[1].normals[1] = {0, 0, 0};  // of the triangle at the common edge, the corner that is not there
    EXPECT_GT(join(hinge).report.turned, 0u);
    EXPECT_EQ(join(hinge).report.flat_pairs, 0u);
}

/// Mesh 0 has a hard edge along z at x = 0, mesh 1 is smooth there and goes on at z > 0.
std::vector<Shape> hard_edge_meets_smooth() {
    Shape a, b;
    b.object = 1;
    const float y = 0.1f;  // a roof with a ridge
    a.positions = {{0, y, 0}, {-1, 0, 0}, {0, y, -1}, {0, y, 0}, {0, y, -1}, {1, 0, 0}};
    a.indices = {0, 2, 1, 3, 5, 4};
    a.normals.assign(3, cast<float>(normalize_or(dvec3{-0.10, 1, 0}, dvec3{})));
    a.normals.resize(6, cast<float>(normalize_or(dvec3{0.15, 1, 0}, dvec3{})));
    b.positions = {{0, y, 0}, {-1, 0, 0}, {0, y, 1}, {1, 0, 0}};
    b.indices = {0, 1, 2, 0, 2, 3};
    b.normals.assign(4, cast<float>(normalize_or(dvec3{0.05, 1, 0.02}, dvec3{})));
    return {a, b};
}

TEST(JoinSeams, NoTwoFansOfOneMeshAreJoinedNotEvenByWayOfAnother) {
    const std::vector<Shape> before = hard_edge_meets_smooth();
    const std::vector<Shape> after = applied(before, join(before));
    EXPECT_EQ(after[0].normals[0], before[0].normals[0]) << "farther from the other mesh's normal";
    EXPECT_EQ(after[0].normals[3], after[1].normals[0]) << "nearer";
    EXPECT_NE(after[0].normals[3], before[0].normals[3]);
}

TEST(JoinSeams, NormalsEqualWithinAThousandthAreOneFan) {
    std::vector<Shape> s = hard_edge_meets_smooth();
    for (std::size_t v = 0; v < 6; ++v) s[0].normals[v] = v < 3 ? vec3{0, 1, 0} : vec3{0.0005f, 1, 0};
    const std::vector<Shape> after = applied(s, join(s));
    EXPECT_EQ(after[0].normals[0], after[0].normals[3]);
    EXPECT_EQ(after[0].normals[0], after[1].normals[0]);
}

TEST(JoinSeams, NormalsThatCancelAndThoseOfNoUseStay) {
    std::vector<Shape> hinge = make_hinge(0);
    hinge[0].normals.assign(4, {0, 0, 1});
    hinge[1].normals.assign(4, {0, 0, -1});
    EXPECT_EQ(join(hinge).report.turned, 0u);
    hinge[1].normals.assign(4, {0, 0, 0});
    hinge[1].normals[0].x = std::nanf("");
    const Joined joined = join(hinge);
    EXPECT_EQ(joined.report.turned, 0u);
    EXPECT_EQ(joined.report.unusable, 4u);
}

TEST(JoinSeams, ANormalNearlyTheSameKeepsItsBits) {
    std::vector<Shape> hinge = make_hinge(0);
    hinge[0].normals.assign(4, {0, 1, 0});
    hinge[1].normals.assign(4, {1e-5f, 1, 0});
    EXPECT_EQ(join(hinge).report.turned, 0u);
}

TEST(JoinSeams, AMirroredHalfHasTheMirroredNormals) {
    // One half, and the same mesh mirrored at x = 0: by symmetry the border's normals get no part along x.
    Shape half = bent_sphere(5)[1];
    half.to_world = translation(dvec3{3, -1, 2});
    Shape mirrored = half;
    mirrored.object = 1;
    mirrored.to_world = translation(dvec3{3, -1, 2}) * scaling(dvec3{-1, 1, 1});
    const Joined joined = join({half, mirrored});
    ASSERT_GT(joined.report.turned, 0u);
    ASSERT_EQ(joined.meshes[0].vertices, joined.meshes[1].vertices);
    for (std::size_t i = 0; i < joined.meshes[0].vertices.size(); ++i) {
        EXPECT_NEAR(joined.meshes[0].normals[i].x, 0, 1e-7);
        EXPECT_LT(degrees_between(joined.meshes[0].normals[i], half.positions[joined.meshes[0].vertices[i]]), 1e-3);
        EXPECT_EQ(joined.meshes[0].normals[i].y, joined.meshes[1].normals[i].y);
    }
}

// ---- the brute force

/// A bumpy grid cut at random into parts; normals at random about the vertical, of few kinds, so that fans meet and part.
std::vector<Shape> random_parts(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-0.4, 0.4);
    Shape grid = make_grid(6, 6, [&](double u, double v) {
        return vec3{float(6 * u), float(value(random)), float(-6 * v)};
    });
    std::vector<Shape> parts = cut_at_random(grid, 2 + seed % 4, seed);
    std::vector<dvec3> kinds(4);
    for (dvec3& k : kinds) k = normalize_or(dvec3{value(random), 1, value(random)}, dvec3{});
    const auto slight = [&] { return dvec3{value(random), value(random), value(random)} * 5e-4; };  // less than 1e-3
    for (Shape& s : parts) {
        if (random() % 3 == 0) {
            s = flat(s);
        } else if (random() % 2 == 0) {  // corners of their own
            Shape apart = flat(s);
            for (vec3& n : apart.normals) n = cast<float>(kinds[random() % kinds.size()] + slight());
            s = apart;
        } else {
            for (std::size_t v = 0; v < s.positions.size(); ++v)
                s.normals.push_back(cast<float>(kinds[random() % kinds.size()] + slight()));
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].object = std::uint32_t(i);
    return parts;
}

struct Corner {
    std::size_t mesh, triangle, k;
    vec3 place;
    dvec3 normal, face;
    double angle;
    std::array<bool, 3> counts;  ///< whether no other mesh is where the face's next corners are: 1, 2
};

dvec3 normal_at(const Shape& s, std::size_t t, std::size_t k) {
    return normalize_or(cast<double>(s.normals[s.indices[3 * t + k % 3]]), dvec3{});
}
vec3 place_at(const Shape& s, std::size_t t, std::size_t k) { return s.positions[s.indices[3 * t + k % 3]]; }

bool is_alone(const std::vector<Shape>& shapes, std::size_t mesh, vec3 place) {
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (const std::uint32_t v : shapes[m].indices)
            if (m != mesh && shapes[m].positions[v] == place) return false;
    return true;
}

std::vector<Corner> all_corners(const std::vector<Shape>& shapes) {
    std::vector<Corner> corners;
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t t = 0; t < shapes[m].indices.size() / 3; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Shape& s = shapes[m];
                Corner c{m, t, k, place_at(s, t, k), normal_at(s, t, k), {}, 0, {}};
                c.face = normalize_or(edge_product(s, t), dvec3{});
                const dvec3 e = cast<double>(place_at(s, t, k + 1)) - cast<double>(c.place),
                            f = cast<double>(place_at(s, t, k + 2)) - cast<double>(c.place);
                c.angle = std::atan2(length(cross(e, f)), dot(e, f));
                for (std::size_t i = 1; i < 3; ++i) c.counts[i] = is_alone(shapes, m, place_at(s, t, k + i));
                corners.push_back(c);
            }
    return corners;
}

/// The edge of two corners at one place: of each the number of its corner there, 1 or 2 behind its own; 0: they share none.
std::pair<std::size_t, std::size_t> common_edge(const std::vector<Shape>& shapes, const Corner& a, const Corner& b) {
    for (std::size_t i = 1; i < 3; ++i)
        for (std::size_t j = 1; j < 3; ++j)
            if (place_at(shapes[a.mesh], a.triangle, a.k + i) == place_at(shapes[b.mesh], b.triangle, b.k + j))
                return {i, j};
    return {};
}

using Labels = std::vector<std::size_t>;

void merge(Labels& labels, std::size_t a, std::size_t b) {
    const std::size_t from = labels[a], to = labels[b];
    for (std::size_t& l : labels)
        if (l == from) l = to;
}

dvec3 mean(const std::vector<Corner>& here, const Labels& labels, std::size_t wanted) {
    dvec3 sum;
    for (std::size_t i = 0; i < here.size(); ++i)
        if (labels[i] == wanted) sum += here[i].normal * here[i].angle;
    return normalize_or(sum, dvec3{});
}

/// Whether a triangle before or after has a common edge, and the corner has the normal of both.
bool is_of_its_square(const Shape& s, const Corner& c) {
    for (const std::size_t other : {c.triangle - 1, c.triangle + 1}) {
        if (other >= s.indices.size() / 3) continue;
        std::size_t common = 0;
        for (std::size_t i = 0; i < 9; ++i) common += s.indices[3 * c.triangle + i / 3] == s.indices[3 * other + i % 3];
        const dvec3 both = edge_product(s, c.triangle) + edge_product(s, other);
        if (common == 2 && degrees_between(c.normal, normalize_or(both, dvec3{})) <= 5) return true;
    }
    return false;
}

bool is_authored_flat(const std::vector<Shape>& shapes, const Corner& c) {
    double lean = degrees_between(c.normal, c.face), apart = c.counts[1] || c.counts[2] ? 0 : 9;
    for (std::size_t i = 1; i < 3; ++i) {
        if (!c.counts[i]) continue;
        const dvec3 other = normal_at(shapes[c.mesh], c.triangle, c.k + i);
        lean = std::max(lean, degrees_between(other, c.face));
        apart = std::max(apart, length(other - c.normal));
    }
    return lean <= 1 || (apart <= 1e-3 && is_of_its_square(shapes[c.mesh], c));
}

dvec3 edge_of(const std::vector<Shape>& shapes, const Corner& c, std::size_t i) {
    return cast<double>(place_at(shapes[c.mesh], c.triangle, c.k + i)) - cast<double>(c.place);
}

/// [degrees] Between face and normals, looking along an edge: signed angles about it.
double tilt_across(const std::vector<Shape>& shapes, const Corner& c, dvec3 edge) {
    const dvec3 axis = normalize_or(edge, dvec3{}), up = normalize_or(cross(c.face, axis), dvec3{});
    const dvec3 right = cross(axis, up);
    const auto tilt = [&](dvec3 n) {
        const auto angle = [&](dvec3 v) { return degrees(std::atan2(dot(v, up), dot(v, right))); };
        return std::fabs(std::remainder(angle(n) - angle(c.face), 360));
    };
    double most = tilt(c.normal);
    for (std::size_t i = 1; i < 3; ++i)
        if (c.counts[i]) most = std::max(most, tilt(normal_at(shapes[c.mesh], c.triangle, c.k + i)));
    return most;
}

/// Whether the normals of a fan say that its edges with another fan are creases.
bool shows_crease(const std::vector<Shape>& shapes, const std::vector<Corner>& here, const Labels& fans,
                  std::size_t fan, std::size_t other, double bend, double crease_deg) {
    std::vector<dvec3> edges;
    for (std::size_t i = 0; i < here.size(); ++i)
        for (std::size_t j = 0; j < here.size(); ++j)
            if (fans[i] == fan && fans[j] == other && degrees_between(here[i].face, here[j].face) <= crease_deg)
                if (const std::size_t k = common_edge(shapes, here[i], here[j]).first; k > 0)
                    edges.push_back(edge_of(shapes, here[i], k));
    double across = 0, whole = 0;
    bool is_shown = false;
    for (std::size_t i = 0; i < here.size(); ++i) {
        if (fans[i] != fan) continue;
        double least = 180;
        for (const dvec3 edge : edges) least = std::min(least, tilt_across(shapes, here[i], edge));
        across = std::max(across, least);
        whole = std::max(whole, degrees_between(here[i].normal, here[i].face));
        is_shown = is_shown || here[i].counts[1] || here[i].counts[2];
    }
    return is_shown ? across <= 0.23 * bend : bend > 25 && whole <= 0.23 * bend;
}

bool stays_hard(const std::vector<Shape>& shapes, const std::vector<Corner>& here, const Labels& fans, std::size_t i,
                std::size_t j, double bend, double crease_deg) {
    const double apart = degrees_between(here[i].normal, here[j].normal);
    if (apart <= 0.01) return false;
    if ((bend > 1 || apart > 3) && is_authored_flat(shapes, here[i]) && is_authored_flat(shapes, here[j])) return true;
    return bend > 1 && shows_crease(shapes, here, fans, fans[i], fans[j], bend, crease_deg) &&
           shows_crease(shapes, here, fans, fans[j], fans[i], bend, crease_deg);
}

/// The corners of one place after one round of the rule, every corner compared with every other one.
std::vector<Corner> one_round(const std::vector<Shape>& shapes, const std::vector<Corner>& here, double crease_deg) {
    Labels fans(here.size());
    std::iota(fans.begin(), fans.end(), 0u);
    for (std::size_t i = 0; i < here.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (here[i].mesh == here[j].mesh && length(here[i].normal - here[j].normal) <= 1e-3) merge(fans, i, j);
    std::vector<std::tuple<double, double, std::size_t, std::size_t>> joints;
    for (std::size_t i = 0; i < here.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double bend = degrees_between(here[i].face, here[j].face);
            if (here[i].mesh == here[j].mesh || bend > crease_deg) continue;
            if (common_edge(shapes, here[i], here[j]).first == 0) continue;
            if (stays_hard(shapes, here, fans, i, j, bend, crease_deg)) continue;
            joints.emplace_back(-dot(mean(here, fans, fans[i]), mean(here, fans, fans[j])), bend, i, j);
        }
    std::sort(joints.begin(), joints.end());
    Labels groups = fans;
    for (const auto& [nearness, bend, i, j] : joints) {
        bool is_allowed = groups[i] != groups[j];
        for (std::size_t a = 0; a < here.size(); ++a)
            for (std::size_t b = 0; b < here.size(); ++b)
                if (groups[a] == groups[i] && groups[b] == groups[j] && here[a].mesh == here[b].mesh)
                    is_allowed = false;
        if (is_allowed) merge(groups, i, j);
    }
    std::vector<Corner> after = here;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const bool is_joined = std::any_of(joints.begin(), joints.end(), [&](const auto& joint) {
            const auto [nearness, bend, a, b] = joint;
            const bool is_open = degrees_between(here[a].normal, here[b].normal) > 0.01;
            return is_open && groups[a] == groups[i] && groups[b] == groups[i];
        });
        if (is_joined) after[i].normal = mean(here, groups, groups[i]);
    }
    return after;
}

/// The normal of each corner after the rule of the header.
std::vector<dvec3> by_brute_force(const std::vector<Shape>& shapes, double crease_deg) {
    const std::vector<Corner> all = all_corners(shapes);
    std::vector<dvec3> normals;
    for (const Corner& of : all) {
        std::vector<Corner> here;
        std::size_t own = 0;
        for (const Corner& c : all) {
            if (!(c.place == of.place)) continue;
            if (c.mesh == of.mesh && c.triangle == of.triangle && c.k == of.k) own = here.size();
            here.push_back(c);
        }
        for (bool turns = true; turns;) {
            const std::vector<Corner> after = one_round(shapes, here, crease_deg);
            turns = !std::ranges::equal(after, here, {}, &Corner::normal, &Corner::normal);
            here = after;
        }
        normals.push_back(here[own].normal);
    }
    return normals;
}

TEST(JoinSeams, EveryCornerOfRandomModelsIsAsComparingAllWithAllSays) {
    std::uint64_t turned = 0, flat_pairs = 0, crease_pairs = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const std::vector<Shape> before = random_parts(seed);
        const double crease = seed % 3 == 0 ? 15 : 60;
        const Joined joined = join(before, crease);
        const std::vector<Shape> after = applied(before, joined);
        const std::vector<dvec3> wanted = by_brute_force(before, crease);
        turned += joined.report.turned, flat_pairs += joined.report.flat_pairs;
        crease_pairs += joined.report.crease_pairs;
        EXPECT_EQ(join(after, crease).report.turned, 0u) << "a second call changes nothing, seed " << seed;
        std::size_t i = 0;
        for (std::size_t m = 0; m < after.size(); ++m)
            for (std::size_t t = 0; t < after[m].indices.size() / 3; ++t)
                for (std::size_t k = 0; k < 3; ++k, ++i)
                    ASSERT_LT(degrees_between(normal_at(after[m], t, k), wanted[i]), 1e-4)
                        << "seed " << seed << ", mesh " << m << ", triangle " << t << ", corner " << k;
    }
    EXPECT_GT(turned, 500u) << "models at which something happens";
    EXPECT_GT(flat_pairs, 20u);
    EXPECT_GT(crease_pairs, 5u);
}

TEST(JoinSeams, ThreadsDoNotCountAndTheOrderOfMeshesAndFacesOnlyForRounding) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-0.001f, 0.001f);
    Shape whole = make_sphere(160, 80);
    for (vec3& p : whole.positions) p = p + vec3{value(random), value(random), value(random)};  // no two edges alike
    std::vector<Shape> parts = cut_at_random(whole, 5, 3);
    for (Shape& s : parts)
        for (const vec3 p : s.positions)
            s.normals.push_back(cast<float>(
                normalize_or(cast<double>(p) + dvec3{100.0 * value(random), 100.0 * value(random), 0}, dvec3{})));
    const Joined one = join(parts, 60, 1), many = join(parts, 60, 8);
    ASSERT_EQ(one.report, many.report);
    ASSERT_GT(one.report.turned, 5000u);
    for (std::size_t m = 0; m < parts.size(); ++m) {
        ASSERT_EQ(one.meshes[m].vertices, many.meshes[m].vertices);
        ASSERT_EQ(one.meshes[m].normals, many.meshes[m].normals);
    }
    std::vector<Shape> turned_round(parts.rbegin(), parts.rend());
    for (Shape& s : turned_round) {  // faces the other way round in their list, corners moved on by one
        std::vector<std::uint32_t> indices;
        for (std::size_t t = s.indices.size() / 3; t-- > 0;)
            for (std::size_t k = 1; k < 4; ++k) indices.push_back(s.indices[3 * t + k % 3]);
        s.indices = indices;
    }
    const Joined other = join(turned_round);
    EXPECT_EQ(other.report.turned, one.report.turned);
    for (std::size_t m = 0; m < parts.size(); ++m) {
        const MeshSeams &a = one.meshes[m], &b = other.meshes[parts.size() - 1 - m];
        ASSERT_EQ(a.vertices, b.vertices);
        for (std::size_t i = 0; i < a.normals.size(); ++i)
            ASSERT_LT(length(cast<double>(a.normals[i]) - cast<double>(b.normals[i])), 1e-6);
    }
}

TEST(JoinSeams, AnEdgeOfVeryManyFacesIsLookedAtInLinearTimeAndJoinsNeighbors) {
    // 3000 pages of a book, each a mesh: neighbors differ by 0.06 degrees, so that all are joined.
    std::vector<Shape> pages;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const double a = radians(180.0 * i / 3000);
        Shape s;
        s.object = i;
        s.positions = {{0, 0, 0}, {0, 0, 1}, {float(std::cos(a)), float(std::sin(a)), 0}};
        s.indices = {0, 1, 2};
        s.normals.assign(3, cast<float>(normalize_or(dvec3{-std::sin(a), std::cos(a), 0.3}, dvec3{})));
        pages.push_back(s);
    }
    const Joined joined = join(pages, 10);
    EXPECT_GE(joined.report.turned, 5900u);
    EXPECT_EQ(joined.meshes[0].normals, joined.meshes[2999].normals);
}

TEST(JoinSeams, SizesThatDoNotFitAreAnError) {
    std::vector<Shape> hinge = make_hinge(0);
    hinge[0].normals.assign(3, {0, 1, 0});
    hinge[1].normals.assign(4, {0, 1, 0});
    EXPECT_THROW(join(hinge), Error);
}

TEST(TurnedTangent, IsTurnedByTheSmallestRotationAndStaysPerpendicular) {
    const vec3 from{0, 1, 0}, to{0, 0, 1};
    EXPECT_EQ(turned_tangent({1, 0, 0, -1}, from, to), (vec4{1, 0, 0, -1})) << "along the axis";
    const vec4 t = turned_tangent({0, 0, 1, 1}, from, to);
    EXPECT_NEAR(t.y, -1, 1e-7);
    const vec4 skew = turned_tangent({0.8f, 0.6f, 0, 1}, from, to);
    EXPECT_NEAR(skew.x, 1, 1e-7) << "made perpendicular";
    for (const vec3 opposite : {vec3{0, -1, 0}, vec3{0, 1, 0}}) {
        const vec4 u = turned_tangent({0, 1, 0, 1}, from, opposite);
        EXPECT_NEAR(length(u.xyz()), 1, 1e-6);
        EXPECT_NEAR(dot(u.xyz(), opposite), 0, 1e-6);
    }
    EXPECT_LT(degrees_between(turned_along({0, 2, 0}, from, to), vec3{0, 0, 2}), 1e-5);
}

}  // namespace
}  // namespace rakelight::test
