// SPDX-License-Identifier: Apache-2.0
// Inspections as the program's JSON, schema rakelight.inspect/1: fields are added, never renamed.
#include <nlohmann/json.hpp>

#include <rakelight/scene/motion.h>
#include <rakelight/tools/inspect.h>

#include "tools/camera_extent.h"
#include "tools/inspect/whole_inspection.h"
#include "tools/material_names.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

using Has = ObjectSummary::Has;

const char* word(Has has) { return has == Has::yes ? "yes" : has == Has::some ? "some" : "no"; }
Json json_of(dvec3 v) { return {v.x, v.y, v.z}; }
Json json_of(vec3 v) { return {v.x, v.y, v.z}; }
Json index_or_null(std::uint32_t index) { return index == no_index ? Json() : Json(index); }

Json json_of(const ObjectSummary& o) {
    return {{"name", o.name},
            {"node", o.node},
            {"meshes", o.meshes},
            {"triangles", o.triangles},
            {"vertices", o.vertices},
            {"lines", o.lines},
            {"points", o.points},
            {"normals", word(o.normals)},
            {"tangents", word(o.tangents)},
            {"texcoords", word(o.texcoords)},
            {"colors", word(o.colors)},
            {"smoothing_groups", word(o.smoothing_groups)},
            {"skin", word(o.skin)},
            {"morph_targets", word(o.morph_targets)},
            {"materials", o.materials}};
}

Json json_of(const Material& m) {
    Json textures = Json::object();
    for (const auto& [role, use] : named_texture_uses(m)) textures[role] = use.texture;
    return {{"name", m.name},
            {"model", name_of(m.model)},
            {"base_color", {m.base_color.x, m.base_color.y, m.base_color.z, m.base_color.w}},
            {"alpha_mode", name_of(m.alpha_mode)},
            {"double_sided", m.double_sided},
            {"textures", textures}};
}

Json json_of(const Texture& t) {
    Json json = {{"name", t.name}};
    if (!t.image) return json;
    json["image"] = t.image->name;
    json["path"] = t.image->path;
    json["mime_type"] = t.image->mime_type;
    json["embedded_bytes"] = t.image->bytes ? Json(t.image->bytes->size()) : Json();
    return json;
}

Json json_of(const Light& l) {
    Json json = {{"name", l.name}, {"type", name_of(l.type)}, {"node", index_or_null(l.node)}};
    if (l.units == LightUnits::photometric) {
        json["units"] = "photometric";
        json["color"] = json_of(l.color);
        json["intensity"] = l.intensity;
    } else {
        json["units"] = "classical";
        json["diffuse"] = json_of(l.type == LightType::ambient ? l.ambient : l.diffuse);
        json["attenuation"] = {l.constant, l.linear, l.quadratic};
    }
    return json;
}

Json json_of(const Camera& c) {
    Json json = {{"name", c.name}, {"node", index_or_null(c.node)}};
    if (c.projection == Projection::perspective) {
        json["projection"] = "perspective";
        const std::optional<double> across = horizontal_fov_rad(c);
        json["vertical_fov_deg"] =
            c.vertical_fov_rad > 0 ? Json(degrees(c.vertical_fov_rad)) : Json();  // null: the height
        json["horizontal_fov_deg"] = across ? Json(degrees(*across)) : Json();    // null: the picture's width decides
    } else {
        json["projection"] = "orthographic";
        const std::optional<double> across = half_width(c);
        json["half_height"] = c.half_height;
        json["half_width"] = across ? Json(*across) : Json();
    }
    json["near"] = c.z_near;
    json["far"] = c.z_far;  // null when it is infinite
    return json;
}

Json json_of(const AngleSummary& a) {
    return {{"max_deg", a.max_deg}, {"mean_deg", a.mean_deg}, {"p95_deg", a.p95_deg}};
}

