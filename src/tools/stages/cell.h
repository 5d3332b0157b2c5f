// SPDX-License-Identifier: Apache-2.0
// The values of a stage's tables: numbers, texts and lists of them. They spare the stages the JSON library, which is slow to
// compile.
#pragma once
#include <charconv>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace rakelight::stages {

struct Cell {
    using List = std::vector<Cell>;
    enum class Kind : std::uint8_t { whole, number, text, list };

    Cell(std::integral auto v) : kind(Kind::whole), whole(std::int64_t(v)) {}
    Cell(std::floating_point auto v) : kind(Kind::number), number(double(v)) {}
    Cell(std::string v) : kind(Kind::text), text(std::move(v)) {}
    Cell(const char* v) : kind(Kind::text), text(v) {}
    Cell(List v) : kind(Kind::list), list(std::move(v)) {}
    Cell(std::initializer_list<Cell> v) : kind(Kind::list), list(v) {}

    // The member that `kind` names is the value.
    Kind kind;
    std::int64_t whole = 0;
    double number = 0;
    std::string text;
    List list;
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

/// A number for people: at most so many digits.
inline std::string digits(double value, int most = 7) {
    char buffer[64];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, most).ptr};
}

}  // namespace rakelight::stages
