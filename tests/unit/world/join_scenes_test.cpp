// SPDX-License-Identifier: Apache-2.0
// Several models as one scene, and models that lie in memory.
#include <gtest/gtest.h>

#include <rakelight/world/load.h>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "world/join_scenes.h"

namespace rakelight {
namespace {

using test::error_of;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::shared_ptr<const std::vector<std::byte>> bytes_of(std::string_view text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return std::make_shared<const std::vector<std::byte>>(first, first + text.size());
}

class JoinScenes : public testing::Test {
protected:
    test::TemporaryFolder folder;
    Context context;
};

TEST_F(JoinScenes, AllStandInOneSceneInTheirOrder) {
    LoadOptions options;
    options.joined = {"builtin:sphere", folder.write("b.obj", triangle)};
    const Scene scene = load(folder.write("a.obj", triangle), options, context);
    ASSERT_EQ(scene.meshes.size(), 3u);
    EXPECT_EQ(scene.meshes[0].triangle_count(), 1u);
    EXPECT_GT(scene.meshes[1].triangle_count(), 100u);
    EXPECT_EQ(scene.source, folder.file("a.obj"));
}

/// The name gives the up axis, so a file with Z up names only what has Z up in all of it.
TEST_F(JoinScenes, AnStlFileBesideOthersNamesNotTheWhole) {
    const auto source_of = [&](const std::vector<std::string>& files) {
        std::vector<Scene> scenes;
        for (const std::string& file : files) scenes.emplace_back().source = file;
        return join_scenes(scenes, context).source;
    };
    EXPECT_EQ(source_of({"a.stl", "b.stl"}), "a.stl");
    EXPECT_EQ(source_of({"b.obj", "a.stl"}), "b.obj");
    EXPECT_EQ(source_of({"", "b.obj"}), "b.obj");
    EXPECT_EQ(source_of({"a.stl", "b.obj"}), "");
    EXPECT_EQ(source_of({"", "a.stl"}), "") << "shapes have Y up and no file";
}

TEST_F(JoinScenes, AFaultNamesTheFileThatHasIt) {
    LoadOptions options;
    options.joined = {folder.file("gone.obj")};
    const Error error = error_of([&] { load("builtin:plane", options, context); });
    EXPECT_EQ(error.code(), ErrorCode::not_found);
    EXPECT_EQ(error.file(), folder.file("gone.obj"));
}

TEST_F(JoinScenes, MeshesOfAFormatWithFlatFacesSaySo) {
    Scene flat = load("builtin:plane", {}, context), other = flat;
    flat.missing_normals_are_flat = true;
    other.missing_normals_are_flat = false;
    const Scene scene = join_scenes({flat, other}, context);
    ASSERT_EQ(scene.meshes.size(), 2u);
    ASSERT_TRUE(scene.meshes[0].normal_choice.has_value());
    EXPECT_TRUE(scene.meshes[0].normal_choice->missing_are_flat);
    EXPECT_FALSE(scene.meshes[1].normal_choice.has_value());
}

TEST_F(JoinScenes, TheFirstEnvironmentAndTheFirstFogCount) {
    Scene first = load("builtin:plane", {}, context), second = first, third = first;
    second.environment.emplace().intensity = 2;
    third.environment.emplace().intensity = 3;
    third.fog.kind = FogKind::exponential, third.fog.density = 0.5f;
    const Scene scene = join_scenes({first, second, third}, context);
    ASSERT_TRUE(scene.environment.has_value());
    EXPECT_EQ(scene.environment->intensity, 2);
    EXPECT_EQ(scene.fog.kind, FogKind::exponential);
}

TEST_F(JoinScenes, AFileInMemoryIsTakenByItsName) {
    LoadOptions options;
    options.memory_files = {{"piped.obj", bytes_of(triangle)}};
    EXPECT_EQ(load("piped.obj", options, context).meshes.size(), 1u);
    options.joined = {"piped.obj"};
    EXPECT_EQ(load("builtin:plane", options, context).meshes.size(), 2u);
    options.memory_files = {{"piped.obj", bytes_of("f 1 2 3\n")}};
    options.joined.clear();
    EXPECT_EQ(error_of([&] { load("piped.obj", options, context); }).file(), "piped.obj");
}

}  // namespace
}  // namespace rakelight
