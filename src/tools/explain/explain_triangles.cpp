// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_triangles.h"

#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>

#include "tools/object_title.h"
#include "tools/shortest_digits.h"
#include "tools/text_table.h"

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

/// The nearest surface visible at a pixel; null: none.
const CoveringTriangle* visible_triangle(const raster::PixelExplanation& pixel) {
    for (const CoveringTriangle& t : pixel.triangles)
        if (t.fate == Fate::visible || t.fate == Fate::blended) return &t;
    return nullptr;
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

std::string in_px(int sixteenths) { return digits(double(sixteenths) / 16); }

char letter_of(Fate fate) {
    switch (fate) {
        case Fate::visible:
            return 'V';
        case Fate::blended:
            return 'B';
        case Fate::masked_out:
            return 'M';
        case Fate::hidden:
            return 'H';
        case Fate::culled_back:
        case Fate::culled_front:
            return 'C';
    }
    return ' ';
}

/// Pictures of several samples: a letter a sample, V visible, B blended, M masked out, H hidden, C culled, - not
/// covered.
std::string letters_of_samples(const ExplainedPixel& e, const raster::CoveringTriangle& triangle) {
    std::string letters(e.pixel.samples.size(), '-');
    for (const raster::CoveredSample& s : triangle.samples) letters[std::size_t(s.sample)] = letter_of(s.fate);
    return letters;
}

std::string fate_text(raster::Fate fate) {
    switch (fate) {
        case raster::Fate::visible:
            return "visible";
        case raster::Fate::blended:
            return "blended: laid over the surfaces behind";
        case raster::Fate::hidden:
            return "hidden: a nearer one is in front";
        case raster::Fate::masked_out:
            return "masked out: alpha below the cutoff";
        case raster::Fate::culled_back:
            return "culled: seen from behind";
        case raster::Fate::culled_front:
            return "culled: seen from the front";
    }
    return {};
}

std::string covering_text(const ExplainedPixel& e) {
    const bool has_samples = e.pixel.samples.size() > 1;
    std::vector<std::string> head = {">#",   "object",        "mesh",       ">triangle", "material",
                                     "side", ">distance [m]", ">depth key", ">alpha",    "result"};
    if (has_samples) head.insert(head.end() - 1, "samples");
    TextTable table(head);
    for (std::size_t i = 0; i < e.pixel.triangles.size(); ++i) {
        const CoveringTriangle& t = e.pixel.triangles[i];
        const TriangleNames n = names_of(e, t);
        std::vector<std::string> cells = {digits(i),
                                          name_or_number(n.object, n.node),
                                          name_or_number(n.mesh, n.mesh_index),
                                          digits(t.triangle),
                                          name_or_number(n.material, n.material_index),
                                          t.is_back ? "back" : "front",
                                          digits(t.distance),
                                          digits(t.depth_key),
                                          digits(t.alpha),
                                          fate_text(t.fate) + (t.is_clipped ? " (clipped)" : "")};
        if (has_samples) cells.insert(cells.end() - 1, letters_of_samples(e, t));
        table.add(std::move(cells));
    }
    return "\nTriangles that cover the pixel, nearest first\n" +
           std::string(has_samples ? "  (numbers are those of the nearest sample; one letter per sample: V visible, B "
                                     "blended, M masked out, H hidden, C culled, - not covered)\n"
                                   : "") +
           table.text("  ");
}

/// The textbook's incremental depth: from the pixel where the triangle's box begins, by slopes and steps.
std::string planes_text(const ExplainedPixel& e) {
    TextTable table({">#", "from pixel", ">key there", ">d key/dx [1/px]", ">d key/dy [1/px]", ">steps", ">by steps",
                     ">error", ">dz/dx [1/px]", ">dz/dy [1/px]"});
    const double per_key = standard_depth_per_key(e);
    for (std::size_t i = 0; i < e.pixel.triangles.size(); ++i) {
        const raster::DepthPlane& p = e.pixel.triangles[i].plane;
        table.add({digits(i), digits(p.x) + "," + digits(p.y), digits(p.key), digits(p.slope_x), digits(p.slope_y),
                   digits(e.pixel.x - p.x) + "," + digits(e.pixel.y - p.y), digits(p.by_steps),
                   digits(float(double(p.by_steps) - p.exact)), digits(float(per_key * double(p.slope_x))),
                   digits(float(per_key * double(p.slope_y)))});
    }
    return "\nTheir depths by steps from pixel to pixel\n  (key + slopes x steps; the error is against the plane "
           "through "
           "the corners in double; z is the textbook's depth, 0 near to 1 far)\n" +
           table.text("  ");
}

}  // namespace

