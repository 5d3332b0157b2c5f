// SPDX-License-Identifier: Apache-2.0
// Accessors, primitive modes and vertex attributes of glTF.
#include <cmath>
#include <limits>

#include "io/gltf/elements.h"
#include "io/gltf/topology.h"
#include "support/scene_builder.h"
#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using io::gltf::expand;
using io::gltf::PrimitiveMode;
using test::GltfFile;
using namespace test;
using Indices = std::vector<std::uint32_t>;

TEST(GltfTopology, StripsKeepTheWindingOfTheirFirstTriangle) {
    EXPECT_EQ(expand(PrimitiveMode::triangle_strip, {0, 1, 2, 3, 4}).indices, (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(GltfTopology, FansTurnAboutTheirFirstVertex) {
    EXPECT_EQ(expand(PrimitiveMode::triangle_fan, {0, 1, 2, 3}).indices, (Indices{1, 2, 0, 2, 3, 0}));
}

TEST(GltfTopology, LoopsAndStripsOfLinesBecomePairs) {
    EXPECT_EQ(expand(PrimitiveMode::line_strip, {4, 5, 6}).indices, (Indices{4, 5, 5, 6}));
    EXPECT_EQ(expand(PrimitiveMode::line_loop, {4, 5, 6}).indices, (Indices{4, 5, 5, 6, 6, 4}));
}

TEST(GltfTopology, CornersThatAreLeftOverAreCounted) {
    EXPECT_EQ(expand(PrimitiveMode::triangles, {0, 1, 2, 3, 4}).left_over, 2u);
    EXPECT_EQ(expand(PrimitiveMode::triangles, {0, 1, 2, 3, 4}).indices, (Indices{0, 1, 2}));
    EXPECT_EQ(expand(PrimitiveMode::lines, {0, 1, 2}).indices, (Indices{0, 1}));
}

TEST(GltfTopology, TooFewCornersGiveNothing) {
    for (int mode = 0; mode <= 6; ++mode) {
        EXPECT_TRUE(expand(PrimitiveMode(mode), {}).indices.empty()) << mode;
        EXPECT_EQ(expand(PrimitiveMode(mode), {0}).indices.size(), mode == 0 ? 1u : 0u) << mode;
        for (std::uint64_t corners = 0; corners < 9; ++corners)
            EXPECT_EQ(expand(PrimitiveMode(mode), Indices(corners)).indices.size(),
                      io::gltf::expanded_size(PrimitiveMode(mode), corners))
                << mode;
    }
}

template <class T>
std::vector<float> scalars(std::vector<T> values, io::gltf::ComponentType type, bool normalized) {
    io::gltf::Elements e;
    e.data = reinterpret_cast<const std::byte*>(values.data());
    e.count = values.size();
    e.stride = sizeof(T);
    e.type = type;
    e.normalized = normalized;
    return io::gltf::to_scalars(e);
}

TEST(GltfElements, NormalizedIntegersAreFractionsOfTheLargest) {
    using io::gltf::ComponentType;
    EXPECT_EQ(scalars<std::uint8_t>({0, 51, 255}, ComponentType::u8, true), (std::vector<float>{0, 0.2f, 1}));
    EXPECT_EQ(scalars<std::int8_t>({-128, -127, 0, 127}, ComponentType::i8, true), (std::vector<float>{-1, -1, 0, 1}));
    EXPECT_EQ(scalars<std::uint16_t>({0, 65535}, ComponentType::u16, true), (std::vector<float>{0, 1}));
    EXPECT_EQ(scalars<std::int16_t>({-32768, 32767}, ComponentType::i16, true), (std::vector<float>{-1, 1}));
    EXPECT_EQ(scalars<std::int16_t>({-5, 7}, ComponentType::i16, false), (std::vector<float>{-5, 7}));
}

TEST(GltfElements, ZeroElementsAreFine) {
    EXPECT_TRUE(scalars<float>({}, io::gltf::ComponentType::f32, false).empty());
}

TEST(GltfGeometry, PositionsKeepTheirBitsAndTheOriginIsZero) {
    GltfFile file;
    const float odd = std::nextafter(1.0f, 2.0f), huge = 12345678.9f;
    file.primitive(file.accessor<float>({odd, huge, -0.0f, 1, 0, 0, 0, 1, 0}, f32, 3));
    const Scene scene = file.load();
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].origin, (dvec3{0, 0, 0}));
    EXPECT_EQ(scene.meshes[0].positions[0].x, odd);
    EXPECT_EQ(scene.meshes[0].positions[0].y, huge);
    EXPECT_TRUE(std::signbit(scene.meshes[0].positions[0].z));
    EXPECT_EQ(to_vector(scene.meshes[0].indices), (Indices{0, 1, 2}));
}

TEST(GltfGeometry, AttributesMayLieInterleaved) {
    GltfFile file;
    const int view = file.view<float>({0, 0, 0, 9, 9, 1, 0, 0, 8, 8, 0, 1, 0, 7, 7});
    file.root["bufferViews"][view]["byteStride"] = 20;
    file.root["accessors"] = {
        {{"bufferView", view}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}},
        {{"bufferView", view}, {"byteOffset", 12}, {"componentType", f32}, {"count", 3}, {"type", "VEC2"}}};
    file.primitive(0)["attributes"]["TEXCOORD_0"] = 1;
    const Scene scene = file.load();
    EXPECT_EQ(scene.meshes[0].positions[2], (vec3{0, 1, 0}));
    ASSERT_EQ(scene.meshes[0].texcoords.size(), 1u);
    EXPECT_EQ(scene.meshes[0].texcoords[0][1], (vec2{8, 8}));
}

