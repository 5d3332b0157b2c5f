// SPDX-License-Identifier: Apache-2.0
// Seams and faults of an inspection for people.
#pragma once
#include <string>
#include <vector>

#include "tools/inspect/inspect_text.h"

namespace rakelight {

/// One line on automatic creases, or none.
std::vector<std::string> crease_lines(const Inspection& inspection);
/// What decides normals.
std::vector<std::string> choice_lines(const Inspection& inspection);
std::vector<std::string> seams_lines(const Inspection& inspection);
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
