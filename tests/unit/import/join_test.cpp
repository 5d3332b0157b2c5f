// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>

#include "import/join.h"

namespace rakelight::import_helper {
namespace {

constexpr std::uint32_t wanted = 1000;  ///< vertices; their table has 2048 slots
constexpr std::uint64_t all_pairs = wanted * (wanted - 1) / 2;

/// What everybody can compute, once this table's own.
std::uint64_t unkeyed_hash(vec3 p) {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (const float x : {p.x, p.y, p.z}) {
        h = (h ^ std::bit_cast<std::uint32_t>(x)) * 0xFF51AFD7ED558CCDull;
        h ^= h >> 32;
    }
    return h;
}

Part points(std::vector<vec3> positions) {
    Part part;
    part.topology = 2;
    part.positions = std::move(positions);
    for (std::uint32_t v = 0; v < part.positions.size(); ++v) part.indices.push_back(v);
    return part;
}

TEST(JoinEqualVertices, VerticesMadeToMeetInOneSlotOfTheTableDoNot) {
    std::vector<vec3> positions;
    for (int i = 0; positions.size() < wanted; ++i) {
        const vec3 p{float(i % 2048), float(i / 2048), 1};
        if ((unkeyed_hash(p) & 2047) == 0) positions.push_back(p);
    }
    Part part = points(positions);
    std::uint64_t met = 0;
    join_equal_vertices(part, &met);
    EXPECT_EQ(part.positions, positions);  // all of them differ
    EXPECT_LT(met, all_pairs / 50) << "evenly filled: about half as many as there are vertices";
}

TEST(JoinEqualVertices, EqualOnesBecomeTheFirstOfThemAndUnusedOnesGo) {
    Part part = points({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}, {-0.0f, 0, 0}, {9, 9, 9}, {2, 0, 0}});
    part.colors = {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
    part.indices = {6, 4, 3, 2, 1, 0, 2};  // all but 5
    join_equal_vertices(part);
    EXPECT_EQ(part.positions, (std::vector<vec3>{{1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {-0.0f, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(part.indices, (std::vector<std::uint32_t>{4, 3, 2, 0, 1, 0, 0}));  // -0 is not 0, and colors count
    EXPECT_EQ(part.colors.size(), 5u);
    EXPECT_EQ(part.colors[4].x, 0);
}

}  // namespace
}  // namespace rakelight::import_helper
