// SPDX-License-Identifier: Apache-2.0
// Bakes against surfaces whose normals, heights, curvatures and openness are known.
#include <rakelight/bake/bake.h>

#include <gtest/gtest.h>

#include "bake/low/low_surface.h"
#include "bake/low/tangent_frame.h"
#include "support/environment_variable.h"
#include "support/thrown_error.h"
#include "unit/bake/bake_scenes.h"

#include <rakelight/world/load.h>

namespace rakelight {
namespace {

using namespace test;

class Bake : public testing::Test {
protected:
    void SetUp() override {
        if (!can_bake()) GTEST_SKIP() << "this build follows no rays";
    }
    BakeResult bake(const Scene& high, const Scene& low, const BakeOptions& options) {
        return bake_maps(high, low, options, context_);
    }
    Context context_{{.threads = 2}};
};

BakeOptions options_for(std::vector<BakeMap> maps, int width, int height) {
    BakeOptions options;
    options.maps = std::move(maps), options.width = width, options.height = height;
    return options;
}

dvec3 normal_at(const BakeResult& result, int x, int y) {
    const float* const n = &result.maps[0].values[3 * (std::size_t(y) * std::size_t(result.width) + std::size_t(x))];
    return {double(n[0]), double(n[1]), double(n[2])};
}

float value_at(const BakeResult& result, std::size_t map, int x, int y) {
    return result.maps[map].values[std::size_t(y) * std::size_t(result.width) + std::size_t(x)];
}

/// Calls f(x, y, direction) for texels of a sphere's map that are not near the poles, where LOW's triangles are slivers.
template <class F>
void for_each_direction(int width, int height, const F& f) {
    for (int y = height / 8; y < height - height / 8; ++y)
        for (int x = 0; x < width; ++x) f(x, y, sphere_direction((x + 0.5) / width, (y + 0.5) / height));
}

TEST_F(Bake, NormalsOfADentedSphereAreTheAnalyticOnes) {
    const Scene high = scene_of(dented_sphere(300, 600)), low = scene_of(plain_sphere(48, 96));
    for (const BakeSpace space : {BakeSpace::object, BakeSpace::tangent})
        for (const bool normalize : {false, true}) {
            BakeOptions options = options_for({BakeMap::normal}, 256, 128);
            options.space = space, options.normalize_frames = normalize, options.distance = 0.08;
            const BakeResult result = bake(high, low, options);
            EXPECT_EQ(result.report.missed, 0u);
            double worst = 0, sum = 0, bent = 0;
            int count = 0;
            for_each_direction(256, 128, [&](int x, int y, dvec3 d) {
                dvec3 n = normal_at(result, x, y);
                if (space == BakeSpace::tangent) {  // u to the east, green to the north
                    const dvec3 east = normalize_or(cross(dvec3{0, 1, 0}, d), dvec3{}), north = cross(d, east);
                    n = east * n.x + north * n.y + d * n.z;
                }
                const double off = angle_deg(n, Dented::normal(d));
                worst = std::max(worst, off), sum += off, ++count;
                bent = std::max(bent, angle_deg(d, Dented::normal(d)));
            });
            EXPECT_GT(bent, 15);  // or the map would have nothing to say
            EXPECT_LT(worst, 0.45) << int(space) << normalize;
            EXPECT_LT(sum / count, 0.03) << int(space) << normalize;
        }
}

TEST_F(Bake, ObjectSpaceIsThatOfThePlacedMesh) {
    const dmat4 place = translation(dvec3{3, -2, 1}) * dmat4{{{0, 2, 0, 0}, {0, 0, 2, 0}, {2, 0, 0, 0}, {0, 0, 0, 1}}};
    BakeOptions options = options_for({BakeMap::normal}, 128, 64);
    options.space = BakeSpace::object;
    const BakeResult plain = bake(scene_of(dented_sphere(150, 300)), scene_of(plain_sphere(24, 48)), options),
                     placed =
                         bake(scene_of(dented_sphere(150, 300), place), scene_of(plain_sphere(24, 48), place), options);
    EXPECT_NEAR(placed.report.distance, 2 * plain.report.distance, 1e-3 * plain.report.distance);
    for_each_direction(128, 64, [&](int x, int y, dvec3) {
        EXPECT_LT(angle_deg(normal_at(plain, x, y), normal_at(placed, x, y)), 0.05);
    });
}

TEST_F(Bake, ProposedCageHoldsTheDents) {
    const BakeResult result =
        bake(scene_of(dented_sphere(150, 300)), scene_of(plain_sphere(24, 48)), options_for({BakeMap::normal}, 64, 32));
    EXPECT_TRUE(result.report.is_proposed);
    EXPECT_GT(result.report.distance, 0.05);
    EXPECT_LT(result.report.distance, 0.08);
    EXPECT_EQ(result.report.missed, 0u);
    EXPECT_EQ(result.report.texels, 64u * 32u);
}

TEST_F(Bake, GreenDownTurnsTheGreenOfPicturesInTangentSpace) {
    const Scene high = scene_of(dented_sphere(100, 200)), low = scene_of(plain_sphere(24, 48));
    BakeOptions options = options_for({BakeMap::normal}, 64, 32);
    const BakeResult result = bake(high, low, options);
    const Pixels up = picture_of(result, result.maps[0], options, Component::f32, context_);
    options.green_down = true;
    const Pixels down = picture_of(result, result.maps[0], options, Component::f32, context_);
    const auto* const a = reinterpret_cast<const float*>(up.bytes.data());
    const auto* const b = reinterpret_cast<const float*>(down.bytes.data());
    for (std::size_t i = 0; i < 3u * 64 * 32; ++i) EXPECT_FLOAT_EQ(b[i], i % 3 == 1 ? 1 - a[i] : a[i]);
}

/// Two squares of 2 x 1 that meet at the ridge y = 1 over x, without normals.
Mesh roof() {
    Mesh mesh;
    mesh.name = "roof";
    mesh.positions = std::vector<vec3>{{-1, 0, 1}, {1, 0, 1}, {-1, 1, 0}, {1, 1, 0}, {-1, 0, -1}, {1, 0, -1}};
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 1}, {1, 1}, {0, .5f}, {1, .5f}, {0, 0}, {1, 0}});
    mesh.indices = std::vector<std::uint32_t>{0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4};
    return mesh;
}

