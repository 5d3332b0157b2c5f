// SPDX-License-Identifier: Apache-2.0
// GLB containers, the JSON text, required extensions and buffers of glTF.
#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using namespace test;

std::string read_error(const std::string& bytes, const char* name = "model.glb") {
    const TemporaryFolder folder;
    Context context({.threads = 1});
    try {
        io::gltf_reader.read(folder.write(name, bytes), {}, context);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string chunk(const char* type, std::string body) {
    const auto size = std::uint32_t(body.size());
    return std::string(reinterpret_cast<const char*>(&size), 4) + std::string(type, 4) + body;
}

std::string glb(const std::string& chunks, int extra = 0) {
    const std::uint32_t version = 2, length = std::uint32_t(12 + int(chunks.size()) + extra);
    return "glTF" + std::string(reinterpret_cast<const char*>(&version), 4) +
           std::string(reinterpret_cast<const char*>(&length), 4) + chunks;
}

TEST(GltfContainer, ABinaryChunkIsTheFirstBuffer) {
    GltfFile file;
    file.triangle();
    file.root["buffers"] = {{{"byteLength", 36}}};
    const std::string whole =
        glb(chunk("JSON", file.root.dump()) + chunk("more", "?") + chunk(std::string("BIN\0", 4).c_str(), file.data));
    EXPECT_EQ(read_error(whole), "");
    for (std::size_t size = 0; size < whole.size(); size += 7) EXPECT_NE(read_error(whole.substr(0, size)), "") << size;
    file.root["buffers"][0]["byteLength"] = 37;
    EXPECT_NE(read_error(glb(chunk("JSON", file.root.dump()) + chunk(std::string("BIN\0", 4).c_str(), file.data)))
                  .find("byteLength says 37"),
              std::string::npos);
}

TEST(GltfContainer, LengthsAreHeldAgainstTheFile) {
    EXPECT_NE(read_error(glb(chunk("JSON", "{}"), 1)).find("cut short"), std::string::npos);
    EXPECT_NE(read_error(glb(chunk("JSON", "{}      "), -4)).find("GLB chunk 0: needs"), std::string::npos);
    EXPECT_NE(read_error(glb("")).find("too few"), std::string::npos);
    EXPECT_NE(read_error(""), "");
}

TEST(GltfJson, DeepNestingIsRefusedAtOnce) {
    for (const char* open : {"[", "{\"a\":"}) {
        std::string text = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
        for (int i = 0; i < 200000; ++i) text += open;
        EXPECT_NE(read_error(text, "deep.gltf").find("nested more than"), std::string::npos);
    }
}

TEST(GltfJson, WhatIsNoJsonIsRefused) {
    for (const char* text : {"{", "{}{}", "{\"a\":NaN}", "{\"a\":1e400}", "{\"a\":01}", "{\"a\":\"\xFF\"}",
                             "{\"a\":1,}", "[]", "null", " "})
        EXPECT_NE(read_error(text, "bad.gltf"), "") << text;
}

TEST(GltfJson, ANameThatStandsTwiceIsSaidAndTheLastCounts) {
    GltfFile file;
    file.triangle();
    const TemporaryFolder folder;
    std::string text = file.text();
    text.insert(1, "\"scene\": 5, ");
    folder.write("data.bin", file.data);
    Context context({.threads = 1});
    EXPECT_EQ(io::gltf_reader.read(folder.write("model.gltf", text), {}, context).nodes.size(), 1u);
    EXPECT_TRUE(is_said(context, Remark::warning, "occurs twice"));
}

TEST(GltfJson, RequiredExtensionsThatAreUnknownAreNamed) {
    GltfFile file;
    file.triangle();
    file.root["extensionsRequired"] = {"VENDOR_new"};
    EXPECT_NE(file.refusal().find("VENDOR_new"), std::string::npos);
    file.root.erase("extensionsRequired");
    file.root["extensionsUsed"] = {"VENDOR_new"};
    Context context({.threads = 1});
    file.load(context);
    EXPECT_TRUE(is_said(context, Remark::dropped, "VENDOR_new"));
}

TEST(GltfJson, RequiredExtensionsOfHowThingsLookAreLeftOutWithOneWarning) {
    for (const char* name :
         {"VENDOR_materials_glitter", "KHR_texture_basisu", "KHR_node_visibility", "EXT_lights_ies"}) {
        GltfFile file;
        file.triangle();
        file.root["extensionsUsed"] = file.root["extensionsRequired"] = {name};
        Context context({.threads = 1});
        EXPECT_EQ(file.load(context).meshes.size(), 1u);
        EXPECT_TRUE(is_said(context, Remark::warning, name));
        EXPECT_FALSE(is_said(context, Remark::dropped, name)) << "said once";
    }
    for (const char* name : {"KHR_mesh_new", "VENDOR_compression", "materials"}) {
        GltfFile file;
        file.triangle();
        file.root["extensionsRequired"] = {name};
        EXPECT_NE(file.refusal().find(name), std::string::npos) << "data";
    }
}

TEST(GltfBuffers, BrokenReferencesAreRefused) {
    for (const char* uri :
         {"../data.bin", "/etc/passwd", "http://example.org/a.bin", "", "data:;base64,@", "data:;base64"}) {
        GltfFile file;
        file.triangle();
        file.root["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        const TemporaryFolder folder;
        const std::string path = folder.write("model.gltf", file.root.dump());
        Context context({.threads = 1});
        EXPECT_THROW(io::gltf_reader.read(path, {}, context), Error) << uri;
    }
}

}  // namespace
}  // namespace rakelight
