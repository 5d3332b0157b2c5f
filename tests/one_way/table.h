// SPDX-License-Identifier: Apache-2.0
// The table of settings.json: an example of each key of [render].
#pragma once
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <rakelight/io/world.h>

#include "support/shared.h"

namespace rakelight::test {

struct Example {
    std::string name;  ///< the key; behind a blank what makes it another example of it
    std::vector<WorldValue> values;
    std::map<std::string, std::string> differs;  ///< way -> reason
    std::string same;                            ///< why the key changes nothing; empty: it does
    std::string needs;                           ///< an engine
    std::string key() const { return name.substr(0, name.find(' ')); }
    std::vector<WorldValue> without_key() const {
        std::vector<WorldValue> others = values;
        std::erase_if(others, [&](const WorldValue& value) { return value.key == key(); });
        return others;
    }
};

struct Table {
    std::vector<WorldValue> base;
    std::vector<Example> examples;
};

namespace table_parts {

inline WorldValue value_of(const std::string& key, const nlohmann::json& words) {
    WorldValue value{.key = key, .words = words.get<std::vector<std::string>>()};
    if (names_files(value))
        for (std::string& word : value.words) word = (source_dir() / word).string();
    return value;
}

inline void put(std::vector<WorldValue>& values, WorldValue value) {
    std::erase_if(values, [&](const WorldValue& other) { return other.key == value.key; });
    values.push_back(std::move(value));
}

inline Example example_of(const std::string& name, const nlohmann::json& row, const std::vector<WorldValue>& base) {
    Example example{.name = name, .values = base};
    const nlohmann::json without = row.value("without", nlohmann::json::array());
    const nlohmann::json with = row.value("with", nlohmann::json::object());
    for (const auto& key : without)
        std::erase_if(example.values, [&](const WorldValue& value) { return value.key == key.get<std::string>(); });
    for (const auto& [key, words] : with.items()) put(example.values, value_of(key, words));
    put(example.values, value_of(example.key(), row.at("words")));
    example.differs = row.value("differs", std::map<std::string, std::string>());
    example.same = row.value("same", ""), example.needs = row.value("needs", "");
    return example;
}

}  // namespace table_parts

inline Table read_table() {
    std::ifstream file(source_dir() / "tests/one_way/settings.json");
    const auto document = nlohmann::ordered_json::parse(file);
    Table table;
    for (const auto& [key, words] : document.at("base").items())
        table.base.push_back(table_parts::value_of(key, words));
    for (const auto& [name, row] : document.at("keys").items())
        table.examples.push_back(table_parts::example_of(name, row, table.base));
    return table;
}

}  // namespace rakelight::test