TEST_F(Bake, ARoofKeepsItsRidgeByTheRuleOfCreases) {
    const Scene scene = scene_of(roof());
    BakeOptions options = options_for({BakeMap::normal}, 16, 16);
    const auto vertices = [&] { return bake(scene, scene, options).low.meshes[0].positions.size(); };
    EXPECT_EQ(vertices(), 6u);  // no creases by default
    options.crease_angle_rad = radians(60);
    EXPECT_EQ(vertices(), 8u);
    options.crease_angle_rad = pi, options.creases = Creasing::automatic;
    EXPECT_EQ(vertices(), 8u);
    const Mesh low = bake(scene, scene, options).low.meshes[0];
    for (const vec3& n : low.normals) EXPECT_NEAR(std::abs(n.z), std::sqrt(0.5f), 1e-6f);
}

TEST_F(Bake, NormalsOfLowTakeTheWeight) {
    Mesh bent = roof();
    bent.positions = std::vector<vec3>{{-1, 0, 1}, {1, 0, 1}, {-1, .2f, 0}, {1, .2f, 0}, {-1, 0, -3}, {1, 0, -3}};
    const Scene scene = scene_of(std::move(bent));
    BakeOptions options = options_for({BakeMap::normal}, 16, 16);
    const auto lean = [&](CornerWeight weight) {
        options.weight = weight;
        return bake(scene, scene, options).low.meshes[0].normals[2].z;
    };
    EXPECT_LT(lean(CornerWeight::area), lean(CornerWeight::uniform) - 0.01f);  // the larger square faces -z
}

TEST_F(Bake, HeightOverATiltedSquareIsItsFormula) {
    Scene high = scene_of(square_mesh(no_index, 2));
    high.nodes[0].local.matrix =
        dmat4{{{1, 0, 0.1, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0.2, 1}}};  // z = 0.2 + 0.1 x
    BakeOptions options = options_for({BakeMap::height}, 32, 32);
    options.distance = 0.4, options.samples = 16;
    const BakeResult result = bake(high, scene_of(square_mesh()), options);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) EXPECT_NEAR(value_at(result, 0, x, y), 0.2 + 0.1 * (2 * (x + 0.5) / 32 - 1), 1e-6);
    const Pixels pixels = picture_of(result, result.maps[0], options, Component::u16, context_);
    EXPECT_NEAR(reinterpret_cast<const std::uint16_t*>(pixels.bytes.data())[16],
                65535 * (0.5 + 0.5 * double(value_at(result, 0, 16, 0)) / 0.4), 0.51);
}