TEST(GltfGeometry, TheLastElementNeedsNoPaddingButMustFit) {
    GltfFile file;
    const int view = file.view<float>({0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0});
    file.root["bufferViews"][view]["byteStride"] = 16;
    file.root["accessors"] = {{{"bufferView", view}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}}};
    file.primitive(0);
    EXPECT_EQ(file.load().meshes[0].positions[2], (vec3{0, 1, 0}));
    file.root["accessors"][0]["byteOffset"] = 4;
    EXPECT_NE(file.refusal().find("reads past the end"), std::string::npos);
}

TEST(GltfGeometry, CountsThatOverflowAreRefused) {
    for (const double count : {4.0, 357913942.0, 1e9, 4294967296.0, 9007199254740992.0}) {
        GltfFile file;
        file.triangle();
        file.root["accessors"][0]["count"] = count;
        EXPECT_NE(file.refusal().find("reads past the end"), std::string::npos) << count;
        file.root["accessors"][0].erase("bufferView");
        if (count > 1e8) {
            EXPECT_NE(file.refusal().find("too many"), std::string::npos) << count;
        }
    }
}

TEST(GltfGeometry, SparseValuesReplaceTheirElements) {
    GltfFile file;
    file.triangle();
    const int indices = file.view<std::uint16_t>({1, 2}), values = file.view<float>({5, 5, 5, 6, 6, 6});
    file.root["accessors"][0]["sparse"] = {{"count", 2},
                                           {"indices", {{"bufferView", indices}, {"componentType", u16}}},
                                           {"values", {{"bufferView", values}}}};
    const Scene scene = file.load();
    EXPECT_EQ(scene.meshes[0].positions[0], (vec3{0, 0, 0}));
    EXPECT_EQ(scene.meshes[0].positions[1], (vec3{5, 5, 5}));
    EXPECT_EQ(scene.meshes[0].positions[2], (vec3{6, 6, 6}));
    file.root["accessors"][0].erase("bufferView");  // the rest is then zero
    EXPECT_EQ(file.load().meshes[0].positions[1], (vec3{5, 5, 5}));
    EXPECT_EQ(file.load().meshes[0].positions[0], (vec3{0, 0, 0}));
}

TEST(GltfGeometry, SparseIndicesMustAscendAndBeInRange) {
    const std::vector<std::vector<std::uint16_t>> wrong = {{2, 1}, {1, 1}, {1, 3}};
    for (const auto& bad : wrong) {
        GltfFile file;
        file.triangle();
        const int indices = file.view(bad), values = file.view<float>({5, 5, 5, 6, 6, 6});
        file.root["accessors"][0]["sparse"] = {{"count", 2},
                                               {"indices", {{"bufferView", indices}, {"componentType", u16}}},
                                               {"values", {{"bufferView", values}}}};
        EXPECT_NE(file.refusal().find("sparse index"), std::string::npos);
    }
}

TEST(GltfGeometry, IndicesOutOfRangeAndRestartValuesAreRefused) {
    GltfFile file;
    file.triangle()["indices"] = file.accessor<std::uint8_t>({0, 1, 3}, u8, 1);
    EXPECT_NE(file.refusal().find("index 3 at corner 2 exceeds 3 vertices"), std::string::npos);
    GltfFile restart;
    restart.triangle()["indices"] = restart.accessor<std::uint8_t>({0, 1, 2, 255}, u8, 1);
    EXPECT_NE(restart.refusal().find("restart value"), std::string::npos);
}

