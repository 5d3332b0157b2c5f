// SPDX-License-Identifier: Apache-2.0
// Materials changed for all objects and for one alone.
#include <filesystem>

#include "looks.h"

namespace rakelight::viewer {
namespace {

/// Three squares side by side: left and middle are instances of one mesh, the right one has a mesh of its own; all of one
/// material. @param name  of it, @param nodes  their names
std::string gltf(const std::string& name, const std::vector<std::string>& nodes) {
    const auto named = [](const std::string& n) { return n.empty() ? std::string() : "\"name\": \"" + n + "\", "; };
    std::string text = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1, 2]}], "scene": 0, "nodes": [)";
    for (int i = 0; i < 3; ++i)
        text += (i ? ", {" : "{") + named(nodes[std::size_t(i)]) + "\"mesh\": " + (i == 2 ? "1" : "0") +
                ", \"translation\": [" + std::to_string(2 * i - 2) + ", 0, 0]}";
    return text + R"(], "materials": [{)" + named(name) +
           R"("pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.8, 0.8, 1], "metallicFactor": 0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]},
                   {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-0.8, -0.8, 0], "max": [0.8, 0.8, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": 60, "uri": "squares.bin"}]})";
}

class Materials : public Looks {
protected:
    std::shared_ptr<const Model> squares(const std::string& name,
                                         const std::vector<std::string>& nodes = {"left", "middle", "right"}) {
        const float corners[] = {-0.8f, -0.8f, 0, 0.8f, -0.8f, 0, 0.8f, 0.8f, 0, -0.8f, 0.8f, 0};
        const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
        std::ofstream bin(file("squares.bin"), std::ios::binary);
        bin.write(reinterpret_cast<const char*>(corners), sizeof corners);
        bin.write(reinterpret_cast<const char*>(indices), sizeof indices);
        bin.close();
        std::ofstream(file("squares.gltf")) << gltf(name, nodes);
        return model(file("squares.gltf"));
    }
    /// Whether left, middle and right look other than before.
    std::array<bool, 3> changed(const std::shared_ptr<const Model>& m, const Look& look) {
        Look first = first_look(*m);
        first.request.view = look.request.view;
        const Frame before = drawn(m, first), after = drawn(m, look);
        std::array<bool, 3> out{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t pixel = height / 2 * width + (2 * i + 1) * width / 6;
            out[i] = !(before.color[pixel] == after.color[pixel]);
        }
        return out;
    }
    Look front(const Model& m) {
        Look look = first_look(m);
        look.request.view = {.side = "front"};
        return look;
    }
};

using Changed = std::array<bool, 3>;

TEST_F(Materials, OfAllObjectsAndOfOneAlone) {
    const auto m = squares("plain");
    Look look = front(*m);
    set_material(look, {.name = "plain"}, "color=0.1,0.5,0.2");
    EXPECT_EQ(changed(m, look), (Changed{true, true, true}));
    look = front(*m);
    set_material(look, {.name = "plain", .node = 1}, "color=0.1,0.5,0.2");  // one of two instances
    EXPECT_EQ(changed(m, look), (Changed{false, true, false}));
    EXPECT_SAVED_AS_SEEN(look, m);
    set_material(look, {.name = "plain"}, "color=0.9,0.2,0.2");  // goes before what one has of its own
    const Frame frame = drawn(m, look);
    EXPECT_FALSE(frame.color[height / 2 * width + width / 6] == frame.color[height / 2 * width + width / 2]);
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Materials, WithoutNamesAreChangedObjectByObject) {
    Model nameless = *squares("");  // the loader of glTF gives names
    nameless.scene.materials[0].name.clear();
    const auto m = std::make_shared<const Model>(nameless);
    Look look = front(*m);
    const MaterialTarget target = target_of(m->scene, 0, 2);
    EXPECT_EQ(target, (MaterialTarget{.name = "*", .node = 2}));
    set_material(look, target, "color=0.1,0.5,0.2");
    EXPECT_EQ(changed(m, look), (Changed{false, false, true}));
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Materials, OfObjectsWithOneNameAreSavedByNumber) {
    for (const char* name : {"twin", "12"}) {
        const auto m = squares("plain", {name, name, name});
        Look look = front(*m);
        set_material(look, {.name = "plain", .node = 1}, "color=0.1,0.5,0.2");
        EXPECT_SAVED_AS_SEEN(look, m);
        const WorldFile world = world_of(look, *m, width, height, file("saved.scene.toml"));
        ASSERT_EQ(world.materials.size(), 1u);
        EXPECT_EQ(world.materials[0].object, "1");
    }
}

