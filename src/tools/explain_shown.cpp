// SPDX-License-Identifier: Apache-2.0
// Which object an explained pixel shows; where none is, the nearest pixel that shows one.
#include <rakelight/error.h>

#include "tools/explained_pixel.h"
#include "tools/shortest_digits.h"

namespace rakelight {
namespace {

using raster::CoveringTriangle;
using raster::Fate;

std::string named(const char* kind, const std::string& name, std::uint32_t index) {
    if (index == no_index) return std::string("no ") + kind;
    return kind + (name.empty() ? " number " + digits(index) : " '" + one_line(name, 60) + "'");
}

std::string names_text(const ExplainedPixel& e, const CoveringTriangle& t) {
    const TriangleNames n = names_of(e, t);
    return named("object", n.object, n.node) + ", " + named("mesh", n.mesh, n.mesh_index) + ", " +
           named("material", n.material, n.material_index);
}

Json names_json(const ExplainedPixel& e, const CoveringTriangle& t) {
    const TriangleNames n = names_of(e, t);
    const auto index = [](std::uint32_t i) { return i == no_index ? Json() : Json(i); };
    return {{"object", n.object},
            {"node", index(n.node)},
            {"mesh_name", n.mesh},
            {"mesh", index(n.mesh_index)},
            {"triangle", t.triangle},
            {"material_name", n.material},
            {"material", index(n.material_index)}};
}

std::string nearest_text(const ExplainedPixel& e) {
    const CoveringTriangle* const t = e.nearest ? shown_triangle(*e.nearest) : nullptr;
    if (!t) return "; no other pixel shows a surface either\n";
    return "; the nearest pixel that shows something is " + digits(e.nearest->x) + "," + digits(e.nearest->y) + ": " +
           names_text(e, *t) + "\n";
}

}  // namespace

const CoveringTriangle* shown_triangle(const raster::PixelExplanation& pixel) {
    for (const CoveringTriangle& t : pixel.triangles)
        if (t.fate == Fate::visible || t.fate == Fate::blended) return &t;
    return nullptr;
}

std::string shown_text(const ExplainedPixel& e) {
    if (const CoveringTriangle* const t = shown_triangle(e.pixel)) return "  shows " + names_text(e, *t) + "\n";
    const bool is_covered = !e.pixel.triangles.empty();
    return std::string("  background: ") +
           (is_covered ? "none of the triangles that cover it is drawn" : "no triangle covers it") + nearest_text(e);
}

void add_shown(Json& row, const ExplainedPixel& e) {
    const CoveringTriangle* const t = shown_triangle(e.pixel);
    row["shows"] = t ? names_json(e, *t) : Json();
    if (t) return;
    const CoveringTriangle* const near = e.nearest ? shown_triangle(*e.nearest) : nullptr;
    row["nearest"] = near ? names_json(e, *near) : Json();
    if (near) row["nearest"]["pixel"] = {e.nearest->x, e.nearest->y};
}

}  // namespace rakelight
