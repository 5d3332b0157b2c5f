// SPDX-License-Identifier: Apache-2.0
// The kernels of geometry and visibility, on every instruction set that this processor has, against the plain functions
// beside them.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "engines/raster/visibility/coverage.h"
#include "math/flush_denormals.h"
#include "unit/raster/geometry/every_geometry_kernels.h"

using namespace rakelight;
using namespace rakelight::raster;

namespace {

PictureCamera picture_camera_of(Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.vertical_fov_rad = radians(70);
    camera.half_height = 3;
    camera.z_near = 0.25;
    camera.z_far = 50;
    return shading::make_picture_camera(camera, dmat4{}, {.width = 1920, .height = 1080});
}

/// As camera space: clip x, y and distance are x, y and -z.
VertexJob job_of(const PictureCamera& view, std::vector<vec3>& positions, std::vector<ClipVertex>& clip,
                 std::vector<ScreenVertex>& screen) {
    const ScreenMap map(view);
    const ClipVolume volume(view);
    clip.assign(positions.size() + row_padding, {});
    screen.assign(positions.size() + row_padding, {});
    VertexJob job{};
    job.positions = &positions[0].x;
    job.count = job.total = std::int32_t(positions.size());
    job.to_clip[0][0] = job.to_clip[1][1] = 1;
    job.to_clip[2][2] = -1;
    job.orthographic = view.orthographic;
    job.z_near = 0.25f, job.z_far = 50;
    job.guard_x = volume.guard_x, job.guard_y = volume.guard_y;
    job.scale_x = map.scale_x, job.offset_x = map.offset_x, job.scale_y = map.scale_y, job.offset_y = map.offset_y;
    job.key_scale = map.key_scale, job.key_offset = map.key_offset;
    job.clip = &clip[0].x;
    job.screen = screen.data();
    return job;
}

/// Corners in and far out of the picture, behind the eye, on the planes, and not finite.
std::vector<vec3> hard_positions() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1, 1);
    const float infinity = std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::max();
    std::vector<vec3> all = {{0, 0, -0.25f},        {0, 0, -50},       {7, 7, -7},          {std::nanf(""), 0, -1},
                             {0, infinity, -1},     {0, 0, -infinity}, {most, most, -most}, {-most, most, -1},
                             {1e-40f, -1e-40f, -1}, {-5, 2, 0},        {1, 1, 30}};
    for (int i = 0; i < 3000; ++i) {
        const float scale = i % 3 == 0 ? 1e6f : i % 3 == 1 ? 60.0f : 1.0f;
        all.push_back(
            {any(random) * scale, any(random) * scale, -std::abs(any(random)) * 60 + (i % 7 == 0 ? 40.0f : 0.0f)});
    }
    return all;
}

/// Small triangles with positive area over and round a tile that begins at (64, 128).
std::vector<ScreenTriangle> small_triangles(std::size_t count) {
    std::mt19937 random(9);
    std::vector<ScreenTriangle> all;
    while (all.size() < count) {
        const int size = all.size() % 4 == 0 ? 30000 : all.size() % 4 == 1 ? 4000 : 500;
        const int x = 64 * 256 + int(random() % 20000) - 1500, y = 128 * 256 + int(random() % 20000) - 1500;
        const auto offset = [&] { return int(random() % unsigned(size)) - size / 2; };
        const auto bits = [&] { return std::uint32_t(random()) << outcode_bits; };
        const auto key = [&] { return float(random() % 100000) / 100000.0f; };
        ScreenTriangle s{};
        s.x0 = x + offset(), s.y0 = y + offset(), s.x1 = x + offset(), s.y1 = y + offset(), s.x2 = x + offset(),
        s.y2 = y + offset();
        const std::int64_t area = std::int64_t(s.x1 - s.x0) * (s.y2 - s.y0) - std::int64_t(s.x2 - s.x0) * (s.y1 - s.y0);
        s.key0 = key(), s.key1 = key(), s.key2 = key();
        s.bits0 = bits(), s.bits1 = bits(), s.bits2 = bits();
        if (area == 0) continue;
        if (area < 0) std::swap(s.x1, s.x2), std::swap(s.y1, s.y2);
        all.push_back(s);
    }
    return all;
}

