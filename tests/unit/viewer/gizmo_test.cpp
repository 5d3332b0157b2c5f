// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/view/gizmo.h"

#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/math/linear.h>

#include "../../../apps/viewer/view/overlay.h"

namespace rakelight::viewer {
namespace {

constexpr double pixel = 1e-6;

/// From (0, 0, 10) along -Z at a model of one meter about the origin.
GizmoView front_view() {
    GizmoView view;
    view.camera.to_world = look_at({0, 0, 10}, {0, 0, 0}, {0, 1, 0});
    view.width = 400, view.height = 300;
    view.bounds = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
    return view;
}

GizmoView oblique_view() {
    GizmoView view = front_view();
    view.camera.to_world = look_at({4, 3, 8}, {0, 0, 0}, {0, 1, 0});
    return view;
}

GizmoView parallel_view() {
    GizmoView view = oblique_view();
    view.camera.projection = Projection::orthographic;
    view.camera.half_height = 2;
    return view;
}

dvec2 seen(dvec3 place, const GizmoView& view) {
    const std::optional<dvec2> p = pixel_of(place, view.camera, view.width, view.height);
    EXPECT_TRUE(p);
    return p.value_or(dvec2{});
}

dvec2 moved(dvec2 p, double x, double y) { return {p.x + x, p.y + y}; }

TEST(Gizmo, RaysGoThroughWhatTheirPixelsSee) {
    for (const GizmoView& view : {front_view(), oblique_view(), parallel_view()})
        for (const dvec3 place : {dvec3{0, 0, 0}, dvec3{0.7, -0.4, 1.1}, dvec3{-1, 1, -2}}) {
            const Ray ray = ray_of(seen(place, view), view);
            EXPECT_NEAR(length(ray.direction), 1, 1e-12);
            EXPECT_LT(length(cross(place - ray.origin, ray.direction)), 1e-9);
        }
}

TEST(Gizmo, AnAxisMovesAlongItselfAndFollowsThePointer) {
    for (const GizmoView& view : {oblique_view(), parallel_view()})
        for (const Handle handle : {Handle::x, Handle::y, Handle::z}) {
            const Light lamp{.position = {0.2, 0.1, -0.3}};
            const dvec3 axis = handle == Handle::x   ? dvec3{1, 0, 0}
                               : handle == Handle::y ? dvec3{0, 1, 0}
                                                     : dvec3{0, 0, 1};
            const dvec2 from = seen(lamp.position, view), to = seen(lamp.position + axis * 0.75, view);
            const Light after = dragged(lamp, handle, from, to, view);
            EXPECT_LT(length(after.position - (lamp.position + axis * 0.75)), 1e-9);
        }
}

TEST(Gizmo, AnAxisAlongTheViewDoesNotMoveAndHasNoHandle) {
    const GizmoView view = front_view();
    const Light lamp{.position = {0, 0, 0}};
    EXPECT_EQ(dragged(lamp, Handle::z, {200, 150}, {260, 150}, view).position, lamp.position);
    for (int x = 0; x < 400; x += 2)
        for (int y = 0; y < 300; y += 2) EXPECT_NE(handle_at({double(x), double(y)}, lamp, view), Handle::z);
}

TEST(Gizmo, TheMiddleMovesAcrossTheView) {
    for (const GizmoView& view : {front_view(), oblique_view(), parallel_view()}) {
        const Light lamp{.position = {0.3, -0.2, 0.4}};
        const dvec2 from = seen(lamp.position, view), to = moved(from, 40, -25);
        const Light after = dragged(lamp, Handle::center, from, to, view);
        const dvec2 p = seen(after.position, view);
        EXPECT_NEAR(p.x, to.x, pixel);
        EXPECT_NEAR(p.y, to.y, pixel);
        EXPECT_NEAR(dot(after.position - lamp.position, view.camera.to_world[2].xyz()), 0, 1e-12);
    }
}

TEST(Gizmo, HandlesAreWhereTheirLinesAre) {
    const GizmoView view = oblique_view();
    const Light lamp{.position = {0.1, 0.2, 0.3}};
    const std::vector<Line> lines = gizmo_lines(lamp, view, Handle::none);
    ASSERT_EQ(lines.size(), 7u);  // three axes and the square
    const Handle axes[] = {Handle::x, Handle::y, Handle::z};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(handle_at(seen(lines[i].to, view), lamp, view), axes[i]);
        EXPECT_EQ(handle_at(moved(seen(lines[i].to, view), 30, 30), lamp, view), Handle::none);
    }
    EXPECT_EQ(handle_at(seen(lamp.position, view), lamp, view), Handle::center);
    EXPECT_EQ(handle_at({5, 5}, lamp, view), Handle::none);
}

TEST(Gizmo, AxesAreAsLongOnTheScreenWhateverTheDistance) {
    for (const double z : {-40.0, 0.0, 7.0}) {
        const Line x = gizmo_lines({.position = {0, 0, z}}, front_view(), Handle::none)[0];
        EXPECT_NEAR(seen(x.to, front_view()).x - seen(x.from, front_view()).x, 80, pixel);
    }
}

TEST(Gizmo, TheLitHandleIsWider) {
    const std::vector<Line> lines = gizmo_lines({.position = {0, 0, 0}}, oblique_view(), Handle::y);
    EXPECT_GT(lines[1].width_px, lines[0].width_px);
    EXPECT_FALSE(lines[1].color == gizmo_lines({.position = {0, 0, 0}}, oblique_view(), Handle::none)[1].color);
}

TEST(Gizmo, TheHeadOfASpotFollowsThePointer) {
    const GizmoView view = oblique_view();
    const Light spot{
        .type = LightType::spot, .position = {0, 0, 0}, .direction = normalize_or(dvec3{1, 0.4, 0.3}, dvec3{})};
    const dvec3 tip = gizmo_lines(spot, view, Handle::none)[7].to;
    EXPECT_EQ(handle_at(seen(tip, view), spot, view), Handle::tip);
    const dvec2 from = seen(tip, view), to = moved(from, -20, 30);
    const Light after = dragged(spot, Handle::tip, from, to, view);
    EXPECT_NEAR(length(after.direction), 1, 1e-12);
    EXPECT_EQ(after.position, spot.position);
    const dvec2 p = seen(after.direction * length(tip), view);
    EXPECT_NEAR(p.x, to.x, pixel);
    EXPECT_NEAR(p.y, to.y, pixel);
    EXPECT_LT(length(dragged(spot, Handle::tip, from, from, view).direction - spot.direction), 1e-9);
}

TEST(Gizmo, PastTheRimTheHeadGoesOnBehind) {
    const GizmoView view = front_view();
    const Light spot{.type = LightType::spot, .position = {0, 0, 0}, .direction = {0, 0, 1}};  // at the viewer
    const dvec2 middle = seen({0, 0, 0}, view);
    double last = 1;
    for (int x = 0; x <= 250; x += 5) {
        const dvec3 d = dragged(spot, Handle::tip, middle, moved(middle, x, 0), view).direction;
        EXPECT_LE(d.z, last + 1e-12) << x;
        EXPECT_LT(last - d.z, 0.35) << x;  // no jump; the rim itself is the steepest
        last = d.z;
    }
    EXPECT_LT(last, -0.3);  // away from the viewer
}

TEST(Gizmo, ADirectionalLightTurnsAboutTheModel) {
    const GizmoView view = oblique_view();
    const Light sun{.type = LightType::directional, .direction = normalize_or(dvec3{-0.6, -0.3, -1}, dvec3{})};
    const dvec2 from = seen(directional_arrow(sun, view.bounds).second, view), to = moved(from, 10, -15);
    EXPECT_EQ(handle_at(from, sun, view), Handle::tip);
    const Light after = dragged(sun, Handle::tip, from, to, view);
    const dvec2 p = seen(directional_arrow(after, view.bounds).second, view);
    EXPECT_NEAR(p.x, to.x, pixel);
    EXPECT_NEAR(p.y, to.y, pixel);
    EXPECT_EQ(handle_at({5, 5}, sun, view), Handle::none);
}

TEST(Gizmo, BehindTheViewerNothingIsDrawnAndNothingTaken) {
    const Light lamp{.position = {0, 0, 20}};
    EXPECT_TRUE(gizmo_lines(lamp, front_view(), Handle::none).empty());
    for (int x = 0; x < 400; x += 10)
        for (int y = 0; y < 300; y += 10)
            EXPECT_EQ(handle_at({double(x), double(y)}, lamp, front_view()), Handle::none);
    EXPECT_TRUE(gizmo_lines({.type = LightType::ambient}, front_view(), Handle::none).empty());
}

}  // namespace
}  // namespace rakelight::viewer
