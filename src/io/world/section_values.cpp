// SPDX-License-Identifier: Apache-2.0
#include "io/world/section_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/format_text.h"
#include "math/color.h"
#include "math/color_names.h"
#include "math/linear.h"

namespace rakelight::io::world {
namespace {

std::string text_of(double number) {
    char text[32];
    const auto [end, fault] = std::to_chars(text, text + sizeof text, number);
    return {text, fault == std::errc() ? end : text};
}

std::string in_quotes(std::string_view text) { return "'" + one_line(std::string(text), 40) + "'"; }

const char* expectation(Kind kind) {
    switch (kind) {
        case Kind::text:
        case Kind::file:
        case Kind::word:
            return "a text in quotes";
        case Kind::flag:
            return "true or false";
        case Kind::number:
            return "a number";
        case Kind::integer:
            return "a whole number";
        case Kind::pair:
            return "two numbers in brackets";
        case Kind::integers:
            return "two whole numbers in brackets";
        case Kind::vector:
            return "three numbers in brackets";
        case Kind::scale:
            return "a number, or three in brackets";
        case Kind::color:
            return "three numbers in brackets, or a text like '#ff8000' or 'orange'";
        case Kind::tables:
            return "a list of tables";
    }
    return "";
}

/// The same of KEY=VALUE on a command line.
std::string expectation_of_words(Kind kind, const std::string& key) {
    switch (kind) {
        case Kind::flag:
            return "on or off";
        case Kind::pair:
        case Kind::integers:
            return std::string(kind == Kind::pair ? "two numbers" : "two whole numbers") + ", as in " + key + "=2,3";
        case Kind::vector:
            return "three numbers, as in " + key + "=1,2,3";
        case Kind::scale:
            return "a number, or three as in " + key + "=1,2,3";
        case Kind::color:
            return "three numbers, as in " + key + "=1,0.5,0, or a code or name, as in " + key + "=#ff8000";
        default:
            return expectation(kind);
    }
}

/// A value as it was written on a command line.
std::string words_of(const TomlNode& node) {
    if (node.kind == TomlNode::Kind::number) return text_of(node.number);
    if (node.kind != TomlNode::Kind::array)
        return node.kind == TomlNode::Kind::flag ? (node.flag ? "on" : "off") : node.text;
    std::string all;
    for (const TomlNode& item : node.items) all += words_of(item) + ",";
    return all.substr(0, all.size() - 1);
}

std::size_t count_of(Kind kind) {
    return kind == Kind::pair || kind == Kind::integers ? 2 : kind == Kind::number || kind == Kind::integer ? 1 : 3;
}

/// One reading of a key's value.
class ValueReader {
public:
    ValueReader(const WorldKey& key, const TomlEntry& entry, Written written)
        : key_(key), entry_(entry), written_(written) {}

    WorldValue read() const {
        WorldValue value{.key = entry_.key, .words = {}, .numbers = {}, .place = entry_.value.place};
        const TomlNode& node = entry_.value;
        switch (key_.kind) {
            case Kind::text:
            case Kind::file:
            case Kind::word:
                value.words.push_back(read_text(node));
                return value;
            case Kind::flag:
                if (node.kind != TomlNode::Kind::flag) refuse(node);
                value.words.emplace_back(node.flag ? "on" : "off");
                value.numbers.push_back(node.flag ? 1 : 0);
                return value;
            default:
                value.numbers = read_numbers(node);
                for (const double x : value.numbers) value.words.push_back(text_of(x));
                return value;
        }
    }

private:
    [[noreturn]] void refuse(const TomlNode& node) const {
        if (written_ == Written::as_words)
            fail(node.place, in_quotes(entry_.key) + " must be " + expectation_of_words(key_.kind, entry_.key) +
                                 ", not " + in_quotes(words_of(entry_.value)));
        const std::string found = node.kind == TomlNode::Kind::other ? node.text : name_of(node.kind);
        fail(node.place, in_quotes(entry_.key) + " must be " + expectation(key_.kind) + ", not " + found);
    }

