// SPDX-License-Identifier: Apache-2.0
// Binary STL: joined corners, colors of two programs, and headers that promise what the file does not hold.
#include <limits>
#include <optional>

#include "io/stl/join_corners.h"
#include "support/expect_color.h"
#include "unit/io/stl/stl_support.h"

namespace rakelight::io::stl_test {
namespace {

using test::expect_color;

TEST(BinaryStl, TrianglesShareVerticesAndHaveNoNormals) {
    ReadStl stl(binary_file(square()));
    ASSERT_EQ(stl.error, "");
    EXPECT_EQ(triangle_count(stl.scene), 2u);
    ASSERT_EQ(stl.mesh().positions.size(), 4u);
    EXPECT_EQ(stl.mesh().positions[3], (vec3{0, 1, 0})) << "in order of first use";
    EXPECT_TRUE(stl.mesh().normals.empty() && stl.mesh().colors.empty() && stl.mesh().polygons.empty());
    ASSERT_EQ(stl.scene.nodes.size(), 2u);
    EXPECT_EQ(stl.scene.nodes[0].name, "<STL_BINARY>");
    EXPECT_EQ(stl.scene.materials.at(0).name, "DefaultMaterial");
    EXPECT_EQ(stl.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1}));
    EXPECT_EQ(stl.remarks(), 0u);
}

TEST(BinaryStl, PositionsThatDifferInOneBitAreTwo) {
    std::vector<Facet> facets = square();
    facets[1].corners[0].x = -0.0f;
    EXPECT_EQ(ReadStl(binary_file(facets)).mesh().positions.size(), 5u);
}

TEST(BinaryStl, FilesOfManyPartsAreJoinedAsOneWhateverTheThreads) {
    std::vector<Facet> facets;
    for (int i = 0; i < 50000; ++i) {  // a strip: each vertex but the outer ones is of three triangles
        const auto at = [](int k) { return vec3{float(k / 2), float(k % 2), 0}; };
        facets.push_back({{at(i), at(i + 1), at(i + 2)}});
    }
    const std::string file = binary_file(facets);
    const ReadStl one(file, {.threads = 1}), four(file, {.threads = 4});
    ASSERT_EQ(one.error, "");
    ASSERT_EQ(one.mesh().positions.size(), 50002u);
    EXPECT_TRUE(std::ranges::equal(one.mesh().positions, four.mesh().positions));
    EXPECT_TRUE(std::ranges::equal(one.mesh().indices, four.mesh().indices));
    for (std::size_t i = 0; i < one.mesh().indices.size(); ++i) ASSERT_EQ(one.mesh().indices[i], i / 3 + i % 3);
}

TEST(BinaryStl, VisCamFacetsHaveColorsWhereBit15SaysSo) {
    constexpr std::uint32_t red = 0x8000 | 31 << 10, blue_without_bit = 31;
    ReadStl stl(binary_file(square(red, blue_without_bit)));
    ASSERT_EQ(stl.error, "");
    EXPECT_EQ(stl.mesh().positions.size(), 6u) << "corners of two colors are two vertices";
    expect_color(stl.color(0), {1, 0, 0});
    expect_color(stl.color(3), {0.6f, 0.6f, 0.6f});
    EXPECT_EQ(stl.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1}));
    ReadStl plain(binary_file(square(1234, 31)));
    EXPECT_TRUE(plain.mesh().colors.empty());
    EXPECT_EQ(plain.mesh().positions.size(), 4u);
}

const std::string magics_header = std::string("made by Magics COLOR=") + "\xFF\x80" + std::string(1, '\0') + "\xFF";
constexpr vec3 orange{1, 128 / 255.0f, 0};

TEST(BinaryStl, MagicsObjectsHaveTheColorOfTheHeader) {
    ReadStl stl(binary_file(square(0x8000, 0x8000 | 31), magics_header));
    ASSERT_EQ(stl.error, "");
    EXPECT_TRUE(stl.mesh().colors.empty());
    expect_color(stl.scene.materials.at(0).base_color, orange);
    expect_color({stl.scene.materials[0].classical.ambient.x, stl.scene.materials[0].classical.ambient.y,
                  stl.scene.materials[0].classical.ambient.z, 1},
                 orange);
}

