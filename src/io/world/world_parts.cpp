// SPDX-License-Identifier: Apache-2.0
#include "io/world/world_parts.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include <rakelight/math/linear.h>

#include "io/world/material_keys.h"

namespace rakelight::io::world {
namespace {

WorldPlacement read_placement(const SectionValues& v) {
    const WorldPlacement placement{v.vector("position", {0, 0, 0}), v.vector("rotation_deg", {0, 0, 0}),
                                   v.vector("scale", {1, 1, 1})};
    const dvec3 s = placement.scale;
    if (s.x == 0 || s.y == 0 || s.z == 0) fail(v.place_of("scale"), "'scale' must not be 0");
    return placement;
}

/// As `subdivide` of [render] and its companions have it.
std::optional<Subdivision> read_subdivision(const SectionValues& v) {
    Subdivision s;
    if (v.has("subdivide_edge")) s.edge = v.number("subdivide_edge", 0), s.level = 8;
    s.level = int(v.number("subdivide", s.level));
    s.scheme = value_of(subdivision_scheme_words, v.text("subdivide_scheme", "auto"));
    s.finds_creases = value_of(subdivision_crease_words, v.text("subdivide_crease", "angle"));
    if (v.has("subdivide_crease_deg")) s.crease_angle_rad = radians(v.number("subdivide_crease_deg", 0));
    if (s.finds_creases && s.crease_angle_rad)
        fail(v.place_of("subdivide_crease"), "'subdivide_crease = auto' leaves nothing to 'subdivide_crease_deg'",
             "remove one of them");
    s.sharpness = v.number("subdivide_sharpness", s.sharpness);
    s.round_corners = value_of(subdivision_boundary_words, v.text("subdivide_boundary", "edge-and-corner"));
    s.uv = value_of(subdivision_uv_words, v.text("subdivide_uv", "boundaries"));
    if (v.has("subdivide") || v.has("subdivide_edge")) return s;
    for (const char* key : {"subdivide_scheme", "subdivide_crease", "subdivide_crease_deg", "subdivide_sharpness",
                            "subdivide_boundary", "subdivide_uv"})
        if (v.has(key))
            fail(v.place_of(key), "'" + std::string(key) + "' says how to subdivide, but there is no 'subdivide'",
                 "add 'subdivide = 3'");
    return std::nullopt;
}

template <class Part>
void read_common(const SectionValues& v, Part& part) {
    part.place = v.place_of("file");
    part.material_place = v.place_of("material");
    if (v.has("shading")) part.shading = value_of(shading_words, v.text("shading"));
    part.name = v.text("name", part.name);
    part.placement = read_placement(v);
    part.material = v.text("material");
    part.normals = v.text("normals");
    if (v.has("crease_angle_deg")) part.crease_angle_rad = radians(v.number("crease_angle_deg", 0));
    part.subdivision = read_subdivision(v);
}

}  // namespace

WorldModel read_model(const SectionValues& v) {
    WorldModel model;
    model.file = v.text("file");
    if (is_world_file(model.file)) fail(v.place_of("file"), "a world file cannot contain another");
    model.name = model.file.starts_with("builtin:") ? model.file.substr(8, model.file.find(':', 8) - 8)
                                                    : std::filesystem::path(model.file).stem().string();
    model.lights = v.flag("lights", false);
    model.cameras = v.flag("cameras", false);
    read_common(v, model);
    return model;
}

WorldPrimitive read_primitive(const SectionValues& v) {
    WorldPrimitive shape;
    shape.type = shape.name = v.text("type");
    const auto only_for = [&](const char* key, std::initializer_list<const char*> types) {
        if (v.has(key) && std::none_of(types.begin(), types.end(), [&](const char* t) { return shape.type == t; }))
            fail(v.place_of(key), "a " + shape.type + " has no '" + key + "'");
    };
    only_for("radius", {"sphere", "cylinder", "cone", "torus"});
    only_for("tube_radius", {"torus"});
    only_for("height", {"cylinder", "cone"});
    only_for("size", {"plane"});
    only_for("divisions", {"plane", "teapot"});
    only_for("objects", {"sphere", "cylinder", "cone", "torus", "plane"});
    if (shape.type == "teapot" && v.has("divisions") && v.has("tolerance"))
        fail(v.place_of("tolerance"), "a teapot takes either 'divisions' or 'tolerance'");
    shape.radius = v.number("radius", shape.radius);
    shape.tube_radius = v.number("tube_radius", shape.tube_radius);
    shape.height = v.number("height", shape.height);
    if (const WorldValue* const size = v.find("size")) shape.width = size->numbers[0], shape.depth = size->numbers[1];
    shape.divisions = int(v.number("divisions", shape.type == "teapot" ? 10 : 1));
    shape.objects = int(v.number("objects", 1));
    shape.objects_place = v.place_of("objects");
    shape.tolerance = v.number("tolerance", shape.tolerance);
    read_common(v, shape);
    return shape;
}

WorldMaterial read_material(const SectionValues& v) {
    WorldMaterial material{
        .name = v.text("name"), .model = v.text("model"), .object = v.text("object"), .values = {}, .place = v.place()};
    const WorldValue* of_classical = nullptr;
    const WorldValue* of_other = nullptr;
    for (const WorldValue& value : v.all()) {
        const MaterialKey* const key = find_material_key(value.key);
        if (!key) continue;  // name, model, object
        if (key->of == Of::classical) of_classical = &value;
        if (key->of == Of::metallic_roughness) of_other = &value;
        if (key->set) material.values.push_back(value);
    }
    if (of_classical && of_other)
        fail(of_other->place, "'" + of_classical->key + "' is of classical materials, '" + of_other->key +
                                  "' of metallic-roughness ones: a material must be one or the other");
    if (const WorldValue* const steps = v.find("bump_steps"); steps && steps->numbers[0] > steps->numbers[1])
        fail(steps->place, "'bump_steps': the first must not be more than the second");
    return material;
}

Fog read_fog(const SectionValues& v) {
    constexpr Word<FogKind> kinds[] = {{"none", FogKind::none},
                                       {"linear", FogKind::linear},
                                       {"exp", FogKind::exponential},
                                       {"exp2", FogKind::exponential_squared}};
    Fog fog;
    fog.kind = value_of(kinds, v.text("kind"));
    fog.color = v.color("color", fog.color);
    fog.start = float(v.number("start", double(fog.start)));
    fog.end = float(v.number("end", double(fog.end)));
    fog.density = float(v.number("density", double(fog.density)));
    for (const char* key : {"start", "end", "density"}) {
        const bool is_linear = fog.kind == FogKind::linear, is_of_linear = key[0] != 'd';
        if (v.has(key) && fog.kind != FogKind::none && is_linear != is_of_linear)
            fail(v.place_of(key), "fog of kind '" + v.text("kind") + "' has no '" + key + "'");
    }
    if (!(fog.end > fog.start)) fail(v.place_of("end"), "'end' must be more than 'start'");
    return fog;
}

WorldEnvironment read_environment(const SectionValues& v) {
    WorldEnvironment out{.file = v.text("file"), .environment = {}, .place = v.place_of("file")};
    out.environment.intensity = float(v.number("intensity", 1));
    out.environment.rotation_rad = radians(v.number("rotation_deg", 0));
    const dvec3 up = v.vector("up", out.environment.up);
    if (up == dvec3{0, 0, 0}) fail(v.place_of("up"), "'up' must not be zero");
    out.environment.up = normalize_or(up, out.environment.up);
    out.environment.is_light = v.flag("light", true);
    out.environment.is_background = v.flag("background", true);
    return out;
}

/// Two [[material]] of one name for the same models, or of one that a part takes as its material.
static void check_materials(const WorldFile& world) {
    std::set<std::string_view> asked_for;
    for (const WorldModel& m : world.models) asked_for.insert(m.material);
    for (const WorldPrimitive& p : world.primitives) asked_for.insert(p.material);
    std::set<std::tuple<std::string_view, std::string_view, std::string_view>> known;
    for (const WorldMaterial& m : world.materials) {
        const bool is_own = m.object.empty() && asked_for.contains(m.name);
        if (!known.insert({m.name, is_own ? std::string_view() : m.model, m.object}).second)
            fail(m.place, "a second [[material]] named '" + one_line(m.name, 40) + "'" +
                              (is_own             ? ", which a part uses as its 'material'"
                               : m.object.empty() ? " for the same models"
                                                  : " for the same object"));
    }
}

void check_names(const WorldFile& world) {
    constexpr std::size_t most = 5;  // names in a message
    check_materials(world);
    std::vector<const char*> materials, models;
    for (const WorldMaterial& m : world.materials)
        if (m.object.empty()) materials.push_back(m.name.c_str());
    for (const WorldModel& m : world.models) models.push_back(m.name.c_str());
    for (const WorldPrimitive& p : world.primitives) models.push_back(p.name.c_str());
    const auto is_in = [](const std::string& name, const std::vector<const char*>& names) {
        return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
    };
    const auto check_material = [&](const auto& part) {
        if (!part.material.empty() && !is_in(part.material, materials))
            fail(part.material_place, "there is no [[material]] named '" + one_line(part.material, 40) + "'",
                 materials.empty() ? "" : advice_for(part.material, materials, most));
    };
    for (const WorldModel& m : world.models) check_material(m);
    for (const WorldPrimitive& p : world.primitives) check_material(p);
    for (const WorldMaterial& m : world.materials)
        if (!m.model.empty() && !is_in(m.model, models))
            fail(m.place, "there is no [[model]] or [[primitive]] named '" + one_line(m.model, 40) + "'",
                 advice_for(m.model, models, most));
}

}  // namespace rakelight::io::world