struct TilePixels {
    std::vector<float> depth = std::vector<float>(tile_size * tile_size, -1.0f);
    std::vector<std::int32_t> visible = std::vector<std::int32_t>(tile_size * tile_size, -1);
    bool operator==(const TilePixels&) const = default;
};

}  // namespace

TEST(GeometryKernels, VerticesAreWhereThePlainFunctionsPutThem) {
    const FlushDenormals guard;
    std::vector<vec3> positions = hard_positions();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const PictureCamera view = picture_camera_of(projection);
        const ScreenMap map(view);
        const ClipVolume volume(view);
        for (const GeometryKernels* kernels : every_geometry_kernels()) {
            std::vector<ClipVertex> clip;
            std::vector<ScreenVertex> screen;
            const VertexJob job = job_of(view, positions, clip, screen);
            kernels->transform(&job);
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const unsigned code = outcode(clip[i], volume);
                ASSERT_EQ(screen[i].bits & outside_all, code) << i;
                if (code & cutting_planes) continue;
                const ScreenVertex plain = snap_to_screen(map, clip[i]);
                ASSERT_EQ(screen[i].x, plain.x) << i;
                ASSERT_EQ(screen[i].y, plain.y) << i;
                ASSERT_EQ(screen[i].key, plain.key) << i;
                ASSERT_EQ(screen[i].bits >> outcode_bits, plain.bits >> outcode_bits) << i;
                const dvec2 exact = view.screen(clip[i]);
                const double fine = double(screen[i].bits >> outcode_bits & 2047u) / 2048 - 0.5;
                ASSERT_NEAR((double(screen[i].x) + fine) / 256, exact.x, 2e-6)
                    << i << ": a true place is known to 1/500,000 px";
            }
        }
    }
}

TEST(GeometryKernels, SmallTrianglesCoverWhatThePlainFunctionsSayAtTheSameDepth) {
    const FlushDenormals guard;
    const std::vector<ScreenTriangle> triangles = small_triangles(500);
    std::vector<const TriangleRow*> rows;
    for (const ScreenTriangle& t : triangles) rows.push_back(&t);
    for (const Window area : {Window{64, 128, 64, 64}, Window{70, 140, 31, 3}}) {
        TilePixels expected;
        std::int32_t written = 0;
        for (std::size_t i = 0; i < 500; ++i)
            cover(triangles[i], area, 64, 128, [&](int x, int y, float depth) {
                const auto p = std::size_t(y * tile_size + x);
                if (!(depth > expected.depth[p])) return;
                expected.depth[p] = depth;
                expected.visible[p] = std::int32_t(i) + 7;
                ++written;
            });
        for (const GeometryKernels* kernels : every_geometry_kernels()) {
            TilePixels found;
            NearestJob job{.rows = rows.data(),
                           .count = 500,
                           .total = 500,
                           .position = 7,
                           .tile_x = 64,
                           .tile_y = 128,
                           .left = area.x - 64,
                           .top = area.y - 128,
                           .right = area.x - 64 + area.width - 1,
                           .bottom = area.y - 128 + area.height - 1,
                           .farthest = -1,
                           .depth = found.depth.data(),
                           .visible = found.visible.data()};
            EXPECT_EQ(kernels->nearest(&job), written);
            EXPECT_TRUE(found == expected);
            EXPECT_EQ(kernels->nearest(&job), 0) << "among equal depths the first stays";
        }
    }
}

