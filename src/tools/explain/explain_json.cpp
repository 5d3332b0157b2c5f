// SPDX-License-Identifier: Apache-2.0
// Explained pixels as the program's JSON, schema rakelight.explain/1 (docs/explain.md): fields are added, never renamed.
// Floats are written as the doubles that they are equal to, so that the bits come back.
#include <nlohmann/json.hpp>

#include <rakelight/scene/words.h>
#include <rakelight/tools/explain.h>

#include "tools/explain/explain_factors.h"
#include "tools/explain/explain_layers.h"
#include "tools/explain/explain_shaders.h"
#include "tools/explain/explain_triangles.h"
#include "tools/material_names.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

using raster::CoveringTriangle;
using raster::ShadedLayer;
using raster::TracedLight;

template <std::size_t n>
Json list(const float (&v)[n]) {
    Json out = Json::array();
    for (const float f : v) out.push_back(double(f));
    return out;
}
Json list(vec4 v) { return {double(v.x), double(v.y), double(v.z), double(v.w)}; }
Json list(dvec3 v) { return {v.x, v.y, v.z}; }
Json index_or_null(std::uint32_t index) { return index == no_index ? Json() : Json(index); }

Json covered_json(const CoveringTriangle& t) {
    Json out = Json::array();
    for (const raster::CoveredSample& s : t.samples)
        out.push_back({{"sample", s.sample},
                       {"fate", word_for(s.fate)},
                       {"depth_key", double(s.depth_key)},
                       {"alpha", double(s.alpha)}});
    return out;
}

Json plane_json(const ExplainedPixel& e, const raster::DepthPlane& p) {
    const double per_key = standard_depth_per_key(e);
    return {{"reference", {p.x, p.y}},
            {"key", double(p.key)},
            {"slope", {double(p.slope_x), double(p.slope_y)}},
            {"steps", {e.pixel.x - p.x, e.pixel.y - p.y}},
            {"by_steps", double(p.by_steps)},
            {"plane", p.exact},
            {"error", double(p.by_steps) - p.exact},
            {"textbook_slope", {per_key * double(p.slope_x), per_key * double(p.slope_y)}}};
}

Json triangle_json(const ExplainedPixel& e, const CoveringTriangle& t) {
    const TriangleNames names = names_of(e, t);
    return {{"fate", word_for(t.fate)},
            {"object", names.object},
            {"node", names.node},
            {"mesh_name", names.mesh},
            {"mesh", names.mesh_index},
            {"triangle", t.triangle},
            {"vertices", {t.vertex[0], t.vertex[1], t.vertex[2]}},
            {"material_name", names.material},
            {"material", index_or_null(names.material_index)},
            {"side", t.is_back ? "back" : "front"},
            {"clipped", t.is_clipped},
            {"distance", double(t.distance)},
            {"depth_key", double(t.depth_key)},
            {"depth_plane", plane_json(e, t.plane)},
            {"alpha", double(t.alpha)},
            {"samples", covered_json(t)}};
}

Json maps_json(const ExplainedPixel& e, const ShadedLayer& layer) {
    Json out = Json::array();
    for (int i = 0; i < texture_role_count; ++i) {
        const raster::TracedTexture& map = layer.trace.map[i];
        if (!map.is_used) continue;
        Json texels = Json::array();
        for (int k = 0; k < layer.texels[std::size_t(i)].count; ++k) {
            const raster::TracedTexel& t = layer.texels[std::size_t(i)].texel[k];
            texels.push_back({{"probe", t.probe},
                              {"level", t.level},
                              {"x", t.x},
                              {"y", t.y},
                              {"weight", double(t.weight)},
                              {"value", list(t.value)}});
        }
        out.push_back({{"role", name_of_map(i)},
                       {"picture", picture_of_map(e, layer, i)},
                       {"uv", {double(map.u), double(map.v)}},
                       {"probes", map.probes},
                       {"along", {double(map.axis_u), double(map.axis_v)}},
                       {"level_of_detail", double(map.level_of_detail)},
                       {"level", double(map.level)},
                       {"value", list(map.value)},
                       {"texels", std::move(texels)}});
    }
    return out;
}

