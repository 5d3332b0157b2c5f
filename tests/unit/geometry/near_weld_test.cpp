// SPDX-License-Identifier: Apache-2.0
// Welding within a tolerance: objects whose matrices differ, explicit distances, chains that are too wide.
#include <gtest/gtest.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

AttributeOptions within(double distance) {
    AttributeOptions options = published();
    options.weld_distance = distance;
    options.tangents = false;
    return options;
}

dmat4 rotation_about_y(double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return {{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
}

// Each part's positions stored in a frame of its own, as authors export them: float in, rounded.
std::vector<Shape> in_own_frames(std::vector<Shape> parts, dvec3 shift) {
    for (std::size_t m = 0; m < parts.size(); ++m) {
        const dmat4 to_world = translation(shift) * rotation_about_y(0.7 * double(m) + 0.1);
        dmat4 back;
        EXPECT_TRUE(inverse_affine(to_world, back));
        for (vec3& p : parts[m].positions) p = cast<float>(transform_point(back, cast<double>(p) + shift));
        parts[m].to_world = to_world;
    }
    return parts;
}

dvec3 turned(const Shape& s, vec3 n) { return transform_direction(s.to_world, cast<double>(n)); }

// [degrees] the largest angle between normals at one place of the uncut model.
double seam(const std::vector<Shape>& uncut_parts, const std::vector<Shape>& parts, const AttributeOptions& options) {
    const auto out = compute(parts, options);
    std::map<std::tuple<float, float, float>, dvec3> seen;
    double worst = 0;
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 p = uncut_parts[m].positions[v];
            const dvec3 n = turned(parts[m], out[m].normals[v]);
            const auto [at, is_new] = seen.try_emplace(std::tuple(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f), n);
            if (!is_new) worst = std::fmax(worst, degrees(angle_between(at->second, n)));
        }
    return worst;
}

TEST(NearWeld, ObjectsWithDifferentMatricesHaveNoSeam) {
    for (const Shape& whole : {make_sphere(40, 20), make_torus(40, 20)})
        for (const dvec3 shift : {dvec3{}, dvec3{1e6, -3e5, 2e6}})
            for (const std::uint32_t count : {2u, 7u}) {
                const auto parts = cut_at_random(whole, count, 5);
                const auto framed = in_own_frames(parts, shift);
                EXPECT_LT(seam(parts, framed, within(-1)), 1e-3);
                EXPECT_GT(seam(parts, framed, within(0)), 1);  // exact comparison does leave one
            }
}

TEST(NearWeld, DefaultLeavesObjectsWithOneMatrixAlone) {
    auto hinge = make_hinge(radians(40));
    for (vec3& p : hinge[1].positions) p.y += 1e-7f;
    const auto out = compute(hinge, within(-1));
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
}

TEST(NearWeld, ExplicitDistanceJoinsWhatLiesWithinIt) {
    auto hinge = make_hinge(radians(40));
    for (vec3& p : hinge[1].positions) p.y += 1e-4f;
    for (const double distance : {1.1e-4, 1e-3, 0.1}) {
        const auto joined = compute(hinge, within(distance));
        EXPECT_EQ(joined[0].normals[0], joined[1].normals[0]) << distance;
        EXPECT_EQ(joined[0].normals[1], joined[1].normals[1]) << distance;
    }
    const auto apart = compute(hinge, within(0.9e-4));
    EXPECT_NE(apart[0].normals[0], apart[1].normals[0]);
    AttributeOptions crease = within(1.1e-4);  // edges are found through the tolerance too
    crease.crease_angle_rad = radians(45);
    EXPECT_EQ(compute(hinge, crease)[0].normals[0], compute(hinge, crease)[1].normals[0]);
    crease.scope = Scope::object;
    EXPECT_NE(compute(hinge, crease)[0].normals[0], compute(hinge, crease)[1].normals[0]);
}

TEST(NearWeld, EveryClosePairIsFoundWhereverItLies) {
    // Single triangles in pairs whose first corners lie 0.9 distances apart, all over the cells' walls.
    std::mt19937 random(17);
    std::uniform_real_distribution<double> value(-1, 1);
    const double distance = 1e-3;
    std::vector<Shape> shapes;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const dvec3 p{8 * value(random), 8 * value(random), 8 * value(random)};
        const dvec3 q =
            p + normalize_or(dvec3{value(random), value(random), value(random)}, dvec3{1, 0, 0}) * (0.9 * distance);
        for (const dvec3 at : {p, q}) {
            Shape s;
            s.object = std::uint32_t(shapes.size());
            s.positions.push_back(cast<float>(at));
            for (int k = 0; k < 2; ++k)
                s.positions.push_back(cast<float>(at + dvec3{value(random), value(random), value(random)} * 0.5));
            s.indices = {0, 1, 2};
            shapes.push_back(s);
        }
    }
    const auto out = compute(shapes, within(distance));
    std::size_t joined = 0;
    for (std::size_t i = 0; i < shapes.size(); i += 2) joined += out[i].normals[0] == out[i + 1].normals[0];
    EXPECT_GE(joined, 1990u);  // a few opposite pairs cancel, or chain up with a third by chance
}

