// SPDX-License-Identifier: Apache-2.0
#include "prepare/shapes/primitives.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

#include <rakelight/base/context.h>
#include <rakelight/base/error.h>
#include <rakelight/scene/validate.h>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr PrimitiveShape shapes[] = {PrimitiveShape::sphere, PrimitiveShape::cylinder, PrimitiveShape::cone,
                                     PrimitiveShape::torus, PrimitiveShape::plane};

dvec3 at(const Mesh& mesh, std::uint32_t v) {
    const vec3 p = mesh.positions[v];
    return {double(p.x), double(p.y), double(p.z)};
}

void for_each_triangle(const Scene& scene, const std::function<void(const Mesh&, std::array<std::uint32_t, 3>)>& f) {
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
            f(mesh, {mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2]});
}

/// [m] distance of a point from the surface, signed or not; closed forms.
double distance(const PrimitiveRequest& r, dvec3 p) {
    const double rho = std::hypot(p.x, p.z), half = r.height / 2;
    switch (r.shape) {
        case PrimitiveShape::sphere:
            return length(p) - r.radius;
        case PrimitiveShape::torus:
            return std::hypot(rho - r.radius, p.y) - r.tube_radius;
        case PrimitiveShape::cylinder:
            return std::max(rho - r.radius, std::abs(p.y) - half);
        case PrimitiveShape::cone: {
            const double slant = std::hypot(r.radius, r.height);
            return std::max((rho * r.height + (p.y - half) * r.radius) / slant, -half - p.y);
        }
        case PrimitiveShape::plane:
            return p.y;
    }
    return 0;
}

PrimitiveRequest odd_sizes(PrimitiveShape shape) {
    return {.shape = shape, .radius = 1.7, .tube_radius = 0.4, .height = 2.3, .width = 3, .depth = 1.5, .divisions = 7};
}

struct Measure {
    double volume = 0, area = 0;
};
Measure measure(const Scene& scene) {
    Measure m;
    for_each_triangle(scene, [&](const Mesh& mesh, std::array<std::uint32_t, 3> t) {
        const dvec3 a = at(mesh, t[0]), b = at(mesh, t[1]), c = at(mesh, t[2]);
        m.volume += dot(a, cross(b, c)) / 6;
        m.area += length(cross(b - a, c - a)) / 2;
    });
    return m;
}

Measure exact(const PrimitiveRequest& r) {
    const double R = r.radius, t = r.tube_radius, h = r.height;
    switch (r.shape) {
        case PrimitiveShape::sphere:
            return {4 * pi / 3 * R * R * R, 4 * pi * R * R};
        case PrimitiveShape::cylinder:
            return {pi * R * R * h, 2 * pi * R * (R + h)};
        case PrimitiveShape::cone:
            return {pi * R * R * h / 3, pi * R * (R + std::hypot(R, h))};
        case PrimitiveShape::torus:
            return {2 * pi * pi * R * t * t, 4 * pi * pi * R * t};
        case PrimitiveShape::plane:
            return {0, r.width * r.depth};
    }
    return {};
}

TEST(Primitives, EveryVertexLiesOnTheSurfaceWithItsNormal) {
    for (const PrimitiveShape shape : shapes) {
        const PrimitiveRequest r = odd_sizes(shape);
        const Scene scene = make_primitive(r);
        EXPECT_NO_THROW(validate(scene));
        const Mesh& mesh = scene.meshes[0];
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
            const dvec3 p = at(mesh, v),
                        n = {double(mesh.normals[v].x), double(mesh.normals[v].y), double(mesh.normals[v].z)};
            ASSERT_NEAR(distance(r, p), 0, 4e-7) << name_of(shape);
            ASSERT_NEAR(length(n), 1, 2e-7);
            if (shape == PrimitiveShape::plane) continue;
            // outward, and along the normal the distance grows as fast as one walks (caps and sides alike)
            ASSERT_GT(distance(r, p + n * 1e-3), 0.999e-3) << name_of(shape) << " " << p.x << " " << p.y << " " << p.z;
        }
    }
}

TEST(Primitives, NoPointOfATriangleIsFurtherFromTheSurfaceThanTheTolerance) {
    for (const PrimitiveShape shape : shapes)
        for (const double tolerance : {0.2, 0.03, 0.004, 0.0005}) {
            PrimitiveRequest r = odd_sizes(shape);
            r.tolerance = tolerance;
            double worst = 0;
            for_each_triangle(make_primitive(r), [&](const Mesh& mesh, std::array<std::uint32_t, 3> t) {
                const dvec3 a = at(mesh, t[0]), b = at(mesh, t[1]), c = at(mesh, t[2]);
                for (int i = 0; i <= 6; ++i)
                    for (int j = 0; j <= 6 - i; ++j)
                        worst = std::max(
                            worst,
                            std::abs(distance(r, (a * double(i) + b * double(j) + c * double(6 - i - j)) * (1.0 / 6))));
            });
            EXPECT_LE(worst, tolerance) << name_of(shape);
            if (shape == PrimitiveShape::plane || tolerance > 0.1) continue;
            EXPECT_GT(worst, tolerance / 5) << name_of(shape) << " is finer than asked for";
        }
}

