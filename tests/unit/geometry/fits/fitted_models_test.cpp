// SPDX-License-Identifier: Apache-2.0
// Fitted normals and automatic creases of whole models: poses, other plans, placements, cuts, orders, instruction sets,
// crowded places, little memory and broken faces change nothing that they should not.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include <rakelight/geometry/creases.h>

#include "geometry/fits/height_fit.h"
#include "math/isa.h"
#include "support/environment_variable.h"
#include "unit/geometry/creases/hard_shapes.h"

namespace rakelight::test {
namespace {

constexpr CornerWeight fitted[] = {CornerWeight::fit, CornerWeight::automatic};

AttributeOptions by(CornerWeight weight, Creasing creases, double crease_deg = 180) {
    AttributeOptions options;
    options.weight = weight, options.creases = creases, options.tangents = false;
    options.crease_angle_rad = crease_deg == 180 ? pi : radians(crease_deg);
    return options;
}
/// Both weights by the rule, by an angle, and with everything joined.
std::vector<AttributeOptions> all_options() {
    std::vector<AttributeOptions> all;
    for (const CornerWeight weight : fitted) {
        all.push_back(by(weight, Creasing::automatic));
        for (const double deg : {60.0, 180.0}) all.push_back(by(weight, Creasing::angle, deg));
    }
    return all;
}

Shape make_lump() {
    return make_grid(24, 14, [](double u, double v) {
        const double a = wrapped(u), b = pi * v, ring = v <= 0 || v >= 1 ? 0 : std::sin(b);
        const double r = 1 + 0.2 * std::sin(3 * a) * ring + 0.15 * std::cos(4 * b);
        return vec3{float(r * ring * std::cos(a)), float(-r * std::cos(b)), float(-r * ring * std::sin(a))};
    });
}
std::vector<Shape> models() { return {make_lump(), make_torus(24, 12), make_chamfered_box(0.2).shape}; }

/// An open wall that tapers, elliptic and of two rows, and a lump with noise: fits are badly determined in places, and
/// trusted in part.
std::vector<Shape> rough_models() {
    Shape cup = make_grid(16, 2, [](double u, double v) {
        const double a = wrapped(u), r = 1 - 0.2 * v;
        return vec3{float(r * std::cos(a)), float(v), float(-0.6 * r * std::sin(a))};
    });
    Shape lump = make_lump();
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(-0.01f, 0.01f);
    std::map<std::tuple<float, float, float>, vec3> moved;  // the ends of the grid share places
    for (vec3& p : lump.positions) {
        const auto at = moved.try_emplace({p.x, p.y, p.z}, p + vec3{noise(random), noise(random), noise(random)});
        p = at.first->second;
    }
    lump.indices.resize(lump.indices.size() / 2 / 3 * 3);  // open
    return {std::move(cup), std::move(lump)};
}

using Place = std::tuple<float, float, float>;
Place place_of(vec3 p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }
vec3 key_point(const Shape& s, std::size_t triangle) { return cast<float>(centroid(s, triangle)); }

/// The normal of each corner, by the place of the corner and the middle of its face: for models in other orders.
std::map<std::pair<Place, Place>, vec3> corners_of(const std::vector<Shape>& shapes, const AttributeOptions& options) {
    std::map<std::pair<Place, Place>, vec3> all;
    const auto out = compute(shapes, options);
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < shapes[m].indices.size(); ++i)
            all[{place_of(shapes[m].positions[shapes[m].indices[i]]), place_of(key_point(shapes[m], i / 3))}] =
                corner_normal(shapes[m], out[m], i);
    return all;
}
/// [rad] the largest angle between the normals of two forms of one model.
double difference(const std::vector<Shape>& one, const std::vector<Shape>& other, const AttributeOptions& options) {
    const auto a = corners_of(one, options), b = corners_of(other, options);
    EXPECT_EQ(a.size(), b.size());
    double worst = 0;
    for (const auto& [key, n] : b) {
        const auto at = a.find(key);
        worst = at == a.end() ? 9 : std::max(worst, angle_between(at->second, n));
    }
    return worst;
}

Shape reordered(const Shape& from, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> vertex(from.positions.size()), face(from.indices.size() / 3);
    std::iota(vertex.begin(), vertex.end(), 0u);
    std::iota(face.begin(), face.end(), 0u);
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    Shape s;
    s.positions.resize(vertex.size());
    for (std::size_t v = 0; v < vertex.size(); ++v) s.positions[vertex[v]] = from.positions[v];
    for (const std::uint32_t t : face)  // the first corner stays: the middle of a face is summed in the same order
        for (std::size_t k = 0; k < 3; ++k) s.indices.push_back(vertex[from.indices[3 * t + k]]);
    return s;
}

TEST(FittedModels, CutsAndOrdersChangeNothing) {
    for (const AttributeOptions& options : all_options())
        for (const Shape& whole : models()) {
            EXPECT_LT(difference({whole}, cut_at_random(whole, 7, 3), options), 1e-5);
            EXPECT_LT(difference({whole}, cut_by_planes(whole, 4), options), 1e-5);
            EXPECT_LT(difference({whole}, {reordered(whole, 5)}, options), 1e-5);
        }
}

TEST(FittedModels, OrdersOfDoubledFacesChangeNothing) {
    Shape folds = make_grid(12, 12, [](double u, double v) {  // planes that meet, of regular triangles
        return vec3{float(u + 0.2 * v), float(v),
                    float(0.5 * std::fabs(u - 0.5) + (v > 0.5 ? 0.2 * std::sin(9 * u) : 0.0))};
    });
    const std::vector<std::uint32_t> once = folds.indices;
    for (const int times : {2, 3}) {  // 12 and 18 faces at a place
        folds.indices = once;
        for (int n = 1; n < times; ++n) folds.indices.insert(folds.indices.end(), once.begin(), once.end());
        for (const AttributeOptions& options : all_options())
            for (const std::uint32_t seed : {1u, 2u, 3u})
                EXPECT_LT(difference({folds}, {reordered(folds, seed)}, options), 1e-5) << times;
    }
}

/// [rad] of all corners; nothing where the groups differ.
std::optional<double> pose_difference(const std::vector<Shape>& parts, const std::vector<MeshAttributes>& posed,
                                      const std::vector<MeshAttributes>& fresh) {
    double worst = 0;
    for (std::size_t m = 0; m < parts.size(); ++m) {
        if (posed[m].indices != fresh[m].indices) return {};
        for (std::size_t i = 0; i < parts[m].indices.size(); ++i)
            worst = std::max(worst,
                             angle_between(corner_normal(parts[m], posed[m], i), corner_normal(parts[m], fresh[m], i)));
    }
    return worst;
}

TEST(FittedModels, APosedPlanIsThePosedModel) {
    int compared = 0;
    for (const AttributeOptions& options : all_options())
        for (const Shape& whole : models()) {
            std::vector<Shape> parts = cut_by_planes(whole, 3);
            Context context({.threads = 2});
            const AttributePlan plan = group(views(parts), options, context);
            for (Shape& part : parts)  // turned about the axis, more with height: groups stay
                for (vec3& p : part.positions) {
                    const float a = 0.02f * p.y, x = p.x;
                    p.x = x * std::cos(a) - p.z * std::sin(a), p.z = x * std::sin(a) + p.z * std::cos(a);
                }
            const auto difference =
                pose_difference(parts, accumulate(plan, views(parts), context), compute(parts, options));
            EXPECT_LT(difference.value_or(0), 1e-5);
            compared += difference.has_value();
        }
    EXPECT_GE(compared, 16);  // a chamfer that is twisted has no planes for the rule of creases
}

TEST(FittedModels, OtherCreasesOfAPlanAreThoseOfANewOne) {
    for (const Shape& whole : models()) {
        const std::vector<Shape> parts = cut_at_random(whole, 4, 1);
        const auto meshes = views(parts);
        Context context({.threads = 2});
        AttributePlan plan = group(meshes, by(CornerWeight::automatic, Creasing::automatic), context);
        for (const AttributeOptions& options : all_options()) {
            plan = regroup(plan, meshes, options, context);
            const auto again = accumulate(plan, meshes, context), fresh = compute(parts, options);
            EXPECT_LE(largest_difference(again, fresh), float_rounding);
        }
    }
}

/// [rad] between the normals in the world of a placed model, and the normals of the model itself, carried there.
double placed_difference(const Shape& shape, const dmat4& to_world, const AttributeOptions& options) {
    Shape placed = shape;
    placed.to_world = to_world;
    const MeshAttributes here = compute({shape}, options).front(), there = compute({placed}, options).front();
    double worst = here.normals.size() == there.normals.size() ? 0 : 9;
    for (std::size_t i = 0; i < shape.indices.size(); ++i)
        worst = std::max(worst, angle_between(corner_normal(shape, here, i), corner_normal(placed, there, i)));
    return worst;  // rotations, mirrors and equal scales keep angles: object space is enough
}

dmat4 turned(double a, double b, double scale, bool mirrored) {
    dmat4 m;
    const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    const double x[] = {ca, sa, 0}, y[] = {-sa * cb, ca * cb, sb}, z[] = {sa * sb, -ca * sb, cb};
    for (std::size_t r = 0; r < 3; ++r) {
        m[0][r] = (mirrored ? -scale : scale) * x[r], m[1][r] = scale * y[r], m[2][r] = scale * z[r];
        m[3][r] = 3 * double(r) - 1;
    }
    return m;
}

TEST(FittedModels, TurnedScaledAndMirroredPlacesHaveTheSameNormals) {
    constexpr double most = 1e-5;
    std::vector<Shape> shapes = models();
    for (Shape& rough : rough_models()) shapes.push_back(std::move(rough));
    for (const AttributeOptions& options : all_options())
        for (const Shape& shape : shapes)
            for (const bool mirrored : {false, true})
                for (const double scale : {1.0, 0.01, 40.0})
                    EXPECT_LT(placed_difference(shape, turned(0.7, 2.1, scale, mirrored), options), most);
}

/// The same part of a model, but its mesh is mirrored and its placement mirrors it back.
Shape stored_mirrored(Shape s) {
    for (vec3& p : s.positions) p.x = -p.x;
    for (std::size_t i = 0; i < s.indices.size(); i += 3) std::swap(s.indices[i + 1], s.indices[i + 2]);
    s.to_world[0][0] = -1;
    return s;
}

TEST(FittedModels, AModelOfWhichPartsAreStoredMirroredIsTheSame) {
    std::vector<Shape> shapes = models();
    for (const HardShape& hard : {make_fillets(4, 0.3), make_gear(0), make_column(24, false)})
        shapes.push_back(hard.shape);
    for (const AttributeOptions& options : all_options())
        for (const Shape& whole : shapes)
            for (const std::vector<Shape>& parts : {cut_at_random(whole, 3, 8), cut_by_planes(whole, 2)}) {
                std::vector<Shape> mixed = parts;
                mixed[1] = stored_mirrored(parts[1]);
                const auto plain = compute(parts, options), mirrored = compute(mixed, options);
                for (std::size_t m = 0; m < parts.size(); ++m)
                    for (std::size_t i = 0; i < parts[m].indices.size(); ++i) {
                        const std::size_t same = m == 1 && i % 3 > 0 ? i + 3 - 2 * (i % 3) : i;
                        vec3 n = corner_normal(mixed[m], mirrored[m], same);
                        if (m == 1) n.x = -n.x;
                        ASSERT_LT(angle_between(n, corner_normal(parts[m], plain[m], i)), 1e-5) << m << " " << i;
                    }
            }
}

TEST(FittedModels, AStretchedPlaceHasTheNormalsOfTheStretchedModel) {
    for (const AttributeOptions& options : all_options())
        for (const Shape& shape : models())
            for (const float sign : {1.0f, -1.0f}) {
                const vec3 stretch{2 * sign, 0.5f, 4};  // exact in binary
                Shape placed = shape, stretched = shape;
                for (std::size_t c = 0; c < 3; ++c) placed.to_world[c][c] = double(stretch[c]);
                for (vec3& p : stretched.positions) p = {p.x * stretch.x, p.y * stretch.y, p.z * stretch.z};
                if (sign < 0)
                    for (std::size_t i = 0; i < stretched.indices.size(); i += 3)
                        std::swap(stretched.indices[i + 1], stretched.indices[i + 2]);
                const auto a = compute({placed}, options).front(), b = compute({stretched}, options).front();
                for (std::size_t i = 0; i < shape.indices.size(); ++i) {
                    const std::size_t same = sign < 0 && i % 3 > 0 ? i + 3 - 2 * (i % 3) : i;
                    const vec3 n = corner_normal(placed, a, i);
                    const dvec3 world = normalize_or(
                        dvec3{double(n.x / stretch.x), double(n.y / stretch.y), double(n.z / stretch.z)}, {});
                    EXPECT_LT(angle_between(world, cast<double>(corner_normal(stretched, b, same))), 1e-5);
                }
            }
}

TEST(FittedModels, TheSameBitsForInstructionSetsAndThreads) {
    const auto parts = cut_at_random(make_lump(), 5, 2);
    for (const AttributeOptions& options : all_options()) {
        const auto usual = compute(parts, options, 1);
        for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            const EnvironmentVariable set("RAKELIGHT_ISA", name(isa));
            for (const int threads : {1, 3}) {
                const auto out = compute(parts, options, threads);
                for (std::size_t m = 0; m < parts.size(); ++m) EXPECT_EQ(out[m].normals, usual[m].normals) << name(isa);
            }
        }
    }
}

