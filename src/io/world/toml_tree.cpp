// SPDX-License-Identifier: Apache-2.0
#include "io/world/toml_tree.h"

// toml++ 3.3 asserts what hostile text can make false (a key that begins with none of its letters), and takes it for granted where NDEBUG
// is defined: here it becomes an error of the text.
#undef NDEBUG
#define TOML_ASSERT(expression) rakelight::io::world::require(static_cast<bool>(expression))
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
namespace rakelight::io::world {
struct TomlFault {};
constexpr void require(bool is_so) {
    if (!is_so) throw TomlFault();
}
}  // namespace rakelight::io::world
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

/// Where the text goes on behind the string that begins at `at`; what is between is no dot of a key.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string three(3, quote);
    const bool is_long = text.substr(at).starts_with(three);  // over several lines
    std::size_t i = at + (is_long ? 3 : 1);
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (is_long && text.substr(i).starts_with(three)) {
            i += 3;
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i;  // belong to the string
            return i;
        } else if (!is_long && (text[i] == quote || text[i] == '\n')) {
            return text[i] == quote ? i + 1 : i;  // toml++ refuses an open one
        }
    }
    return text.size();
}

WorldPlace place_at(std::string_view text, std::size_t at) {
    WorldPlace place{1, 1};
    for (const char c : text.substr(0, at))
        place = c == '\n' ? WorldPlace{place.line + 1, 1} : WorldPlace{place.line, place.column + 1};
    return place;
}

/// toml++ descends into dotted keys by calling itself, so their length is bounded before it sees them. Comments and
/// the inside of strings do not count.
void check_dotted_keys(std::string_view text) {
    constexpr int most_dots = 64;
    int dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            i = end_of_string(text, i);
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        const bool may_be_key = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                                c == '_' || c == '-' || c == ' ' || c == '\t';
        dots = c == '.' ? dots + 1 : may_be_key ? dots : 0;
        if (dots > most_dots)
            throw Error(ErrorCode::bad_file, "a key of more than 64 parts", to_text(place_at(text, i)));
        ++i;
    }
}

bool is_taken(std::string_view text) {
    try {
        (void)toml::parse(text);
    } catch (const toml::parse_error&) {  // an end that is too early: the fault lies behind it
    } catch (const TomlFault&) {
        return false;
    }
    return true;
}

/// The place at which toml++ gives up: the shortest beginning of the text that makes it.
WorldPlace place_of_fault(std::string_view text) {
    std::size_t taken = 0, refused = text.size();
    while (refused - taken > 1) {
        const std::size_t middle = taken + (refused - taken) / 2;
        (is_taken(text.substr(0, middle)) ? taken : refused) = middle;
    }
    return place_at(text, taken);
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
    } catch (const TomlFault&) {
        throw Error(ErrorCode::bad_file, "not TOML: a key or a value is expected here", to_text(place_of_fault(text)));
    }
}

}  // namespace rakelight::io::world
