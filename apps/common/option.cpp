// SPDX-License-Identifier: Apache-2.0
#include "option.h"

#include <algorithm>
#include <cassert>

namespace rakelight::apps {

const Option* find_or_null(const std::vector<Option>& options, std::string_view name) {
    const auto found = std::ranges::find_if(
        options, [&](const Option& option) { return option.name == name || (option.also && option.also == name); });
    return found == options.end() ? nullptr : &*found;
}

Option& find(std::vector<Option>& options, std::string_view name) {
    const Option* const option = find_or_null(options, name);
    assert(option != nullptr);
    return options[std::size_t(option - options.data())];
}

std::vector<Option> without(std::vector<Option> options, std::initializer_list<std::string_view> names) {
    std::erase_if(options, [&](const Option& option) {
        return std::ranges::find(names, std::string_view(option.name)) != names.end();
    });
    return options;
}

const WorldValue* Given::find(std::string_view name) const {
    for (const std::vector<WorldValue>* const list : {&values_, &settings_})
        if (const auto value = std::ranges::find(*list, name, &WorldValue::key); value != list->end()) return &*value;
    return nullptr;
}

bool Given::has(std::string_view name) const { return find(name) != nullptr; }

std::string Given::word(std::string_view name) const {
    const WorldValue* const value = find(name);
    return value ? value->words.at(0) : std::string();
}

std::vector<std::string> Given::words(std::string_view name) const {
    const WorldValue* const value = find(name);
    return value ? value->words : std::vector<std::string>();
}

std::string_view Given::first_of(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
        if (has(name)) return name;
    return {};
}

}  // namespace rakelight::apps
