// SPDX-License-Identifier: Apache-2.0
// KEY=VALUE of a command line -> the values of a [[material]], by the same table and checks.
#include <algorithm>

#include "io/world/material_keys.h"
#include "io/world/section_values.h"
#include "io/world/word_nodes.h"
#include "io/world/world_parts.h"

namespace rakelight {
namespace {

using namespace io::world;

TomlEntry entry_of(std::string_view words) {
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

}  // namespace

std::vector<WorldValue> material_values(std::span<const std::string> words) {
    TomlNode table;
    table.kind = TomlNode::Kind::table;
    table.entries.push_back({"name", {}, node_of(Kind::text, "*")});
    for (const std::string& each : words) {
        TomlEntry entry = entry_of(each);
        if (std::any_of(table.entries.begin(), table.entries.end(),
                        [&](const TomlEntry& before) { return before.key == entry.key; }))
            throw Error(ErrorCode::usage, "'" + entry.key + "' is given twice");
        table.entries.push_back(std::move(entry));
    }
    try {
        return read_material(SectionValues(table, section("material"), Written::as_words)).values;
    } catch (const Error& error) {  // a fault of words, not of a file
        throw Error(ErrorCode::usage, error.reason(), {}, error.advice());
    }
}

}  // namespace rakelight
