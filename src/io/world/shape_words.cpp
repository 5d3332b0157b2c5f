// SPDX-License-Identifier: Apache-2.0
// "sphere:tolerance=0.01" of a command line -> a [[primitive]], by the same table and checks.
#include <algorithm>
#include <array>

#include "io/world/section_values.h"
#include "io/world/word_nodes.h"
#include "io/world/world_parts.h"

namespace rakelight {
namespace {

using namespace io::world;

/// The keys of [[primitive]] that define the shape; its placement and materials are only for world files.
constexpr std::array<const char*, 7> shape_keys = {"radius",    "tube_radius", "height",   "size",
                                                   "divisions", "objects",     "tolerance"};

TomlEntry entry_of(std::string_view words) {
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

WorldPrimitive shape_of_words(std::string_view words) {
    TomlNode table;
    table.kind = TomlNode::Kind::table;
    const std::size_t name_end = std::min(words.find(':'), words.size());
    table.entries.push_back({"type", {}, node_of(Kind::text, words.substr(0, name_end))});
    for (std::size_t begin = name_end; begin < words.size();) {
        const std::size_t end = std::min(words.find(':', begin + 1), words.size());
        TomlEntry entry = entry_of(words.substr(begin + 1, end - begin - 1));
        if (std::any_of(table.entries.begin(), table.entries.end(),
                        [&](const TomlEntry& before) { return before.key == entry.key; }))
            throw Error(ErrorCode::usage, "'" + entry.key + "' is given twice");
        table.entries.push_back(std::move(entry));
        begin = end;
    }
    try {
        return read_primitive(SectionValues(table, section("primitive"), Written::as_words));
    } catch (const Error& error) {  // a fault of words, not of a file
        throw Error(ErrorCode::usage, error.reason(), {}, error.advice());
    }
}

}  // namespace rakelight