Json light_json(const Light& light, std::size_t index, int reflection_model, const TracedLight& t,
                const raster::TracedParts& parts) {
    Json out = {{"light", index},
                {"name", light.name},
                {"type", name_of(light.type)},
                {"to_light", list(t.to_light)},
                {"distance", double(t.distance)},
                {"attenuation", double(t.attenuation)},
                {"range_window", double(t.range_window)},
                {"spot", double(t.spot)},
                {"n_dot_l", double(t.n_dot_l)}};
    if (reflection_model == shading::reflects_phong) out["r_dot_v"] = double(t.lobe_cosine);
    if (reflection_model == shading::reflects_blinn_phong || has_microfacets(reflection_model))
        out["n_dot_h"] = double(t.lobe_cosine);
    if (reflection_model == shading::reflects_pbr) out["fresnel_weight"] = double(t.fresnel_weight);
    out["lobe"] = double(t.lobe);
    out["specular_factor"] = double(t.specular_factor);
    out["own_color"] = {
        {"ambient", list(t.own_ambient)}, {"diffuse", list(t.own_diffuse)}, {"specular", list(t.own_specular)}};
    out["light_color"] = {
        {"ambient", list(t.ambient_color)}, {"diffuse", list(t.diffuse_color)}, {"specular", list(t.specular_color)}};
    out["ambient"] = list(t.ambient);
    out["diffuse"] = list(t.diffuse);
    out["specular"] = list(t.specular);
    out["parts"] = parts_json(parts);
    out["seen"] = double(t.seen);
    out["sum"] = list(t.sum);
    return out;
}

/// Flat and Gouraud: what each corner received, and what is interpolated at the pixel, per unit of k_a, k_d and k_s.
void add_corners(Json& out, const ExplainedPixel& e, const ShadedLayer& layer) {
    const raster::PixelTrace& t = layer.trace;
    out["lit_at"] = !t.is_lit_at_corners ? "pixel" : layer.corners.size() == 1 ? "face" : "vertices";
    if (!t.is_lit_at_corners) return;
    out["corners"] = Json::array();
    for (const raster::TracedCorner& c : layer.corners) {
        Json corner = {{"vertex", index_or_null(c.corner.vertex)}, {"position_from_eye", list(c.corner.position)},
                       {"normal", list(c.corner.normal)},          {"lights", Json::array()},
                       {"ambient", list(c.corner.light.ambient)},  {"diffuse", list(c.corner.light.diffuse)},
                       {"specular", list(c.corner.light.specular)}};
        for (std::size_t i = 0; i < c.lights.size(); ++i) {
            corner["lights"].push_back(
                light_json(e.engine->list().scene.lights[i], i, layer.reflection_model, c.lights[i], c.parts[i]));
            corner["lights"].back().erase("sum");
        }
        out["corners"].push_back(std::move(corner));
    }
    out["received"] = {
        {"ambient", list(t.received[0])}, {"diffuse", list(t.received[1])}, {"specular", list(t.received[2])}};
}

Json surface_json(const ShadedLayer& layer) {
    const raster::PixelTrace& t = layer.trace;
    return {
        {"vertex_color", list(t.vertex_color)}, {"paint", list(t.paint)},         {"base_color", list(t.base_color)},
        {"k_ambient", list(t.k_ambient)},       {"k_diffuse", list(t.k_diffuse)}, {"k_specular", list(t.k_specular)},
        {"exponent", double(t.exponent)},       {"metallic", double(t.metallic)}, {"roughness", double(t.roughness)}};
}

/// Of the models of more parameters.
void add_parameters(Json& out, const ShadedLayer& layer) {
    const raster::PixelTrace& t = layer.trace;
    if (shading::is_oren_nayar(layer.reflection_model)) {
        out["oren_nayar"] = list(t.oren_nayar);
        if (layer.reflection_model == shading::reflects_oren_nayar) out["oren_nayar"].erase(2);
    }
    if (has_microfacets(layer.reflection_model)) out["alpha"] = list(t.lobe_alpha);
    if (layer.reflection_model != shading::reflects_pbr) return;
    out["f90"] = list(t.f90);
    if (t.coat > 0)
        out["clearcoat"] = {
            {"reflectance", double(t.coat)}, {"alpha", double(t.coat_alpha)}, {"normal", list(t.coat_normal)}};
    if (t.sheen_alpha > 0) out["sheen"] = {{"color", list(t.sheen)}, {"alpha", double(t.sheen_alpha)}};
}