TEST(Primitives, SolidsAreClosedAcrossAllObjects) {
    using Point = std::tuple<float, float, float>;
    const auto key = [](vec3 p) { return Point(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f); };
    for (const PrimitiveShape shape : shapes)
        for (const auto& [objects, tolerance] : {std::pair{1, 0.0}, {16, 0.0}, {1, 0.2}, {7, 0.03}, {16, 0.004}}) {
            if (shape == PrimitiveShape::plane) continue;
            PrimitiveRequest r = odd_sizes(shape);
            r.objects = objects, r.tolerance = tolerance;
            const Scene scene = make_primitive(r);
            EXPECT_EQ(scene.nodes.size(), std::size_t(objects));
            EXPECT_NO_THROW(validate(scene));
            std::map<std::pair<Point, Point>, int> edges;
            for_each_triangle(scene, [&](const Mesh& mesh, std::array<std::uint32_t, 3> t) {
                for (std::size_t k = 0; k < 3; ++k)
                    ++edges[{key(mesh.positions[t[k]]), key(mesh.positions[t[(k + 1) % 3]])}];
            });
            for (const auto& [edge, count] : edges) {
                const auto back = edges.find({edge.second, edge.first});
                ASSERT_TRUE(count == 1 && back != edges.end() && back->second == 1) << name_of(shape);
            }
        }
}

TEST(Primitives, VolumeAndAreaGoToTheClosedFormsAsTheToleranceDoes) {
    for (const PrimitiveShape shape : shapes) {
        PrimitiveRequest r = odd_sizes(shape);
        const Measure wanted = exact(r);
        double before = 1;
        for (const double tolerance : {0.02, 0.002, 0.0002}) {
            r.tolerance = tolerance;
            const Measure got = measure(make_primitive(r));
            if (shape == PrimitiveShape::plane) {
                EXPECT_DOUBLE_EQ(got.area, wanted.area);
                continue;
            }
            const double error = std::abs(got.volume / wanted.volume - 1);
            EXPECT_GT(got.volume, 0) << name_of(shape);  // turned outwards
            EXPECT_LE(error, 6 * tolerance) << name_of(shape);
            EXPECT_LE(std::abs(got.area / wanted.area - 1), 6 * tolerance) << name_of(shape);
            EXPECT_LT(error, before / 5);
            before = error;
        }
    }
}

TEST(Primitives, TexturesAreUprightAndNotMirroredSeenFromOutside) {
    for (const PrimitiveShape shape : shapes)
        for_each_triangle(make_primitive(odd_sizes(shape)), [&](const Mesh& mesh, std::array<std::uint32_t, 3> t) {
            const auto uv = [&](std::size_t k) { return mesh.texcoords[0][t[k]]; };
            const double du1 = double(uv(1).x - uv(0).x), dv1 = double(uv(1).y - uv(0).y);
            const double du2 = double(uv(2).x - uv(0).x), dv2 = double(uv(2).y - uv(0).y);
            ASSERT_LT(du1 * dv2 - du2 * dv1, 0) << name_of(shape);  // v is down
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_GE(uv(k).x, 0.0f);
                ASSERT_LE(uv(k).x, 1.0f);
                ASSERT_GE(uv(k).y, 0.0f);
                ASSERT_LE(uv(k).y, 1.0f);
            }
        });
}

TEST(Primitives, NamesGoBothWays) {
    for (const PrimitiveShape shape : shapes) EXPECT_EQ(primitive_named(name_of(shape)), shape);
    EXPECT_FALSE(primitive_named("teapots").has_value());
}

TEST(Primitives, ChargeWhatTheirArraysHoldBeforeTheyAreMade) {
    for (const PrimitiveShape shape : shapes)
        for (const int objects : {1, 7}) {
            PrimitiveRequest r = odd_sizes(shape);
            r.objects = objects;
            MemoryBudget memory;
            std::uint64_t held = 0;
            const Scene scene = make_primitive(r, &memory);
            for (const Mesh& mesh : scene.meshes) held += mesh.positions.size() * 32 + mesh.indices.size() * 4;
            EXPECT_EQ(memory.charged(), held) << name_of(shape) << objects;
            MemoryBudget small(held - 1);
            EXPECT_THROW(make_primitive(r, &small), Error) << name_of(shape) << objects;
        }
}

TEST(Primitives, RefusesWhatCannotBe) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(make_primitive({.radius = 0}), Error);
    EXPECT_THROW(make_primitive({.radius = nan}), Error);
    EXPECT_THROW(make_primitive({.radius = 1e9}), Error);
    EXPECT_THROW(make_primitive({.tolerance = -1}), Error);
    EXPECT_THROW(make_primitive({.tolerance = nan}), Error);
    EXPECT_THROW(make_primitive({.tolerance = 1e-12}), Error);
    EXPECT_THROW(make_primitive({.objects = 0}), Error);
    EXPECT_THROW(make_primitive({.shape = PrimitiveShape::plane, .objects = 3}), Error);
    EXPECT_THROW(make_primitive({.shape = PrimitiveShape::plane, .divisions = 5000}), Error);
    EXPECT_THROW(make_primitive({.shape = PrimitiveShape::torus, .radius = 1, .tube_radius = 1.5}), Error);
    EXPECT_THROW(make_primitive({.shape = PrimitiveShape::cone, .height = -2}), Error);
}

}  // namespace
}  // namespace rakelight