void expect_unit(const std::vector<MeshAttributes>& out) {
    for (const MeshAttributes& mesh : out)
        for (const vec3 n : mesh.normals) ASSERT_NEAR(length(cast<double>(n)), 1, 1e-5);
}

/// Faces around a point, waved.
Shape make_fan(std::uint32_t faces) {
    Shape s;
    s.positions.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i < faces; ++i) {
        const double a = 2 * pi * i / faces;
        s.positions.push_back({float(std::cos(a)), float(std::sin(a)), float(0.1 * std::sin(9 * a))});
    }
    for (std::uint32_t i = 0; i < faces; ++i) s.indices.insert(s.indices.end(), {0, i + 1, (i + 1) % faces + 1});
    return s;
}
/// Pages around one edge, which every second one uses backwards.
Shape make_book(std::uint32_t pages) {
    Shape s;
    s.positions = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t i = 0; i < pages; ++i) {
        const double a = 2 * pi * i / pages;
        s.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0.5f});
        s.indices.insert(s.indices.end(), {i % 2, 1 - i % 2, i + 2});
    }
    return s;
}

// Work that grows with the square of a place's or an edge's faces would take hours here.
TEST(FittedModels, PlacesAndEdgesOfVeryManyFacesEnd) {
    for (const CornerWeight weight : fitted) expect_unit(compute({make_book(100'000)}, by(weight, Creasing::angle)));
    expect_unit(compute({make_book(100'000)}, by(CornerWeight::automatic, Creasing::automatic)));
    expect_unit(compute({make_fan(100'000)}, by(CornerWeight::fit, Creasing::automatic)));
    expect_unit(compute({make_fan(1'000'000)}, by(CornerWeight::automatic, Creasing::automatic)));
}

TEST(FittedModels, LittleMemoryIsAnError) {
    const std::vector<Shape> parts = {make_torus(100, 50)};
    const auto meshes = views(parts);
    const auto fits = [&](const AttributeOptions& options, std::uint64_t bytes) {
        Context context({.threads = 1, .max_memory = bytes});
        try {
            compute_attributes(meshes, options, context);
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_file);
            return false;
        }
    };
    for (const AttributeOptions& options : all_options()) {
        bool before = false;  // once it is enough, more is
        for (std::uint64_t bytes = 1 << 14; bytes <= 1 << 26; bytes *= 2) {
            const bool now = fits(options, bytes);
            EXPECT_TRUE(now || !before);
            before = now;
        }
        EXPECT_TRUE(before);
        EXPECT_FALSE(fits(options, 1 << 16));
    }
    const std::vector<Shape> crowded = {make_fan(100'000)};  // the rings of its middle take more than all else
    Context some({.threads = 1, .max_memory = 24 << 20});
    EXPECT_NO_THROW(compute_attributes(views(crowded), by(CornerWeight::max, Creasing::angle), some));
    EXPECT_THROW(compute_attributes(views(crowded), by(CornerWeight::fit, Creasing::angle), some), Error);
    Context little({.threads = 1, .max_memory = 1 << 16});
    EXPECT_THROW(find_creases(meshes, {}, little), Error);
}

TEST(FittedModels, FewAndBrokenFacesAreNoTrouble) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Shape none, empty, single, lines, broken;
    none.positions = {{1, 2, 3}, {4, 5, 6}};
    single.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    single.indices = {0, 1, 2};
    lines.positions = {{5, 5, 5}, {6, 6, 6}, {7, 7, 7}, {8, 8, 8}};
    lines.indices = {0, 1, 2, 1, 2, 3, 0, 0, 3, 2, 2, 2};
    broken.positions = {{nan, 0, 0}, {inf, 0, 0}, {0, 1, -inf}, {3e38f, 0, 1}, {-3e38f, 1, 0}, {1e-45f, 0, 0}};
    for (std::uint32_t i = 0; i < 6; ++i) broken.indices.insert(broken.indices.end(), {i, (i + 1) % 6, (i + 2) % 6});
    for (const AttributeOptions& options : all_options()) {
        EXPECT_TRUE(compute({}, options).empty());
        for (const Shape& s : {none, empty, single, lines, broken}) expect_unit(compute({s}, options));
        const auto flat = compute({single, none, lines}, options);
        for (const MeshAttributes& mesh : flat)
            for (const vec3 n : mesh.normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
        EXPECT_EQ(flat[2].degenerate_faces, 4u);
        expect_unit(compute({none, empty, single, lines, broken, make_cube()}, options));
    }
    Context context;
    for (const Shape& s : {none, empty, single, lines}) {
        const AttributeMesh mesh = s.view();
        EXPECT_EQ(find_creases(std::span(&mesh, 1), {}, context).report, CreaseReport{});
    }
    EXPECT_TRUE(find_creases({}, {}, context).hard.empty());
}

TEST(FittedModels, AuthoredNormalsOfSmallFacesCountInLargeGroups) {
    Shape large = make_grid(1, 1, [](double u, double v) { return vec3{float(8192 * u), float(8192 * v), 0}; });
    Shape little;
    little.positions = {{0, 0, 0}, {-1e-3f, 0, 0}, {0, -1e-3f, 0}};
    little.indices = {0, 1, 2};
    const vec3 authored = cast<float>(normalize_or(dvec3{0.3, 0.1, 0.8}, {}));
    const std::vector<vec3> normals(3, authored);
    const std::vector<std::uint8_t> locked(3, 2);
    const std::vector<Shape> shapes = {large, little};
    std::vector<AttributeMesh> meshes = views(shapes);
    meshes[1].normals = normals, meshes[1].locked = locked;
    Context context;
    for (const CornerWeight weight : {CornerWeight::area, CornerWeight::fit, CornerWeight::automatic}) {
        const AttributeOptions options = by(weight, Creasing::angle);
        const auto out = compute_attributes(meshes, options, context);
        EXPECT_LT(angle_between(out[0].normals[0], authored), 1e-6);
        EXPECT_EQ(accumulate(group(meshes, options, context), meshes, context)[0].normals, out[0].normals);
    }
}

TEST(FittedModels, PlacesWithoutNeighborsKeepTheirGuess) {
    geometry::HeightBatch batch;
    batch.add({}, 1, {0, 0, 1});
    batch.add({}, 1, {0, 1, 0});
    batch.fit();
    EXPECT_EQ(batch.cubic(0).normal, (dvec3{0, 0, 1}));
    EXPECT_EQ(batch.cubic(1).normal, (dvec3{0, 1, 0}));
}

}  // namespace
}  // namespace rakelight::test
