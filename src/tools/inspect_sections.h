// SPDX-License-Identifier: Apache-2.0
// Sections of an inspection for people.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include <rakelight/inspect.h>

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

/// A table under its title, cut to max_rows; nothing when the list is empty.
template <class List, class AddRow>
std::string section(const char* title, std::vector<std::string> head, const List& list, const AddRow& add_row,
                    std::size_t left_out = 0) {
    if (list.empty()) return {};
    TextTable table(std::move(head));
    const std::size_t shown = list.size() < max_rows ? list.size() : max_rows;
    for (std::size_t i = 0; i < shown; ++i) table.add(add_row(list[i], i));
    const std::size_t more = list.size() - shown + left_out;
    return std::string(title) + "\n" + table.text("  ") +
           (more ? "  ... " + std::to_string(more) + " more, all of them in the JSON\n" : "");
}

/// "300 positions shared by objects, ..." with a line feed.
std::string seams_line(const Inspection& inspection);
/// "closed body of 960 triangles: 'shell' and 13 more objects"
std::string inside_out_text(const Inspection& inspection, const InsideOutBody& body);
/// Edges, faces and normals of each object, worst first.
std::string surfaces_text(const Inspection& inspection);
/// Pairs of objects, worst first.
std::string borders_text(const Inspection& inspection);

}  // namespace rakelight