    std::string read_text(const TomlNode& node) const {
        if (node.kind != TomlNode::Kind::text) refuse(node);
        if (node.text.empty()) fail(node.place, in_quotes(entry_.key) + " is empty");
        if (node.text.find('\0') != std::string::npos) fail(node.place, in_quotes(entry_.key) + " holds a zero byte");
        if (key_.kind != Kind::word) return node.text;
        for (const char* const word : key_.words)
            if (same_word(node.text, word)) return word;
        fail(node.place, in_quotes(entry_.key) + " has an unknown word " + in_quotes(node.text),
             advice_for(node.text, key_.words));
    }

    double read_number(const TomlNode& node) const {
        const bool is_integer = key_.kind == Kind::integer || key_.kind == Kind::integers;
        if (node.kind != TomlNode::Kind::number) refuse(node);
        if (is_integer && !node.is_whole)
            fail(node.place,
                 in_quotes(entry_.key) + " must be " + expectation(key_.kind) + ", not " + text_of(node.number));
        const double x = node.number;
        const Range r = key_.kind == Kind::color ? from_0 : key_.range;
        if (!std::isfinite(x)) fail(node.place, in_quotes(entry_.key) + " must be a finite number");
        if (r.is_open ? x > r.low && x < r.high : x >= r.low && x <= r.high) return x;
        std::string limits;
        if (r.low > -1e29 || x < r.low) limits = (r.is_open ? " more than " : " at least ") + text_of(r.low);
        if (r.high < 1e29 || x > r.high)
            limits +=
                (limits.empty() ? "" : " and") + std::string(r.is_open ? " less than " : " at most ") + text_of(r.high);
        fail(node.place, in_quotes(entry_.key) + " is " + text_of(x) + ", but must be" + limits);
    }

    std::vector<double> read_numbers(const TomlNode& node) const {
        if (key_.kind == Kind::color && node.kind == TomlNode::Kind::text) return read_color_text(node);
        if (key_.kind == Kind::number || key_.kind == Kind::integer) return {read_number(node)};
        if (key_.kind == Kind::scale && node.kind == TomlNode::Kind::number)
            return std::vector<double>(3, read_number(node));
        if (node.kind != TomlNode::Kind::array || node.items.size() != count_of(key_.kind)) {
            if (node.kind == TomlNode::Kind::array && written_ == Written::in_file)
                fail(node.place, format_text("{} must be {}, not {} values", in_quotes(entry_.key),
                                             expectation(key_.kind), node.items.size()));
            refuse(node);
        }
        std::vector<double> numbers;
        for (const TomlNode& item : node.items) numbers.push_back(read_number(item));
        return numbers;
    }

    std::vector<double> read_color_text(const TomlNode& node) const {
        const auto codes = color_by_text(node.text);
        if (!codes) refuse(node);
        std::vector<double> linear;
        for (const std::uint8_t code : *codes) linear.push_back(double(linear_from_srgb8(code)));
        return linear;
    }

