// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include <rakelight/io/world.h>
#include <rakelight/scene/validate.h>
#include <rakelight/scene/words.h>
#include <rakelight/tools/check_scene.h>
#include <rakelight_internal/base/text.h>

#include <rakelight/render/shot.h>
#include "base/format_text.h"
#include "engines/check_settings.h"
#include "render/engines.h"
#include "scene/placement.h"
#include "shading/lights/shadow_cameras.h"
#include "tools/material_names.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

std::string quoted(const std::string& name) { return "'" + one_line(name, 60) + "'"; }

std::string text_of(const Light& light) {
    std::string text = light.units == LightUnits::photometric ? "photometric " : "";
    text += name_of(light.type);
    return light.name.empty() ? text : text + " " + quoted(light.name);
}

/// With their numbers, by which the command line takes them.
std::string list_of(const std::vector<std::string>& things) {
    std::vector<std::string> numbered;
    numbered.reserve(things.size());
    for (const std::string& thing : things) numbered.push_back(format_text("{} {}", numbered.size(), thing));
    return list_of_names(numbered, 20, 80);
}

std::vector<std::string> quoted(const std::vector<std::string>& names) {
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const std::string& name : names) result.push_back(quoted(name));
    return result;
}

}  // namespace

SceneSummary summarize(const Scene& scene) {
    validate(scene);
    SceneSummary out;
    out.is_world = is_world_file(scene.source);
    for (const Node& node : scene.nodes) {
        out.objects += node.meshes.empty() ? 0 : 1;
        if (out.is_world && node.parent == no_index) out.parts.push_back(node.name);
    }
    out.meshes = scene.meshes.size();
    out.triangles = triangle_count(scene);
    out.materials = scene.materials.size();
    out.textures = scene.textures.size();
    out.skins = scene.skins.size();
    out.animations = scene.animations.size();
    for (const Camera& camera : scene.cameras) out.cameras.push_back(camera.name);
    for (const Light& light : scene.lights) out.lights.push_back(text_of(light));
    out.has_fog = scene.fog.kind != FogKind::none;
    out.has_environment = scene.environment.has_value();
    return out;
}

void check_picture(const Scene& scene, const PictureRequest& request, Context& context) {
    validate(scene);
    check_engine_name(request.engine);
    check_settings(request.settings);
    Scene lit;  // without objects, of which there may be millions
    lit.lights = scene.lights, lit.environment = scene.environment;
    shading::check_shadow_memory(requested_lights(lit, request, Camera{}), request.settings, context.memory());
}

std::string to_text(const std::string& file, const SceneSummary& s) {
    std::string text = one_line(file) + ": " + (s.is_world ? "world of " + counted(s.parts.size(), "part") : "model") +
                       ", " + counted(s.objects, "object") + ", " + counted(s.triangles, "triangle") + ", " +
                       counted(s.materials, "material") + ", " + counted(s.textures, "texture");
    if (s.skins) text += ", " + counted(s.skins, "skin");
    if (s.animations) text += ", " + counted(s.animations, "animation");
    if (s.has_fog) text += ", fog";
    if (s.has_environment) text += ", surroundings";
    text += "\n";
    if (s.is_world) text += "  parts: " + list_of(quoted(s.parts)) + "\n";
    if (!s.cameras.empty()) text += "  cameras: " + list_of(quoted(s.cameras)) + "\n";
    if (!s.lights.empty()) text += "  lights: " + list_of(s.lights) + "\n";
    return text;
}

std::string to_json(std::span<const CheckRow> rows) {
    Json list = Json::array();
    for (const CheckRow& r : rows) {
        Json row = {{"file", r.file}};
        if (r.summary) {
            const SceneSummary& s = *r.summary;
            row["kind"] = s.is_world ? "world" : "model";
            row["objects"] = s.objects;
            row["meshes"] = s.meshes;
            row["triangles"] = s.triangles;
            row["materials"] = s.materials;
            row["textures"] = s.textures;
            row["skins"] = s.skins;
            row["animations"] = s.animations;
            row["parts"] = s.parts;
            row["cameras"] = s.cameras;
            row["lights"] = s.lights;
            row["fog"] = s.has_fog;
            row["environment"] = s.has_environment;
        }
        if (r.error) row["error"] = error_json(*r.error);
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        list.push_back(std::move(row));
    }
    return document("rakelight.check/1", std::move(list));
}

}  // namespace rakelight