TriangleNames names_of(const ExplainedPixel& e, const CoveringTriangle& triangle) {
    const shading::DrawList& list = e.engine->list();
    const shading::Draw& draw = list.draws[triangle.draw];
    TriangleNames names;
    names.node = draw.node;
    names.mesh_index = draw.mesh;
    names.material_index = list.materials[draw.material].scene_material;
    names.object = object_title(list.scene, draw.node);
    names.mesh = list.scene.meshes[draw.mesh].name;
    if (names.material_index != no_index) names.material = list.scene.materials[names.material_index].name;
    return names;
}

const char* word_for(raster::Fate fate) {
    switch (fate) {
        case raster::Fate::visible:
            return "visible";
        case raster::Fate::blended:
            return "blended";
        case raster::Fate::hidden:
            return "hidden";
        case raster::Fate::masked_out:
            return "masked_out";
        case raster::Fate::culled_back:
            return "culled_back";
        case raster::Fate::culled_front:
            return "culled_front";
    }
    return "";
}

std::string name_or_number(const std::string& name, std::uint32_t index) {
    if (index == no_index) return "(none)";
    return name.empty() ? "number " + digits(index) : one_line(name, 60);
}

std::string triangles_text(const ExplainedPixel& e) { return covering_text(e) + planes_text(e); }

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

std::string shaded_at_text(const raster::ShadedLayer& layer) {
    std::string text = "  shaded once for sample";
    if (layer.samples.size() > 1) text += "s";
    for (const raster::LaidSample& s : layer.samples) text += " " + digits(s.sample);
    if (layer.place.x == 0 && layer.place.y == 0) return text + ", at the pixel's center\n";
    return text + ", " + digits(layer.place.x) + ", " + digits(layer.place.y) + " px from the pixel's center\n";
}

std::string samples_text(const ExplainedPixel& e) {
    TextTable table({">sample", ">x [px]", ">y [px]", "shows", ">red", ">green", ">blue", ">alpha"});
    const auto add = [&table](std::vector<std::string> cells, vec4 c) {
        for (const float v : {c.x, c.y, c.z, c.w}) cells.push_back(digits(v));
        table.add(std::move(cells));
    };
    for (std::size_t k = 0; k < e.pixel.samples.size(); ++k) {
        const raster::SeenSample& s = e.pixel.samples[k];
        add({digits(k), in_px(s.at.x), in_px(s.at.y),
             s.triangle == SIZE_MAX ? "background" : "triangle " + digits(s.triangle)},
            s.color);
    }
    add({"mean", "", "", "= the pixel"}, e.pixel.sum);
    return "\nThe samples after all layers are blended, from the pixel's center, y down; their mean in linear light, "
           "each weighted by its alpha\n" +
           table.text("  ");
}

Json samples_json(const ExplainedPixel& e) {
    Json out = Json::array();
    for (const raster::SeenSample& s : e.pixel.samples)
        out.push_back({{"x", double(s.at.x) / 16},
                       {"y", double(s.at.y) / 16},
                       {"triangle", s.triangle == SIZE_MAX ? Json() : Json(s.triangle)},
                       {"color", {double(s.color.x), double(s.color.y), double(s.color.z), double(s.color.w)}}});
    return out;
}

}  // namespace rakelight
