// SPDX-License-Identifier: Apache-2.0
// Fitted normals: exact where the form is, the same over borders of objects, orders, threads; never far off.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "geometry/fits/height_fit.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

AttributeOptions by(CornerWeight weight, double crease_deg = 180) {
    AttributeOptions options;
    options.weight = weight, options.crease_angle_rad = radians(crease_deg), options.tangents = false;
    return options;
}

/// The largest angle between the normals of the same places. [degrees]
double largest_difference(const std::vector<Shape>& one, const AttributeOptions& options,
                          const std::vector<Shape>& other) {
    std::map<std::tuple<float, float, float>, vec3> at;
    const auto fill = [&](const std::vector<Shape>& shapes, const auto& take) {
        const auto out = compute(shapes, options);
        for (std::size_t m = 0; m < shapes.size(); ++m)
            for (std::size_t i = 0; i < shapes[m].indices.size(); ++i) {
                const vec3 p = shapes[m].positions[shapes[m].indices[i]];
                take(std::tuple{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, corner_normal(shapes[m], out[m], i));
            }
    };
    fill(one, [&](const auto& place, vec3 n) { at[place] = n; });
    double worst = 0;
    fill(other, [&](const auto& place, vec3 n) { worst = std::max(worst, angle_between(at.at(place), n)); });
    return degrees(worst);
}

std::vector<dvec3> around(const std::function<double(double, double)>& height) {
    std::vector<dvec3> out;
    for (int ring = 1; ring <= 2; ++ring)
        for (int i = 0; i < 6 * ring; ++i) {
            const double a = 2 * pi * (i + 0.2 * ring) / (6 * ring), r = 0.8 * ring + 0.1 * std::sin(5.0 * i);
            const double x = r * std::cos(a), y = r * std::sin(a);
            out.push_back({x, y, height(x, y)});
        }
    return out;
}

TEST(HeightFit, ACubicFormIsFoundExactly) {
    // The circle of the quadratic terms is of fourth order: a form without them.
    const auto neighbors = around([](double x, double y) { return 0.1 * x - 0.05 * y + 0.01 * x * x * y; });
    const dvec3 exact = normalize_or(dvec3{-0.1, 0.05, 1}, {});
    EXPECT_LT(degrees(angle_between(fit_height(neighbors, {0, 0, 1}, geometry::HeightForm::cubic).normal, exact)), 0.1);
    EXPECT_GT(degrees(angle_between(fit_height(neighbors, {0, 0, 1}, geometry::HeightForm::quadric).normal, exact)),
              0.001);
}

TEST(HeightFit, ASphereIsExactFromAGuessThatIsNot) {
    const double radius = 3;
    const auto neighbors =
        around([&](double x, double y) { return std::sqrt(radius * radius - x * x - y * y) - radius; });
    for (const auto form : {geometry::HeightForm::quadric, geometry::HeightForm::cubic}) {
        const geometry::HeightFit fit = fit_height(neighbors, normalize_or(dvec3{0.1, -0.05, 1}, {}), form);
        EXPECT_LT(degrees(angle_between(fit.normal, dvec3{0, 0, 1})), 0.01);
        EXPECT_LT(fit.residual, 1e-6 * fit.bent);
        EXPECT_GT(fit.certainty, 1e-3);
    }
}

TEST(HeightFit, NeighborsThatDetermineNothingAreSaid) {
    const std::vector<dvec3> line = {{-2, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    for (const auto form : {geometry::HeightForm::quadric, geometry::HeightForm::cubic}) {
        const geometry::HeightFit fit = fit_height(line, {0, 0, 1}, form);
        EXPECT_LT(fit.certainty, 1e-8);
        EXPECT_TRUE(std::isfinite(fit.normal.x) && std::isfinite(fit.normal.y) && std::isfinite(fit.normal.z));
        EXPECT_EQ(fit_height({}, {0, 1, 0}, form).normal, (dvec3{0, 1, 0}));
    }
}

TEST(FitNormals, CutsAndOrdersChangeNothing) {
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic})
        for (const Shape& whole : {make_torus(24, 12), make_sphere(20, 10)}) {
            for (const std::uint32_t parts : {2u, 7u, 40u}) {
                EXPECT_LT(largest_difference({whole}, by(weight), cut_at_random(whole, parts, parts)), 1e-5);
                EXPECT_LT(largest_difference({whole}, by(weight), cut_by_planes(whole, parts)), 1e-5);
            }
            Shape other = whole;
            std::mt19937 random(5);
            std::vector<std::uint32_t> order(whole.indices.size() / 3);
            std::iota(order.begin(), order.end(), 0u);
            std::shuffle(order.begin(), order.end(), random);
            for (std::size_t t = 0; t < order.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    other.indices[3 * t + k] = whole.indices[3 * order[t] + (k + t) % 3];
            EXPECT_LT(largest_difference({whole}, by(weight), {other}), 1e-5);
        }
}

TEST(FitNormals, AllCornersOfAGroupHaveTheSameBits) {
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic}) {
        const std::vector<Shape> parts = cut_at_random(make_torus(24, 12), 9, 2);
        const auto out = compute(parts, by(weight, 60));
        std::map<std::tuple<float, float, float>, vec3> seen;
        for (std::size_t m = 0; m < parts.size(); ++m)
            for (std::size_t i = 0; i < parts[m].indices.size(); ++i) {
                const vec3 p = parts[m].positions[parts[m].indices[i]], n = corner_normal(parts[m], out[m], i);
                const auto [at, is_new] = seen.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, n);
                EXPECT_EQ(at->second, n);
            }
    }
}