/// Squares with corners on pixel centers, of two triangles each: by the top-left rule every center belongs to one.
TEST(GeometryKernels, CentersOnTheEdgesOfSmallTrianglesBelongToTopAndLeftEdges) {
    const FlushDenormals guard;
    const auto triangle = [](int x0, int y0, int x1, int y1, int x2, int y2) {
        ScreenTriangle s{};
        const auto at = [](int v) { return v * 256 + 128; };
        s.x0 = at(x0), s.y0 = at(y0), s.x1 = at(x1), s.y1 = at(y1), s.x2 = at(x2), s.y2 = at(y2);
        s.key0 = s.key1 = s.key2 = 0.5f;
        s.bits0 = s.bits1 = s.bits2 = std::uint32_t(1 << (fine_bits - 1)) << outcode_bits |
                                      std::uint32_t(1 << (fine_bits - 1)) << (outcode_bits + fine_bits);
        return s;
    };
    for (const GeometryKernels* kernels : every_geometry_kernels())
        for (const int size : {1, 2, 5, 9})
            for (const bool falls : {false, true}) {  // which diagonal
                const int l = 70, t = 135, r = l + size, b = t + size;
                const ScreenTriangle halves[2] = {triangle(l, t, r, t, falls ? r : l, b),
                                                  falls ? triangle(l, t, r, b, l, b) : triangle(r, t, r, b, l, b)};
                std::vector<int> covered(tile_size * tile_size, 0);
                for (const ScreenTriangle& half : halves) {
                    const std::vector<const TriangleRow*> rows(32, &half);
                    TilePixels found;
                    NearestJob job{.rows = rows.data(),
                                   .count = 1,
                                   .total = 1,
                                   .position = 0,
                                   .tile_x = 64,
                                   .tile_y = 128,
                                   .left = 0,
                                   .top = 0,
                                   .right = tile_size - 1,
                                   .bottom = tile_size - 1,
                                   .farthest = -1,
                                   .depth = found.depth.data(),
                                   .visible = found.visible.data()};
                    kernels->nearest(&job);
                    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] += found.visible[i] >= 0;
                }
                for (int y = 0; y < tile_size; ++y)
                    for (int x = 0; x < tile_size; ++x)
                        ASSERT_EQ(covered[std::size_t(y * tile_size + x)],
                                  x + 64 >= l && x + 64 < r && y + 128 >= t && y + 128 < b)
                            << x << ", " << y << " of a square of " << size;
            }
}

TEST(GeometryKernels, TheFarthestDepthOfAPartOfATileIsThatOfItsPixelsAlone) {
    std::mt19937 random(31);
    for (const GeometryKernels* kernels : every_geometry_kernels()) {
        TilePixels tile;
        kernels->clear_tile(tile.depth.data(), tile.visible.data());
        EXPECT_TRUE(tile == TilePixels{});
        EXPECT_EQ(kernels->farthest(tile.depth.data(), 3, 4, 3, 4), -1.0f) << "nothing stands there";
        for (float& d : tile.depth) d = float(random() % 1000 + 1) / 1001.0f;
        for (int round = 0; round < 200; ++round) {
            const int left = int(random() % 64), top = int(random() % 64);
            const int right = left + int(random() % unsigned(64 - left)),
                      bottom = top + int(random() % unsigned(64 - top));
            float least = 2;
            for (int y = top; y <= bottom; ++y)
                for (int x = left; x <= right; ++x) least = std::min(least, tile.depth[std::size_t(y * tile_size + x)]);
            ASSERT_EQ(kernels->farthest(tile.depth.data(), left, top, right, bottom), least);
        }
        tile.depth[10 * tile_size + 20] = -1;
        EXPECT_EQ(kernels->farthest(tile.depth.data(), 20, 10, 63, 63), -1.0f);
        EXPECT_GT(kernels->farthest(tile.depth.data(), 21, 10, 63, 63), 0.0f);
    }
}

TEST(GeometryKernels, ATrianglesDepthDoesNotDependOnWhichCornerComesFirst) {
    for (ScreenTriangle s : small_triangles(300)) {
        std::vector<float> first;
        for (int turn = 0; turn < 3; ++turn) {
            std::vector<float> depths;
            cover(s, {64, 128, 64, 64}, 64, 128, [&](int, int, float depth) { depths.push_back(depth); });
            if (turn == 0) first = depths;
            ASSERT_EQ(depths, first);
            const ScreenTriangle t = s;
            s.x0 = t.x1, s.y0 = t.y1, s.key0 = t.key1, s.bits0 = t.bits1;
            s.x1 = t.x2, s.y1 = t.y2, s.key1 = t.key2, s.bits1 = t.bits2;
            s.x2 = t.x0, s.y2 = t.y0, s.key2 = t.key0, s.bits2 = t.bits0;
        }
    }
}

