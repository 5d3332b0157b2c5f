// SPDX-License-Identifier: Apache-2.0
#include "io/reader.h"

#include <sys/stat.h>

#include <string>

#include "io/content_kind.h"
#include "support/shared.h"
#include "unit/io/obj/obj_fixture.h"

namespace rakelight::io {
namespace {

using namespace std::string_literals;

class Reader : public obj_test::ObjFolder {
protected:
    /// The error of loading a file of this name and content.
    std::string refusal(const std::string& name, const std::string& content) {
        return refusal_of(write(name, content));
    }
    std::string refusal_of(const std::string& path, ErrorCode code = ErrorCode::bad_file) {
        Context context;
        try {
            read_scene(path, {}, context);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), code) << e.what();
            EXPECT_NE(std::string(e.what()).find(std::filesystem::path(path).filename().string()), std::string::npos);
            return e.what();
        }
        ADD_FAILURE() << path << " was read";
        return {};
    }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string triangle_gltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

TEST_F(Reader, EndingsSayTheFormatInAnyCase) {
    Context context;
    EXPECT_EQ(read_scene(write("a.obj", triangle), {}, context).meshes.size(), 1u);
    EXPECT_EQ(read_scene(write("b.OBJ", triangle), {}, context).meshes.size(), 1u);
    EXPECT_EQ(read_scene(write("c.gltf", triangle_gltf), {}, context).meshes.size(), 1u);
    EXPECT_TRUE(context.report().entries().empty());
}

TEST_F(Reader, FilesWithoutAKnownEndingAreReadByTheirContent) {
    Context context;
    EXPECT_EQ(read_scene(write("model", triangle_gltf), {}, context).meshes.size(), 1u);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].remark, Remark::guessed);
    EXPECT_TRUE(has(refusal("model.abc", triangle), ".abc"));
    EXPECT_TRUE(has(refusal("model.abc", triangle), "supported: glTF 2.0, GLB, OBJ"));
    EXPECT_TRUE(has(refusal("model", triangle), "no ending"));
    EXPECT_TRUE(has(refusal(".obj", triangle), "no ending"));
}

TEST_F(Reader, ContentOfAnotherFormatIsRefused) {
    EXPECT_TRUE(has(refusal("a.glb", "\xFF\xD8\xFF\xE0 rest of a picture"), "JPEG picture, not GLB"));
    EXPECT_TRUE(has(refusal("a.obj", "\x89PNG\r\n\x1A\n"), "PNG picture, not OBJ"));
    EXPECT_TRUE(has(refusal("b.obj", "Kaydara FBX Binary  \0\x1A\0"s), "give it the ending .fbx"));
    EXPECT_TRUE(has(refusal("c.obj", "glTF\2\0\0\0"s), "GLB, not OBJ"));
    EXPECT_TRUE(has(refusal("d.gltf", "PK\3\4"), "ZIP archive"));
}

TEST_F(Reader, MaxFilesAreRefusedByNameWithAdvice) {
    const std::string ole = "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1 the rest";
    for (const std::string& text : {refusal("a.max", ole), refusal("b.MAX", "anything"), refusal("c", ole)}) {
        EXPECT_TRUE(has(text, ".max")) << text;
        EXPECT_TRUE(has(text, "export FBX or glTF")) << text;
    }
    EXPECT_TRUE(has(refusal("c.obj", ole), "3ds Max"));
}

TEST_F(Reader, EmptyFilesOfEveryFormatAreRefused) {
    for (const char* ending :
         {"obj", "glb", "gltf", "fbx", "dae", "3ds", "ase", "blend", "stl", "ply", "off", "x", "xyz", "pts"})
        EXPECT_TRUE(has(refusal("empty."s + ending, ""), "empty")) << ending;
}

TEST_F(Reader, WhatIsNoFileIsNotFound) {
    EXPECT_TRUE(has(refusal_of((folder_ / "gone.obj").string(), ErrorCode::not_found), "gone.obj"));
    EXPECT_TRUE(has(refusal_of((folder_ / "gone.max").string(), ErrorCode::not_found), "gone.max"));
    std::filesystem::create_directory(folder_ / "directory.glb");
    refusal_of((folder_ / "directory.glb").string(), ErrorCode::not_found);
    ASSERT_EQ(::mkfifo((folder_ / "pipe.gltf").c_str(), 0600), 0);  // without a writer: open() would wait for ever
    refusal_of((folder_ / "pipe.gltf").string(), ErrorCode::not_found);
}

TEST_F(Reader, ErrorsOfTheFormatCarryTheFile) {
    EXPECT_TRUE(has(refusal("v.obj", "v 0 0 0\n"), "v.obj: nothing to draw"));
}

TEST_F(Reader, ContentKindsNeedTheirWholeSignature) {
    const auto kind = [](const std::string& text) {
        return content_kind(std::as_bytes(std::span(text.data(), text.size())));
    };
    EXPECT_EQ(kind("").name, "");
    EXPECT_EQ(kind("glT").name, "");
    EXPECT_EQ(kind("glTF").ending, "glb");
    EXPECT_EQ(kind("RIFF1234WEBPVP8 ").name, "WebP picture");
    EXPECT_EQ(kind("RIFF").name, "");
    EXPECT_EQ(kind("\xEF\xBB\xBF \n{").ending, "gltf");
    EXPECT_EQ(kind("  <?xml version").ending, "dae");
    EXPECT_EQ(kind("\xFF\xFE*\0003\0D\0S\0M\0"s).ending, "ase");
    EXPECT_FALSE(kind("solid cube").is_certain);
    EXPECT_EQ(kind(" \t\n").name, "");
}

TEST_F(Reader, TheListOfFormatsNamesThemAll) { EXPECT_EQ(supported_formats().substr(0, 18), "glTF 2.0, GLB, OBJ"); }

TEST_F(Reader, HostileFilesOfTheWrongFormatAreRefused) {
    RL_NEEDS_SHARED("hostile");
    for (const char* name :
         {"garbage/jpeg_called.glb", "garbage/random.obj", "empty/empty.obj", "empty/empty.glb", "empty/empty.gltf"})
        refusal_of((rakelight::test::shared_dir() / "hostile" / name).string());
}

}  // namespace
}  // namespace rakelight::io
