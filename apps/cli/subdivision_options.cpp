// SPDX-License-Identifier: Apache-2.0
#include "subdivision_options.h"

#include "option_table.h"
#include "values.h"

namespace rakelight::cli {
namespace {

using W = SubdivisionWords;
constexpr const char* group = "Subdivision";

constexpr OptionEntry<W> which[] = {
    {group, "--subdivide", &W::level, "N", "The model is a control net: every edge becomes 2^N, 0 (default) to 8"},
    {group, "--subdivide-edge", &W::edge, "M", "As many levels as make edges M meters long, at most 8 or --subdivide"},
};
constexpr OptionEntry<W> how[] = {
    {group, "--subdivide-scheme", &W::scheme, "NAME",
     "auto (default: by the polygons of the file), catmull-clark, loop (triangles)"},
    {group, "--subdivide-crease", &W::crease, "DEG", "Edges bent more are creases, 0 to 180 (default: none are)"},
    {group, "--subdivide-sharpness", &W::sharpness, "S",
     "Creases stay sharp for S levels, 0 to 10 (default 10: for ever)"},
    {group, "--subdivide-boundary", &W::boundary, "RULE",
     "edge-and-corner (default), edge: boundary vertices of one face are rounded off too"},
    {group, "--subdivide-uv", &W::uv, "RULE",
     "Texture coordinates: boundaries (default: rims of charts stay straight), smooth, linear"},
};

}  // namespace

void add_subdivision_options(CLI::App& app, SubdivisionWords& words) {
    add_table<W>(app, which, words);
    add_table<W>(app, how, words);
}

void apply(const SubdivisionWords& w, Subdivision& s) {
    if (!w.edge.empty()) {
        s.edge = number("--subdivide-edge", w.edge, 1e-6, 1e6);
        s.level = 8;
    }
    if (!w.level.empty()) s.level = integer("--subdivide", w.level, 0, 8);
    if (!w.scheme.empty()) s.scheme = word("--subdivide-scheme", w.scheme, subdivision_scheme_words);
    if (!w.crease.empty()) s.crease_angle_rad = radians(number("--subdivide-crease", w.crease, 0, 180));
    if (!w.sharpness.empty()) s.sharpness = number("--subdivide-sharpness", w.sharpness, 0, 10);
    if (!w.boundary.empty()) s.round_corners = word("--subdivide-boundary", w.boundary, subdivision_boundary_words);
    if (!w.uv.empty()) s.uv = word("--subdivide-uv", w.uv, subdivision_uv_words);
    const char* const idle = first_given<W>(how, w);
    if (idle && w.level.empty() && w.edge.empty())
        throw Error(ErrorCode::usage, std::string(idle) + " says how to subdivide, but nothing is to be subdivided", {},
                    "add --subdivide 3");
}

}  // namespace rakelight::cli
