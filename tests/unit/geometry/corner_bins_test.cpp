// SPDX-License-Identifier: Apache-2.0
// Corners sorted by keys: every one in its bin, in order, for any number of keys and threads.
#include "geometry/corners/corner_bins.h"

#include <gtest/gtest.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using namespace geometry;

std::uint32_t key_of(std::uint32_t corner, std::uint32_t keys) {
    const std::uint32_t mixed = (corner * 2654435761u) ^ (corner >> 7);
    if (mixed % 11 == 0) return CornerSort::no_bin;
    return mixed % 5 == 0 ? keys - 1 : mixed % keys;  // and one crowded bin
}

CornerBins sorted(const AttributeInput& input, std::uint32_t keys, int threads) {
    Context context({.threads = threads});
    CornerBins stale;  // memory of another use
    stale.begin.assign(7, 99);
    stale.corners.reserve(10);
    BlockArray<std::uint16_t> scratch;
    CornerSort sort(input, keys, std::move(stale), scratch, context);
    return sort.run([&](std::uint32_t) { return [&](std::uint32_t corner) { return key_of(corner, keys); }; });
}

TEST(CornerBins, HoldEveryCornerOfTheirKeyInOrder) {
    // Two meshes, one of more triangles than a chunk has.
    std::vector<std::uint32_t> large(3 * 70'000, 0), small(3 * 11, 0);
    const std::vector<vec3> positions(1);
    std::vector<AttributeMesh> meshes(3);
    for (AttributeMesh& m : meshes) m.positions = positions;
    meshes[0].indices = large;
    meshes[2].indices = small;
    const AttributeInput input = number_input(meshes);
    const std::uint32_t corners = std::uint32_t(large.size() + small.size());
    for (const std::uint32_t keys : {1u, 5u, 32767u, 32768u, 32769u, 65536u, 200'000u}) {
        std::vector<std::vector<std::uint32_t>> expected(keys);
        for (std::uint32_t c = 0; c < corners; ++c)
            if (const std::uint32_t key = key_of(c, keys); key != CornerSort::no_bin) expected[key].push_back(c);
        for (const int threads : {1, 2, 4}) {
            const CornerBins bins = sorted(input, keys, threads);
            ASSERT_EQ(bins.begin.size(), keys + 1u);
            for (std::uint32_t key = 0; key < keys; ++key)
                ASSERT_TRUE(std::equal(bins[key].begin(), bins[key].end(), expected[key].begin(), expected[key].end()))
                    << key << " of " << keys;
        }
    }
}

TEST(CornerBins, NoCornersOrNoBins) {
    const AttributeInput nothing = number_input({});
    EXPECT_EQ(sorted(nothing, 3, 2).begin, (std::vector<std::uint32_t>{0, 0, 0, 0}));
    EXPECT_EQ(sorted(nothing, 1, 1).size(0), 0u);
}

}  // namespace
}  // namespace rakelight::test
