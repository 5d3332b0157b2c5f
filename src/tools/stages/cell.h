// SPDX-License-Identifier: Apache-2.0
// The values of a stage's tables: numbers, texts and lists of them. They spare the stages the JSON library, which is slow to
// compile.
#pragma once
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rakelight::stages {

class Cell {
public:
    using List = std::vector<Cell>;

    Cell(std::integral auto value) : value(std::int64_t(value)) {}
    Cell(std::floating_point auto value) : value(double(value)) {}
    Cell(std::string text) : value(std::move(text)) {}
    Cell(const char* text) : value(std::string(text)) {}
    Cell(List list) : value(std::move(list)) {}
    Cell(std::initializer_list<Cell> list) : value(List(list)) {}

    /// Null: it is none.
    const List* list() const { return std::get_if<List>(&value); }

    std::variant<std::int64_t, double, std::string, List> value;
};

/// Values by name, in the order in which they were added.
class Numbers : public std::vector<std::pair<std::string, Cell>> {
public:
    using vector::vector;
    using vector::operator[];
    Cell& operator[](const std::string& name) {
        for (auto& [known, value] : *this)
            if (known == name) return value;
        return emplace_back(name, 0).second;
    }
};

}  // namespace rakelight::stages