TEST_F(Bake, CurvatureOfASphereIsOneByItsRadius) {
    BakeOptions options = options_for({BakeMap::curvature}, 64, 32);
    const BakeResult out = bake(scene_of(plain_sphere(100, 200, 2)), scene_of(plain_sphere(24, 48, 2)), options);
    for_each_direction(64, 32, [&](int x, int y, dvec3) { EXPECT_NEAR(value_at(out, 0, x, y), 0.5, 0.005); });
    const auto inside_out = [](Mesh mesh) {
        std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
        for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
        mesh.indices = std::move(indices), mesh.normals = {};
        return scene_of(std::move(mesh));
    };
    const BakeResult in = bake(inside_out(plain_sphere(100, 200, 2)), inside_out(plain_sphere(24, 48, 2)), options);
    for_each_direction(64, 32, [&](int x, int y, dvec3) { EXPECT_NEAR(value_at(in, 0, x, y), -0.5, 0.005); });
}

TEST_F(Bake, OpennessOfASquareIsOneAndBesideAWallItsFormFactor) {
    BakeOptions options = options_for({BakeMap::occlusion}, 16, 16);
    options.rays = 1024, options.distance = 0.01;
    const BakeResult open = bake(scene_of(square_mesh()), scene_of(square_mesh()), options);
    for (const float v : open.maps[0].values) EXPECT_EQ(v, 1);
    // A wall along y at x = -1, 1000 long and 1 high, on a floor that goes on below it.
    Scene high = scene_of(square_mesh(no_index, 500));
    add_object(high, square_mesh(no_index, 500),
               translation(dvec3{-1, 0, -499}) * dmat4{{{0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}}});
    options.occlusion_distance = 900;
    const BakeResult corner = bake(high, scene_of(square_mesh()), options);
    for (int x = 0; x < 16; ++x) {  // a strip perpendicular to the point: (1 - d / sqrt(d^2 + h^2)) / 2
        const double d = 2 * (x + 0.5) / 16;
        EXPECT_NEAR(value_at(corner, 0, x, 8), 1 - (1 - d / std::sqrt(d * d + 1)) / 2, 0.012) << x;
    }
}

/// What the map says at texture coordinates, between texels.
dvec3 filtered(const BakeResult& result, dvec2 uv) {
    const double x = uv.x * result.width - 0.5, y = uv.y * result.height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const double a = x - x0, b = y - y0;
    return (normal_at(result, x0, y0) * (1 - a) + normal_at(result, x0 + 1, y0) * a) * (1 - b) +
           (normal_at(result, x0, y0 + 1) * (1 - a) + normal_at(result, x0 + 1, y0 + 1) * a) * b;
}

