// SPDX-License-Identifier: Apache-2.0
// Patches of many small triangles.
#include "radiosity/patches.h"

#include <gtest/gtest.h>

#include <random>

#include "radiosity/form_factor.h"
#include "radiosity/visibility.h"
#include "unit/radiosity/box_scene.h"

namespace rakelight::radiosity {
namespace {

/// Small triangles that face up, scattered in a cube of side 1.
Elements dust(std::uint32_t count) {
    std::mt19937 random(1);
    const auto within = [&](double most) { return most * double(random()) / 4294967296.0; };
    Elements out{.base = {0, count}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 at{within(1), within(1), within(1)};
        Element e;
        e.corner = {at, at + dvec3{0.01, 0, within(0.005)}, at + dvec3{0, 0.01, within(0.005)}};
        e.center = (e.corner[0] + e.corner[1] + e.corner[2]) / 3.0;
        const dvec3 area = cross(e.corner[1] - e.corner[0], e.corner[2] - e.corner[0]) * 0.5;
        e.area = length(area), e.face_normal = e.normal = area / e.area;
        out.list.push_back(e);
    }
    return out;
}

TEST(Patches, APatchOfManyTrianglesIsSummedOverThoseNearTheReceiverAlone) {
    const Elements elements = dust(2000);
    const Patches patches = make_patches(elements, 2);
    ASSERT_EQ(patches.list.size(), 1u);
    std::size_t leaves = 0;
    const auto visit = [&](const auto& self, const Patch& part) -> void {
        const std::span<const Patch> halves = patches.halves_of(part);
        if (halves.empty()) {
            EXPECT_LE(part.end - part.begin, 8u);
            ++leaves;
            return;
        }
        EXPECT_EQ(halves[0].begin, part.begin);
        EXPECT_EQ(halves[0].end, halves[1].begin);
        EXPECT_EQ(halves[1].end, part.end);
        EXPECT_NEAR(halves[0].area + halves[1].area, part.area, 1e-12);
        for (const Patch& half : halves) self(self, half);
    };
    visit(visit, patches.list[0]);
    EXPECT_EQ(leaves, 256u);

    Context context({.threads = 1});
    Scene elsewhere;
    elsewhere.materials = {diffuse({1, 1, 1})};
    test::add_object(elsewhere, test::square_mesh(0), translation(dvec3{0, 0, -100}));
    const raytrace::SurfaceRays rays(elsewhere, context);
    const FormFactors factors(elements, patches, rays, 1e-5);
    for (const double height : {1.1, 1.5, 3.0, 20.0}) {
        const Receiver receiver{{0.4, 0.6, height}, {0, 0, -1}, {0, 0, -1}};
        double sum = 0;
        for (const Element& e : elements.list) sum += form_factor_of_triangle(receiver.at, receiver.normal, e.corner);
        EXPECT_NEAR(factors(receiver, 0, 1), sum, 0.01 * sum) << height;
    }
}

}  // namespace
}  // namespace rakelight::radiosity
