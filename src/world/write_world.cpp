// SPDX-License-Identifier: Apache-2.0
// Writes a world as the text of a world file.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include <rakelight/math/linear.h>

#include "base/enumerators.h"
#include "base/from_chars.h"
#include "io/files/beside.h"
#include "io/world/material_keys.h"
#include "world/keys/key_fields.h"
#include "world/write_tracks.h"

namespace rakelight {
namespace {

using keys::degrees_of;
using keys::degrees_of_float;
using keys::text_of;
using keys::text_of_float;

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) {
            out += c;
            continue;
        }
        constexpr const char* hex = "0123456789ABCDEF";
        out += std::string("\\u00") + hex[c >> 4] + hex[c & 15];
    }
    return out + "\"";
}

std::string array_of(const std::vector<std::string>& items) {
    std::string out = "[";
    for (std::size_t i = 0; i < items.size(); ++i) out += (i > 0 ? ", " : "") + items[i];
    return out + "]";
}

std::string array_of(dvec3 v) { return array_of({text_of(v.x), text_of(v.y), text_of(v.z)}); }
std::string array_of(vec3 v) { return array_of({text_of_float(v.x), text_of_float(v.y), text_of_float(v.z)}); }
std::string flag(bool value) { return value ? "true" : "false"; }

[[noreturn]] void refuse(const std::string& what, const std::string& name, const std::string& why) {
    throw Error(ErrorCode::usage, "the " + what + " '" + one_line(name, 60) + "' cannot stand in a world file: " + why);
}