TEST(GltfGeometry, UnequalCountsAreRefused) {
    GltfFile file;
    file.triangle()["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1}, f32, 3);
    EXPECT_NE(file.refusal().find("NORMAL has 2 elements"), std::string::npos);
}

TEST(GltfGeometry, ColorsBecomeRgbaOfFloats) {
    GltfFile file;
    file.triangle()["attributes"]["COLOR_0"] =
        file.accessor<std::uint8_t>({255, 0, 51, 0, 255, 0, 0, 0, 255}, u8, 3, true);
    EXPECT_EQ(file.load().meshes[0].colors[0], (vec4{1, 0, 0.2f, 1}));
    GltfFile rgba;
    rgba.triangle()["attributes"]["COLOR_0"] =
        rgba.accessor<std::uint16_t>({65535, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, u16, 4, true);
    EXPECT_EQ(rgba.load().meshes[0].colors[0], (vec4{1, 0, 0, 0}));
}

TEST(GltfGeometry, QuantizedPositionsAreReadByValueOrNormalized) {
    GltfFile file;
    file.root["extensionsUsed"] = {"KHR_mesh_quantization"};
    file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    file.primitive(file.accessor<std::int16_t>({100, -200, 0, 1, 0, 0, 0, 1, 0}, i16, 3));
    Context context({.threads = 1});
    EXPECT_EQ(file.load(context).meshes[0].positions[0], (vec3{100, -200, 0}));
    EXPECT_TRUE(context.report().entries().empty());
    file.root["accessors"][0]["normalized"] = true;
    EXPECT_EQ(file.load().meshes[0].positions[1], (vec3{1 / 32767.0f, 0, 0}));
}

TEST(GltfGeometry, QuantizedPositionsTellTheStepBetweenTwoCodes) {
    const auto step = [](int type, bool normalized) {
        GltfFile file;
        file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
        const std::vector<std::uint16_t> words(18, 0);  // enough for each of the types
        const int accessor = file.accessor<std::uint16_t>(words, type, 3, normalized);
        file.root["accessors"][accessor]["count"] = 3;
        file.primitive(accessor);
        return file.load().meshes[0].position_step;
    };
    EXPECT_EQ(step(f32, false), 0);
    for (const auto& [type, largest] : {std::pair(i8, 127.0), {u8, 255.0}, {i16, 32767.0}, {u16, 65535.0}}) {
        EXPECT_EQ(step(type, false), 1) << type;
        EXPECT_EQ(step(type, true), 1 / largest) << type;
    }
}

// quantize() of gltf-transform: 14 bits are 13 and the sign, and the two highest of them are repeated in the lowest.
TEST(GltfGeometry, PositionsOfFewerBitsThanTheirTypeTellTheirOwnStep) {
    const auto step = [](std::vector<std::uint16_t> words) {
        GltfFile file;
        file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
        file.primitive(file.accessor<std::uint16_t>(words, i16, 3, true));
        return file.load().meshes[0].position_step;
    };
    std::vector<std::uint16_t> repeated, plain;
    for (unsigned k = 0; k < 36; ++k) {
        const unsigned number = 227 * k;  // of 13 bits
        const unsigned code = number << 2 | number >> 11;
        repeated.push_back(std::uint16_t(k % 2 ? code : -code));
        plain.push_back(std::uint16_t(code ^ 1));
    }
    EXPECT_EQ(step(repeated), 6 / 32767.0);
    EXPECT_EQ(step(plain), 1 / 32767.0);
    EXPECT_EQ(step({repeated.begin(), repeated.begin() + 9}), 1 / 32767.0) << "so few could be chance";
    repeated[20] ^= 1;
    EXPECT_EQ(step(repeated), 1 / 32767.0) << "one code that is not repeated";
}

TEST(GltfGeometry, TheEightStrongestJointsAreKept) {
    GltfFile file;
    auto& attributes = file.triangle()["attributes"];
    attributes["JOINTS_0"] = file.accessor<std::uint8_t>({1, 2, 3, 4, 9, 0, 0, 0, 7, 0, 0, 0}, u8, 4);
    attributes["WEIGHTS_0"] = file.accessor<float>({0.1f, 0.2f, 0.05f, 0.15f, 1, 0, 0, 0, NAN, 0, 0, 0}, f32, 4);
    attributes["JOINTS_1"] = file.accessor<std::uint16_t>({5, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, u16, 4);
    attributes["WEIGHTS_1"] = file.accessor<float>({0.4f, 0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, f32, 4);
    attributes["JOINTS_2"] = file.accessor<std::uint8_t>({8, 9, 10, 11, 0, 0, 0, 0, 0, 0, 0, 0}, u8, 4);
    attributes["WEIGHTS_2"] = file.accessor<float>({0.3f, 0.25f, 0.01f, 0, 0, 0, 0, 0, 0, 0, 0, 0}, f32, 4);
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    const JointInfluence &first = scene.meshes[0].influences[0], &next = scene.meshes[0].more_influences[0];
    EXPECT_EQ(first.joints, (std::array<std::uint16_t, 4>{5, 8, 9, 2}));
    EXPECT_EQ(next.joints, (std::array<std::uint16_t, 4>{4, 1, 6, 3})) << "of equal ones the lower joint first";
    EXPECT_NEAR(first.weights[0], 0.4 / 1.55, 1e-6);
    EXPECT_EQ(scene.meshes[0].influences[1].weights[0], 1);
    EXPECT_EQ(scene.meshes[0].influences[2].weights, (std::array<float, 4>{}));
    EXPECT_TRUE(is_said(context, Remark::dropped, "more than eight joints"));
    EXPECT_TRUE(is_said(context, Remark::changed, "non-finite joint weights"));
}

TEST(GltfGeometry, JointsWhoseShareVanishesAreNotNamed) {
    GltfFile file;
    auto& attributes = file.triangle()["attributes"];
    attributes["JOINTS_0"] = file.accessor<std::uint16_t>({0, 65535, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, u16, 4);
    attributes["WEIGHTS_0"] = file.accessor<float>({3, 1.4e-45f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, f32, 4);
    const Scene scene = file.load();
    EXPECT_EQ(scene.meshes[0].influences[0].weights[1], 0);
    EXPECT_EQ(scene.meshes[0].influences[0].joints[1], 0) << "else it would have to be there";
}

TEST(GltfGeometry, MorphTargetsAndTheirWeightsAreData) {
    GltfFile file;
    auto& primitive = file.triangle();
    primitive["targets"] = {{{"POSITION", file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3)}}, {{"NORMAL", 0}}};
    file.root["meshes"][0]["weights"] = {0.25, 0.5};
    file.root["meshes"][0]["extras"]["targetNames"] = {"smile", 7};
    const Scene scene = file.load();
    ASSERT_EQ(scene.meshes[0].targets.size(), 2u);
    EXPECT_EQ(scene.meshes[0].targets[0].name, "smile");
    EXPECT_EQ(scene.meshes[0].targets[1].name, "target 1");
    EXPECT_EQ(scene.meshes[0].targets[0].positions[2], (vec3{0, 0, 1}));
    EXPECT_TRUE(scene.meshes[0].targets[0].normals.empty());
    EXPECT_EQ(test::values_of(scene.nodes[0].morph_weights), (std::vector<float>{0.25f, 0.5f}));
    file.root["nodes"][0]["weights"] = {1, 0};
    EXPECT_EQ(test::values_of(file.load().nodes[0].morph_weights), (std::vector<float>{1, 0}));
    file.root["nodes"][0]["weights"] = {1};
    Context context({.threads = 1});
    EXPECT_EQ(test::values_of(file.load(context).nodes[0].morph_weights), (std::vector<float>{0.25f, 0.5f}));
    EXPECT_TRUE(is_said(context, Remark::dropped, "morph weights"));
}

TEST(GltfGeometry, PrimitivesOverOneAccessorShareTheArray) {
    GltfFile file;
    file.triangle();
    file.primitive(0);
    const Scene scene = file.load();
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].positions, scene.meshes[1].positions);
    EXPECT_EQ(scene.nodes[0].meshes, (Indices{0, 1}));
}

TEST(GltfGeometry, ManyPrimitivesOverOneLargeArrayMeetTheBudget) {
    GltfFile file;
    file.primitive(file.accessor(std::vector<float>(3 * 30000), f32, 3));
    for (int i = 0; i < 2000; ++i) file.primitive(0);
    EXPECT_NE(file.refusal().find("more than the limit"), std::string::npos);
}

TEST(GltfGeometry, APrimitiveWithoutPositionsIsLeftOutAndSaid) {
    GltfFile file;
    file.triangle();
    file.root["meshes"][0]["primitives"].push_back({{"attributes", {{"NORMAL", 0}}}});
    Context context({.threads = 1});
    EXPECT_EQ(file.load(context).meshes.size(), 1u);
    EXPECT_TRUE(is_said(context, Remark::dropped, "without POSITION"));
    file.root["meshes"][0]["primitives"].erase(0);
    EXPECT_NE(file.refusal().find("nothing to draw"), std::string::npos);
}

TEST(GltfGeometry, ALongNameCountsForEachMeshThatHasIt) {
    GltfFile file;
    file.triangle();
    for (int i = 0; i < 3000; ++i) file.primitive(0);
    file.root["meshes"][0]["name"] = std::string(1 << 20, 'n');
    EXPECT_NE(file.refusal().find("more than the limit"), std::string::npos);
}

// prepare says these, for every format.
TEST(GltfGeometry, ValuesThatAreNotFiniteStayAsTheyAre) {
    GltfFile file;
    file.triangle()["attributes"]["NORMAL"] = file.accessor<float>({NAN, 0, 1, 0, 0, 0, 0, 0, 1}, f32, 3);
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    EXPECT_TRUE(std::isnan(scene.meshes[0].normals[0].x));
    EXPECT_EQ(scene.meshes[0].normals[1], (vec3{0, 0, 0}));
    EXPECT_TRUE(context.report().entries().empty());
}

}  // namespace
}  // namespace rakelight
