// SPDX-License-Identifier: Apache-2.0
// Sections of an inspection for people.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include <rakelight/tools/inspect.h>

#include "tools/text_table.h"

namespace rakelight {

inline constexpr std::size_t max_rows = 40;  ///< of each table

inline std::string number(double value, const char* format = "%.6g") {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

inline std::string counted(std::uint64_t count, const char* thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
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
/// One line on automatic creases, or none.
std::vector<std::string> crease_lines(const Inspection& inspection);
/// What decides normals.
std::vector<std::string> choice_lines(const Inspection& inspection);
std::vector<std::string> seams_lines(const Inspection& inspection);
/// All tables, those that are empty left out.
std::vector<Section> sections_of(const Inspection& inspection);
/// "closed body of 960 triangles: 'shell' and 13 more objects"
std::string inside_out_text(const Inspection& inspection, const InsideOutBody& body);
/// Edges, faces and normals of each object, worst first.
Section surfaces_section(const Inspection& inspection);
Section t_junctions_section(const Inspection& inspection);
Section inside_out_section(const Inspection& inspection);
/// Pairs of objects, worst first.
Section borders_section(const Inspection& inspection);
/// Borders that run along each other: the matched ones and their seams; or, if not requested, that there are some.
std::vector<std::string> matched_lines(const Inspection& inspection);
inline constexpr const char* matched_title = "borders that run along each other (degrees)";
Section matched_section(const Inspection& inspection);

}  // namespace rakelight