TEST(FitNormals, TheSameBitsForAnyNumberOfThreads) {
    const std::vector<Shape> parts = cut_at_random(make_torus(200, 100), 5, 2);
    const std::vector<AttributeMesh> meshes = views(parts);
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic}) {
        Context one({.threads = 1}), three({.threads = 3});
        const auto a = compute_attributes(meshes, by(weight, 60), one),
                   b = compute_attributes(meshes, by(weight, 60), three);
        for (std::size_t m = 0; m < meshes.size(); ++m) EXPECT_EQ(a[m].normals, b[m].normals);
    }
}

TEST(FitNormals, ACubeStaysFlatAndItsCornersMeetInTheMiddle) {
    const Shape cube = make_cube();
    const MeshAttributes hard = compute({cube}, by(CornerWeight::automatic, 60)).front(),
                         soft = compute({cube}, by(CornerWeight::automatic)).front();
    for (const vec3 n : hard.normals) EXPECT_NEAR(std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}), 1, 1e-6);
    for (const vec3 n : soft.normals) EXPECT_NEAR(std::fabs(n.x), 1 / std::sqrt(3.0), 1e-3);
}

TEST(FitNormals, NothingIsTooSmallTooLargeOrTooBrokenForThem) {
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic}) {
        for (const float size : {1e-18f, 1e15f}) {
            Shape s = make_torus(24, 12);
            for (vec3& p : s.positions) p = p * size;
            const auto out = compute({s}, by(weight)).front();
            const auto usual = compute({make_torus(24, 12)}, by(weight)).front();
            for (std::size_t v = 0; v < out.normals.size(); ++v)
                EXPECT_LT(degrees(angle_between(out.normals[v], usual.normals[v])), 1e-3) << size;
        }
        const Shape fan = [] {  // many faces meet in a point, some of them nothing
            Shape s;
            s.positions.push_back({0, 0, 0});
            for (int i = 0; i < 5000; ++i)
                s.positions.push_back({std::cos(float(i)), std::sin(float(i)), 0.1f * std::sin(3 * float(i))});
            for (std::uint32_t i = 1; i < 5000; ++i)
                for (const std::uint32_t v : {0u, i, i % 7 == 0 ? i : i + 1}) s.indices.push_back(v);
            return s;
        }();
        const MeshAttributes of_fan = compute({fan}, by(weight)).front();
        for (const vec3 n : of_fan.normals) EXPECT_NEAR(length(n), 1, 1e-5);
    }
}

TEST(FitNormals, AuthoredNormalsStayAndAreTakenBesideThem) {
    std::vector<Shape> parts = cut_by_planes(make_torus(24, 12), 2);
    std::vector<AttributeMesh> meshes = views(parts);
    const vec3 authored = cast<float>(normalize_or(dvec3{0.3, 0.8, 0.2}, {}));
    const std::vector<vec3> normals(parts[0].positions.size(), authored);
    const std::vector<std::uint8_t> locked(parts[0].positions.size(), 2);
    meshes[0].normals = normals, meshes[0].locked = locked;
    Context context;
    for (const CornerWeight weight : {CornerWeight::max, CornerWeight::fit, CornerWeight::automatic}) {
        const auto out = compute_attributes(meshes, by(weight), context);
        for (const vec3 n : out[0].normals) EXPECT_EQ(n, authored);
        // Of the other part those at its border, where the authored normal is on their side: as with a weight.
        const auto taken = std::count(out[1].normals.begin(), out[1].normals.end(), authored);
        EXPECT_GT(taken, 0) << int(weight);
        EXPECT_LT(taken, std::ptrdiff_t(out[1].normals.size()) / 2) << int(weight);
    }
}

TEST(FitNormals, ATubeOfOneRowOfFacesHasNormalsAcrossItsAxis) {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t sides = 12;
    for (std::uint32_t i = 0; i < 2 * sides; ++i) {
        const double a = 2 * pi * (i % sides) / sides;
        positions.push_back({float(std::cos(a)), float(std::sin(a)), i < sides ? 0.0f : 1.0f});
    }
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        for (const std::uint32_t v : {i, next, next + sides, i, next + sides, i + sides}) indices.push_back(v);
    }
    const AttributeMesh mesh{.positions = positions, .indices = indices};
    Context context;
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic}) {
        const MeshAttributes out = compute_attributes({&mesh, 1}, by(weight), context).front();
        for (const vec3 n : out.normals) EXPECT_NEAR(n.z, 0, 1e-5) << int(weight);
    }
}

TEST(FitNormals, MemoryIsAskedForBeforeItIsTaken) {
    const std::vector<Shape> parts = {make_torus(100, 50)};
    const std::vector<AttributeMesh> meshes = views(parts);
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic}) {
        Context context({.threads = 1, .max_memory = 700'000});
        EXPECT_NO_THROW(compute_attributes(meshes, by(CornerWeight::max), context));
        EXPECT_THROW(compute_attributes(meshes, by(weight), context), Error);
    }
}

}  // namespace
}  // namespace rakelight::test
