// SPDX-License-Identifier: Apache-2.0
// OFF: colors of faces and vertices, kinds of the header, and files that promise what they do not hold.
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "io/ply/read_off.h"
#include "scene/placement.h"
#include "support/expect_color.h"

namespace rakelight::io {
namespace {

struct ReadOff {
    Context context{{.threads = 1}};
    Scene scene;
    std::string error;
    explicit ReadOff(std::string_view text) {
        try {
            scene = ply::read_off_text(text, "folder/a.off", context);
            validate(scene);
        } catch (const Error& e) {
            error = e.what();
        }
    }
    const Mesh& mesh() const { return scene.meshes.at(0); }
    /// Of a triangle's corner.
    vec4 color(std::size_t corner) const { return mesh().colors[mesh().indices[corner]]; }
    vec3 position(std::size_t corner) const { return mesh().positions[mesh().indices[corner]]; }
    bool says(const std::string& part) {
        const auto entries = context.report().entries();
        return std::ranges::any_of(entries,
                                   [&](const ReportEntry& e) { return e.message.find(part) != std::string::npos; });
    }
};

const std::string square = "0 0 0\n2 0 0\n2 1 0\n0 1 0\n";

using test::expect_color;

TEST(ReadOff, PolygonsBecomeTriangles) {
    const ReadOff off("OFF\n4 1 0\n" + square + "4 0 1 2 3\n");
    ASSERT_EQ(off.error, "");
    EXPECT_EQ(triangle_count(off.scene), 2u);
    EXPECT_EQ(off.mesh().positions.size(), 4u);
    EXPECT_TRUE(off.mesh().normals.empty() && off.mesh().colors.empty());
    EXPECT_EQ(off.mesh().name, "a");
}

TEST(ReadOff, FacesHaveTheirColors) {
    const ReadOff off("OFF\n4 2 0\n" + square + "3 0 1 2 255 0 0\n3 0 2 3 0 0 128\n");
    ASSERT_EQ(off.error, "");
    for (std::size_t k = 0; k < 3; ++k) {
        expect_color(off.color(k), {1, 0, 0});
        expect_color(off.color(3 + k), {0, 0, 128 / 255.0f});
    }
    EXPECT_EQ(off.mesh().positions.size(), 6u);  // the two corners of both faces are two vertices each
    EXPECT_EQ(off.position(0), (vec3{0, 0, 0}));
    EXPECT_EQ(off.position(5), (vec3{0, 1, 0}));
    EXPECT_EQ(off.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1}));
}

TEST(ReadOff, ColorsMayBeSharesAndHaveAlpha) {
    const ReadOff off("OFF\n4 2 0\n" + square + "3 0 1 2 0.5 0.25 1.0 0.5\n3 0 2 3 0 0 1 1\n");
    ASSERT_EQ(off.error, "");
    expect_color(off.color(0), {0.5f, 0.25f, 1}, 0.5f);
    expect_color(off.color(3), {0, 0, 1});
    const ReadOff bytes("OFF\n4 1 0\n" + square + "4 0 1 2 3 255 255 255 51\n");
    expect_color(bytes.color(0), {1, 1, 1}, 0.2f);
}

TEST(ReadOff, FacesWithoutColorAreGrayBesideColoredOnes) {
    for (const char* const faces : {"3 0 1 2\n3 0 2 3 0 255 0\n", "3 0 2 3 0 255 0\n3 0 1 2\n"}) {
        const ReadOff off("OFF\n4 2 0\n" + square + faces);
        ASSERT_EQ(off.error, "");
        const std::size_t gray = faces[6] == '2' ? 0 : 3;
        expect_color(off.color(gray), {0.6f, 0.6f, 0.6f});
        expect_color(off.color(3 - gray), {0, 1, 0});
    }
}