Json json_of(const BorderSummary& b) {
    return {{"object_a", b.object_a},
            {"object_b", b.object_b},
            {"material_a", index_or_null(b.material_a)},
            {"material_b", index_or_null(b.material_b)},
            {"positions", b.positions},
            {"continuous", b.continuous},
            {"joined", b.joined},
            {"seam_deg", b.seam_deg},
            {"seam_position", json_of(b.seam_position)},
            {"before", json_of(b.before)},
            {"after", json_of(b.after)},
            {"median_deg", b.median_deg},
            {"largest_deg", b.largest_deg},
            {"inconsistent_edges", b.inconsistent_edges}};
}

Json json_of(const CurveAngles& a) {
    return {{"max_deg", a.max_deg}, {"mean_deg", a.mean_deg}, {"p95_deg", a.p95_deg}};
}

Json json_of(const MatchedPair& p) {
    return {{"object_a", p.object_a},    {"object_b", p.object_b}, {"length", p.length},
            {"gap_max", p.gap_max},      {"gap_mean", p.gap_mean}, {"before", json_of(p.before)},
            {"after", json_of(p.after)}, {"seam_deg", p.seam_deg}, {"seam_position", json_of(p.seam_position)}};
}

Json json_of(const BorderProposal& p) {
    return {{"distance", p.distance},
            {"open_length", p.open_length},
            {"matched_length", p.matched_length},
            {"gap_max", p.gap_max},
            {"seam_deg", p.seam_deg}};
}

Json json_of(const InconsistentPair& p) {
    return {{"object_a", p.object_a}, {"object_b", p.object_b}, {"edges", p.edges}};
}

Json json_of(const SeamTotals& s) {
    return {{"positions", s.positions},
            {"continuous", s.continuous},
            {"continuous_within_deg", continuous_deg},
            {"joined", s.joined},
            {"seam_deg", s.seam_deg},
            {"before", json_of(s.before)},
            {"after", json_of(s.after)},
            {"normals_before", s.normals_before},
            {"normals_after", s.normals_after},
            {"crease_angle_deg", s.crease_angle_deg},
            {"crease_angle_most_deg", s.crease_angle_max_deg},
            {"creases_are_automatic", s.creases_are_automatic},
            {"pairs", s.pairs},
            {"crowded_positions", s.crowded_positions},
            {"pairings_left_out", s.pairings_left_out},
            {"missing_normals", s.missing_normals},
            {"inconsistent_edges", s.inconsistent_edges}};
}

Json json_of(const CreaseReport& c) {
    Json rings = Json::array();
    for (std::size_t n = 0; n < c.rings.size(); ++n)
        if (c.rings[n] > 0) rings.push_back({{"sides", n}, {"count", c.rings[n]}, {"hard", n <= flat_most_sides}});
    return {{"hard", c.hard},
            {"soft", c.soft},
            {"hard_least_deg", c.hard_least_deg},
            {"hard_most_deg", c.hard_most_deg},
            {"soft_most_deg", c.soft_most_deg},
            {"rings", std::move(rings)},
            {"smooth_surfaces", c.smooth_surfaces}};
}

Json json_of(const NormalChoices& c) {
    return {{"fit", c.fit},       {"edge_fit", c.edge_fit}, {"plane", c.plane}, {"smooth", c.smooth},
            {"planar", c.planar}, {"noise", c.noise},       {"angle", c.angle}};
}

Json json_of(const SurfaceSummary& s) {
    return {{"closed", s.closed},
            {"edges", s.edges},
            {"open_edges", s.open_edges},
            {"inconsistent_edges", s.inconsistent_edges},
            {"non_manifold_edges", s.non_manifold_edges},
            {"t_junctions", s.t_junctions},
            {"degenerate_faces", s.degenerate_faces},
            {"zero_normals", s.zero_normals},
            {"non_finite_normals", s.non_finite_normals},
            {"non_unit_normals", s.non_unit_normals},
            {"mirrored_positions", s.mirrored_positions},
            {"mirror_split_vertices", s.mirror_split_vertices}};
}

