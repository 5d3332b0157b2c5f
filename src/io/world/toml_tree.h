// SPDX-License-Identifier: Apache-2.0
// TOML text as a tree with places. The only door to toml++.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rakelight/io/world.h>

namespace rakelight::io::world {

struct TomlNode;

struct TomlEntry;

/// A value of the file.
struct TomlNode {
    enum class Kind { table, array, text, number, flag, other };
    Kind kind = Kind::other;
    WorldPlace place;
    std::string text;       ///< of texts; for `other` what it is: "a date"
    double number = 0;      ///< finite where the file's is
    bool is_whole = false;  ///< a number without fraction
    bool flag = false;
    std::vector<TomlEntry> entries;  ///< of a table, by their places
    std::vector<TomlNode> items;     ///< of an array
};

struct TomlEntry {
    std::string key;
    WorldPlace place;  ///< of the key
    TomlNode value;
};

/// "a table", "a number", ...
const char* name_of(TomlNode::Kind kind);

/// @throws Error bad_file with line and column: not TOML 1.0, or not UTF-8
TomlNode parse_toml(std::string_view text);

}  // namespace rakelight::io::world
