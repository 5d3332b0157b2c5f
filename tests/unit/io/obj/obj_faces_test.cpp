// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <cmath>
#include <limits>
#include <set>

#include "io/obj/obj_meshes.h"
#include "math/color.h"
#include "scene/placement.h"
#include "unit/io/obj/obj_fixture.h"

namespace rakelight::io {
namespace {

class ObjFaces : public obj_test::ObjFolder {};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::uint64_t triangles(const Scene& scene) {
    std::uint64_t sum = 0;
    for (const Mesh& m : scene.meshes) sum += m.triangle_count();
    return sum;
}

TEST_F(ObjFaces, ASquareIsOneObjectNamedAfterTheFile) {
    const Scene s = load(square + "f 1 2 3 4\n");
    ASSERT_EQ(s.nodes.size(), 1u);
    ASSERT_EQ(s.meshes.size(), 1u);
    EXPECT_EQ(s.nodes[0].name, "model");
    EXPECT_EQ(s.nodes[0].meshes, std::vector<std::uint32_t>{0});
    EXPECT_EQ(s.meshes[0].positions.size(), 4u);
    EXPECT_EQ(s.meshes[0].triangle_count(), 2u);
    EXPECT_TRUE(s.meshes[0].normals.empty());
    EXPECT_TRUE(s.meshes[0].smoothing.empty());
    EXPECT_EQ(s.meshes[0].smoothing_kind, SmoothingKind::none);
    EXPECT_FALSE(s.missing_normals_are_flat);
    EXPECT_TRUE(remarks().empty());
    EXPECT_NO_THROW(validate(s));
}

TEST_F(ObjFaces, TrianglesOfAPolygonHaveItsNumber) {
    const std::string six = square + "v 2 0 0\nv 2 1 0\n";
    const auto polygons = [&](const std::string& faces) {
        const Scene s = load(six + faces);
        EXPECT_NO_THROW(validate(s));
        return std::vector<std::uint32_t>(s.meshes.at(0).polygons.begin(), s.meshes.at(0).polygons.end());
    };
    EXPECT_TRUE(polygons("f 1 2 3\nf 2 5 6\n").empty());  // nothing but triangles
    EXPECT_EQ(polygons("f 1 2 3\nf 1 3 4\nf 2 5 6 3\nf 1 2 3\n"), (std::vector<std::uint32_t>{0, 1, 2, 2, 4}));
    EXPECT_EQ(polygons("f 1 2 5 6 4\nf 1 2 3 4\n"), (std::vector<std::uint32_t>{0, 0, 0, 3, 3}));
}

TEST_F(ObjFaces, CornersAreUniqueInOrderOfFirstUse) {
    const Scene s = load(
        square +
        "vt 0 0\nvt 0.25 0.75\nvn 0 0 2\nvn 0 0 -1\nf 3/1/1 1/1/1 2/1/1\nf 3/1/1 2/2/1 1/1/2\nf 3/1/1 1/1/1 4/1/1\n");
    const Mesh& m = s.meshes.at(0);
    ASSERT_EQ(m.positions.size(), 6u);
    EXPECT_EQ(m.positions[0], (vec3{1, 1, 0}));
    EXPECT_EQ(m.positions[1], (vec3{0, 0, 0}));
    EXPECT_EQ(m.normals[0], (vec3{0, 0, 1}));               // made unit
    EXPECT_EQ(m.texcoords.at(0)[3], (vec2{0.25f, 0.25f}));  // v down
    const std::vector<std::uint32_t> expected{0, 1, 2, 0, 3, 4, 0, 1, 5};
    EXPECT_EQ(std::vector<std::uint32_t>(m.indices.begin(), m.indices.end()), expected);
}

TEST_F(ObjFaces, NegativeIndicesCountFromTheLinesSoFarAndPositiveOnesMayPointForward) {
    const Scene s = load("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 5 5\nf 2 3 6\nv 6 6 6\n");
    const Mesh& m = s.meshes.at(0);
    EXPECT_EQ(m.positions[m.indices[0]], (vec3{0, 0, 0}));
    EXPECT_EQ(m.positions[m.indices[2]], (vec3{1, 1, 0}));
    EXPECT_EQ(m.positions[m.indices[5]], (vec3{6, 6, 6}));
}

TEST_F(ObjFaces, FacesWithBadVertexIndicesAreSkippedWithTheirLine) {
    const Scene s = load(square +
                         "f 0 1 2\nf 1 2 5\nf -5 1 2\nf 1 2 99999999999999999999\nf 1 2\nf 1 x 2\nf "
                         "-9223372036854775808 1 2\nf 1 2 3\n");
    EXPECT_EQ(triangles(s), 1u);
    ASSERT_TRUE(remark("index of 0 or out of range"));
    EXPECT_EQ(remark("index of 0 or out of range")->place, "line 5");
    EXPECT_NE(remark("index of 0 or out of range")->message.find("(4 times)"), std::string::npos);
    EXPECT_EQ(remark("fewer than 3")->place, "line 9");
    EXPECT_EQ(remark("cannot be read")->place, "line 8");
    for (const ReportEntry& e : remarks()) EXPECT_EQ(e.remark, Remark::warning);
}

TEST_F(ObjFaces, ABadTexcoordOrNormalIndexLeavesTheFace) {
    const Scene s = load(square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/9/1 3/1/0\n");
    EXPECT_EQ(triangles(s), 1u);
    EXPECT_TRUE(s.meshes.at(0).normals.empty());
    EXPECT_EQ(remark("texture coordinate index")->place, "line 7");
    EXPECT_EQ(remark("normal index")->place, "line 7");
    EXPECT_EQ(remark("only a part of a mesh has texture coordinates")->remark, Remark::changed);
}

TEST_F(ObjFaces, FilesWithNothingToDrawAreRefused) {
    EXPECT_NE(error_of("").find("nothing to draw"), std::string::npos);
    EXPECT_NE(error_of(square).find("nothing to draw"), std::string::npos);
    EXPECT_NE(error_of(square + "f 1\nf 1 2\nf 7 8 9\n").find("nothing to draw"), std::string::npos);
    EXPECT_NE(error_of("v nan 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n").find("nothing to draw"), std::string::npos);
    EXPECT_NE(error_of("v 0 0 0\n").find("model.obj"), std::string::npos);
    EXPECT_NE(error_of(std::string("\xFF\xFEv\0 \0", 6)).find("nothing to draw"), std::string::npos) << "UTF-16";
}

TEST_F(ObjFaces, TextInUtf16IsReadAndSaid) {
    std::string wide = "\xFF\xFE";
    for (const char c : square + "f 1 2 3 4\n") wide += {c, '\0'};
    const Scene s = load(wide);
    EXPECT_EQ(s.meshes.at(0).indices.size(), 6u);
    EXPECT_TRUE(remark("UTF-16"));
}

TEST_F(ObjFaces, VerticesWithColorsAndWithoutFacesArePoints) {
    const Scene s = load("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv nan 0 0 0 0 1\n");
    ASSERT_EQ(s.meshes.size(), 1u);
    EXPECT_EQ(s.meshes[0].topology, Topology::points);
    EXPECT_EQ(s.meshes[0].indices.size(), 2u);
    EXPECT_EQ(s.meshes[0].colors[1], (vec4{0, 1, 0, 1}));
    EXPECT_TRUE(s.meshes[0].normals.empty());
    const Scene scan = load("vn 0 0 1\nv 0 0 0\nvn 0 1 0\nv 1 0 0\n");
    ASSERT_EQ(scan.meshes.at(0).normals.size(), 2u);
    EXPECT_EQ(scan.meshes[0].normals[1], (vec3{0, 1, 0}));
}

TEST_F(ObjFaces, ObjectsBeginAtOAndGroupsCountOnlyWithoutO) {
    const Scene s = load(square + "g x\nf 1 2 3\no a\ng y\nf 1 2 3\ng z\nf 1 3 4\no  b c \no empty\no a\nf 1 2 3\n");
    ASSERT_EQ(s.nodes.size(), 3u);  // before the first o, a, the second a
    EXPECT_EQ(s.nodes[0].name, "model");
    EXPECT_EQ(s.nodes[1].name, "a");
    EXPECT_EQ(s.nodes[2].name, "a");
    EXPECT_EQ(s.meshes[s.nodes[1].meshes.at(0)].triangle_count(), 2u);
}

TEST_F(ObjFaces, AGroupThatComesAgainGoesOnWithItsObject) {
    const Scene s = load(square + "g front cube\nf 1 2 3\ng b\nf 1 2 3\ng front   cube\nf 1 3 4\ng\nf 1 2 4\n");
    ASSERT_EQ(s.nodes.size(), 3u);
    EXPECT_EQ(s.nodes[0].name, "front cube");
    EXPECT_EQ(s.nodes[2].name, "");
    EXPECT_EQ(s.meshes[0].triangle_count(), 2u);
}

TEST_F(ObjFaces, UsemtlOnlyStartsAMeshAndComesBackToIt) {
    const Scene s = load(square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl a\nf 1 2 4\no next\nf 1 2 3\n");
    ASSERT_EQ(s.nodes.size(), 2u);
    EXPECT_EQ(s.nodes[0].meshes.size(), 2u);
    EXPECT_EQ(s.meshes[0].triangle_count(), 2u);
    EXPECT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.meshes[2].material, s.meshes[0].material);  // usemtl holds on across o
}

TEST_F(ObjFaces, SmoothingGroupsAreKeptForEachTriangle) {
    const Scene s = load(square + "f 1 2 3\ns 3\nf 1 2 3 4\ns off\nf 1 2 4\ns x\nf 1 2 4\n");
    const Mesh& m = s.meshes.at(0);
    EXPECT_EQ(m.smoothing_kind, SmoothingKind::numbers);
    const std::vector<std::uint32_t> expected{0, 3, 3, 0, 0};
    EXPECT_EQ(std::vector<std::uint32_t>(m.smoothing.begin(), m.smoothing.end()), expected);
    EXPECT_EQ(remark("smoothing group")->place, "line 10");
}

TEST_F(ObjFaces, FacesWithoutNormalsBecomeAMeshOfTheirOwn) {
    const Scene s = load(square + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 4\nf 1//9 3//1 4//1\nf 1//1 2 3//1\n");
    ASSERT_EQ(s.meshes.size(), 2u);
    EXPECT_EQ(s.nodes.size(), 1u);
    EXPECT_EQ(s.meshes[0].triangle_count(), 1u);
    EXPECT_EQ(s.meshes[1].triangle_count(), 3u);
    EXPECT_FALSE(s.meshes[0].normals.empty());
    EXPECT_TRUE(s.meshes[1].normals.empty());
    EXPECT_EQ(remark("only some faces")->remark, Remark::changed);
}

TEST_F(ObjFaces, OnlyCornersWithAZeroOrNonFiniteNormalHaveNone) {
    for (const char* none : {"0 0 0", "nan 0 0", "0 inf 0", "1e39 0 0", "1 0"}) {
        const Scene s = load(square + "vn 0 0 1\nvn " + none + "\nf 1//1 2//1 3//2\nf 1//1 3//1 4//1\n");
        ASSERT_EQ(s.meshes.size(), 1u) << none;
        const std::vector<vec3> normals(s.meshes[0].normals.begin(), s.meshes[0].normals.end());
        EXPECT_EQ(normals, (std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {}, {0, 0, 1}, {0, 0, 1}})) << none;
        EXPECT_EQ(remark("a normal has zero length")->place, "line 6") << none;
    }
}

TEST_F(ObjFaces, NumbersThatCannotBeReadAreNaNAndReported) {
    const Scene s = load(square + "v 1,5 0 0\nv nan 0 0\nv 1e39 0 0\nv 1\nvt nan 3\nf 1/1 2/1 3/1\nf 5 6 7\nf 8 2 3\n");
    EXPECT_EQ(triangles(s), 3u);
    EXPECT_EQ(remark("a number cannot be read")->place, "line 5");
    EXPECT_EQ(remark("not finite or too large")->place, "line 5");
    EXPECT_EQ(remark("too few numbers")->place, "line 8");
    EXPECT_EQ(remark("texture coordinate is not finite")->place, "line 9");
    EXPECT_EQ(s.meshes[0].texcoords.at(0)[0], (vec2{0, 0}));
    EXPECT_TRUE(std::isnan(s.meshes[0].positions[3].x));
}

TEST_F(ObjFaces, VertexColorsBecomeLinear) {
    const Scene s = load("v 0 0 0 0.5 0 1\nv 1 0 0 0.5 0.5 0.5 0.25\nv 1 1 0\nf 1 2 3\n");
    const Mesh& m = s.meshes.at(0);
    ASSERT_EQ(m.colors.size(), 3u);
    EXPECT_EQ(m.colors[0], (vec4{linear_from_srgb(0.5f), 0, 1, 1}));
    EXPECT_EQ(m.colors[1].w, 0.25f);
    EXPECT_EQ(m.colors[2], (vec4{1, 1, 1, 1}));
}

TEST_F(ObjFaces, VertexColorsOverOneAreBytes) {
    const Scene s = load("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 1 1 0 1 nan 1\nf 1 2 3\n");
    EXPECT_EQ(s.meshes.at(0).colors[0], (vec4{1, 0, linear_from_srgb(51.0f * (1.0f / 255)), 1}));
    EXPECT_EQ(remark("0..255")->remark, Remark::guessed);
    EXPECT_TRUE(remark("vertex color is not finite"));
}

TEST_F(ObjFaces, WeightsAreDroppedWithARemark) {
    load("v 0 0 0 1\nv 1 0 0 1.0\nv 1 1 0 2\nf 1 2 3\n");
    EXPECT_EQ(remark("weight")->place, "line 3");
    EXPECT_EQ(remarks().size(), 1u);
}

TEST_F(ObjFaces, LinesAndPointsAreMeshesOfTheirOwn) {
    const Scene s = load(square + "l 1 2 3\np 1 4\nf 1 2 3\nl 1\nl 1 9\n");
    ASSERT_EQ(s.meshes.size(), 3u);
    EXPECT_EQ(s.nodes.size(), 1u);
    EXPECT_EQ(s.meshes[0].topology, Topology::lines);
    EXPECT_EQ(s.meshes[0].indices.size(), 4u);
    EXPECT_EQ(s.meshes[1].topology, Topology::points);
    EXPECT_EQ(s.meshes[1].indices.size(), 2u);
    EXPECT_TRUE(remark("line or point element"));
    EXPECT_TRUE(remark("out of range"));
    EXPECT_NO_THROW(validate(s));
}

TEST_F(ObjFaces, FreeFormGeometryIsDroppedWithOneRemark) {
    load(square + "f 1 2 3\ncstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nlod 3\nwhat is this\n");
    EXPECT_EQ(remark("free-form")->remark, Remark::dropped);
    EXPECT_EQ(remark("free-form")->place, "line 6");
    EXPECT_EQ(remark("display and rendering")->remark, Remark::note);
    EXPECT_EQ(remark("unknown keyword")->place, "line 12");
    EXPECT_EQ(remarks().size(), 3u);
}

TEST_F(ObjFaces, OldMacLinesAndNulBytesLoadWithAWarning) {
    EXPECT_EQ(triangles(load("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r")), 1u);
    EXPECT_EQ(remark("CR alone")->remark, Remark::warning);
    EXPECT_EQ(triangles(load(std::string("v 0 0 0\n\0v 1 0 0\nv 0 1 0\nf 1 2 3\n", 33))), 1u);
    EXPECT_EQ(remark("NUL")->place, "line 2");
}

TEST_F(ObjFaces, NumbersThatFloatHoldsNeedNoOrigin) {
    const Scene s = load("v 500000 0 0\nv 500001 0 0\nv 500000 1 0\nf 1 2 3\n");
    EXPECT_EQ(s.meshes.at(0).origin, (dvec3{0, 0, 0}));
    EXPECT_EQ(load("v 0.1 0.7 0.3\nv 0.3 0.2 0.9\nv 0.11 0.12 0.13\nf 1 2 3\n").meshes.at(0).origin, (dvec3{0, 0, 0}));
}

TEST_F(ObjFaces, LargeCoordinatesCountFromOneOriginForTheWholeFile) {
    const Scene s = load(
        "v 500000.123 4000000.456 7.1\nv 500001.123 4000000.456 7.1\nv 500000.123 4000001.789 7.1\nv 500002.5 "
        "4000002.5 8\n"
        "v 0 0 0\no a\nf 1 2 3\no b\nf 1 3 4\n");
    ASSERT_EQ(s.meshes.size(), 2u);
    const Mesh &a = s.meshes[0], &b = s.meshes[1];
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.positions[0], b.positions[0]);
    EXPECT_EQ(a.positions[2], b.positions[1]);
    EXPECT_NEAR(a.origin.x + double(a.positions[0].x), 500000.123, 2e-7);
    EXPECT_NEAR(a.origin.y + double(a.positions[2].y), 4000001.789, 2e-7);
    EXPECT_LT(std::abs(a.positions[0].x), 4);
    EXPECT_EQ(std::floor(a.origin.y * 4), a.origin.y * 4);
}

TEST_F(ObjFaces, TwentyThousandObjectsOfOneNameEach) {
    std::string text = square;
    for (int i = 0; i < 20'000; ++i) text += "o p" + std::to_string(i) + "\nf 1 2 3\n";
    const Scene s = load(text);
    EXPECT_EQ(s.nodes.size(), 20'000u);
    EXPECT_EQ(s.meshes.size(), 20'000u);
}

TEST_F(ObjFaces, MaterialChangesByTheThousandStayInTwoMeshes) {
    std::string text = square;
    for (int i = 0; i < 50'000; ++i) text += i % 2 ? "usemtl a\nf 1 2 3\n" : "usemtl b\nf 1 3 4\n";
    EXPECT_EQ(load(text).meshes.size(), 2u);
}

TEST_F(ObjFaces, ALongNameCountsForEachMeshThatHasIt) {
    std::string materials, text = "mtllib m.mtl\no " + std::string(1 << 20, 'n') + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 3000; ++i) {
        materials += "newmtl m" + std::to_string(i) + "\n";
        text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    }
    write("m.mtl", materials);
    EXPECT_NE(error_of(text).find("more than the limit"), std::string::npos);
}

TEST_F(ObjFaces, MemoryIsChargedBeforeItIsAskedFor) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) text += "v 0 1 2\n";
    const std::string path = write("big.obj", text + "f 1 2 3\n");
    Context small({.max_memory = 100'000});
    EXPECT_THROW(obj_reader.read(path, {}, small), Error);
    Context large({.max_memory = 4'000'000});
    EXPECT_NO_THROW(obj_reader.read(path, {}, large));
}

/// Finalizer of SplitMix64: a good hash that everybody can compute.
std::uint64_t splitmix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

TEST_F(ObjFaces, CornersMadeToMeetInOneSlotDoNot) {
    std::vector<obj::Corner> corners;
    for (std::uint32_t p = 0; corners.size() < 1000; ++p)
        for (std::uint32_t t = 0; t < 1000; ++t)
            if ((splitmix(splitmix((std::uint64_t(p) << 32 | t) + 0x9E3779B97F4A7C15u) + 7) & 0xfff) == 0)
                corners.push_back({p, t, 7});
    for (const HashKey key : {hash_key_of_this_run(), HashKey{0x243f6a8885a308d3u, 0x13198a2e03707344u}}) {
        std::set<std::uint64_t> slots;
        for (const obj::Corner& c : corners) slots.insert(obj::hash_of(c, key) & 0xfff);
        // 1000 balls in 4096 bins: 4096 (1 - e^(-1000/4096)) = 887 of them are hit, with a deviation of about 10.
        EXPECT_GT(slots.size(), 800u);
    }
    obj::UniqueTable<obj::Corner> table;  // in its 2048 slots all would meet in the first
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(table.number_of(corners[i]), i);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(table.number_of(corners[i]), i);
    EXPECT_LT(table.longest_run(), 200u);
    table.clear();
    EXPECT_EQ(table.longest_run(), 0u);
    EXPECT_EQ(table.number_of(corners[999]), 0u);
    table.clear();  // few keys in many slots
    EXPECT_EQ(table.longest_run(), 0u);
    EXPECT_EQ(table.number_of(corners[5]), 0u);
}

TEST_F(ObjFaces, ACancelledRunStops) {
    std::string text(200'000, '\n');
    const std::string path = write("long.obj", text);
    Context context;
    context.cancel();
    try {
        obj_reader.read(path, {}, context);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::failed);
    }
}

}  // namespace
}  // namespace rakelight::io
