// SPDX-License-Identifier: Apache-2.0
// An inspection for people: lines, then sections with a table each.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include <rakelight/tools/inspect.h>
#include <rakelight_internal/base/text.h>

#include "tools/text_table.h"

namespace rakelight {

inline constexpr std::size_t max_rows = 40;  ///< of each table

inline std::string number(double value, const char* format = "%.6g") {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

inline std::string position_text(dvec3 p) { return number(p.x) + " " + number(p.y) + " " + number(p.z); }

/// A table with its title and a note below it.
struct Section {
    std::string title;
    TextTable table;   ///< may have no rows
    std::string note;  ///< a line without its end, or empty
    bool empty() const { return table.empty() && note.empty(); }
};

/// The table is cut to `most` rows; it has no rows when the list is empty.
template <class List, class AddRow>
Section section(const char* title, std::vector<std::string> head, const List& list, const AddRow& add_row,
                std::size_t left_out = 0, std::size_t most = max_rows) {
    TextTable table(std::move(head));
    const std::size_t shown = list.size() < most ? list.size() : most;
    for (std::size_t i = 0; i < shown; ++i) table.add(add_row(list[i], i));
    const std::size_t more = list.size() - shown + left_out;
    return {title, std::move(table), more ? "... " + std::to_string(more) + " more, all of them in the JSON" : ""};
}

/// The lines above all tables: "3 objects, ...", bounds, "300 positions shared by meshes, ..."; without line ends.
std::vector<std::string> summary_lines(const Inspection& inspection);
/// All tables, those that are empty left out.
std::vector<Section> sections_of(const Inspection& inspection);

}  // namespace rakelight