/// The text of a file, section by section.
class Writer {
public:
    void section(const std::string& header) { text_ += (text_.empty() ? "" : "\n") + header + "\n"; }
    void lines(const std::string& whole) { text_ += whole; }
    void put(const std::string& key, const std::string& value) { text_ += key + " = " + value + "\n"; }
    void put_text(const std::string& key, const std::string& value, const std::string& usual = {}) {
        if (value != usual) put(key, quoted(value));
    }
    void put_number(const std::string& key, double value, double usual) {
        if (value != usual) put(key, text_of(value));
    }
    void put_float(const std::string& key, float value, float usual) {
        if (value != usual) put(key, text_of_float(value));
    }
    void put_flag(const std::string& key, bool value, bool usual) {
        if (value != usual) put(key, flag(value));
    }
    void put_vector(const std::string& key, dvec3 value, dvec3 usual) {
        if (value != usual) put(key, array_of(value));
    }
    void put_color(const std::string& key, vec3 value, vec3 usual) {
        if (value != usual) put(key, array_of(value));
    }
    template <class T, std::size_t n>
    void put_word(const std::string& key, const Word<T> (&words)[n], const T& value, const T& usual) {
        if (value != usual) put_text(key, keys::name_in(words, value).at(0));
    }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void write_subdivision(Writer& to, const Subdivision& s) {
    const Subdivision usual;
    to.put("subdivide", std::to_string(s.level));
    to.put_number("subdivide_edge", s.edge, usual.edge);
    to.put_word("subdivide_scheme", subdivision_scheme_words, s.scheme, usual.scheme);
    to.put_word("subdivide_crease", subdivision_crease_words, s.finds_creases, usual.finds_creases);
    if (s.crease_angle_rad) to.put("subdivide_crease_deg", degrees_of(*s.crease_angle_rad));
    to.put_number("subdivide_sharpness", s.sharpness, usual.sharpness);
    to.put_word("subdivide_boundary", subdivision_boundary_words, s.round_corners, usual.round_corners);
    to.put_word("subdivide_uv", subdivision_uv_words, s.uv, usual.uv);
}

template <class Part>
void write_common(Writer& to, const Part& part) {
    to.put_text("name", part.name);
    to.put_vector("position", part.placement.position, {0, 0, 0});
    to.put_vector("rotation_deg", part.placement.rotation_deg, {0, 0, 0});
    to.put_vector("scale", part.placement.scale, {1, 1, 1});
    to.put_text("material", part.material);
    to.put_text("normals", part.normals);
    if (part.crease_angle_rad) to.put("crease_angle_deg", degrees_of(*part.crease_angle_rad));
    if (part.shading) to.put_text("shading", keys::name_in(shading_words, *part.shading).at(0));
    if (part.subdivision) write_subdivision(to, *part.subdivision);
}

void write_model(Writer& to, const WorldModel& model) {
    to.section("[[model]]");
    to.put_text("file", model.file);
    write_common(to, model);
    to.put_flag("lights", model.lights, false);
    to.put_flag("cameras", model.cameras, false);
}

void write_primitive(Writer& to, const WorldPrimitive& shape) {
    const WorldPrimitive usual;
    to.section("[[primitive]]");
    to.put_text("type", shape.type);
    write_common(to, shape);
    to.put_number("radius", shape.radius, usual.radius);
    to.put_number("tube_radius", shape.tube_radius, usual.tube_radius);
    to.put_number("height", shape.height, usual.height);
    if (shape.width != usual.width || shape.depth != usual.depth)
        to.put("size", array_of({text_of(shape.width), text_of(shape.depth)}));
    to.put_number("tolerance", shape.tolerance, 0);
    const bool is_by_tolerance = shape.type == "teapot" && shape.tolerance > 0;
    if (!is_by_tolerance) to.put_number("divisions", shape.divisions, shape.type == "teapot" ? 10 : 1);
    to.put_number("objects", shape.objects, 1);
}

void write_classical(Writer& to, const Light& light) {
    if (light.type == LightType::ambient) return to.put("ambient", array_of(light.ambient));
    to.put_color("ambient", light.ambient, {0, 0, 0});
    to.put_color("diffuse", light.diffuse, {1, 1, 1});
    to.put_color("specular", light.specular, light.diffuse);
    if (light.type == LightType::directional) return;
    const vec3 attenuation{light.constant, light.linear, light.quadratic};
    to.put_color("attenuation", attenuation, {1, 0, 0});
    if (light.type != LightType::spot) return;
    to.put("cutoff_deg", degrees_of_float(light.cutoff_rad));
    to.put_float("exponent", light.exponent, 0);
}

void write_photometric(Writer& to, const Light& light) {
    to.put_color("color", light.color, {1, 1, 1});
    to.put_float(light.type == LightType::directional ? "intensity_lux" : "intensity_cd", light.intensity, 1);
    if (light.type != LightType::spot) return;
    to.put("inner_cone_deg", degrees_of_float(light.inner_cone_rad));
    to.put("outer_cone_deg", degrees_of_float(light.outer_cone_rad));
}

void write_light(Writer& to, const Light& light) {
    if (light.node != no_index) refuse("light", light.name, "it hangs on a node");
    const bool is_spot = light.type == LightType::spot, is_placed = is_spot || light.type == LightType::point;
    to.section("[[light]]");
    to.put_text("type", keys::name_of(light));
    to.put_text("name", light.name);
    if (is_placed) to.put("position", array_of(light.position));
    if (is_spot || light.type == LightType::directional) to.put("direction", array_of(light.direction));
    light.units == LightUnits::classical ? write_classical(to, light) : write_photometric(to, light);
    if (is_placed && std::isfinite(light.range)) to.put("range", text_of_float(light.range));
    if (light.type != LightType::ambient) to.put_flag("casts_shadow", light.casts_shadow, true);
}

void write_camera(Writer& to, const Camera& camera) {
    if (camera.node != no_index) refuse("camera", camera.name, "it hangs on a node");
    if (camera.aspect || camera.half_width) refuse("camera", camera.name, "it has an aspect of its own");
    if (!std::isfinite(camera.z_far)) refuse("camera", camera.name, "it sees infinitely far");
    const dmat4& m = camera.to_world;
    to.section("[[camera]]");
    to.put_text("name", camera.name);
    to.put("position", array_of(m[3].xyz()));
    to.put("target", array_of(m[3].xyz() - m[2].xyz()));
    to.put("up", array_of(m[1].xyz()));
    if (camera.projection == Projection::orthographic) {
        to.put("orthographic_height", text_of(2 * camera.half_height));
    } else {
        if (camera.vertical_fov_rad != 0) to.put("vertical_fov_deg", degrees_of(camera.vertical_fov_rad));
        if (camera.horizontal_fov_rad) to.put("horizontal_fov_deg", degrees_of(*camera.horizontal_fov_rad));
    }
    const Camera otherwise;  // neither is given: has_default_depths()
    if (camera.z_near == otherwise.z_near && camera.z_far == otherwise.z_far) return;
    to.put("near", text_of(camera.z_near));
    to.put("far", text_of(camera.z_far));
}

/// A number if the word is its canonical form, else a string.
std::string bare_or_quoted(const std::string& word) {
    double number = 0;
    const auto [end, fault] = from_chars(word.data(), word.data() + word.size(), number);
    const bool is_number = fault == std::errc() && end == word.data() + word.size() && std::isfinite(number);
    return is_number && text_of(number) == word ? word : quoted(word);
}

void write_material(Writer& to, const WorldMaterial& material) {
    to.section("[[material]]");
    to.put_text("name", material.name);
    to.put_text("model", material.model);
    to.put_text("object", material.object);
    for (const WorldValue& value : material.values) {
        const io::world::MaterialKey* const key = io::world::find_material_key(value.key);
        if (key && key->key.kind == io::world::Kind::flag) {
            to.put(value.key, flag(value.words.at(0) == "on"));
        } else if (!value.numbers.empty()) {
            std::vector<std::string> items;
            for (const double number : value.numbers) items.push_back(text_of(number));
            to.put(value.key, items.size() == 1 ? items[0] : array_of(items));
        } else {
            to.put(value.key, quoted(value.words.at(0)));
        }
    }
}

void write_fog(Writer& to, const Fog& fog) {
    const char* const kinds[] = {"none", "linear", "exp", "exp2"};
    const Fog usual;
    to.section("[fog]");
    to.put_text("kind", kinds[std::size_t(fog.kind)]);
    to.put_color("color", fog.color, usual.color);
    if (fog.kind == FogKind::linear) to.put_float("start", fog.start, usual.start);
    if (fog.kind == FogKind::linear) to.put_float("end", fog.end, usual.end);
    if (fog.kind != FogKind::linear && fog.kind != FogKind::none) to.put_float("density", fog.density, usual.density);
}

void write_environment(Writer& to, const WorldEnvironment& of) {
    to.section("[environment]");
    to.put_text("file", of.file);
    to.put_float("intensity", of.environment.intensity, 1);
    if (of.environment.rotation_rad != 0) to.put("rotation_deg", degrees_of(of.environment.rotation_rad));
    to.put_vector("up", of.environment.up, {0, 1, 0});
    to.put_flag("light", of.environment.is_light, true);
    to.put_flag("background", of.environment.is_background, true);
}

void write_render(Writer& to, const std::vector<WorldValue>& values) {
    if (values.empty()) return;
    to.section("[render]");
    for (const WorldValue& value : values) {
        const RenderKey* const key = find_render_key(value.key);
        const bool is_flag = key && (key->kind == RenderKey::Kind::flag || key->kind == RenderKey::Kind::on_off);
        std::vector<std::string> items;
        for (const std::string& word : value.words)
            items.push_back(is_flag && (word == "on" || word == "off") ? flag(word == "on") : bare_or_quoted(word));
        to.put(value.key, value.is_array || items.size() != 1 ? array_of(items) : items[0]);
    }
}

void check(const WorldMaterial& material) {
    for (const WorldValue& value : material.values)
        if (!io::world::find_material_key(value.key) || (value.words.empty() && value.numbers.empty()))
            refuse("material", material.name, "it has no '" + one_line(value.key, 40) + "'");
}

void check(const WorldTrack& track) {
    const std::size_t keys = track.times.size();
    const bool ascends = std::ranges::adjacent_find(track.times, std::greater_equal<>()) == track.times.end();
    if (!ascends || keys == 0 || track.values.empty() || track.values.size() % keys != 0 ||
        (track.path != AnimationPath::camera && track.path != AnimationPath::light))
        throw Error(ErrorCode::usage,
                    "the track of '" + one_line(track.property, 40) + "' has no keys in ascending order");
}

/// Checks for data that the sections below cannot express.
void check(const WorldFile& world) {
    const auto check_shading = [](const auto& part) {
        if (part.shading && !exists(*part.shading, Shading::automatic))
            refuse("part", part.name, no_such("shading", *part.shading));
    };
    std::ranges::for_each(world.models, check_shading);
    std::ranges::for_each(world.primitives, check_shading);
    for (const WorldMaterial& material : world.materials) check(material);
    for (const WorldTrack& track : world.tracks) check(track);
    for (const Light& light : world.lights)
        if (!exists(light.type, LightType::spot) || !exists(light.units, LightUnits::photometric))
            refuse("light", light.name, "there is no such type");
    if (world.fog && !exists(world.fog->kind, FogKind::exponential_squared))
        throw Error(ErrorCode::usage, no_such("kind of fog", world.fog->kind));
    if (world.environment && world.environment->file.empty() && world.environment->environment.image)
        throw Error(ErrorCode::usage, "the environment's picture is no file that a world file could name");
    if (std::ranges::find(world.render, "material", &WorldValue::key) != world.render.end())
        throw Error(ErrorCode::usage, "'material' is no key of [render]", {}, "WorldFile::materials says it");
    std::vector<WorldValue> render = world.render;
    std::erase_if(render, [](const WorldValue& value) {  // relative to the folder of the new world file
        return value.key == "lighting" && names_files(value);
    });
    PictureRequest ignored;
    read_render_keys(render, ignored);
}

}  // namespace

std::string to_toml(const WorldFile& world) {
    check(world);
    Writer to;
    for (const WorldModel& model : world.models) write_model(to, model);
    for (const WorldPrimitive& shape : world.primitives) write_primitive(to, shape);
    for (const WorldMaterial& material : world.materials) write_material(to, material);
    for (std::size_t i = 0; i < world.lights.size(); ++i) {
        write_light(to, world.lights[i]);
        to.lines(text_of_tracks(world, AnimationPath::light, i));
    }
    for (std::size_t i = 0; i < world.cameras.size(); ++i) {
        write_camera(to, world.cameras[i]);
        to.lines(text_of_tracks(world, AnimationPath::camera, i));
    }
    if (world.fog) write_fog(to, *world.fog);
    if (world.environment) write_environment(to, *world.environment);
    write_render(to, world.render);
    std::string text = to.take();
    parse_world(text);  // checks that reading the file would fail on
    return text;
}

void save_world(const WorldFile& world, const std::string& path) {
    try {
        const std::string text = to_toml(world);
        if (!is_world_file(path)) throw Error(ErrorCode::usage, "world files end in .scene.toml");
        io::write_file(path, std::as_bytes(std::span(text)));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace rakelight