/// What passes set-up is what covers a pixel center (exactly so for boxes of up to 2 x 2 centers) and is on a side that
/// is drawn.
TEST(GeometryKernels, TrianglesWithoutAPixelCenterVanishAndNoOtherDoes) {
    std::vector<ScreenVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::mt19937 random(21);
    constexpr int triangles = 3001;  // no whole number of vectors
    for (int t = 0; t < triangles; ++t) {
        const int x = int(random() % (96 * 256)), y = int(random() % (96 * 256)), size = t % 5 == 0 ? 9000 : 600;
        for (int k = 0; k < 3; ++k) {
            indices.push_back(std::uint32_t(vertices.size()));
            vertices.push_back({x + int(random() % unsigned(size)), y + int(random() % unsigned(size)), 0.5f, 0});
        }
    }
    for (const GeometryKernels* kernels : every_geometry_kernels()) {
        std::vector<ScreenTriangle> rows(triangles);
        std::vector<std::uint32_t> tiles(triangles);
        SetUpJob job{.indices = indices.data(),
                     .count = triangles,
                     .first = 0,
                     .draw = 4,
                     .vertices = vertices.data(),
                     .cull_back = 1,
                     .cull_front = 0,
                     .front_is_negative = 1,
                     .left = 3,
                     .top = 5,
                     .right = 82,
                     .bottom = 74,
                     .first_tile_x = 0,
                     .first_tile_y = 0,
                     .columns = 2,
                     .rows = rows.data(),
                     .tiles = tiles.data()};
        const std::int32_t passed = kernels->set_up(&job);
        ASSERT_EQ(std::uint32_t(passed) + job.culled_back + job.culled_degenerate + job.culled_outside,
                  std::uint32_t(triangles));
        std::int32_t next = 0;
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const ScreenVertex *a = &vertices[3 * t], *b = a + 1, *c = a + 2;
            const std::int64_t area =
                std::int64_t(b->x - a->x) * (c->y - a->y) - std::int64_t(c->x - a->x) * (b->y - a->y);
            const bool is_here = next < passed && rows[std::size_t(next)].triangle == t;
            const ScreenTriangle& s = rows[std::size_t(is_here ? next++ : 0)];
            if (area >= 0) {
                ASSERT_FALSE(is_here) << "seen from behind";
                continue;
            }
            ScreenTriangle own{};
            own.x0 = a->x, own.y0 = a->y, own.x1 = c->x, own.y1 = c->y, own.x2 = b->x, own.y2 = b->y;
            int covered = 0, outer_x = -1, outer_y = -1;
            for (const Window tile :
                 {Window{3, 5, 61, 59}, Window{64, 5, 19, 59}, Window{3, 64, 61, 11}, Window{64, 64, 19, 11}})
                cover(own, tile, 0, 0, [&](int x, int y, float) { ++covered, outer_x = x, outer_y = y; });
            if (covered > 0) {
                ASSERT_TRUE(is_here) << t;
            }
            if (!is_here) continue;
            ASSERT_TRUE(s.is_swapped && !s.is_back && !s.is_piece && s.draw == 4u);
            ASSERT_EQ(std::memcmp(&s.x0, &own.x0, 8) + std::memcmp(&s.x1, &own.x1, 8) + std::memcmp(&s.x2, &own.x2, 8),
                      0);
            const auto [low_x, high_x] = std::minmax({a->x, b->x, c->x});
            const auto [low_y, high_y] = std::minmax({a->y, b->y, c->y});
            const int across = std::min((high_x - 128) >> 8, 82) - std::max((low_x + 127) >> 8, 3);
            const int down = std::min((high_y - 128) >> 8, 74) - std::max((low_y + 127) >> 8, 5);
            if (across <= 1 && down <= 1) {
                ASSERT_GT(covered, 0) << t;
            }
            if (tiles[std::size_t(next - 1)] != in_many_tiles && covered > 0) {
                ASSERT_EQ(tiles[std::size_t(next - 1)], std::uint32_t(outer_y / 64 * 2 + outer_x / 64));
            }
        }
        EXPECT_EQ(next, passed);
    }
}
