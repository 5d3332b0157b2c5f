// SPDX-License-Identifier: Apache-2.0
#include "io/world/word_nodes.h"

#include <algorithm>
#include <charconv>

#include <rakelight/scene/words.h>

#include "base/from_chars.h"
#include "math/color_names.h"

namespace rakelight::io::world {
namespace {

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
    const auto [stop, fault] = from_chars(text.data(), end, value);
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

}  // namespace

TomlNode node_of(Kind kind, std::string_view text) {
    switch (kind) {
        case Kind::text:
        case Kind::file:
        case Kind::word:
            return text_node(text);
        case Kind::flag: {
            const auto is_one_of = [&](std::initializer_list<const char*> words) {
                return std::ranges::any_of(words, [&](const char* word) { return same_word(text, word); });
            };
            TomlNode node;
            node.kind = TomlNode::Kind::flag;
            node.flag = is_one_of({"on", "true", "1"});
            if (!node.flag && !is_one_of({"off", "false", "0"})) return text_node(text);
            return node;
        }
        case Kind::color:
            return color_by_text(text) || text.starts_with('#') ? text_node(text) : numbers_node(text);
        default:
            return numbers_node(text);
    }
}

}  // namespace rakelight::io::world
