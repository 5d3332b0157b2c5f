// SPDX-License-Identifier: Apache-2.0
// Which object an explained pixel shows; where none is, the nearest pixel that shows one.
#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>

#include "tools/explain/explain.h"
#include "tools/object_title.h"
#include "tools/shortest_digits.h"

namespace rakelight {
namespace {

using raster::CoveringTriangle;
using raster::Fate;

std::string named(const char* kind, const std::string& name, std::uint32_t index) {
    if (index == no_index) return std::string("no ") + kind;
    return kind + (name.empty() ? " number " + digits(index) : " '" + one_line(name, 60) + "'");
}

std::string names_text(const TriangleNames& n) {
    return named("object", n.object, n.node) + ", " + named("mesh", n.mesh, n.mesh_index) + ", " +
           named("material", n.material, n.material_index);
}

Json names_json(const TriangleNames& n) {
    const auto index = [](std::uint32_t i) { return i == no_index ? Json() : Json(i); };
    return {{"object", n.object},          {"node", index(n.node)},       {"mesh_name", n.mesh},
            {"mesh", index(n.mesh_index)}, {"material_name", n.material}, {"material", index(n.material_index)}};
}

/// A line or a point, as names_of() has a triangle's.
TriangleNames names_of(const ExplainedPixel& e, const raster::VisibleMark& mark) {
    const Scene& scene = e.engine->list().scene;
    TriangleNames n;
    n.node = mark.node, n.mesh_index = mark.mesh, n.material_index = mark.material;
    n.object = object_title(scene, mark.node), n.mesh = scene.meshes[mark.mesh].name;
    if (mark.material != no_index) n.material = scene.materials[mark.material].name;
    return n;
}

std::string nearest_text(const ExplainedPixel& e) {
    const CoveringTriangle* const t = e.nearest ? visible_triangle(*e.nearest) : nullptr;
    if (!t) return "; no other pixel shows a surface either\n";
    return "; the nearest pixel that shows something is " + digits(e.nearest->x) + "," + digits(e.nearest->y) + ": " +
           names_text(names_of(e, *t)) + "\n";
}

Json visible_triangle_json(const ExplainedPixel& e, const CoveringTriangle& t) {
    Json out = names_json(names_of(e, t));
    out["triangle"] = t.triangle;
    return out;
}

Json mark_json(const ExplainedPixel& e, const raster::VisibleMark& mark) {
    Json out = names_json(names_of(e, mark));
    out["kind"] = mark.is_point ? "point" : "line";
    return out;
}

}  // namespace

const CoveringTriangle* visible_triangle(const raster::PixelExplanation& pixel) {
    for (const CoveringTriangle& t : pixel.triangles)
        if (t.fate == Fate::visible || t.fate == Fate::blended) return &t;
    return nullptr;
}

std::string visible_text(const ExplainedPixel& e) {
    if (const auto& mark = e.pixel.mark)
        return std::string("  shows a ") + (mark->is_point ? "point" : "line") + " of " +
               names_text(names_of(e, *mark)) + "; not lit\n";
    if (const CoveringTriangle* const t = visible_triangle(e.pixel))
        return "  shows " + names_text(names_of(e, *t)) + "\n";
    const bool is_covered = !e.pixel.triangles.empty();
    return std::string("  background: ") +
           (is_covered ? "none of the triangles that cover it is drawn" : "no triangle covers it") + nearest_text(e);
}

void add_visible(Json& row, const ExplainedPixel& e) {
    const CoveringTriangle* const t = visible_triangle(e.pixel);
    row["shows"] = e.pixel.mark ? mark_json(e, *e.pixel.mark) : t ? visible_triangle_json(e, *t) : Json();
    if (t || e.pixel.mark) return;
    const CoveringTriangle* const near = e.nearest ? visible_triangle(*e.nearest) : nullptr;
    row["nearest"] = near ? visible_triangle_json(e, *near) : Json();
    if (near) row["nearest"]["pixel"] = {e.nearest->x, e.nearest->y};
}

}  // namespace rakelight
