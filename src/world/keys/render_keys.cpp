// SPDX-License-Identifier: Apache-2.0
// All keys of [render], and checks of their combinations.
#include <algorithm>
#include <filesystem>

#include "base/format_text.h"
#include "engines/check_settings.h"
#include "engines/shader_text.h"
#include "world/keys/key_fields.h"
#include "world/keys/lighting_text.h"

namespace rakelight {
namespace {

std::vector<RenderKey> all_keys() {
    std::vector<RenderKey> all;
    for (const keys::KeyTable part : {keys::picture_keys, keys::surface_keys, keys::normal_keys, keys::view_keys,
                                      keys::scene_keys, keys::coloring_keys, keys::motion_keys})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// The given keys.
class Given {
public:
    explicit Given(std::span<const WorldValue> values) : values_(values) {}
    bool has(std::string_view key) const { return std::ranges::find(values_, key, &WorldValue::key) != values_.end(); }
    /// The first of some keys that was given, or null.
    const char* first_of(std::initializer_list<const char*> names) const {
        for (const char* name : names)
            if (has(name)) return name;
        return nullptr;
    }

private:
    std::span<const WorldValue> values_;
};

[[noreturn]] void exclude(const std::string& one, const std::string& other, std::string advice = {}) {
    throw Error(ErrorCode::usage, "cannot be given together with '" + other + "'", {}, std::move(advice))
        .about(one, {other});
}

void check_picture(const PictureRequest& r, const Given& given) {
    const RenderSettings& s = r.settings;
    const Window& w = s.window;
    if (given.has("window") && (w.x < 0 || w.y < 0 || w.x > s.width - w.width || w.y > s.height - w.height))
        throw Error(ErrorCode::usage,
                    format_text("does not lie inside the picture of {} x {} pixels that 'resolution' asks for", s.width,
                                s.height))
            .about("window", {"resolution"});
    if (has_pixel_samples(s) && s.visibility != Visibility::z_reversed)
        throw Error(ErrorCode::usage, format_text("{} samples need 'visibility' z-reversed, the default", s.samples))
            .about("samples", {"visibility"});
    if (given.has("point-sprites") && !s.surfaces && s.points == PointShape::none) exclude("point-sprites", "points");
    if (given.has("channel-files") && s.channels == 0)
        throw Error(ErrorCode::usage, "says how data channels are written, but 'channels' asks for none")
            .about("channel-files", {"channels"});
}

void check_view(const PictureRequest& r, const Given& given) {
    if (given.has("view") && given.has("camera-index")) exclude("view", "camera-index");
    if (const char* const other = given.first_of({"view", "camera-index"}); other && given.has("camera-position"))
        exclude(other, "camera-position", "focal point, view up and view angle may be added to either");
    if (const char* const other = given.first_of({"view", "camera-index", "camera-position"});
        other && given.has("camera-direction"))
        exclude(other, "camera-direction");
    if (const char* const other = given.first_of({"camera-index", "camera-position"});
        other && given.has("camera-zoom-factor"))
        exclude(other, "camera-zoom-factor", "it is for fitted views; a view angle may be added to either");
    if (r.view.z_near && r.view.z_far && !(*r.view.z_near < *r.view.z_far))
        throw Error(ErrorCode::usage, "must be less than 'far'").about("near", {"far"});
}

void check_bitangents(const PictureRequest& r) {
    if (r.prepare.bitangents && !(r.prepare.tangents && is_published(*r.prepare.tangents)))
        throw Error(ErrorCode::usage,
                    "attribute needs 'tangents' published or published-no-handedness: they average bitangents")
            .about("bitangents", {"tangents"});
}

void check_subdivision(const Given& given) {
    const char* const how = given.first_of(
        {"subdivide-scheme", "subdivide-crease", "subdivide-sharpness", "subdivide-boundary", "subdivide-uv"});
    if (how && !given.has("subdivide") && !given.has("subdivide-edge"))
        throw Error(ErrorCode::usage, "says how to subdivide, but nothing is to be subdivided", {}, "add 'subdivide' 3")
            .about(how, {"subdivide"});
}

void check_coloring(const PictureRequest& r, const Given& given) {
    const char* const how = given.first_of({"coloring-component", "coloring-range", "colormap", "bar"});
    if (how && !r.coloring.is_on)
        throw Error(ErrorCode::usage, "says how to color by numbers of the vertices, but nothing asks for that", {},
                    "add 'scalar-coloring', or 'scalars' with a name")
            .about(how, {"scalar-coloring", "scalars"});
}

/// The words of a value; those of flags are "on" or "off".
std::vector<std::string> words_of(const RenderKey& key, const WorldValue& value) {
    if (value.words.empty()) throw values::wrong(key.name, "a value is needed");
    const bool is_flag = key.kind == RenderKey::Kind::flag || key.kind == RenderKey::Kind::on_off;
    if (!is_flag) return value.words;
    if (value.words.size() > 1) throw values::wrong(key.name, "must be on or off");
    return {values::on_off(key.name, value.words[0]) ? "on" : "off"};
}

void check_once(std::span<const WorldValue> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (values[i].key == values[k].key) throw values::wrong(values[i].key, "is given more than once");
}

/// A list of a world file in the form of the command line: "1280,720".
std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
    return text;
}

}  // namespace

std::span<const RenderKey> render_keys() {
    static const std::vector<RenderKey> all = all_keys();
    return all;
}

const RenderKey* find_render_key(std::string_view name) {
    const auto found =
        std::ranges::find(render_keys(), name, [](const RenderKey& k) { return std::string_view(k.name); });
    return found == render_keys().end() ? nullptr : &*found;
}

bool names_files(const WorldValue& value) {
    const RenderKey* const key = find_render_key(value.key);
    return (key && key->kind == RenderKey::Kind::file) || names_lighting_file(value);
}

bool places_camera(std::string_view key) {
    constexpr std::string_view keys[] = {"view", "camera-index", "camera-position", "camera-direction"};
    return std::ranges::find(keys, key) != std::end(keys);
}

const RenderKey& require_render_key(const std::string& name) {
    if (const RenderKey* const key = find_render_key(name)) return *key;
    std::vector<std::string_view> names;
    for (const RenderKey& key : render_keys()) names.emplace_back(key.name);
    const std::string nearest = nearest_word(name, names);
    throw Error(ErrorCode::usage, "unknown key '" + one_line(name, 40) + "' in [render]", {},
                nearest.empty() ? "" : "did you mean '" + nearest + "'?");
}

void read_render_keys(std::span<const WorldValue> values, PictureRequest& to) {
    for (const WorldValue& value : values) require_render_key(value.key);
    check_once(values);
    for (const RenderKey& key : render_keys())
        for (const WorldValue& value : values) {
            if (value.key != key.name) continue;
            const std::vector<std::string> words = words_of(key, value);
            const std::string one = joined(words);
            key.read(to, key.kind == RenderKey::Kind::list ? words : std::span(&one, 1));
        }
    for (const WorldValue& value : values) to.given_keys.push_back(value.key);
    const Given given(values);
    check_picture(to, given);
    check_view(to, given);
    check_bitangents(to);
    check_subdivision(given);
    check_coloring(to, given);
    check_shaders(to.settings);
    if (given.has("animation-index") && given.has("animation-name")) exclude("animation-index", "animation-name");
}

namespace {

/// A light without name, direction (rounded by words) and numbers unused by its type and units.
Light comparable(Light light) {
    const Light plain{.type = light.type, .units = light.units, .node = light.node};
    light.name.clear();
    light.direction = plain.direction;
    if (light.type == LightType::ambient) {
        Light out = plain;
        out.ambient = light.ambient;
        return out;
    }
    const bool is_classical = light.units == LightUnits::classical, is_spot = light.type == LightType::spot;
    if (light.type == LightType::directional) light.position = plain.position, light.range = plain.range;
    if (!is_classical) light.ambient = plain.ambient, light.diffuse = plain.diffuse, light.specular = plain.specular;
    if (!is_classical || light.type == LightType::directional)
        light.constant = plain.constant, light.linear = plain.linear, light.quadratic = plain.quadratic;
    if (!is_classical || !is_spot) light.cutoff_rad = plain.cutoff_rad, light.exponent = plain.exponent;
    if (is_classical) light.color = plain.color, light.intensity = plain.intensity;
    if (is_classical || !is_spot)
        light.inner_cone_rad = plain.inner_cone_rad, light.outer_cone_rad = plain.outer_cone_rad;
    return light;
}

/// Removes fields without a key, and rounding of words, from a comparison.
PictureRequest comparable(PictureRequest r) {
    r.input.clear(), r.output.clear(), r.load = {};
    r.settings.shader_time_s = 0;
    for (vec4* const color : {&r.settings.background, &r.settings.line_color})
        if (color->w == 0 || color->w == 1) *color = {0, 0, 0, color->w};
    if (r.materials.color) r.materials.color = vec3{};
    if (r.fog) r.fog->color = {};
    for (WorldValue& value : r.materials.values) value = {.key = value.key, .words = value.words};
    if (r.lights)
        for (Light& light : *r.lights) light = comparable(light);
    return r;
}

void check_written(const std::vector<WorldValue>& values, const PictureRequest& of) {
    PictureRequest back;
    read_render_keys(values, back);
    back.given_keys = of.given_keys;
    if (!(comparable(back) == comparable(of)))
        throw Error(ErrorCode::usage, "the request asks for something that no key of [render] says");
}

}  // namespace

std::vector<WorldValue> written_render_keys(const PictureRequest& of) {
    std::vector<WorldValue> values;
    for (const RenderKey& key : render_keys())
        if (std::vector<std::string> words = key.write(of); !words.empty()) {
            WorldValue value{.key = key.name, .words = std::move(words)};
            value.is_array = key.kind == RenderKey::Kind::list;
            values.push_back(std::move(value));
        }
    check_written(values, of);
    return values;
}

}  // namespace rakelight
