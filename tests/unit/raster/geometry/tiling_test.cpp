// SPDX-License-Identifier: Apache-2.0
// Meshes that tile a region cover each of its pixels exactly once, and by the triangle that the rule names: through the
// whole engine, on every instruction set, against exact integers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engines/raster/raster_engine.h"
#include "math/functions.h"
#include "math/isa.h"
#include "support/scene_builder.h"
#include "unit/raster/geometry/tilings.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int side = 128;                                         // [px] of the picture: two tiles each way
constexpr std::int64_t edge = side * 256;                         // [1/256 px]
constexpr std::int64_t rim = std::int64_t(1 << 20) * 256 - edge;  // as far out as corners are before clipping
constexpr int nobody = -1;

/// A camera whose pixels are units of the scene, (0, 0) at the top left corner, y up: places on the grid of 1/256 px
/// stay exact in float.
Camera pixel_camera() {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.half_height = side / 2;
    camera.z_near = 1;
    camera.z_far = 20000;
    camera.to_world = translation(dvec3{side / 2, -side / 2, 10000});
    return camera;
}

/// Each triangle nearer than the one before, with its number as its color: then every pixel of every triangle is
/// written.
Scene numbered(const Tiling& tiling) {
    Scene scene;
    Material material = matte();
    material.model = MaterialModel::unlit;
    material.double_sided = true;
    scene.materials = {material};
    std::vector<vec3> positions;
    std::vector<vec4> colors;
    std::vector<std::uint32_t> indices;
    for (std::size_t t = 0; t < tiling.size(); ++t)
        for (const GridPoint p : tiling[t]) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back({float(double(p.x) / 256), float(-double(p.y) / 256), float(t)});
            colors.push_back({float(t + 1), 0, 0, 1});
        }
    Mesh mesh;
    mesh.positions = positions;
    mesh.colors = colors;
    mesh.indices = indices;
    mesh.material = 0;
    add_object(scene, std::move(mesh));
    return scene;
}

struct Drawn {
    std::vector<int> owner;  ///< [side * side] number of the triangle that shows, or nobody
    std::uint64_t covered, times_covered;
};

Drawn draw(const Scene& scene) {
    Context context({.threads = 2});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    const RenderStats stats = engine->render(
        pixel_camera(), {.width = side, .height = side, .shading = Shading::unlit, .background = {0, 0, 0, 0}}, frame,
        context);
    Drawn drawn{{}, stats.pixels_covered, stats.depth_passes};
    for (const vec4& c : frame.color) drawn.owner.push_back(c.w > 0 ? int(std::lround(c.x)) - 1 : nobody);
    return drawn;
}

std::vector<int> owners_by_definition(const Tiling& tiling) {
    std::vector<int> owner(side * side, nobody);
    for (std::size_t t = 0; t < tiling.size(); ++t)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (owns(tiling[t], x, y)) owner[std::size_t(y * side + x)] = int(t);
    return owner;
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

/// @param whole  the region is all of the picture or more
void expect_exactly_once(const Tiling& tiling, bool whole, const std::string& what) {
    const std::vector<int> expected = owners_by_definition(tiling);
    const Scene scene = numbered(tiling);
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        const Drawn drawn = draw(scene);
        EXPECT_EQ(drawn.owner, expected) << what << ", " << name(isa);
        EXPECT_EQ(drawn.times_covered, drawn.covered)
            << what << ", " << name(isa) << ": some pixels are written more than once";
        if (whole) {
            EXPECT_EQ(drawn.covered, std::uint64_t(side * side)) << what << ", " << name(isa);
        }
    }
}

std::vector<GridPoint> random_points(Random& random, int count, std::int64_t snap) {
    std::vector<GridPoint> points;
    for (int i = 0; i < count; ++i) {
        const auto place = [&] { return std::max<std::int64_t>(between(random, 1, edge - 1) / snap * snap, 1); };
        points.push_back({place(), place()});
    }
    return points;
}

}  // namespace

TEST(Tiling, TheMeshesOfTheseTestsTile) {
    Random random(1);
    const std::vector<Tiling> tilings = {delaunay(rectangle(0, 0, edge, edge), random_points(random, 60, 1)),
                                         subdivided(rectangle(0, 0, edge, edge), 4, random),
                                         fan(edge / 2, edge / 2, {5, 7}, 9)};
    for (const Tiling& tiling : tilings) {
        __int128 sum = 0;
        for (const Tile3& t : tiling) {
            EXPECT_TRUE(doubled_area(t[0], t[1], t[2]) > 0);
            sum += doubled_area(t[0], t[1], t[2]);
        }
        EXPECT_TRUE(sum == 2 * __int128(edge) * edge);
    }
}

TEST(Tiling, RandomPointsWithTheirDelaunayTriangles) {
    Random random(2);
    for (int round = 0; round < 8; ++round)
        expect_exactly_once(delaunay(rectangle(0, 0, edge, edge), random_points(random, 20 << (round % 4), 1)), true,
                            "round " + std::to_string(round));
}