TEST_F(Bake, ObjectsOfACutSphereShowNoSeamWhereTheyMeet) {
    Mesh whole = plain_sphere(24, 48);
    whole.normals = {}, whole.texcoords.clear();
    Scene low;
    std::vector<std::uint32_t> half[2];
    for (std::size_t t = 0; t < whole.triangle_count(); ++t) {  // by columns
        double x = 0;
        for (std::size_t k = 0; k < 3; ++k) x += double(whole.positions[whole.indices[3 * t + k]].x);
        for (std::size_t k = 0; k < 3; ++k) half[x > 0].push_back(whole.indices[3 * t + k]);
    }
    for (const auto& indices : half) {
        Mesh part = whole;
        part.indices = indices;
        add_object(low, std::move(part));
    }
    const BakeResult result = bake(scene_of(dented_sphere(300, 600)), low, options_for({BakeMap::normal}, 512, 512));
    EXPECT_EQ(result.report.made_coordinates, 2u);
    EXPECT_EQ(result.report.overlapping, 0u);
    const bake::LowSurface surface(result.low, 0, context_);
    int border_corners = 0;
    double worst = 0;
    for (std::uint32_t t = 0; t < surface.triangle_count(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const bake::LowTriangle triangle = surface.triangle(t);
            const dvec3 place = (triangle.place[k] + triangle.place[(k + 1) % 3]) * 0.5;
            if (std::fabs(place.x) > 1e-6) continue;
            bake::CornerWeights w{0, 0, 0};
            w[k] = w[(k + 1) % 3] = 0.5;
            const bake::LowPoint p = bake::point_of(triangle, w);
            const auto uv = surface.texcoords(t);
            const vec2 at = (uv[k] + uv[(k + 1) % 3]) * 0.5f;
            const dvec3 m = filtered(result, {double(at.x), double(at.y)});
            const bake::TangentFrame f = bake::interpolated_frame(p.normal, p.tangent, p.handedness);
            worst = std::max(worst, angle_deg(f.tangent * m.x + f.bitangent * m.y + f.normal * m.z,
                                              Dented::normal(normalize_or(place, dvec3{}))));
            ++border_corners;
        }
    EXPECT_EQ(border_corners, 2 * 2 * 24);  // both sides of two meridians
    EXPECT_LT(worst, 0.25);                 // each side is that near to the truth, and so the two are to each other
}

TEST_F(Bake, MirroredAndOverlappingChartsAreReportedAndBakedOnce) {
    Scene low = scene_of(square_mesh());
    Mesh mirrored = square_mesh();
    mirrored.texcoords[0] = std::vector<vec2>{{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    add_object(low, std::move(mirrored), translation(dvec3{4, 0, 0}));
    std::swap(low.nodes[0].meshes, low.nodes[1].meshes);
    Scene high = scene_of(square_mesh());
    high.nodes[0].local.matrix = dmat4{{{1, 0, 0.1, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    add_object(high, square_mesh(), translation(dvec3{4, 0, 0.02}));
    BakeOptions options = options_for({BakeMap::height}, 16, 16);
    options.distance = 0.2;
    const BakeResult result = bake(high, low, options);
    EXPECT_EQ(result.report.charts, 2u);
    EXPECT_EQ(result.report.mirrored, 1u);
    EXPECT_EQ(result.report.overlapping, 1u);
    EXPECT_EQ(result.report.overlapping_texels, 256u);
    EXPECT_EQ(result.report.texels, 256u);
    for (const float v : result.maps[0].values)
        EXPECT_NEAR(v, 0.02, 1e-6);  // of the one that is not mirrored, though second
}

TEST_F(Bake, OverlapsAreReportedBeforeTheRays) {
    Scene low = scene_of(square_mesh());
    add_object(low, square_mesh(), translation(dvec3{4, 0, 0}));
    std::vector<std::string> known;  // when the first rows have their rays
    Context* running = nullptr;
    Context context({.threads = 1, .progress = [&](std::string_view stage, double fraction) {
                         if (stage != "bake" || fraction == 0) return;
                         for (const ReportEntry& entry : running->report().entries()) known.push_back(entry.message);
                         running->cancel();
                     }});
    running = &context;
    EXPECT_THROW(bake_maps(low, low, options_for({BakeMap::normal}, 64, 64), context), Error);
    ASSERT_EQ(known.size(), 1u);
    EXPECT_NE(known[0].find("1 of 2 charts lie on others"), std::string::npos) << known[0];
}

TEST_F(Bake, NumbersAreTheSameForAnyNumberOfThreadsAndAnyInstructionSet) {
    const Scene high = load("builtin:teapot", {}, context_);
    BakeOptions options =
        options_for({BakeMap::normal, BakeMap::height, BakeMap::curvature, BakeMap::occlusion}, 150, 90);
    options.rays = 9, options.make_coordinates = true, options.chart_margin = 2;
    Context one({.threads = 1}), three({.threads = 3});
    const BakeResult a = bake_maps(high, high, options, one);
    const EnvironmentVariable isa("RAKELIGHT_ISA", "scalar");
    const BakeResult b = bake_maps(high, high, options, three);
    EXPECT_GT(a.report.texels, 1000u);
    EXPECT_EQ(a.report.distance, b.report.distance);
    EXPECT_EQ(a.report.missed, b.report.missed);
    for (std::size_t i = 0; i < a.maps.size(); ++i) EXPECT_EQ(a.maps[i].values, b.maps[i].values) << i;
}

/// The square of side 2 with steep bumps of a height: where |x| and |y| are less than `half`.
Scene bumpy_square(float height, float half) {
    constexpr int n = 100;
    Mesh mesh = square_mesh();
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const vec2 at{2.0f * float(x) / n - 1, 2.0f * float(y) / n - 1};
            positions.push_back({at.x, at.y, std::max(std::fabs(at.x), std::fabs(at.y)) < half ? height : 0});
        }
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto v = std::uint32_t(y * (n + 1) + x), up = v + n + 1;
            indices.insert(indices.end(), {v, v + 1, up + 1, v, up + 1, up});
        }
    mesh.positions = std::move(positions), mesh.indices = std::move(indices);
    mesh.normals = {}, mesh.tangents = {}, mesh.texcoords = {};
    return scene_of(std::move(mesh));
}

TEST_F(Bake, ACageForTwoTrianglesHoldsWhatStandsBetweenTheirCorners) {
    Scene low = scene_of(square_mesh());
    const BakeResult result = bake(bumpy_square(0.2f, 0.25f), low, options_for({BakeMap::height}, 32, 32));
    EXPECT_TRUE(result.report.is_proposed);
    EXPECT_NEAR(result.report.distance, 0.25, 1e-5);
    EXPECT_EQ(result.report.missed, 0u);
    EXPECT_EQ(result.report.beyond, 0u);
    EXPECT_NEAR(value_at(result, 0, 16, 16), 0.2, 1e-6);
    EXPECT_NEAR(value_at(result, 0, 4, 28), 0, 1e-6);
}

TEST_F(Bake, WhereNextToNothingMeetsTheDetailedModelIsElsewhere) {
    BakeOptions options = options_for({BakeMap::height}, 256, 256);
    options.distance = 0.01;
    const Scene low = scene_of(square_mesh());
    Scene high = scene_of(square_mesh(no_index, 0.01f));  // 9 of 65536 texels
    EXPECT_EQ(error_of([&] { (void)bake(high, low, options); }).code(), ErrorCode::bad_file);
}

TEST_F(Bake, TexelsBeyondAProposedCageAreCounted) {
    const Scene low = scene_of(square_mesh());
    const BakeResult result = bake(bumpy_square(0.0006f, 0.07f), low, options_for({BakeMap::height}, 64, 64));
    EXPECT_LT(result.report.distance, 0.0005);  // the bump is half a percent of the area
    EXPECT_GT(result.report.beyond, 4u);
    EXPECT_EQ(result.report.missed, 0u);
    EXPECT_NEAR(value_at(result, 0, 32, 32), 0.0006, 1e-6);
}

TEST_F(Bake, ANormalMapOfTheDetailedModelIsBakedAlong) {
    Scene high = scene_of(square_mesh(0));
    high.materials.push_back(matte());
    const Pixels leaning = rgb_pixels(4, 4, [](int, int) { return std::array{204, 128, 230}; });
    high.materials[0].normal_texture = add_texture(high, picture(leaning));
    const BakeResult result = bake(high, scene_of(square_mesh()), options_for({BakeMap::normal}, 8, 8));
    const dvec3 expected{204 / 127.5 - 1, 128 / 127.5 - 1, 230 / 127.5 - 1};
    EXPECT_LT(angle_deg(normal_at(result, 4, 4), expected), 0.01);
}

TEST_F(Bake, NormalsOfTheDetailedModelAreItsFilesOrMadeOverAllObjects) {
    Scene high = scene_of(plain_sphere(12, 24));
    high.missing_normals_are_flat = true;
    high.meshes[0].normals = {};
    BakeOptions options = options_for({BakeMap::normal}, 64, 32);
    options.space = BakeSpace::object, options.samples = 1;
    const auto most = [&](NormalSource source) {
        options.high_normals = source;
        const BakeResult result = bake(high, scene_of(plain_sphere(12, 24)), options);
        double angle = 0;
        for_each_direction(
            64, 32, [&](int x, int y, dvec3 d) { angle = std::max(angle, angle_deg(normal_at(result, x, y), d)); });
        return angle;
    };
    EXPECT_GT(most(NormalSource::automatic), 5);
    EXPECT_LT(most(NormalSource::model), 1);
}

TEST_F(Bake, TheFirstFaceThatLooksOutwardIsBaked) {
    Scene high = scene_of(square_mesh());
    high.nodes[0].local.matrix = translation(dvec3{0, 0, 0.05});
    add_object(high, square_mesh(),
               translation(dvec3{0, 0, 0.1}) * dmat4{{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}});
    BakeOptions options = options_for({BakeMap::height}, 4, 4);
    options.distance = 0.2;
    const BakeResult result = bake(high, scene_of(square_mesh()), options);  // one above looks down
    for (const float v : result.maps[0].values) EXPECT_NEAR(v, 0.05, 1e-6);
}

TEST_F(Bake, WhereNothingIsMetTheModelItselfIsShownAndCounted) {
    BakeOptions options = options_for({BakeMap::normal, BakeMap::occlusion}, 16, 16);
    options.distance = 0.1;
    const BakeResult result = bake(scene_of(square_mesh(no_index, 0.5f)), scene_of(square_mesh()), options);
    EXPECT_EQ(result.report.missed, 256u - 64u);
    EXPECT_LT(angle_deg(normal_at(result, 0, 0), {0, 0, 1}), 1e-6);
    EXPECT_EQ(value_at(result, 1, 0, 0), 1);
    EXPECT_EQ(context_.report().entries().size(), 1u);
}

}  // namespace
}  // namespace rakelight
