// SPDX-License-Identifier: Apache-2.0
// Rows of a name, numbers and a note, for explained pixels.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include <rakelight/math/vector.h>

#include "tools/shortest_digits.h"
#include "tools/text_table.h"

namespace rakelight {

/// "name   x  y  z  note" lines.
class Values {
public:
    explicit Values(std::size_t columns) : columns_(columns), table_(head(columns)) {}
    template <std::size_t n>
    void add(const std::string& name, const float (&v)[n], const std::string& note = "") {
        std::vector<std::string> cells{name};
        for (const float f : v) cells.push_back(digits(f));
        fill(std::move(cells), note);
    }
    void add(const std::string& name, dvec3 v, const std::string& note = "") {
        fill({name, digits(v.x), digits(v.y), digits(v.z)}, note);
    }
    void add(const std::string& name, float v, const std::string& note = "") { fill({name, digits(v)}, note); }
    void add(const std::string& name, vec4 v, const std::string& note = "") {
        fill({name, digits(v.x), digits(v.y), digits(v.z), digits(v.w)}, note);
    }
    void title(const std::string& name) { fill({name}, ""); }
    bool empty() const { return table_.empty(); }
    std::string text(const char* indent) const {
        const std::string whole = table_.text(indent);
        return whole.substr(whole.find('\n') + 1);  // the head is empty
    }

private:
    static std::vector<std::string> head(std::size_t columns) {
        std::vector<std::string> cells{""};
        cells.insert(cells.end(), columns, ">");
        cells.push_back("");
        return cells;
    }
    void fill(std::vector<std::string> cells, const std::string& note) {
        cells.resize(columns_ + 1);
        cells.push_back(note);
        table_.add(std::move(cells));
    }
    std::size_t columns_;
    TextTable table_;
};

}  // namespace rakelight