Json json_of(const TJunctionPlace& t) {
    return {{"position", json_of(t.position)}, {"object", t.object}, {"edge_object", t.edge_object}};
}

Json json_of(const ArraySummary& a) {
    return {{"name", a.name}, {"components", a.components}, {"low", a.low},
            {"high", a.high}, {"vertices", a.vertices},     {"not_finite", a.not_finite}};
}

Json json_of(const Animation& a) {
    const ClipSpan span = clip_span(a);
    return {{"name", a.name}, {"begin_s", span.begin_s}, {"end_s", span.end_s}, {"channels", a.channels.size()}};
}

Json json_of(const InsideOutBody& b) { return {{"triangles", b.triangles}, {"objects", b.objects}}; }

Json json_of(const CheckFailure& f) { return {{"limit", f.limit}, {"message", f.message}}; }

template <class List>
Json list(const List& values) {
    Json array = Json::array();
    for (const auto& value : values) array.push_back(json_of(value));
    return array;
}

Json json_of(const MatchedSeams& m) {
    return {{"distance", m.distance},
            {"open_length", m.open_length},
            {"matched_length", m.matched_length},
            {"unmatched_length", m.unmatched_length()},
            {"gap_max", m.gap_max},
            {"gap_mean", m.gap_mean},
            {"before", json_of(m.before)},
            {"after", json_of(m.after)},
            {"seam_deg", m.seam_deg},
            {"pairs", list(m.pairs)},
            {"pairs_left_out", m.pairs_left_out},
            {"edges_not_searched", m.edges_not_searched}};
}

void add(Json& row, const Inspection& i) {
    check_whole(i);
    row["triangles"] = i.triangles;
    row["unit"] = i.unit;
    row["bounds"] = {{"low", json_of(i.low)}, {"high", json_of(i.high)}};
    row["objects"] = list(i.objects);
    for (std::size_t o = 0; o < i.surfaces.size(); ++o) row["objects"][o]["surface"] = json_of(i.surfaces[o]);
    row["arrays"] = list(i.arrays);
    row["materials"] = list(i.scene.materials);
    for (std::size_t m = 0; m < i.material_objects.size(); ++m) row["materials"][m]["objects"] = i.material_objects[m];
    row["textures"] = list(i.scene.textures);
    row["lights"] = list(i.scene.lights);
    row["cameras"] = list(i.scene.cameras);
    row["animations"] = i.scene.animations.size();
    row["clips"] = list(i.scene.animations);
    row["posed"] = i.is_posed;
    row["shared_positions"] = i.shared_positions;
    if (i.creases) row["creases"] = json_of(*i.creases);
    if (i.choices) row["normal_choices"] = json_of(*i.choices);
    row["seams"] = json_of(i.seams);
    row["borders"] = list(i.borders);
    row["borders_left_out"] = i.borders_left_out;
    row["inconsistent_pairs"] = list(i.inconsistent_pairs);
    if (i.matched.distance > 0) row["matched_borders"] = json_of(i.matched);
    if (i.proposal.distance > 0) row["border_proposal"] = json_of(i.proposal);
    if (i.surfaces.empty()) return;
    row["inside_out"] = list(i.inside_out);
    row["t_junctions"] = {
        {"count", i.t_junctions}, {"places", list(i.t_junction_places)}, {"edges_not_searched", i.edges_not_searched}};
}

}  // namespace

std::string to_json(std::span<const InspectionRow> rows) {
    Json array = Json::array();
    for (const InspectionRow& r : rows) {
        Json row = {{"file", r.file}};
        if (r.error) row["error"] = error_json(*r.error);
        if (r.inspection) add(row, *r.inspection);
        if (r.check) row["check"] = {{"passed", r.check->empty()}, {"failures", list(*r.check)}};
        if (!r.heat_map.empty()) row["heat_map"] = r.heat_map;
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        array.push_back(std::move(row));
    }
    return document("rakelight.inspect/1", std::move(array));
}

}  // namespace rakelight
