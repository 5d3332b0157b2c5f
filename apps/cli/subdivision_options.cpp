// SPDX-License-Identifier: Apache-2.0
#include "subdivision_options.h"

#include "option_table.h"

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

void add_values(const SubdivisionWords& words, std::vector<WorldValue>& values) {
    add_values<W>(which, words, values);
    add_values<W>(how, words, values);
}

}  // namespace rakelight::cli
