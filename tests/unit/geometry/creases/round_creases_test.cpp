// SPDX-License-Identifier: Apache-2.0
// Automatic creases of round shapes of which some sides are planes: flat annuli of tori and rims, tubes of planes and
// warped squares.
#include <rakelight/geometry/creases.h>

#include <gtest/gtest.h>

#include <cmath>

#include "unit/geometry/creases/hard_shapes.h"

namespace rakelight::test {
namespace {

CreaseReport report_of(const HardShape& made) {
    Context context({.threads = 2});
    const AttributeMesh mesh = made.shape.view();
    return find_creases(std::span(&mesh, 1), {}, context).report;
}

/// A tube of closed rings, all surfaces of one.
HardShape tube(const std::vector<std::vector<dvec3>>& rings, bool is_closed, double step) {
    HardBuilder builder(step);
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < rings.size(); ++i)
        builder.wall(rings[(i + 1) % rings.size()], rings[i], 0);
    return builder.take();
}

/// A circle of `sides` around the point at an angle of an ellipse, with a pitch for a helix.
std::vector<dvec3> section(double angle, double long_axis, double short_axis, double height, double radius, int sides) {
    std::vector<dvec3> ring;
    const double across = std::hypot(short_axis * std::cos(angle), long_axis * std::sin(angle));
    const dvec3 out{short_axis * std::cos(angle) / across, long_axis * std::sin(angle) / across, 0};
    const dvec3 at{long_axis * std::cos(angle), short_axis * std::sin(angle), height};
    for (int k = 0; k < sides; ++k) {
        const double turn = 2 * pi * k / sides;
        ring.push_back(at + out * (radius * std::cos(turn)) + dvec3{0, 0, radius * std::sin(turn)});
    }
    return ring;
}

TEST(RoundCreases, ToriWithFlatAnnuliHaveNone) {
    for (const int around : {12, 22, 48, 200})
        for (const int sides : {8, 9, 10, 14, 18})
            for (const double short_axis : {1.2, 0.8})
                for (const double step : {0.0, 1e-5}) {
                    std::vector<std::vector<dvec3>> rings;
                    for (int i = 0; i < around; ++i)
                        rings.push_back(section(2 * pi * i / around, 1.2, short_axis, 0, 0.3, sides));
                    EXPECT_EQ(report_of(tube(rings, true, step)).hard, 0u)
                        << around << " x " << sides << ", " << short_axis << ", step " << step;
                }
}

TEST(RoundCreases, SpringsOfPlanesAndWarpedSquaresHaveNone) {
    for (const double pitch : {0.2, 1.0, 3.0})
        for (const double step : {0.0, 1e-6, 1e-4}) {
            std::vector<std::vector<dvec3>> rings;
            for (int i = 0; i < 54; ++i) rings.push_back(section(2 * pi * i / 18, 5, 5, pitch * i / 18, 0.42, 10));
            EXPECT_EQ(report_of(tube(rings, false, step)).hard, 0u) << pitch << ", step " << step;
        }
}

TEST(RoundCreases, ChamfersOfWashersStayHard) {
    constexpr int around = 32;
    for (const double chamfer : {0.05, 0.1, 0.3}) {  // the land is 1 less two chamfers wide
        const double profile[8][2] = {{1, chamfer},     {1 + chamfer, 0}, {2 - chamfer, 0}, {2, chamfer},
                                      {2, 1 - chamfer}, {2 - chamfer, 1}, {1 + chamfer, 1}, {1, 1 - chamfer}};
        std::vector<std::vector<dvec3>> rings;
        for (const auto& [radius, z] : profile) {
            rings.emplace_back();
            for (int i = 0; i < around; ++i) {
                const double a = 2 * pi * i / around;
                rings.back().push_back({radius * std::cos(a), radius * std::sin(a), z});
            }
        }
        const CreaseReport report = report_of(tube(rings, true, 0));
        // With the widest chamfers the profile is nearly a regular octagon, of eight sides: round.
        EXPECT_EQ(report.hard, chamfer < 0.3 ? 8u * around : 0u) << chamfer;
    }
}

}  // namespace
}  // namespace rakelight::test
