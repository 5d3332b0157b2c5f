// SPDX-License-Identifier: Apache-2.0
// PLY: names of the common writers, the three forms of the data, faces, and files that promise what they do not hold.
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>

#include "io/ply/read_ply.h"
#include "math/color.h"
#include "support/hostile_cases.h"
#include "support/temporary_folder.h"

namespace rakelight::io {
namespace {

struct ReadPly {
    Context context{{.threads = 2}};
    Scene scene;
    std::string error;
    explicit ReadPly(std::string_view bytes, const std::string& path = "folder/scan.ply") {
        try {
            scene = ply::read_ply_bytes(bytes, path, {}, context);
            validate(scene);
        } catch (const Error& e) {
            error = e.what();
        }
    }
    const Mesh& mesh(std::size_t i = 0) const { return scene.meshes.at(i); }
    bool says(const std::string& part) {
        const auto entries = context.report().entries();
        return std::ranges::any_of(entries,
                                   [&](const ReportEntry& e) { return e.message.find(part) != std::string::npos; });
    }
};

std::string header(const std::string& format, const std::string& rest) {
    return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string xyz_face = "element face 1\nproperty list uchar int vertex_indices\n";

template <class T>
std::string raw(T value, bool is_big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// Five vertices, then elements in any order.
std::string five_vertices(const std::string& elements, const std::string& rows) {
    return header("ascii", "element vertex 5\n" + xyz + elements) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n" + rows;
}

TEST(ReadPly, FacesStripsAndPolygonsStayInStep) {
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n",
                      colored = faces + "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                      strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const ReadPly quad_then_strip(five_vertices(faces + strips, "4 0 1 2 3\n3 1 4 2\n"));
    ASSERT_EQ(quad_then_strip.error, "");
    EXPECT_EQ(
        std::vector<std::uint32_t>(quad_then_strip.mesh().polygons.begin(), quad_then_strip.mesh().polygons.end()),
        (std::vector<std::uint32_t>{0, 0, 2}));
    for (const auto& [elements, rows] : {std::pair(colored + strips, std::string("3 0 1 2 255 0 0\n3 1 4 2\n")),
                                         std::pair(strips + colored, std::string("3 1 4 2\n3 0 1 2 255 0 0\n")),
                                         std::pair(colored + faces, std::string("3 0 1 2 255 0 0\n3 1 4 2\n")),
                                         std::pair(faces + colored, std::string("4 1 4 2 0\n3 0 1 2 255 0 0\n"))}) {
        const ReadPly read(five_vertices(elements, rows));
        ASSERT_EQ(read.error, "") << elements;
        const Mesh& mesh = read.mesh();
        ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
        std::size_t red = 0, white = 0;
        for (const std::uint32_t corner : mesh.indices) {
            red += mesh.colors[corner] == vec4{1, 0, 0, 1};
            white += mesh.colors[corner] == vec4{1, 1, 1, 1};
        }
        EXPECT_EQ(red, 3u) << elements;
        EXPECT_EQ(red + white, mesh.indices.size()) << elements;
    }
}

TEST(ReadPly, VerticesWithoutPositionsAreRefusedBeforeFacesAreRead) {
    const ReadPly read(header("ascii", "element vertex 4\nproperty float confidence\n" + xyz_face) +
                       "1\n1\n1\n1\n4 0 1 2 3\n");
    EXPECT_NE(read.error.find("the vertices have no x, y and z"), std::string::npos) << read.error;
}

TEST(ReadPly, ColorsByTheNamesOfTheCommonWriters) {
    for (const std::string names : {"red green blue alpha", "diffuse_red diffuse_green diffuse_blue diffuse_alpha",
                                    "r g b a", "Red Green Blue Alpha"}) {
        std::string properties;
        for (std::string_view rest = names; !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            properties += "property uchar " + std::string(rest.substr(0, end)) + "\n";
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        const ReadPly read(header("ascii", "element vertex 2\n" + xyz + properties) +
                           "0 0 0 255 128 0 255\n1 0 0 7 8 9 51\n");
        ASSERT_EQ(read.error, "") << names;
        EXPECT_EQ(read.mesh().topology, Topology::points);
        ASSERT_EQ(read.mesh().colors.size(), 2u) << names;
        EXPECT_EQ(read.mesh().colors[0].x, 1);
        EXPECT_EQ(read.mesh().colors[0].y, linear_from_srgb8(128));
        EXPECT_NEAR(read.mesh().colors[1].w, 0.2f, 1e-6f);
        EXPECT_EQ(read.scene.materials.at(0).base_color, (vec4{1, 1, 1, 1})) << "its colors are as the file has them";
    }
}

TEST(ReadPly, ColorsOfOtherTypes) {
    const auto first = [](const std::string& type, const std::string& numbers) {
        const ReadPly read(header("ascii", "element vertex 1\n" + xyz + "property " + type + " red\nproperty " + type +
                                               " green\nproperty " + type + " blue\n") +
                           "0 0 0 " + numbers + "\n");
        EXPECT_EQ(read.error, "");
        return read.mesh().colors.empty() ? vec4{} : read.mesh().colors[0];
    };
    EXPECT_NEAR(first("float", "0.5 0.25 1").x, linear_from_srgb(0.5f), 1e-6f);
    EXPECT_NEAR(first("float", "255 51 0").y, linear_from_srgb(0.2f), 1e-6f);
    EXPECT_NEAR(first("ushort", "65535 13107 0").y, linear_from_srgb(0.2f), 1e-6f);
    EXPECT_NEAR(first("int", "255 51 0").y, linear_from_srgb(0.2f), 1e-6f);
    const ReadPly packed(header("binary_little_endian", "element vertex 1\n" + xyz + "property float rgb\n") +
                         raw(0.0f) + raw(0.0f) + raw(0.0f) + raw(0x00ff8033u));
    ASSERT_EQ(packed.error, "");
    ASSERT_EQ(packed.mesh().colors.size(), 1u);
    EXPECT_EQ(packed.mesh().colors[0].y, linear_from_srgb8(0x80));
    EXPECT_EQ(packed.mesh().colors[0].z, linear_from_srgb8(0x33));
    const ReadPly number(header("ascii", "element vertex 1\n" + xyz + "property uint rgba\n") + "0 0 0 4278255411\n");
    ASSERT_EQ(number.mesh().colors.size(), 1u);
    EXPECT_EQ(number.mesh().colors[0].x, 0);
    EXPECT_EQ(number.mesh().colors[0].y, 1);
    EXPECT_EQ(number.mesh().colors[0].z, linear_from_srgb8(0x33));
}

TEST(ReadPly, TheThreeFormsSayTheSame) {
    const std::string vertices =
        "element vertex 3\n" + xyz + "property double nx\nproperty short ny\nproperty uchar nz\n" + xyz_face;
    const float places[3][3] = {{0, 0, 0}, {1, 0.5f, 0}, {0, 1, -2.25f}};
    std::string text;
    for (const auto& p : places)
        text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " 0 0 1\n";
    const auto binary = [&](bool big) {
        std::string bytes;
        for (const auto& p : places) {
            for (const float x : p) bytes += raw(x, big);
            bytes += raw(0.0, big) + raw(std::int16_t(0), big) + raw(std::uint8_t(1));
        }
        return bytes + raw(std::uint8_t(3)) + raw(0, big) + raw(1, big) + raw(2, big);
    };
    const ReadPly a(header("ascii", vertices) + text + "3 0 1 2\n"),
        b(header("binary_little_endian", vertices) + binary(false)),
        c(header("binary_big_endian", vertices) + binary(true));
    for (const ReadPly* read : {&a, &b, &c}) {
        ASSERT_EQ(read->error, "");
        EXPECT_EQ(read->mesh().topology, Topology::triangles);
        ASSERT_EQ(read->mesh().positions.size(), 3u);
        for (std::size_t v = 0; v < 3; ++v)
            EXPECT_EQ(read->mesh().positions[v], (vec3{places[v][0], places[v][1], places[v][2]}));
        EXPECT_EQ(read->mesh().normals[2], (vec3{0, 0, 1}));
        EXPECT_EQ(std::vector<std::uint32_t>(read->mesh().indices.begin(), read->mesh().indices.end()),
                  (std::vector<std::uint32_t>{0, 1, 2}));
    }
}

TEST(ReadPly, PolygonsStripsAndEdges) {
    const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const ReadPly quad(
        header("ascii", "element vertex 4\n" + xyz + "element face 2\nproperty list uchar int vertex_index\n") +
        square + "3 0 1 2\n4 0 1 2 3\n");
    ASSERT_EQ(quad.error, "");
    EXPECT_EQ(quad.mesh().indices.size(), 9u);
    EXPECT_EQ(std::vector<std::uint32_t>(quad.mesh().polygons.begin(), quad.mesh().polygons.end()),
              (std::vector<std::uint32_t>{0, 1, 1}));
    const ReadPly strip(
        header("ascii", "element vertex 4\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n") +
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n" + "8 0 1 2 3 -1 0 1 3\n");
    ASSERT_EQ(strip.error, "");
    EXPECT_EQ(std::vector<std::uint32_t>(strip.mesh().indices.begin(), strip.mesh().indices.end()),
              (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 0, 1, 3}))
        << "every second one turns round";
    const ReadPly edges(
        header("ascii", "element vertex 4\n" + xyz + "element edge 1\nproperty int vertex1\nproperty int vertex2\n") +
        square + "0 2\n");
    ASSERT_EQ(edges.error, "");
    EXPECT_EQ(edges.mesh().topology, Topology::lines);
}

TEST(ReadPly, FacesWithTexcoordsOrColorsOfTheirOwnSplitVertices) {
    const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const ReadPly uv(
        header("ascii",
               "element vertex 4\n" + xyz +
                   "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n") +
        square + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 0.5 0.5 0 1\n");
    ASSERT_EQ(uv.error, "");
    EXPECT_EQ(uv.mesh().positions.size(), 5u) << "vertex 2 has two, vertex 0 one";
    EXPECT_EQ(uv.mesh().texcoords.at(0)[0], (vec2{0, 1}));
    const ReadPly colors(
        header("ascii", "element vertex 4\n" + xyz +
                            "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty "
                            "uchar green\nproperty uchar blue\n") +
        square + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n");
    ASSERT_EQ(colors.error, "");
    EXPECT_EQ(colors.mesh().positions.size(), 6u);
    EXPECT_EQ(colors.mesh().colors[0], (vec4{1, 0, 0, 1}));
}

TEST(ReadPly, ColorsOfFacesHaveTheRangesOfColorsOfVertices) {
    const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const auto read = [&](const std::string& properties, const std::string& first, const std::string& second) {
        return ReadPly(header("ascii", "element vertex 4\n" + xyz +
                                           "element face 2\nproperty list uchar int vertex_indices\n" + properties) +
                       square + "3 0 1 2 " + first + "\n3 0 2 3 " + second + "\n");
    };
    const auto rgb = [](const std::string& type) {
        return "property " + type + " Red\nproperty " + type + " green\nproperty " + type + " blue\n";
    };
    ReadPly reals = read(rgb("float"), "255 51 0", "1 0.5 0");
    ASSERT_EQ(reals.error, "");
    ASSERT_EQ(reals.mesh().colors.size(), 6u);
    EXPECT_EQ(reals.mesh().colors[0].y, linear_from_srgb8(51));
    EXPECT_EQ(reals.mesh().colors[3].x, linear_from_srgb8(1)) << "one range for the whole column";
    EXPECT_TRUE(reals.says("face colors over 1 were read as 0..255"));
    EXPECT_EQ(read(rgb("float"), "0.5 1 0", "1 0 0").mesh().colors[0].x, linear_from_srgb(0.5f));
    EXPECT_NEAR(read(rgb("ushort"), "65535 13107 0", "0 0 0").mesh().colors[0].y, linear_from_srgb(0.2f), 1e-6f);
    const ReadPly alpha = read(rgb("uchar") + "property uchar alpha\n", "255 0 0 51", "0 0 255 255");
    EXPECT_NEAR(alpha.mesh().colors[0].w, 0.2f, 1e-6f);
    EXPECT_EQ(alpha.mesh().colors[3].w, 1);
    EXPECT_EQ(read("property uchar alpha\n", "51", "255").mesh().colors[3], (vec4{1, 1, 1, 1})) << "alpha alone";
    ReadPly twice = read(rgb("uchar") + "property uchar diffuse_red\n", "255 0 0 7", "0 0 255 7");
    EXPECT_EQ(twice.mesh().colors[0], (vec4{1, 0, 0, 1}));
    EXPECT_TRUE(twice.says("'diffuse_red'"));
    const ReadPly none = read(rgb("float"), "nan 1 0", "nan 1 0");
    EXPECT_EQ(none.mesh().colors[0], (vec4{0, 1, 0, 1}));
    EXPECT_EQ(none.mesh().positions.size(), 4u) << "the same color at the corners that both faces share";
}

TEST(ReadPly, NothingIsLeftOutInSilence) {
    ReadPly read(
        header("ascii",
               "element vertex 1\n" + xyz +
                   "property float intensity\nproperty float confidence\nproperty list uchar int seen_by\nelement "
                   "camera 1\nproperty float focal\n") +
        "0 0 0 0.5 1 2 7 8\n35\nmore\n");
    ASSERT_EQ(read.error, "");
    ASSERT_EQ(read.mesh().arrays.size(), 2u);
    EXPECT_TRUE(read.mesh().arrays[0].name == "intensity" && read.mesh().arrays[1].name == "confidence");
    EXPECT_TRUE(read.says("'seen_by'"));
    EXPECT_TRUE(read.says("'camera'"));
    EXPECT_TRUE(read.says("bytes follow"));
}

TEST(ReadPly, CountsAreHeldAgainstTheDataBeforeMemoryIsAskedFor) {
    const auto error = [](const std::string& bytes) { return ReadPly(bytes).error; };
    EXPECT_NE(error(header("ascii", "element vertex 1000000000\n" + xyz) + "0 0 0\n").find("promises 1000000000"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex -1\n" + xyz) + "0 0 0\n"), "");
    EXPECT_NE(error("ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "0 0 0\n").find("end_header"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex 1\nproperty quark x\n") + "0\n").find("quark"), std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex 3\n" + xyz + xyz_face) + "0 0 0\n1 0 0\n0 1 0\n2147483648 0 1\n")
                  .find("promises 2147483648 numbers"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex 3\n" + xyz + xyz_face) + "0 0 0\n1 0 0\n0 1 0\n-1 0 1\n"), "");
    const std::string binary = header("binary_little_endian", "element vertex 3\n" + xyz + xyz_face), three(36, '\0');
    EXPECT_NE(error(binary + three + raw(std::uint8_t(3)) + raw(0) + raw(1)).find("face"), std::string::npos);
    EXPECT_NE(error(binary + three + raw(std::uint8_t(3)) + raw(0) + raw(1) + raw(3)).find("no face"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex 1\nproperty float x\n") + "0\n").find("x, y and z"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element vertex 2\n" + xyz) + "0.25 0 0 1.125\n1\n").find("ends inside"),
              std::string::npos);
    EXPECT_NE(error(header("ascii", "element none 1000000000000\nelement vertex 0\n" + xyz)).find("no vertex"),
              std::string::npos);
}

TEST(ReadPly, ATextureBesideIsTaken) {
    const rakelight::test::TemporaryFolder folder;
    folder.write("skin.png", "not decoded here");
    const std::string text = header("ascii", "comment TextureFile skin.png\nelement vertex 3\n" + xyz +
                                                 "property float s\nproperty float t\n" + xyz_face) +
                             "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n";
    const ReadPly read(text, folder.write("a.ply", text));
    ASSERT_EQ(read.error, "");
    ASSERT_EQ(read.scene.textures.size(), 1u);
    EXPECT_EQ(read.mesh().texcoords.at(0)[0], (vec2{0, 1}));
}

TEST(ReadPly, HostileFilesKeepTheirVerdicts) {
    RL_NEEDS_SHARED("hostile");
    std::size_t seen = 0;
    for (const auto& [name, fault, verdict, path] : rakelight::test::hostile_cases()) {
        if (!name.ends_with(".ply")) continue;
        SCOPED_TRACE(name + ": " + verdict);
        ++seen;
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        ReadPly read(bytes, path.string());
        EXPECT_TRUE(verdict != "refuse" || !read.error.empty()) << "it was accepted";
        EXPECT_EQ(read.error.find('\n'), std::string::npos);
        const bool is_made = name.starts_with("truncated/") || name.starts_with("flipped/") || name.starts_with("ply/");
        const auto remarks = read.context.report().entries();
        const bool remarked =
            std::ranges::any_of(remarks, [](const ReportEntry& e) { return e.remark != Remark::note; });
        EXPECT_TRUE(verdict != "either" || !is_made || !read.error.empty() || remarked) << "accepted without a word";
    }
    EXPECT_GT(seen, 8u);
}

}  // namespace
}  // namespace rakelight::io