TEST(Tiling, CornersOnPixelCentersAndOnPixelCorners) {
    Random random(3);
    for (const std::int64_t snap : {128, 256, 512}) {
        Tiling tiling = delaunay(rectangle(0, 0, edge, edge), random_points(random, 120, snap));
        expect_exactly_once(tiling, true, "multiples of " + std::to_string(snap));
        for (Tile3& t : tiling)
            for (GridPoint& p : t) p.x += 128, p.y += 128;  // the region's own border passes through centers
        expect_exactly_once(tiling, false, "shifted multiples of " + std::to_string(snap));
    }
}

TEST(Tiling, SliversDownToPartsOfAPixel) {
    Random random(4);
    for (int round = 0; round < 4; ++round)
        expect_exactly_once(subdivided(rectangle(0, 0, edge, edge), 5, random), true, "round " + std::to_string(round));
    const Tiling tiny = subdivided(rectangle(60 * 256 + 3, 60 * 256 + 9, 67 * 256 + 77, 66 * 256 + 200), 6,
                                   random);  // where four tiles meet
    expect_exactly_once(tiny, false, "a few pixels of " + std::to_string(tiny.size()) + " triangles");
}

TEST(Tiling, TrianglesLargerThanTheScreenUpToTheGuardBand) {
    Random random(5);
    for (int round = 0; round < 6; ++round) {
        const GridPoint middle{between(random, -edge / 2, edge / 2), between(random, -edge / 2, edge / 2)};
        const std::int64_t half = (rim >> (3 * (round % 3))) / (1 << 12) * (1 << 12);
        Tiling tiling = fan(half, half, middle, 1 + 40 * (round / 3));
        for (Tile3& t : tiling)
            for (GridPoint& p : t)
                p.x += edge / 2, p.y += edge / 2;  // about the middle of the picture, as the guard band is
        expect_exactly_once(tiling, true, "fan to " + std::to_string(half / 256) + " px");
    }
}

TEST(Tiling, TrianglesWithCornersBeyondTheGuardBandLeaveNoGapAlthoughTheyAreCut) {
    Random random(6);
    for (int round = 0; round < 4; ++round) {
        const Tiling tiling =
            fan(rim * (2 << round), rim * (2 << round), {between(random, 0, edge), between(random, 0, edge)}, 3);
        const Drawn drawn = draw(numbered(tiling));
        EXPECT_EQ(drawn.covered, std::uint64_t(side * side)) << round;
        EXPECT_EQ(drawn.times_covered, drawn.covered) << round;
    }
}

/// In perspective corners fall anywhere. A pane that lets half of the background through shows gaps and double cover:
/// each pixel is laid over once or not at all.
TEST(Tiling, APaneOfGlassOfManyTrianglesSeenInPerspectiveIsLaidOverEachPixelOnce) {
    Random random(7);
    for (int round = 0; round < 12; ++round) {
        Scene scene;
        Material glass = matte();
        glass.model = MaterialModel::unlit;
        glass.double_sided = true;
        glass.base_color = {1, 1, 1, 0.5f};
        glass.alpha_mode = AlphaMode::blend;
        scene.materials = {glass};
        const Tiling tiling = round % 2 == 0 ? delaunay(rectangle(0, 0, edge, edge), random_points(random, 100, 1))
                                             : subdivided(rectangle(0, 0, edge, edge), 4, random);
        std::vector<vec3> positions;
        std::vector<std::uint32_t> indices;
        for (const Tile3& t : tiling)
            for (const GridPoint p : t) {
                indices.push_back(std::uint32_t(positions.size()));
                positions.push_back({float(p.x) / edge * 2 - 1, float(p.y) / edge * 2 - 1, 0});
            }
        Mesh mesh;
        mesh.positions = positions;
        mesh.indices = indices;
        mesh.material = 0;
        add_object(scene, std::move(mesh), scaling(dvec3{3, 3, 3}));
        Camera camera;
        camera.vertical_fov_rad = radians(70);
        camera.z_near = 0.05;
        const double turn =
            0.5 * round;  // near the pane, so that most of these look along it and parts lie behind the eye
        camera.to_world =
            look_at({0.1, -0.2, 1.3}, {0.1 + 2 * math::sin(turn), 0.3, 1.3 - 2.5 * math::cos(0.2 * turn)}, {0, 1, 0});
        Context context({.threads = 2});
        const auto engine = raster::make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(camera, {.width = side, .height = side, .background = {0, 0, 0, 1}}, frame, context);
        std::size_t once = 0;
        for (const vec4& c : frame.color) {
            EXPECT_TRUE(c.x == 0 || c.x == 0.5f) << round << ": " << c.x;
            once += c.x == 0.5f;
        }
        EXPECT_GT(once, 2000u) << round;
    }
}