/// What only some pictures have.
void add_extras(Json& out, const raster::PixelTrace& t) {
    if (t.has_relief) out["texcoords_relief"] = {list(t.relief_texcoord[0]), list(t.relief_texcoord[1])};
    if (t.has_relief && t.relief_height >= 0) out["relief_height"] = double(t.relief_height);
    if (t.openness >= 0) out["ambient_occlusion"] = double(t.openness);
    if (t.has_environment)
        out["environment"] = {{"ambient", list(t.environment[0])},
                              {"diffuse", list(t.environment[1])},
                              {"specular", list(t.environment[2])}};
    if (t.has_transmission) out["transmitted"] = list(t.transmitted);
    if (!t.has_fog) return;
    out["before_fog"] = list(t.before_fog);
    out["fog"] = {{"distance", double(t.fog_distance)}, {"share", double(t.fog_share)}, {"color", list(t.fog_color)}};
}

Json layer_json(const ExplainedPixel& e, const ShadedLayer& layer) {
    const raster::PixelTrace& t = layer.trace;
    Json out = {{"triangle", layer.triangle},
                {"blended", layer.is_blended},
                {"material_model", material_model(e, layer)},
                {"unlit", layer.is_unlit},
                {"reflection_model", reflection_model(layer)},
                {"reflection_form", layer.reflection_form ? "normalized" : "textbook"},
                {"barycentric", list(t.barycentric)},
                {"position", list(world_position(e, t.position))},
                {"position_from_eye", list(t.position)},
                {"texcoords", {list(t.texcoord[0]), list(t.texcoord[1])}},
                {"maps", maps_json(e, layer)},
                {"normal_interpolated", list(t.interpolated)},
                {"tangent", list(t.tangent)},
                {"handedness", double(t.handedness)},
                {"normal_texel", list(t.mapped)},
                {"normal_is_of_slopes", t.is_of_slopes != 0},
                {"facing", double(t.facing)},
                {"normal", list(t.normal)},
                {"diffuse_normal", list(t.diffuse_normal)},
                {"to_viewer", list(t.view)}};
    for (const Word<WardForm>& word : ward_form_words)
        if (layer.ward_form == word.value) out["ward_form"] = word.name;
    out["surface"] = surface_json(layer);
    add_parameters(out["surface"], layer);
    out["emission"] = list(t.emission);
    out["lights"] = Json::array();
    for (std::size_t i = 0; i < layer.lights.size(); ++i)
        out["lights"].push_back(
            light_json(e.engine->list().scene.lights[i], i, layer.reflection_model, layer.lights[i], layer.parts[i]));
    add_corners(out, e, layer);
    out["parts_around"] = parts_json(layer.parts.back());
    add_extras(out, t);
    out["color"] = list(t.color);
    out["alpha"] = double(t.alpha);
    out["place"] = {double(layer.place.x), double(layer.place.y)};
    out["before"] = list(layer.samples[0].before);
    out["after"] = list(layer.samples[0].after);
    out["samples"] = Json::array();
    for (const raster::LaidSample& s : layer.samples)
        out["samples"].push_back({{"sample", s.sample}, {"before", list(s.before)}, {"after", list(s.after)}});
    return out;
}

Json pixel_json(const ExplainedPixel& e) {
    const RenderSettings& settings = e.engine->settings();
    const raster::PixelExplanation& p = e.pixel;
    Json out = {{"width", settings.width},          {"height", settings.height},
                {"background", list(p.background)}, {"is_background", p.layers.empty() && !p.has_marks},
                {"color", list(p.color)},           {"sum", list(p.sum)},
                {"displayed", list(e.displayed)},   {"codes", e.codes},
                {"samples", samples_json(e)},       {"triangles", Json::array()},
                {"layers", Json::array()}};
    if (p.has_marks) out["has_marks"] = true;
    add_visible(out, e);
    out["look"] = Json::array();
    for (const LookChoice& choice : e.look) out["look"].push_back({{"topic", choice.topic}, {"value", choice.value}});
    out["exposure_ev"] = double(e.tone.exposure_ev);
    for (const CoveringTriangle& t : p.triangles) out["triangles"].push_back(triangle_json(e, t));
    for (const ShadedLayer& layer : p.layers) out["layers"].push_back(layer_json(e, layer));
    if (!e.shaded) return out;
    for (Json& layer : out["layers"])
        for (const char* const of_soft : {"lights", "parts_around", "color", "before", "after", "samples"})
            layer.erase(of_soft);
    out["shaders"] = shaded_json(*e.shaded);
    return out;
}

}  // namespace

std::string to_json(std::span<const ExplainRow> rows) {
    Json list = Json::array();
    for (const ExplainRow& row : rows) {
        Json json = {{"file", row.file}, {"pixel", {row.x, row.y}}};
        if (row.error) json["error"] = error_json(*row.error);
        if (row.pixel) json.update(pixel_json(*row.pixel));
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.explain/1", std::move(list));
}

}  // namespace rakelight