TEST(BinaryStl, MagicsFacetsHaveColorsWhereBit15IsClear) {
    constexpr std::uint32_t red = 31;
    ReadStl stl(binary_file(square(red, 0x8000), magics_header));
    ASSERT_EQ(stl.error, "");
    expect_color(stl.color(0), {1, 0, 0});
    expect_color(stl.color(3), orange);
    EXPECT_EQ(stl.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1}));
}

/// As Autodesk's programs write them, and those that leave attributes alone.
TEST(BinaryStl, MagicsFacetsInTheColorOfTheObjectHaveNoneOfTheirOwn) {
    constexpr std::uint32_t orange_in_five_bits = 31 | 15 << 5;
    for (const std::uint32_t attribute : {orange_in_five_bits, 0u}) {
        ReadStl stl(binary_file(square(attribute, attribute), magics_header));
        EXPECT_TRUE(stl.mesh().colors.empty());
        expect_color(stl.scene.materials.at(0).base_color, orange);
    }
    ReadStl black(binary_file(square(0, 31), magics_header));
    expect_color(black.color(0), {0, 0, 0});
}

TEST(BinaryStl, AColorThatTheHeaderCutsOffIsNone) {
    const std::string header = std::string(72, ' ') + "COLOR=\xFF\xFF";
    ReadStl stl(binary_file(square(), header));
    ASSERT_EQ(stl.error, "");
    EXPECT_EQ(stl.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1}));
}

TEST(BinaryStl, TheDeclaredFacetsAreHeldAgainstTheSize) {
    const auto error = [](std::uint32_t promised) { return ReadStl(binary_file(square(), "", promised)).error; };
    EXPECT_EQ(error(2), "");
    EXPECT_EQ(error(3), "byte 80: it promises 3 triangles (at least 234 bytes), but 184 bytes are there");
    EXPECT_EQ(error(0xFFFFFFFF),
              "byte 80: it promises 4294967295 triangles (at least 214748364834 bytes), but 184 bytes are there");
    // 50 times it is 100 modulo 2^32.
    EXPECT_NE(error(2 + 0x80000000u).find("promises 2147483650"), std::string::npos);
    EXPECT_EQ(error(1), "byte 80: 50 bytes follow the 1 triangles that it declares");
    EXPECT_NE(error(0), "");
    EXPECT_EQ(ReadStl(binary_file({})).error, "nothing to draw: the file holds no triangle");
    const std::string whole = binary_file(square());
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(ReadStl(whole.substr(0, size)).error, "") << size;
}

TEST(BinaryStl, AHeaderMayBeginLikeText) {
    ReadStl stl(binary_file(square(), "solid but binary"));
    ASSERT_EQ(stl.error, "");
    EXPECT_TRUE(stl.says("it is binary and was read as such"));
    EXPECT_NE(ReadStl(binary_file(square(), "solid but binary", 3)).error.find("promises 3"), std::string::npos);
}

TEST(BinaryStl, NumbersThatAreNotFiniteAreReported) {
    std::vector<Facet> facets = square();
    facets[0].corners[1] = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
    facets[1].corners[2] = {0, std::numeric_limits<float>::infinity(), 0};
    ReadStl stl(binary_file(facets));
    ASSERT_EQ(stl.error, "");
    EXPECT_TRUE(stl.says("2 vertices are not finite numbers"));
    EXPECT_EQ(stl.mesh().positions.size(), 4u);
}

TEST(BinaryStl, MemoryIsChargedAndLimited) {
    const std::string file = binary_file(std::vector<Facet>(2000, square()[0]));
    EXPECT_NE(ReadStl(file, {.threads = 1, .max_memory = 50000}).error.find("more than the limit of 50000"),
              std::string::npos);
    ReadStl read(file);
    const std::uint64_t held = read.mesh().indices.size() * 4 + read.mesh().positions.size() * 12;
    EXPECT_GE(read.context.memory().charged(), held);
    EXPECT_LT(read.context.memory().charged(), held + 1000) << "what was needed to read it is given back";
}

TEST(BinaryStl, CancellationEndsIt) {
    Context context;
    context.cancel();
    EXPECT_THROW(stl::read_stl_bytes(binary_file(square()), "a.stl", context), Error);
}

}  // namespace
}  // namespace rakelight::io::stl_test
