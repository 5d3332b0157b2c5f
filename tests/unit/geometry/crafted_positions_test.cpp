// SPDX-License-Identifier: Apache-2.0
// Meshes whose positions were chosen to meet in one slot of a table, by hashes that everybody can compute: the tables
// of welding fill as evenly as with any other mesh. Otherwise each of n positions meets all before it, n^2 / 2
// together.
#include <gtest/gtest.h>

#include <bit>
#include <unordered_map>

#include "geometry/refine/tessellate.h"
#include "geometry/weld/near_cells.h"
#include "geometry/weld/position_weld.h"
#include "unit/geometry/shapes.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t wanted = 1000;  ///< positions; their tables have 2048 slots
constexpr std::uint64_t all_pairs = wanted * (wanted - 1) / 2;

/// Grid points times a step whose hash has the low 11 bits 0.
template <class Hash>
test::Shape crafted(float step, const Hash& hash) {
    test::Shape shape;
    for (std::uint64_t i = 0; shape.positions.size() < wanted; ++i) {
        const std::uint64_t x = i & 255, y = i >> 8 & 255, z = i >> 16;
        if ((hash(x, y, z) & 2047) == 0) shape.positions.push_back(vec3{float(x), float(y), float(z)} * step);
    }
    for (std::uint32_t v = 0; v + 2 < wanted; v += 3) shape.indices.insert(shape.indices.end(), {v, v + 1, v + 2});
    return shape;
}

/// Multiply and shift, once this weld's own.
std::uint64_t unkeyed_hash(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    std::uint64_t h = 0;
    for (const std::uint64_t a : {x, y, z}) {
        const auto bits = std::bit_cast<std::uint64_t>(double(a));
        h = (h ^ bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15ull;
        h ^= h >> 29;
    }
    h *= 0xbf58476d1ce4e5b9ull;
    return h ^ (h >> 32);
}

/// What tells NearCells' cells apart: of no key, so that results are the same in every run.
std::uint64_t cell_hash(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    std::uint64_t h = (x * 0x9e3779b97f4a7c15ull ^ y) * 0xbf58476d1ce4e5b9ull;
    h = ((h ^ (h >> 31)) + z) * 0x94d049bb133111ebull;
    return h ^ (h >> 29);
}

TEST(CraftedPositions, DoNotMeetInTheTableOfTheWeld) {
    const std::vector<test::Shape> shapes = {crafted(1.0f, unkeyed_hash)};
    const std::vector<AttributeMesh> meshes = test::views(shapes);
    Context context({.threads = 1});
    std::uint64_t met = 0;
    const auto representative = weld_positions(check_input(meshes, context), {}, context, &met);
    for (std::uint32_t v = 0; v < wanted; ++v) EXPECT_EQ(representative[v], v);
    EXPECT_LT(met, all_pairs / 50) << "evenly filled: about a third of the positions";
}

TEST(CraftedPositions, DoNotMeetInTheTableOfNearCells) {
    test::Shape shape = crafted(4.0f, cell_hash);  // cells are 4 distances wide
    for (vec3& p : shape.positions) p = p + vec3{2, 2, 2};
    const std::vector<test::Shape> shapes = {shape};
    const std::vector<AttributeMesh> meshes = test::views(shapes);
    Context context({.threads = 1});
    const AttributeInput input = check_input(meshes, context);
    const NearCells cells(weld_positions(input, {}, context), input, {}, 1.0, context);
    ASSERT_EQ(cells.partitions(), 1u);
    EXPECT_LT(cells.for_each_shared_cell(0, [](auto) {}), all_pairs / 50);
}

TEST(CraftedPositions, EdgesMadeToMeetInTheTableOfCutEdgesDoNot) {
    // The number of an edge between two multiples of a prime is one, too: in a table of so many slots, as the standard
    // library makes for 1000 edges, all fall into the first by their number alone.
    constexpr std::uint32_t vertices = 45;
    std::unordered_map<std::uint64_t, int> by_number;
    for (std::uint64_t i = 0; i < vertices * (vertices - 1) / 2; ++i) by_number[i] = 0;
    const auto prime = std::uint32_t(by_number.bucket_count());
    by_number.clear();  // keeps its slots
    CoarseMesh mesh;
    mesh.places.resize(std::size_t(prime) * vertices);
    for (std::uint32_t v = 0; v < vertices; ++v)
        mesh.places[v * prime] = {double(v), double(v * v % 47), double(v * v * v % 53)};
    for (std::uint32_t a = 0; a < vertices; ++a)
        for (std::uint32_t b = a + 1; b < vertices; ++b) {
            by_number[std::uint64_t(a) * prime << 32 | std::uint64_t(b) * prime] = 0;
            mesh.indices.insert(mesh.indices.end(),
                                {a * prime, b * prime, (b == a + 1 ? (b + 1) % vertices : a + 1) * prime});
        }
    ASSERT_EQ(by_number.bucket_size(0), by_number.size());  // they are crafted well
    const std::uint64_t edges = by_number.size(), pairs = edges * (edges - 1) / 2;
    Context context({.threads = 1});
    std::uint64_t met = 0;
    const Tessellation t = tessellate({&mesh, 1}, 0.5, mesh.indices.size() / 3 * 4, context, &met);
    EXPECT_EQ(t.meshes[0].places.size(), mesh.places.size() + edges) << "each edge cut once";
    EXPECT_LT(met, pairs / 50) << "evenly filled: about half as many as there are edges";
}

}  // namespace
}  // namespace rakelight::geometry
