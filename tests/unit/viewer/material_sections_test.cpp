// SPDX-License-Identifier: Apache-2.0
// Changed materials among the sections of a world: against what the sections say, section by section.
#include "../../../apps/viewer/document/material_sections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

namespace rakelight::viewer {
namespace {

constexpr const char *names[] = {"a", "b"}, *models[] = {"m", "n"}, *objects[] = {"o", "p"}, *keys[] = {"x", "y", "z"};

/// Of each material of each object: key -> value.
using Said = std::map<std::tuple<std::string, std::string, std::string>, std::map<std::string, std::string>>;

bool is_met(const WorldMaterial& section, const std::string& name, const std::string& model,
            const std::string& object) {
    return (section.name == "*" || section.name == name) && (section.model.empty() || section.model == model) &&
           (section.object.empty() || section.object == object);
}

void say(Said& said, const WorldMaterial& section) {
    for (const char* name : names)
        for (const char* model : models)
            for (const char* object : objects)
                if (is_met(section, name, model, object))
                    for (const WorldValue& value : section.values)
                        said[{name, model, object}][value.key] = value.words[0];
}

Said said_by(const WorldFile& world) {
    Said said;
    for (const bool is_of_object : {false, true})
        for (const WorldMaterial& section : world.materials)
            if (section.object.empty() != is_of_object) say(said, section);
    return said;
}

class Worlds {
public:
    explicit Worlds(unsigned seed) : random_(seed) {}

    WorldMaterial section(bool may_name_model) {
        WorldMaterial m;
        m.name = pick(3) == 0 ? "*" : names[pick(2)];
        if (may_name_model && pick(2) == 0) m.model = models[pick(2)];
        if (pick(3) == 0) m.object = objects[pick(2)];
        const int count = 1 + pick(3);
        for (int i = 0; i < count; ++i) {
            const WorldValue value{.key = keys[i], .words = {std::to_string(++values_)}};
            if (i == 0 || pick(2) == 0) m.values.push_back(value);
        }
        return m;
    }
    WorldFile world() {
        WorldFile world;
        const int count = pick(7);
        for (int i = 0; i < count; ++i) {
            const WorldMaterial m = section(true);
            const bool is_there = std::ranges::any_of(world.materials, [&](const WorldMaterial& k) {
                return k.name == m.name && k.model == m.model && k.object == m.object;
            });
            if (!is_there) world.materials.push_back(m);
        }
        return world;
    }
    int pick(int count) { return int(random_() % unsigned(count)); }

private:
    std::mt19937 random_;
    int values_ = 0;
};

std::string text_of(const WorldFile& world) {
    std::string text;
    for (const WorldMaterial& m : world.materials) {
        text += m.name + "/" + m.model + "/" + m.object + ":";
        for (const WorldValue& v : m.values) text += " " + v.key + "=" + v.words[0];
        text += "\n";
    }
    return text;
}

TEST(MaterialSections, GoOverAllThatTheWorldSaysAndNothingElse) {
    Worlds worlds(1);
    for (int i = 0; i < 20000; ++i) {
        WorldFile world = worlds.world();
        WorldMaterial edit = worlds.section(false);
        if (!edit.object.empty()) edit.model = models[worlds.pick(2)];  // as the viewer names objects
        Said wanted = said_by(world);
        say(wanted, edit);
        const std::string before = text_of(world);
        set_values(world, edit, edit.values);
        ASSERT_EQ(said_by(world), wanted) << before << "edit " << text_of({.materials = {edit}}) << text_of(world);
        std::map<std::tuple<std::string, std::string, std::string>, int> count;
        for (const WorldMaterial& m : world.materials)
            ASSERT_EQ(++count[std::tuple(m.name, m.model, m.object)], 1) << before << text_of(world);
    }
}

TEST(MaterialSections, OfTheWorldsOwnMaterialsAreReachedByAllToo) {
    WorldFile world;
    world.primitives = {{.type = "sphere", .material = "clay"}};
    world.materials = {{.name = "clay", .values = {{.key = "roughness", .words = {"1"}}}}};
    set_values(world, {.name = "*"}, {{.key = "metallic", .words = {"0.5"}}});
    ASSERT_EQ(world.materials.size(), 2u);
    EXPECT_EQ(world.materials[0].values.size(), 2u);
}

}  // namespace
}  // namespace rakelight::viewer
