// SPDX-License-Identifier: Apache-2.0
// The text of a world file -> what it says.
#include <algorithm>
#include <filesystem>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/world/material_keys.h"
#include "io/world/motion_keys.h"
#include "io/world/read_settings.h"
#include "io/world/section_values.h"
#include "io/world/world_lights_cameras.h"
#include "io/world/world_parts.h"

namespace rakelight {
namespace {

using namespace io::world;

constexpr std::size_t most_bytes = 4u << 20, most_entries = 10'000;

/// One entry of a section -> the world.
using Reading = void (*)(const SectionValues& values, WorldFile& world);

constexpr std::pair<const char*, Reading> readings[] = {
    {"model", [](const SectionValues& v, WorldFile& w) { w.models.push_back(read_model(v)); }},
    {"primitive", [](const SectionValues& v, WorldFile& w) { w.primitives.push_back(read_primitive(v)); }},
    {"light",
     [](const SectionValues& v, WorldFile& w) {
         w.lights.push_back(read_light(v));
         add_light_tracks(v, w);
     }},
    {"camera",
     [](const SectionValues& v, WorldFile& w) {
         w.cameras.push_back(read_camera(v, w));
         add_camera_tracks(v, w);
     }},
    {"material", [](const SectionValues& v, WorldFile& w) { w.materials.push_back(read_material(v)); }},
    {"fog", [](const SectionValues& v, WorldFile& w) { w.fog = read_fog(v); }},
    {"environment", [](const SectionValues& v, WorldFile& w) { w.environment = read_environment(v); }},
};

void read_entries(const TomlEntry& entry, const WorldSection& section, Reading read, WorldFile& world) {
    const std::string name = entry.key;
    if (!section.is_array) {
        if (entry.value.kind != TomlNode::Kind::table)
            fail(entry.place, "'" + name + "' may occur only once", "write [" + name + "]");
        return read(SectionValues(entry.value, section), world);
    }
    const auto is_table = [](const TomlNode& item) { return item.kind == TomlNode::Kind::table; };
    if (entry.value.kind != TomlNode::Kind::array ||
        !std::all_of(entry.value.items.begin(), entry.value.items.end(), is_table))
        fail(entry.place, "'" + name + "' is a list of tables", "write [[" + name + "]]");
    if (entry.value.items.size() > most_entries)
        fail(entry.place, format_text("more than {} of [[{}]]", most_entries, name));
    for (const TomlNode& item : entry.value.items) read(SectionValues(item, section), world);
}

void read_render(const TomlEntry& entry, WorldFile& world) {
    if (entry.value.kind != TomlNode::Kind::table) fail(entry.place, "'render' may occur only once", "write [render]");
    for (const TomlEntry& option : entry.value.entries) {
        if (option.key.starts_with('-'))
            fail(option.place, "'" + one_line(option.key, 40) + "' is written without dashes");
        WorldValue value = free_value(option);
        value.place = option.place;
        world.render.push_back(std::move(value));
    }
}

void read_section(const TomlEntry& entry, WorldFile& world) {
    if (entry.key == "render") return read_render(entry, world);
    for (const auto& [name, read] : readings)
        if (entry.key == name) return read_entries(entry, section(name), read, world);
    std::vector<const char*> names = {"render"};
    for (const WorldSection& s : sections()) names.push_back(s.name);
    fail(entry.place, "unknown section '" + one_line(entry.key, 40) + "'", advice_for(entry.key, names));
}

}  // namespace

std::string to_text(WorldPlace place) {
    if (place.line == 0) return {};
    return format_text("line {}, column {}", place.line, place.column);
}

bool is_world_file(std::string_view path) {
    constexpr std::string_view ending = ".scene.toml";
    if (path.size() <= ending.size()) return false;
    path.remove_prefix(path.size() - ending.size());
    return lower_case(path) == ending;
}

WorldFile parse_world(std::string_view text) {
    if (text.size() > most_bytes) throw Error(ErrorCode::bad_file, "a world file has at most 4 MiB");
    const TomlNode tree = parse_toml(text);
    WorldFile world;
    for (const TomlEntry& entry : tree.entries) read_section(entry, world);
    check_names(world);
    if (world.models.empty() && world.primitives.empty())
        throw Error(ErrorCode::bad_file, "the world is empty", "line 1, column 1",
                    "add a [[model]] or a [[primitive]]");
    return world;
}

std::string resolve_in_world(const std::string& path, const std::string& name, bool allow_outside) {
    return io::resolve_reference(path, name, allow_outside);
}

namespace {

/// Calls read(text) with all of a file. @throws Error with the file's name
template <class Read>
auto read_text(const std::string& path, Context& context, const Read& read) {
    try {
        std::error_code ignored;
        if (std::filesystem::file_size(path, ignored) > most_bytes && !ignored)
            throw Error(ErrorCode::bad_file, "a world file has at most 4 MiB");
        const io::Bytes bytes = io::read_file(path, context);
        return read(std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace

WorldFile read_world(const std::string& path, Context& context) { return read_text(path, context, parse_world); }

std::vector<WorldValue> io::world::read_settings(const std::string& path, Context& context) {
    return read_text(path, context, [](std::string_view text) {
        WorldFile world;
        for (const TomlEntry& entry : parse_toml(text).entries) {
            if (entry.key != "render")
                fail(entry.place, "a configuration has only [render], not '" + one_line(entry.key, 40) + "'",
                     "write settings below [render]; a world file is given as a model");
            read_render(entry, world);
        }
        return world.render;
    });
}

}  // namespace rakelight