TEST_F(Materials, OfAWorldsObjectsAreSavedAsSeen) {
    squares("plain");
    std::ofstream(file("two.scene.toml"))
        << "[[primitive]]\ntype = \"plane\"\nposition = [0, -1, 0]\n"
           "[[model]]\nfile = \"squares.gltf\"\nname = \"a\"\n"
           "[[model]]\nfile = \"squares.gltf\"\nname = \"b\"\nposition = [0, 2, 0]\n"
           "[[material]]\nname = \"plain\"\nmodel = \"b\"\nobject = \"left\"\ncolor = [1, 0, 0]\n";
    const auto m = model(file("two.scene.toml"));
    Look look = front(*m);
    std::uint32_t last_right = 0;
    for (std::uint32_t n = 0; n < m->scene.nodes.size(); ++n)
        if (m->scene.nodes[n].name == "right") last_right = n;
    set_material(look, {.name = "plain", .node = last_right}, "color=0,0.5,1");
    EXPECT_EQ(object_in_world(m->scene, last_right).model, "b");
    EXPECT_SAVED_AS_SEEN(look, m);
    set_material(look, {.name = "plain"}, "color=0.2,0.2,0.2");  // takes the color of b's left, too
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Materials, OfObjectsGoWithTheirNamesWhenTheFileIsReadAgain) {
    const Scene before = squares("plain")->scene;
    std::vector<MaterialEdit> edits;
    for (const std::uint32_t node : {0u, 1u, 2u}) edits.push_back({{.name = "plain", .node = node}, {}});
    edits.push_back({{.name = "plain"}, {}});
    const Scene after = squares("plain", {"right", "other", "left"})->scene;
    EXPECT_EQ(carry_edits(edits, before, after), (std::vector<std::string>{"plain of middle"}));
    ASSERT_EQ(edits.size(), 3u);
    EXPECT_EQ(edits[0].target, (MaterialTarget{.name = "plain", .node = 2}));
    EXPECT_EQ(edits[1].target, (MaterialTarget{.name = "plain", .node = 0}));
    EXPECT_EQ(edits[2].target, (MaterialTarget{.name = "plain"}));
}

TEST_F(Materials, OfObjectsWithoutNamesStayAtTheirNumbers) {
    Scene before = squares("plain")->scene;
    for (Node& node : before.nodes) node.name = "twin";
    Scene after = before;
    EXPECT_EQ(same_object(before, 1, after), 1u);
    after.nodes[1].name = "other";
    EXPECT_EQ(same_object(before, 1, after), no_index);
    after.nodes.resize(1);
    EXPECT_EQ(same_object(before, 1, after), no_index);
    EXPECT_EQ(same_object(after, no_index, before), no_index);
}

TEST_F(Materials, OfAWorldsObjectsStayInTheirModels) {
    squares("plain");
    const auto world = [&](const std::string& first, const std::string& second) {
        folder_.write("two.scene.toml", "[[model]]\nfile = \"squares.gltf\"\nname = \"" + first +
                                            "\"\n[[model]]\nfile = \"squares.gltf\"\nname = \"" + second + "\"\n");
        return model(file("two.scene.toml"))->scene;
    };
    const Scene before = world("a", "b"), after = world("b", "c");
    EXPECT_EQ(same_object(before, 6, after), 2u);  // b's middle
    EXPECT_EQ(same_object(before, 2, after), no_index);
}

TEST_F(Materials, OfNodesThatAreNotThereAreRefused) {
    const auto m = squares("plain");
    Look look = front(*m);
    set_material(look, {.name = "plain", .node = 3}, "color=0.1,0.5,0.2");
    EXPECT_THROW(world_of(look, *m, width, height, file("saved.scene.toml")), Error);
}

TEST_F(Materials, OfAPictureAreFoundInTheFile) {
    const auto m = squares("plain");
    Look look = front(*m);
    set_material(look, {.name = "plain", .node = 1}, "color=0.1,0.5,0.2");
    set_material(look, {.name = "plain", .node = 0}, "color=0.5,0.5,0.2");
    const Scene edited = with_edits(m->scene, look.materials, context_);
    EXPECT_EQ(edited.materials.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(source_material(m->scene, look.materials, i), 0u) << i;
    EXPECT_EQ(objects_with(m->scene, 0), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST_F(Materials, AreResetToTheFilesOwn) {
    const auto m = squares("plain");
    Look look = front(*m);
    set_material(look, {.name = "plain", .node = 1}, "color=0.1,0.5,0.2");
    forget_material(look, {.name = "plain", .node = 1});
    EXPECT_EQ(edited_values(look, {.name = "plain", .node = 1}), nullptr);
    EXPECT_EQ(changed(m, look), (Changed{false, false, false}));
}

}  // namespace
}  // namespace rakelight::viewer