TEST(ReadOff, HeadersNameWhatVerticesHave) {
    const ReadOff off(
        "STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 0 255  0.25 0.75\n1 0 0  0 0 1  0 255 0 255  1 0\n"
        "0 1 0  0 0 1  0 0 255 255  0 1\n3 0 1 2\n");
    ASSERT_EQ(off.error, "");
    EXPECT_EQ(off.mesh().normals[1], (vec3{0, 0, 1}));
    expect_color(off.color(0), {1, 0, 0});
    expect_color(off.color(2), {0, 0, 1});
    EXPECT_EQ(off.mesh().texcoords.at(0)[0], (vec2{0.25f, 0.25f}));
    const ReadOff colors("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2 9 9 9\n");
    ASSERT_EQ(colors.error, "");
    expect_color(colors.color(1), {0, 1, 0});
    EXPECT_NE(ReadOff("4OFF\n1 0 0\n0 0 0 0\n").error.find("not supported"), std::string::npos);
}

TEST(ReadOff, ColorsBehindPositionsAreColors) {
    ReadOff off("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    ASSERT_EQ(off.error, "");
    expect_color(off.color(0), {1, 0, 0});
    EXPECT_TRUE(off.says("were read as colors"));
}

TEST(ReadOff, LayoutIsFree) {
    const ReadOff off("# by hand\r\n\r\n  OFF 4 1 4 # counts\r\n" + square + "\n# a face\r\n\t4 0 1 2 3 # white\r\n");
    ASSERT_EQ(off.error, "");
    EXPECT_EQ(triangle_count(off.scene), 2u);
    EXPECT_EQ(ReadOff("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n").mesh().topology, Topology::points);
}

TEST(ReadOff, WhatIsLeftOutIsSaid) {
    ReadOff off("OFF\n4 5 0\n" + square + "3 0 1 2 7\n2 0 1\n3 0 1 9\n3 0 2 3\n3 -1 2 3\n");
    ASSERT_EQ(off.error, "");
    EXPECT_EQ(triangle_count(off.scene), 2u);
    EXPECT_TRUE(off.says("1 faces have a color that is no color"));  // an index of a colormap
    EXPECT_TRUE(off.says("1 faces have fewer than 3 corners"));
    EXPECT_TRUE(off.says("2 faces have vertex numbers out of range"));
}

TEST(ReadOff, BrokenFilesAreOneLineWithItsNumber) {
    EXPECT_NE(ReadOff("").error, "");
    EXPECT_NE(ReadOff("PLY\n").error.find("not an OFF file"), std::string::npos);
    EXPECT_NE(ReadOff("OFF BINARY\n").error.find("binary OFF"), std::string::npos);
    EXPECT_NE(ReadOff("OFF\n1000000000 1 0\n0 0 0\n").error.find("promises 1000000000 vertices"), std::string::npos);
    EXPECT_NE(ReadOff("OFF\n1 18446744073709551615 0\n0 0 0\n").error, "");
    EXPECT_NE(ReadOff("OFF\n3 -1 0\n0 0 0\n1 0 0\n0 1 0\n").error.find("number of faces is '-1'"), std::string::npos);
    EXPECT_NE(ReadOff("OFF\n4 1 0\n" + square).error.find("cut short"), std::string::npos);
    EXPECT_NE(ReadOff("OFF\n4 1 0\n" + square + "4 0 1 2\n").error.find("line 7: a face has 3 corners instead of 4"),
              std::string::npos);
    EXPECT_NE(ReadOff("OFF\n4 1 0\n" + square + "4294967295 0 1 2\n").error, "");
    EXPECT_NE(ReadOff("OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n").error.find("line 3: a vertex has 2 numbers"),
              std::string::npos);
    EXPECT_NE(ReadOff("OFF\n3 1 0\n0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n").error.find("'x' is not a number"),
              std::string::npos);
    EXPECT_NE(ReadOff("OFF\n4 1 0\n" + square + "3 7 8 9\n").error.find("no face has three valid corners"),
              std::string::npos);
}

}  // namespace
}  // namespace rakelight::io
