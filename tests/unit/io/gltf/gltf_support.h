// SPDX-License-Identifier: Apache-2.0
// Small glTF files made in a test: JSON as a tree, binary data collected into one buffer, written to a folder of its
// own.
#pragma once
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/model_readers.h"
#include "support/temporary_folder.h"

namespace rakelight::test {

inline constexpr int i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126;

/// A glTF file under construction. Starts with one scene of one node of one mesh without primitives.
struct GltfFile {
    using Json = nlohmann::json;
    Json root =
        Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": []}], "accessors": [], "bufferViews": []})");
    std::string data;

    template <class T>
    int view(const std::vector<T>& values) {
        while (data.size() % 4) data += '\0';
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", values.size() * sizeof(T)}});
        if (!values.empty()) data.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        return int(root["bufferViews"].size()) - 1;
    }

    /// An accessor over a view of its own; `width` components an element.
    template <class T>
    int accessor(const std::vector<T>& values, int component_type, std::size_t width, bool normalized = false) {
        static const char* names[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        root["accessors"].push_back({{"bufferView", view(values)},
                                     {"componentType", component_type},
                                     {"count", values.size() / width},
                                     {"type", width == 16 ? "MAT4" : names[width]},
                                     {"normalized", normalized}});
        return int(root["accessors"].size()) - 1;
    }

    Json& primitive(int position, Json more = Json::object()) {
        more["attributes"]["POSITION"] = position;
        auto& list = root["meshes"][0]["primitives"];
        list.push_back(std::move(more));
        return list.back();
    }

    /// The triangle (0,0,0) (1,0,0) (0,1,0) as the mesh of node 0.
    Json& triangle() { return primitive(accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, 3)); }

    std::string text() {
        if (!data.empty()) root["buffers"][0] = {{"byteLength", data.size()}, {"uri", "data.bin"}};
        return root.dump();
    }

    Scene load(Context& context) {
        const TemporaryFolder folder;
        const std::string json = text();
        folder.write("data.bin", data);
        return io::gltf_reader.read(folder.write("model.gltf", json), {}, context);
    }
    Scene load() {
        Context context({.threads = 1});
        return load(context);
    }
    /// The reason of the refusal; fails the test when there is none.
    std::string refusal() {
        try {
            load();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_file);
            EXPECT_NE(error.file(), "");
            return error.reason();
        }
        ADD_FAILURE() << "was not refused";
        return {};
    }
};

inline bool is_said(Context& context, Remark remark, const std::string& part) {
    for (const ReportEntry& entry : context.report().entries())
        if (entry.remark == remark && entry.message.find(part) != std::string::npos) return true;
    return false;
}

inline std::vector<std::uint32_t> to_vector(const Block<std::uint32_t>& block) { return {block.begin(), block.end()}; }

}  // namespace rakelight::test
