// SPDX-License-Identifier: Apache-2.0
// KEY=VALUE of a command line -> the values of a [[material]] or [[primitive]], by the same tables and checks.
#include <rakelight/io/world_words.h>

#include <algorithm>
#include <array>

#include "io/world/material_keys.h"
#include "io/world/section_values.h"
#include "io/world/word_nodes.h"
#include "io/world/world_parts.h"

namespace rakelight {
namespace {

using namespace io::world;

void add(TomlEntry entry, TomlNode& table) {
    if (std::any_of(table.entries.begin(), table.entries.end(),
                    [&](const TomlEntry& before) { return before.key == entry.key; }))
        throw Error(ErrorCode::usage, "'" + entry.key + "' is given twice");
    table.entries.push_back(std::move(entry));
}

/// What a section's reader makes of the table.
template <class Part>
Part read(const TomlNode& table, const char* name, Part (*read_part)(const SectionValues&)) {
    try {
        return read_part(SectionValues(table, section(name), Written::as_words));
    } catch (const Error& error) {  // a fault of words, not of a file
        throw Error(ErrorCode::usage, error.reason(), {}, error.advice());
    }
}

TomlEntry material_entry(std::string_view words) {
    const std::size_t equals = words.find('=');
    const std::string key(words.substr(0, equals));
    if (equals == words.npos || key.empty())
        throw Error(ErrorCode::usage, "'" + one_line(std::string(words), 60) + "' is not KEY=VALUE", {},
                    "write for example clearcoat=1");
    std::vector<const char*> names;
    for (const MaterialKey& known : material_setters()) names.push_back(known.key.name);
    const MaterialKey* const known = find_material_key(key);
    if (!known) throw Error(ErrorCode::usage, "unknown key '" + one_line(key, 40) + "'", {}, advice_for(key, names));
    return {key, {}, node_of(known->key.kind, words.substr(equals + 1))};
}

/// The keys of [[primitive]] that define the shape; its placement and materials are only for world files.
constexpr std::array<const char*, 7> shape_keys = {"radius",    "tube_radius", "height",   "size",
                                                   "divisions", "objects",     "tolerance"};

TomlEntry shape_entry(std::string_view words) {
    const std::size_t equals = words.find('=');
    const std::string key(words.substr(0, equals));
    if (equals == words.npos)
        throw Error(ErrorCode::usage, "'" + one_line(std::string(words), 60) + "' is not KEY=VALUE", {},
                    "write for example builtin:sphere:tolerance=0.01");
    if (std::find(shape_keys.begin(), shape_keys.end(), key) == shape_keys.end())
        throw Error(ErrorCode::usage, "unknown key '" + one_line(key, 40) + "'", {},
                    advice_for(key, {shape_keys.begin(), shape_keys.end()}));
    const std::vector<WorldKey>& keys = section("primitive").keys;
    const auto known = std::find_if(keys.begin(), keys.end(), [&](const WorldKey& k) { return key == k.name; });
    return {key, {}, node_of(known->kind, words.substr(equals + 1))};
}

}  // namespace

std::vector<WorldValue> material_values(std::span<const std::string> words) {
    TomlNode table;
    table.kind = TomlNode::Kind::table;
    table.entries.push_back({"name", {}, node_of(Kind::text, "*")});
    for (const std::string& each : words) add(material_entry(each), table);
    return read(table, "material", read_material).values;
}

WorldPrimitive shape_of_words(std::string_view words) {
    TomlNode table;
    table.kind = TomlNode::Kind::table;
    const std::size_t name_end = std::min(words.find(':'), words.size());
    table.entries.push_back({"type", {}, node_of(Kind::text, words.substr(0, name_end))});
    for (std::size_t begin = name_end; begin < words.size();) {
        const std::size_t end = std::min(words.find(':', begin + 1), words.size());
        add(shape_entry(words.substr(begin + 1, end - begin - 1)), table);
        begin = end;
    }
    return read(table, "primitive", read_primitive);
}

}  // namespace rakelight