    const WorldKey& key_;
    const TomlEntry& entry_;
    Written written_;
};

void add_scalar(const TomlNode& node, const TomlEntry& entry, WorldValue& value) {
    switch (node.kind) {
        case TomlNode::Kind::text:
            if (node.text.empty() || node.text.find('\0') != std::string::npos)
                fail(node.place, in_quotes(entry.key) + " is empty or holds a zero byte");
            value.words.push_back(node.text);
            return;
        case TomlNode::Kind::flag:
            value.words.emplace_back(node.flag ? "on" : "off");
            return;
        case TomlNode::Kind::number:
            if (!std::isfinite(node.number)) fail(node.place, in_quotes(entry.key) + " must be a finite number");
            value.words.push_back(text_of(node.number));
            value.numbers.push_back(node.number);
            return;
        default:
            fail(node.place, in_quotes(entry.key) +
                                 " must be a text, a number, true, false, or an array of such, not " +
                                 name_of(node.kind));
    }
}

}  // namespace

void fail(WorldPlace place, std::string reason, std::string advice) {
    throw Error(ErrorCode::bad_file, std::move(reason), to_text(place), std::move(advice));
}

std::string advice_for(std::string_view word, const std::vector<const char*>& names, std::size_t most) {
    const std::string near = nearest_word(word, {names.begin(), names.end()});
    if (!near.empty()) return "did you mean '" + near + "'?";
    return "there is " + list_of_names({names.begin(), names.end()}, most);
}

SectionValues::SectionValues(const TomlNode& table, const WorldSection& section, Written written)
    : place_(table.place) {
    const std::string title =
        (section.is_array ? "[[" : "[") + std::string(section.name) + (section.is_array ? "]]" : "]");
    for (const TomlEntry& entry : table.entries) {
        const auto key = std::find_if(section.keys.begin(), section.keys.end(),
                                      [&](const WorldKey& k) { return entry.key == k.name; });
        if (key == section.keys.end()) {
            std::vector<const char*> names;
            for (const WorldKey& k : section.keys) names.push_back(k.name);
            fail(entry.place, "unknown key " + in_quotes(entry.key) + " in " + title, advice_for(entry.key, names));
        }
        if (key->kind == Kind::tables)
            read_tables(entry, *key, section);
        else
            values_.push_back(ValueReader(*key, entry, written).read());
    }
    for (const WorldKey& key : section.keys)
        if (key.is_required && !has(key.name)) fail(place_, title + " lacks the key '" + key.name + "'");
}

void SectionValues::read_tables(const TomlEntry& entry, const WorldKey& key, const WorldSection& section) {
    constexpr std::size_t most_tables = 10'000;
    const std::vector<TomlNode>& items = entry.value.items;
    const auto is_table = [](const TomlNode& item) { return item.kind == TomlNode::Kind::table; };
    if (entry.value.kind != TomlNode::Kind::array || !std::ranges::all_of(items, is_table))
        fail(entry.value.place, in_quotes(entry.key) + " must be " + expectation(key.kind), "write [{ ... }, { ... }]");
    if (items.empty()) fail(entry.value.place, in_quotes(entry.key) + " is empty");
    if (items.size() > most_tables)
        fail(entry.value.place, format_text("more than {} of {}", most_tables, in_quotes(entry.key)));
    const std::string name = std::string(section.name) + "." + key.name;
    const WorldSection of_tables{name.c_str(), true, key.help, key.parts};
    for (const TomlNode& item : items) tables_.emplace_back(item, of_tables);
    values_.push_back({.key = entry.key, .words = {}, .numbers = {}, .place = entry.value.place});
}

const WorldValue* SectionValues::find(std::string_view key) const {
    const auto value = std::ranges::find(values_, key, &WorldValue::key);
    if (value != values_.end()) return &*value;
    for (const SectionValues& table : tables_)
        if (const WorldValue* const first = table.find(key)) return first;
    return nullptr;
}

WorldPlace SectionValues::place_of(std::string_view key) const {
    const WorldValue* const value = find(key);
    return value ? value->place : place_;
}

std::string SectionValues::text(std::string_view key, const std::string& otherwise) const {
    const WorldValue* const value = find(key);
    return value ? value->words[0] : otherwise;
}

double SectionValues::number(std::string_view key, double otherwise) const {
    const WorldValue* const value = find(key);
    return value ? value->numbers[0] : otherwise;
}

bool SectionValues::flag(std::string_view key, bool otherwise) const { return number(key, otherwise ? 1 : 0) != 0; }

dvec3 SectionValues::vector(std::string_view key, dvec3 otherwise) const {
    const WorldValue* const value = find(key);
    return value ? dvec3{value->numbers[0], value->numbers[1], value->numbers[2]} : otherwise;
}

vec3 SectionValues::color(std::string_view key, vec3 otherwise) const {
    const WorldValue* const value = find(key);
    return value ? cast<float>(vector(key, {})) : otherwise;
}

dvec3 SectionValues::direction(std::string_view key, dvec3 otherwise) const {
    const dvec3 d = vector(key, otherwise);
    const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    if (largest == 0) fail(place_of(key), in_quotes(key) + " must not be zero");
    return normalize_or(d * (1 / largest), d);  // first, so that the squares cannot overflow or vanish
}

WorldValue free_value(const TomlEntry& entry) {
    WorldValue value{.key = entry.key, .words = {}, .numbers = {}, .place = entry.value.place};
    value.is_array = entry.value.kind == TomlNode::Kind::array;
    if (!value.is_array) {
        add_scalar(entry.value, entry, value);
        return value;
    }
    if (entry.value.items.empty()) fail(value.place, in_quotes(entry.key) + " is empty");
    for (const TomlNode& item : entry.value.items) add_scalar(item, entry, value);
    if (value.numbers.size() != value.words.size()) value.numbers.clear();
    return value;
}

}  // namespace rakelight::io::world