TEST(NearWeld, ChainWiderThanTwiceTheDistanceIsKeptExactAndReported) {
    std::vector<Shape> chain;
    for (std::uint32_t i = 0; i < 5; ++i) {
        Shape s;
        s.object = i;
        s.positions = {{0.9e-3f * float(i), 0, 0}, {1, float(i), 0}, {1, float(i), 1}};
        s.indices = {0, 1, 2};
        chain.push_back(s);
    }
    Context context({.threads = 2});
    const auto out = compute_attributes(views(chain), within(1e-3), context);
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].remark, Remark::warning);
    chain.resize(3);  // two steps are 1.8 distances: one place
    const auto joined = compute(chain, within(1e-3));
    EXPECT_EQ(joined[0].normals[0], joined[2].normals[0]);
}

// Two objects, half of the places of each spot in either; all places of a spot within the distance, all different.
std::vector<Shape> crowd(std::uint32_t spots, std::uint32_t per_object) {
    std::vector<Shape> shapes(2);
    for (std::uint32_t object = 0; object < 2; ++object) {
        Shape& s = shapes[object];
        s.object = object;
        s.to_world = translation(dvec3{0, 0, double(object) * 1e-12});  // another matrix, no other place that counts
        for (std::uint32_t spot = 0; spot < spots; ++spot)
            for (std::uint32_t i = 0; i < per_object; ++i) {
                const auto corner = std::uint32_t(s.positions.size());
                const float angle = float(i) / float(per_object), height = float(object) + 0.5f;
                s.positions.push_back({0, float(i) * 1e-12f + float(object) * 1e-14f, 0.1f * float(spot + 1)});
                s.positions.push_back({1 + angle, height, 0.1f * float(spot)});
                s.positions.push_back({1 + angle, height + 1, 0.05f + 0.1f * float(spot)});
                s.indices.insert(s.indices.end(), {corner, corner + 1, corner + 2});
            }
    }
    return shapes;
}

TEST(NearWeld, AThousandPlacesOnOneSpotAreOnePlace) {
    constexpr std::uint32_t spots = 20, per_object = 500;
    const auto out = compute(crowd(spots, per_object), within(-1));
    for (std::uint32_t spot = 0; spot < spots; ++spot)
        for (std::uint32_t object = 0; object < 2; ++object)
            for (std::uint32_t i = 0; i < per_object; ++i) {
                const std::size_t first = 3 * std::size_t(spot) * per_object;
                ASSERT_EQ(out[object].normals[first + 3 * i], out[0].normals[first])
                    << spot << " " << object << " " << i;
            }
}

