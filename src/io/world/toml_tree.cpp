// SPDX-License-Identifier: Apache-2.0
#include "io/world/toml_tree.h"

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>

namespace rakelight::io::world {
namespace {

WorldPlace place_of(const toml::source_region& source) { return {int(source.begin.line), int(source.begin.column)}; }

TomlNode tree_of(const toml::node& from);

TomlNode table_of(const toml::table& table) {
    TomlNode node;
    node.kind = TomlNode::Kind::table;
    for (const auto& [key, value] : table)
        node.entries.push_back({std::string(key.str()), place_of(key.source()), tree_of(value)});
    std::stable_sort(node.entries.begin(), node.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return node;
}

TomlNode array_of(const toml::array& array) {
    TomlNode node;
    node.kind = TomlNode::Kind::array;
    for (const toml::node& item : array) node.items.push_back(tree_of(item));
    return node;
}

TomlNode number_of(double value, bool is_whole) {
    TomlNode node;
    node.kind = TomlNode::Kind::number;
    node.number = value;
    node.is_whole = is_whole;
    return node;
}

TomlNode leaf_of(const toml::node& from) {
    TomlNode node;
    if (const auto* text = from.as_string()) {
        node.kind = TomlNode::Kind::text;
        node.text = text->get();
    } else if (const auto* flag = from.as_boolean()) {
        node.kind = TomlNode::Kind::flag;
        node.flag = flag->get();
    } else {
        node.text = from.is_time() ? "a time" : "a date";
    }
    return node;
}

TomlNode tree_of(const toml::node& from) {
    TomlNode node;
    if (const toml::table* table = from.as_table())
        node = table_of(*table);
    else if (const toml::array* array = from.as_array())
        node = array_of(*array);
    else if (const auto* whole = from.as_integer())
        node = number_of(double(whole->get()), true);
    else if (const auto* real = from.as_floating_point())
        node = number_of(real->get(), false);
    else
        node = leaf_of(from);
    node.place = place_of(from.source());
    return node;
}

/// toml++ descends into dotted keys by calling itself, so their length is bounded before it sees them.
void check_dotted_keys(std::string_view text) {
    constexpr int most_dots = 64;
    WorldPlace place{1, 0};
    int dots = 0;
    for (const char c : text) {
        ++place.column;
        if (c == '\n') place = {place.line + 1, 0};
        const bool may_be_key = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                                c == '_' || c == '-' || c == ' ' || c == '\t' || c == '"' || c == '\'';
        dots = c == '.' ? dots + 1 : may_be_key ? dots : 0;
        if (dots > most_dots) throw Error(ErrorCode::bad_file, "a key of more than 64 parts", to_text(place));
    }
}

}  // namespace

const char* name_of(TomlNode::Kind kind) {
    switch (kind) {
        case TomlNode::Kind::table:
            return "a table";
        case TomlNode::Kind::array:
            return "an array";
        case TomlNode::Kind::text:
            return "a text";
        case TomlNode::Kind::number:
            return "a number";
        case TomlNode::Kind::flag:
            return "true or false";
        case TomlNode::Kind::other:
            return "a date or time";
    }
    return "";
}

TomlNode parse_toml(std::string_view text) {
    check_dotted_keys(text);
    try {
        return tree_of(toml::parse(text));
    } catch (const toml::parse_error& fault) {
        throw Error(ErrorCode::bad_file, std::string(fault.description()), to_text(place_of(fault.source())));
    }
}

}  // namespace rakelight::io::world
