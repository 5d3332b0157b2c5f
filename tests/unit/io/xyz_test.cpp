// SPDX-License-Identifier: Apache-2.0
// Points as lines of numbers: what the columns mean, and lines that are none.
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include "io/read_xyz.h"
#include "math/color.h"
#include "math/linear.h"

namespace rakelight::io {
namespace {

struct ReadXyz {
    Context context{{.threads = 1}};
    Scene scene;
    std::string error;
    explicit ReadXyz(std::string_view text) {
        try {
            scene = read_xyz_text(text, "folder/cloud.xyz", context);
            validate(scene);
        } catch (const Error& e) {
            error = e.what();
        }
    }
    const Mesh& mesh() const { return scene.meshes.at(0); }
};

TEST(ReadXyz, PlacesAlone) {
    const ReadXyz read("# a comment\n1 2 3\r\n\n4;5;6\n  7, 8, 9\n");
    ASSERT_EQ(read.error, "");
    EXPECT_EQ(read.mesh().topology, Topology::points);
    ASSERT_EQ(read.mesh().positions.size(), 3u);
    EXPECT_EQ(read.mesh().positions[1], (vec3{4, 5, 6}));
    EXPECT_EQ(read.mesh().positions[2], (vec3{7, 8, 9}));
    EXPECT_EQ(read.mesh().name, "cloud");
}

TEST(ReadXyz, ThreeMoreAreNormalsOrColorsByWhatTheyAre) {
    const ReadXyz normals("0 0 0 0.6 0.8 0\n1 0 0 0 0 -1\n");
    ASSERT_EQ(normals.error, "");
    EXPECT_EQ(normals.mesh().normals.size(), 2u);
    EXPECT_TRUE(normals.mesh().colors.empty());
    const ReadXyz colors("0 0 0 255 128 0\n1 0 0 1 0 0\n");
    ASSERT_EQ(colors.error, "");
    EXPECT_TRUE(colors.mesh().normals.empty());
    ASSERT_EQ(colors.mesh().colors.size(), 2u);
    EXPECT_EQ(colors.mesh().colors[0].y, linear_from_srgb8(128));
    EXPECT_EQ(colors.mesh().colors[1].x, linear_from_srgb8(1));
    const ReadXyz shares("0 0 0 0.5 0.25 0\n1 0 0 0.9 0 1\n");
    ASSERT_EQ(shares.mesh().colors.size(), 2u);
    EXPECT_NEAR(shares.mesh().colors[0].x, linear_from_srgb(0.5f), 1e-6f);
}

TEST(ReadXyz, NormalsAndColorsInEitherOrder) {
    const ReadXyz a("0 0 0 0 0 1 10 20 30\n1 0 0 0 1 0 40 50 60\n"), b("0 0 0 10 20 30 0 0 1\n1 0 0 40 50 60 0 1 0\n");
    for (const ReadXyz* read : {&a, &b}) {
        ASSERT_EQ(read->error, "");
        ASSERT_EQ(read->mesh().normals.size(), 2u);
        ASSERT_EQ(read->mesh().colors.size(), 2u);
        EXPECT_EQ(read->mesh().normals[1], (vec3{0, 1, 0}));
        EXPECT_EQ(read->mesh().colors[1].x, linear_from_srgb8(40));
    }
}

TEST(ReadXyz, PtsBeginsWithACountAndHasAnIntensity) {
    const ReadXyz read("2\n0 0 0 -1200 10 20 30\n1 0 0 77 40 50 60\n");
    ASSERT_EQ(read.error, "");
    ASSERT_EQ(read.mesh().positions.size(), 2u);
    EXPECT_EQ(read.mesh().colors[1].z, linear_from_srgb8(60));
    EXPECT_TRUE(read.mesh().normals.empty());
}

TEST(ReadXyz, WhatIsNoLineOfNumbersIsSaidWithItsLine) {
    EXPECT_NE(ReadXyz("12\nwater\nO 0 0 0\n").error.find("line 2"), std::string::npos) << "a molecule";
    EXPECT_NE(ReadXyz("1 2 3\n1 2\n").error.find("line 2"), std::string::npos);
    EXPECT_NE(ReadXyz("").error.find("no point"), std::string::npos);
    EXPECT_NE(ReadXyz("# nothing\n").error.find("no point"), std::string::npos);
}

TEST(ReadXyz, PlacesOfSurveysKeepTheirDigits) {
    const ReadXyz read("431234.125 5432109.875 100\n431234.25 5432109.75 100.5\n");
    ASSERT_EQ(read.error, "");
    const dvec3 first = cast<double>(read.mesh().positions[0]) + read.mesh().origin;
    EXPECT_EQ(first, (dvec3{431234.125, 5432109.875, 100}));
}

TEST(ReadXyz, NumbersBeyondTheColumnsAreReported) {
    const auto dropped = [](const std::string& text) {
        ReadXyz read(text);
        EXPECT_EQ(read.error, "");
        const auto entries = read.context.report().entries();
        return entries.empty() ? std::string() : entries[0].message;
    };
    const std::string sixteen = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16";
    EXPECT_EQ(dropped(sixteen + " \n" + sixteen + "\n"), "");
    EXPECT_EQ(dropped(sixteen + " 17\n" + sixteen + ",17,18\n"),
              "2 lines hold more than 16 numbers; further ones are left out");
    EXPECT_EQ(dropped("1 2 3\n4 5 6 7\n"), "1 line holds more than 3 numbers; further ones are left out");
}

}  // namespace
}  // namespace rakelight::io