// Comparing all of them in pairs would take hours.
TEST(NearWeld, PlacesCrowdedBeyondReasonAreKeptExactAndReported) {
    const auto shapes = crowd(1, 200'000);
    Context context({.threads = 2});
    const auto out = compute_attributes(views(shapes), within(-1), context);
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_NE(context.report().entries()[0].message.find("400000 crowded"), std::string::npos);
}

// 7000 places within 3 cm, in a scene of 1.4 km whose diagonal makes the default distance half a millimeter.
TEST(NearWeld, SmallPartsOfAWideSceneHaveNoSeam) {
    Shape whole = make_cylinder(150, 48);
    for (vec3& p : whole.positions) p = vec3{p.x, 2 * p.y, p.z} * 0.0155f;
    auto parts = cut_by_planes(whole, 2);
    auto framed = in_own_frames(parts, {});
    EXPECT_GT(seam(parts, framed, within(0)), 1);
    Shape ground;
    ground.positions = {{1000, 0, 0}, {0, 0, 1000}, {1000, 0, 1000}};
    ground.indices = {0, 1, 2};
    ground.object = 2;
    parts.push_back(ground);
    framed.push_back(ground);
    EXPECT_LT(seam(parts, framed, within(-1)), 1e-3);
}

// Small parts a kilometer from the world's origin and half of it from the center of the model: as much as the floats of
// their pivots are off, so are the places where they meet.
TEST(NearWeld, PartsMeetWithinTheRoundingOfTheirPivots) {
    Shape flat, slope, far;
    flat.positions = {{-0.05f, 0, 0}, {0.05f, 0, 0}, {0.05f, 0, -0.1f}};
    slope.positions = {{-0.05f, 0, 0}, {0.05f, 0.1f, 0}, {-0.05f, 0, -0.1f}};
    far.positions = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0, -0.1f}};
    flat.indices = slope.indices = far.indices = {0, 1, 2};
    slope.object = 1, far.object = 2;
    flat.to_world =
        translation(dvec3{double(1000.1f), 0, 0});  // both 0.05 from where they meet, but for 37 micrometers
    slope.to_world = translation(dvec3{double(1000.2f), 0, 0});
    const auto bend_deg = [&](double distance) {
        const auto out = compute({flat, slope, far}, within(distance));
        return degrees(angle_between(out[0].normals[1], out[1].normals[0]));
    };
    EXPECT_NEAR(bend_deg(0), 45, 1e-3);
    EXPECT_NEAR(bend_deg(-1), 0, 1e-3);
}

// Each part is stored about a pivot 500 of its sizes away: its floats are rounded to what that distance leaves.
TEST(NearWeld, PartsWhosePivotLiesFarOutsideHaveNoSeam) {
    const auto parts = cut_by_planes(make_sphere(40, 20), 2);
    auto framed = parts;
    for (std::size_t m = 0; m < parts.size(); ++m) {
        const dmat4 to_world = translation(dvec3{300, -700, 640}) * rotation_about_y(0.7 * double(m) + 0.1);
        dmat4 back;
        ASSERT_TRUE(inverse_affine(to_world, back));
        for (vec3& p : framed[m].positions) p = cast<float>(transform_point(back, cast<double>(p)));
        framed[m].to_world = to_world;
    }
    EXPECT_GT(seam(parts, framed, within(0)), 1);
    EXPECT_LT(seam(parts, framed, within(-1)), 1e-3);
}

// The plates lie 0.1 mm apart, which is less than the floats of the ground of 4 km can tell.
TEST(NearWeld, DefaultKeepsApartWhatTheSmallPartsOfAWideSceneTellApart) {
    auto plates = make_hinge(radians(40));
    for (vec3& p : plates[1].positions) p.y += 1e-4f;
    plates[1].to_world = translation(dvec3{0, 0, 1e-12});  // another matrix
    Shape ground;
    ground.positions = {{-2000, -1, -2000}, {2000, -1, -2000}, {0, -1, 2000}};
    ground.indices = {0, 1, 2};
    ground.object = 2;
    plates.push_back(ground);
    const auto out = compute(plates, within(-1));
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
    for (vec3& p : plates[1].positions) p.y -= 1e-4f;
    const auto joined = compute(plates, within(-1));
    EXPECT_EQ(joined[0].normals[0], joined[1].normals[0]);
}

TEST(NearWeld, CodesOfQuantizedMeshesThatDifferByOneStepAreOnePlace) {
    auto hinge = make_hinge(radians(40));
    const float step = 1.0f / 1024;
    for (const vec3 shift : {vec3{0, step, 0}, vec3{-step, step, step}}) {
        auto shifted = hinge;
        for (vec3& p : shifted[1].positions) p = p + shift;
        auto meshes = views(shifted);
        Context context({.threads = 2});
        for (AttributeMesh& m : meshes) m.position_step = step;
        const auto joined = compute_attributes(meshes, within(-1), context);
        EXPECT_EQ(joined[0].normals[0], joined[1].normals[0]);
        EXPECT_EQ(joined[0].normals[1], joined[1].normals[1]);
        meshes[1].position_step = 0;  // this one is exact: half of the distance remains
        EXPECT_NE(compute_attributes(meshes, within(-1), context)[0].normals[0], joined[0].normals[0]);
    }
}

