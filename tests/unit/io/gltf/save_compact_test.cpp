// SPDX-License-Identifier: Apache-2.0
// Bytes of buffer views that nothing refers to: what goes, what moves, what stays.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "io/gltf/write/save_compact.h"

namespace rakelight::io::gltf {
namespace {

OrderedJson view(std::size_t offset, std::size_t length) {
    return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
}
OrderedJson accessor(std::size_t number) {
    return {{"bufferView", number}, {"componentType", 5126},          {"count", 1},
            {"type", "SCALAR"},     {"min", OrderedJson::array({0})}, {"max", OrderedJson::array({9})}};
}

/// Views of a buffer whose bytes count from 0; accessor i lies in view i, `used` are the attributes of one primitive.
struct File {
    OrderedJson tree;
    std::vector<std::byte> binary;

    File(std::vector<std::pair<std::size_t, std::size_t>> views, const std::vector<std::size_t>& used) {
        tree["accessors"] = OrderedJson::array();
        tree["bufferViews"] = OrderedJson::array();
        std::size_t size = 0;
        for (const auto& [offset, length] : views) {
            tree["accessors"].push_back(accessor(tree["bufferViews"].size()));
            tree["bufferViews"].push_back(view(offset, length));
            size = std::max(size, offset + length);
        }
        OrderedJson attributes = OrderedJson::object();
        for (const std::size_t a : used) attributes["_" + std::to_string(a)] = a;
        OrderedJson primitive = {{"attributes", attributes}};
        OrderedJson mesh = {{"primitives", OrderedJson::array({primitive})}};
        tree["meshes"] = OrderedJson::array({mesh});
        binary.resize(size);
        for (std::size_t i = 0; i < size; ++i) binary[i] = std::byte(i);
    }
    /// The first byte of a view, which is where it lay before.
    std::size_t first_byte(std::size_t v) const {
        return std::size_t(binary[tree["bufferViews"][v].value("byteOffset", std::size_t(0))]);
    }
};

TEST(SaveCompact, DeadBytesGoOffsetsMoveNumbersStay) {
    File file({{0, 8}, {8, 12}, {20, 4}, {24, 8}, {32, 4}}, {0, 2, 4});
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 20u);
    EXPECT_EQ(file.binary.size(), 16u);
    ASSERT_EQ(file.tree["bufferViews"].size(), 5u);
    ASSERT_EQ(file.tree["accessors"].size(), 5u);
    EXPECT_EQ(file.first_byte(0), 0u);
    EXPECT_EQ(file.first_byte(2), 20u);
    EXPECT_EQ(file.first_byte(4), 32u);
    EXPECT_EQ(file.tree["bufferViews"][4], view(12, 4));
    EXPECT_EQ(file.tree["bufferViews"][1], (OrderedJson{{"buffer", 0}, {"byteLength", 1}}));
    EXPECT_FALSE(file.tree["accessors"][1].contains("bufferView"));
    EXPECT_FALSE(file.tree["accessors"][1].contains("max")) << "its elements are zeros now";
    EXPECT_EQ(file.tree["accessors"][2], accessor(2));
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 0u) << "a second time";
}

TEST(SaveCompact, WhatALiveViewCoversStaysAndOffsetsKeepTheirAlignment) {
    File file({{0, 10}, {4, 15}, {16, 4}, {21, 6}, {28, 4}}, {0, 2, 4});
    // Dead alone: bytes 10 to 16 (of which 12 to 16 are whole words), and 21 to 27 (24 to 27: no whole word).
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 4u);
    for (const std::size_t v : {0u, 2u, 4u}) EXPECT_EQ(file.tree["bufferViews"][v]["byteOffset"].get<int>() % 4, 0);
    EXPECT_EQ(file.first_byte(2), 16u);
    EXPECT_EQ(file.first_byte(4), 28u);
}

TEST(SaveCompact, ImagesSparsePartsAndCompressedDataAreUses) {
    File file({{0, 4}, {4, 4}, {8, 4}, {12, 4}}, {0});
    file.tree["images"] = OrderedJson::array();
    file.tree["images"].push_back({{"bufferView", 1}});
    file.tree["accessors"][0]["sparse"] = {{"values", {{"bufferView", 2}}}};
    file.tree["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 3}};
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 0u);
}

TEST(SaveCompact, CompressedViewsAreWhereTheirExtensionSays) {
    File file({{0, 4}, {0, 400}, {4, 8}}, {0, 2});
    file.tree["bufferViews"][1] = {{"buffer", 1}, {"byteLength", 400}, {"byteStride", 4}};
    file.tree["bufferViews"][1]["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0}, {"byteOffset", 12}, {"byteLength", 8}};
    file.tree["bufferViews"][2]["byteOffset"] = 20;
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 8u);
    EXPECT_EQ(file.first_byte(2), 20u);
    EXPECT_FALSE(file.tree["bufferViews"][1].contains("extensions"));
}

TEST(SaveCompact, NothingIsDoneWhereAnExtensionIsNotKnown) {
    const auto file = [] { return File({{0, 8}, {8, 8}}, {0}); };
    File used = file();
    used.tree["extensionsUsed"] = OrderedJson::array({"EXT_structural_metadata"});
    EXPECT_EQ(drop_dead_views(used.tree, used.binary), 0u);
    File unlisted = file();
    unlisted.tree["meshes"][0]["extensions"]["VENDOR_thing"] = {{"view", 1}};
    EXPECT_EQ(drop_dead_views(unlisted.tree, unlisted.binary), 0u);
    File known = file();
    known.tree["extensionsUsed"] = OrderedJson::array({"KHR_materials_ior"});
    EXPECT_EQ(drop_dead_views(known.tree, known.binary), 8u);
}

TEST(SaveCompact, ViewsThatReachPastTheBufferLeaveAllAsItIs) {
    File file({{0, 8}, {8, 8}}, {0});
    file.tree["bufferViews"][1]["byteLength"] = 9;
    const OrderedJson before = file.tree;
    EXPECT_EQ(drop_dead_views(file.tree, file.binary), 0u);
    EXPECT_EQ(file.tree, before);
}

}  // namespace
}  // namespace rakelight::io::gltf
