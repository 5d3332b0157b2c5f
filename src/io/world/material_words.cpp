// SPDX-License-Identifier: Apache-2.0
// KEY=VALUE of a command line -> the values of a [[material]], by the same table and checks.
#include <algorithm>
#include <charconv>

#include "io/world/material_keys.h"
#include "io/world/section_values.h"
#include "io/world/world_parts.h"

namespace rakelight {
namespace {

using namespace io::world;

TomlNode text_node(std::string_view text) {
    TomlNode node;
    node.kind = TomlNode::Kind::text;
    node.text = std::string(text);
    return node;
}

/// What is no number stays a text, which the check of the key refuses with what it must be.
TomlNode number_node(std::string_view text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || stop != end) return text_node(text);
    TomlNode node;
    node.kind = TomlNode::Kind::number;
    node.number = value;
    node.is_whole = value >= -9e15 && value <= 9e15 && value == double(std::int64_t(value));
    return node;
}

TomlNode numbers_node(std::string_view text) {
    TomlNode list;
    list.kind = TomlNode::Kind::array;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        list.items.push_back(number_node(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return list.items.size() == 1 ? list.items[0] : list;
}

TomlNode node_of(Kind kind, std::string_view text) {
    switch (kind) {
        case Kind::text:
        case Kind::file:
        case Kind::word:
            return text_node(text);
        case Kind::flag: {
            if (text != "on" && text != "true" && text != "off" && text != "false") return text_node(text);
            TomlNode node;
            node.kind = TomlNode::Kind::flag;
            node.flag = text == "on" || text == "true";
            return node;
        }
        case Kind::color:
            return text.starts_with('#') ? text_node(text) : numbers_node(text);
        default:
            return numbers_node(text);
    }
}

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
    table.entries.push_back({"name", {}, text_node("*")});
    for (const std::string& each : words) {
        TomlEntry entry = entry_of(each);
        if (std::any_of(table.entries.begin(), table.entries.end(),
                        [&](const TomlEntry& before) { return before.key == entry.key; }))
            throw Error(ErrorCode::usage, "'" + entry.key + "' is given twice");
        table.entries.push_back(std::move(entry));
    }
    try {
        return read_material(SectionValues(table, section("material"))).values;
    } catch (const Error& error) {  // a fault of words, not of a file
        throw Error(ErrorCode::usage, error.reason(), {}, error.advice());
    }
}

}  // namespace rakelight