// Both halves have the border's codes; the next row of vertices of each lies one step away from it.
TEST(NearWeld, QuantizedMeshesThatMeetExactlyAreNotWeldedBeyondThat) {
    const float step = 1.0f / 1024;
    Shape left, right;
    left.positions = {{0, 0, 0}, {0, 0, 1}, {-step, 0, 0}, {-step, 0, 1}, {-1, -0.5f, 0}, {-1, -0.5f, 1}};
    left.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
    right.positions = {{0, 0, 0}, {0, 0, 1}, {step, 0, 0}, {step, 0, 1}, {1, -1, 0}, {1, -1, 1}};
    right.indices = {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4};
    right.object = 1;
    const std::vector<Shape> parts{left, right};
    auto meshes = views(parts);
    Context context({.threads = 2});
    const auto exact = compute_attributes(meshes, within(0), context);
    EXPECT_EQ(exact[0].normals[0], exact[1].normals[0]);
    for (AttributeMesh& m : meshes) m.position_step = step;
    const auto stepped = compute_attributes(meshes, within(-1), context);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t v = 0; v < 6; ++v)
            EXPECT_LT(angle_between(exact[m].normals[v], stepped[m].normals[v]), 1e-6) << m << " " << v;
}

// Thousands of meshes at each of two places one step apart; the places are two when a single mesh has a vertex at both.
TEST(NearWeld, ManyQuantizedMeshesAtTwoPlacesAreComparedByTheOneThatIsAtBoth) {
    constexpr std::uint32_t at_each = 4000;
    const float step = 1.0f / 1024;
    const std::vector<vec3> a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, b{{step, 0, 0}, {-1, 0, 0.5f}, {0, -1, 0.5f}};
    std::vector<vec3> both = a;
    both.insert(both.end(), b.begin(), b.end());
    const std::vector<std::uint32_t> one{0, 1, 2}, two{0, 1, 2, 3, 4, 5};
    Context context({.threads = 2});
    for (const std::uint32_t shared : {2 * at_each, 0u, at_each - 1, at_each, 2 * at_each - 1}) {  // the first: none
        std::vector<AttributeMesh> meshes(2 * at_each);
        for (std::uint32_t m = 0; m < meshes.size(); ++m) {
            meshes[m].object = m;
            meshes[m].position_step = step;
            meshes[m].positions = m == shared ? both : m < at_each ? a : b;
            meshes[m].indices = m == shared ? two : one;
        }
        const auto out = compute_attributes(meshes, within(-1), context);
        const vec3 at_a = out[1].normals[0], at_b = out[2 * at_each - 2].normals[0];
        if (shared < meshes.size())
            EXPECT_NE(at_a, at_b) << shared;
        else
            EXPECT_EQ(at_a, at_b);
    }
}

TEST(NearWeld, OrderOfObjectsDoesNotMatter) {
    const auto parts = cut_at_random(make_torus(30, 16), 6, 3);
    auto framed = in_own_frames(parts, {});
    auto forwards = compute(framed, within(-1));
    std::reverse(framed.begin(), framed.end());
    auto backwards = compute(framed, within(-1));
    std::reverse(backwards.begin(), backwards.end());
    for (std::size_t m = 0; m < forwards.size(); ++m)
        for (std::size_t v = 0; v < forwards[m].normals.size(); ++v)
            EXPECT_LT(angle_between(forwards[m].normals[v], backwards[m].normals[v]), 1e-6);
}

TEST(NearWeld, DistanceMustBeFinite) { EXPECT_THROW(compute({make_cube()}, within(INFINITY)), Error); }

TEST(NearWeld, DistanceLargerThanTheModelIsSound) {
    const Shape sphere = make_sphere(24, 12);
    Context context({.threads = 2});
    const auto out = compute_attributes(views({sphere}), within(100), context);
    for (const vec3 n : out[0].normals) EXPECT_NEAR(length(cast<double>(n)), 1, 1e-6);
}

}  // namespace
}  // namespace rakelight::test
