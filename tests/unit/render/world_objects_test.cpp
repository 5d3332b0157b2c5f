// SPDX-License-Identifier: Apache-2.0
// [[material]] of single objects of a world.
#include <gtest/gtest.h>
#include <rakelight/io/world.h>
#include <rakelight/io/world_words.h>
#include <rakelight/render/picture.h>
#include <rakelight/world/material_changes.h>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

class WorldObjects : public testing::Test {
protected:
    void SetUp() override {
        folder_.write(
            "a.obj",
            "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no left\nf 1 2 3\no right\nf 2 4 3\n");
        folder_.write("m.mtl", "newmtl red\nKd 1 0 0\n");
    }
    Scene load_text(const std::string& text) {
        folder_.write("w.scene.toml", text);
        return load((folder_ / "w.scene.toml").string(), {}, context_);
    }
    /// Base color of the first mesh of a node of that name; the `which`th such.
    static vec4 color_of(const Scene& scene, const std::string& name, int which = 0) {
        for (const Node& node : scene.nodes)
            if (node.name == name && which-- == 0)
                return scene.materials.at(scene.meshes.at(node.meshes.at(0)).material).base_color;
        throw std::runtime_error("no such node");
    }
    std::string warning() {
        EXPECT_EQ(context_.report().entries().size(), 1u);
        return context_.report().entries().empty() ? std::string() : context_.report().entries()[0].message;
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 1}};
};

constexpr vec4 red{1, 0, 0, 1}, green{0, 1, 0, 1}, blue{0, 0, 1, 1};
const std::string two = "[[model]]\nfile = 'a.obj'\nname = 'a'\n[[model]]\nfile = 'a.obj'\nname = 'b'\n";

}  // namespace

TEST_F(WorldObjects, AreChangedByNameInAllModelsOrInOne) {
    Scene s = load_text(two + "[[material]]\nname = 'red'\nobject = 'left'\ncolor = [0, 1, 0]\n");
    for (const int which : {0, 1}) {
        EXPECT_EQ(color_of(s, "left", which), green);
        EXPECT_EQ(color_of(s, "right", which), red);
    }
    s = load_text(two + "[[material]]\nname = '*'\nmodel = 'b'\nobject = 'left'\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(color_of(s, "left", 0), red);
    EXPECT_EQ(color_of(s, "left", 1), green);
    EXPECT_TRUE(context_.report().entries().empty());
}

TEST_F(WorldObjects, AreChangedByTheNumberOfTheirNodeInTheModel) {
    const Scene alone = load((folder_ / "a.obj").string(), {}, context_);
    std::string number;
    for (std::size_t n = 0; n < alone.nodes.size(); ++n)
        if (alone.nodes[n].name == "right") number = std::to_string(n);
    const Scene s =
        load_text(two + "[[material]]\nname = 'red'\nmodel = 'b'\nobject = '" + number + "'\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(color_of(s, "right", 0), red);
    EXPECT_EQ(color_of(s, "right", 1), green);
    EXPECT_EQ(color_of(s, "left", 1), red);
}

TEST_F(WorldObjects, GoOverWhatIsSaidOfAllWhereverItStands) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\n[[material]]\nname = 'red'\nobject = 'left'\ncolor = [0, 1, 0]\n"
        "[[material]]\nname = 'red'\ncolor = [0, 0, 1]\nemission = [0, 0, 1]\n");
    EXPECT_EQ(color_of(s, "left"), green);
    EXPECT_EQ(color_of(s, "right"), blue);
    for (const Material& m : s.materials) EXPECT_EQ(m.emission, (vec3{0, 0, 1}));
}

TEST_F(WorldObjects, AreChangedUnderAMaterialOfTheWorldToo) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\nmaterial = 'gold'\n[[material]]\nname = 'gold'\nmetallic = 1\n"
        "[[material]]\nname = 'gold'\nobject = 'left'\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(color_of(s, "left"), green);
    EXPECT_EQ(color_of(s, "right"), (vec4{1, 1, 1, 1}));
    EXPECT_TRUE(context_.report().entries().empty());
}

TEST_F(WorldObjects, ShareTheirArraysStill) {
    const Scene s =
        load_text("[[model]]\nfile = 'a.obj'\n[[material]]\nname = '*'\nobject = 'left'\ncolor = [0, 1, 0]\n");
    ASSERT_EQ(s.meshes.size(), 3u);
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.meshes[2].positions, s.meshes[0].positions);
}

TEST_F(WorldObjects, ThatAreNotThereAreWarnedOf) {
    load_text("[[model]]\nfile = 'a.obj'\n[[material]]\nname = 'red'\nobject = 'lefd'\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(warning(), "no model has an object 'lefd'; did you mean 'left'?");
}

TEST_F(WorldObjects, WithoutTheMaterialAreWarnedOf) {
    load_text("[[model]]\nfile = 'a.obj'\n[[material]]\nname = 'blue'\nobject = 'left'\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(warning(), "the object 'left' has no material named 'blue'");
}

TEST_F(WorldObjects, AreNamedOnceForAMaterial) {
    const std::string left = "[[material]]\nname = 'red'\nobject = 'left'\n";
    const Error error = error_of([&] { parse_world(two + left + left); });
    EXPECT_NE(std::string(error.what()).find("for the same object"), std::string::npos) << error.what();
    EXPECT_NO_THROW(
        parse_world(two + left + "[[material]]\nname = 'red'\nobject = 'right'\n[[material]]\nname = 'red'\n"));
}

TEST_F(WorldObjects, ComeBackFromText) {
    const WorldFile world =
        parse_world(two + "[[material]]\nname = 'red'\nmodel = 'b'\nobject = 'le\"ft'\nopacity = 0.5\n");
    const WorldFile back = parse_world(to_toml(world));
    ASSERT_EQ(back.materials.size(), 1u);
    EXPECT_EQ(back.materials[0].object, "le\"ft");
    EXPECT_EQ(back.materials[0].model, "b");
}

TEST_F(WorldObjects, ScenesInMemoryAreChangedLikewise) {
    const Scene before = load((folder_ / "a.obj").string(), {}, context_);
    std::uint32_t left = 0;
    while (before.nodes.at(left).name != "left") ++left;
    const std::vector<WorldValue> green_value = material_values(std::vector<std::string>{"color=0,1,0"});
    const MaterialChanges changes[] = {{{.name = "red", .node = left}, green_value}};
    const Scene s = with_material_changes(before, changes, context_);
    EXPECT_EQ(color_of(s, "left"), green);
    EXPECT_EQ(color_of(s, "right"), red);
    const MaterialChanges nowhere[] = {{{.name = "red", .node = 99}, green_value}};
    EXPECT_EQ(error_of([&] { with_material_changes(before, nowhere, context_); }).code(), ErrorCode::usage);
}
