// SPDX-License-Identifier: Apache-2.0
// Keys of the picture: size, samples, data channels, engine, shading frequency, visibility, lines and points.
#include "base/format_text.h"

#include <rakelight_internal/base/text.h>
#include "world/keys/channel_info.h"
#include "world/keys/fixed_function.h"
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

constexpr Word<std::uint32_t> channel_file_words[] = {
    {"exr", channel_files_exr}, {"layers", channel_files_layers}, {"png", channel_files_png}};
constexpr Word<bool> exr_color_words[] = {{"float", false}, {"half", true}};
constexpr Word<RayMethod> method_words[] = {{"auto", RayMethod::automatic},
                                            {"whitted", RayMethod::whitted},
                                            {"cast", RayMethod::cast},
                                            {"path", RayMethod::path},
                                            {"radiosity", RayMethod::radiosity}};
constexpr Word<LightSampling> sampling_words[] = {
    {"both", LightSampling::both}, {"lights", LightSampling::lights}, {"materials", LightSampling::materials}};
constexpr Word<FrontFace> front_words[] = {{"ccw", FrontFace::counter_clockwise}, {"cw", FrontFace::clockwise}};
constexpr Word<Cull> cull_words[] = {
    {"auto", Cull::automatic}, {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}};
constexpr Word<AttributeInterpolation> interpolation_words[] = {{"perspective", AttributeInterpolation::perspective},
                                                                {"screen", AttributeInterpolation::screen}};
constexpr Word<Visibility> visibility_words[] = {{"z-reversed", Visibility::z_reversed},
                                                 {"z-float", Visibility::z_float},
                                                 {"z16", Visibility::z16},
                                                 {"z24", Visibility::z24},
                                                 {"z32", Visibility::z32},
                                                 {"painter", Visibility::painter},
                                                 {"none", Visibility::none},
                                                 {"back-face", Visibility::back_face}};
constexpr Word<PointShape> point_words[] = {
    {"none", PointShape::none}, {"square", PointShape::square}, {"disc", PointShape::disc}};

constexpr Word<Preset> preset_words[] = {{"none", Preset::none}, {"fixed-function", Preset::fixed_function}};

/// Read before all keys that it sets.
void read_preset(PictureRequest& r, Words w) {
    r.preset = values::word("preset", w[0], preset_words);
    set_preset(r.preset, r);
}

/// Ray tracing has shadows by default; `shadows`, which is read later, may override it.
void read_engine(PictureRequest& r, Words w) {
    r.engine = lower_case(w[0]);
    if (r.engine == "trace") r.settings.shadows = true;
}

/// One path per pixel is useless; with an error or time limit the samples do not end the picture.
int plain_samples(const RenderSettings& s) {
    if (s.method != RayMethod::path) return defaults().settings.samples;
    return s.paths.noise > 0 || s.paths.max_seconds > 0 ? 65536 : 64;
}

/// `samples`, which is read later, may override it.
void set_plain_paths(RenderSettings& s) {
    if (s.method == RayMethod::path) s.samples = plain_samples(s);
}

void read_method(PictureRequest& r, Words w) {
    r.settings.method = values::word("method", w[0], method_words);
    set_plain_paths(r.settings);
}

Written write_samples(const PictureRequest& r) {
    return r.settings.samples == plain_samples(r.settings) ? Written{} : Written{std::to_string(r.settings.samples)};
}

void read_resolution(PictureRequest& r, Words w) {
    const std::vector<int> size = values::integers("resolution", w[0], 2);
    constexpr int most = 65536;
    if (size[0] < 1 || size[1] < 1 || size[0] > most || size[1] > most)
        throw values::wrong("resolution", "must be 1 to 65536 pixels a side");
    r.settings.width = size[0], r.settings.height = size[1];
}

Written write_resolution(const PictureRequest& r) {
    const RenderSettings &s = r.settings, &plain = defaults().settings;
    if (s.width == plain.width && s.height == plain.height) return {};
    return {format_text("{},{}", s.width, s.height)};
}

void read_window(PictureRequest& r, Words w) {
    const std::vector<int> v = values::integers("window", w[0], 4);
    if (v[2] < 1 || v[3] < 1) throw values::wrong("window", "the window is empty");
    r.settings.window = {v[0], v[1], v[2], v[3]};
}

std::string text_of_window(const Window& w) { return format_text("{},{},{},{}", w.x, w.y, w.width, w.height); }

void read_channels(PictureRequest& r, Words w) {
    r.settings.channels = 0;
    for (const std::string_view name : values::split(w[0], ',')) {
        try {
            r.settings.channels |= channels_by_name(name);
        } catch (const Error& error) {
            throw error.about("channels");
        }
    }
}

Written write_channels(const PictureRequest& r) {
    if (r.settings.channels == 0) return {};
    if (r.settings.channels == channels_all) return {"all"};
    std::string names;
    for (const ChannelInfo& c : all_channels())
        if (r.settings.channels & c.channel) names += (names.empty() ? "" : ",") + std::string(c.word);
    return {names};
}

void read_channel_files(PictureRequest& r, Words w) {
    r.channel_files = 0;
    for (const std::string_view way : values::split(w[0], ','))
        r.channel_files |= values::word("channel-files", way, channel_file_words);
}

std::string channel_files_of(std::uint32_t bits) {
    std::string names;
    for (const auto& way : channel_file_words)
        if (bits & way.value) names += (names.empty() ? "" : ",") + std::string(way.name);
    return names;
}

std::string background_of(vec4 color) { return color.w < 1 ? "transparent" : color_of(color.xyz()); }

Shading shading_word(std::string_view text) { return values::word("shading", text, shading_words); }

/// HOW, material:NAME=HOW, object:NAME=HOW. Names may hold any character: the last '=' ends them.
void read_shading(PictureRequest& r, Words w) {
    RenderSettings& s = r.settings;
    std::size_t plain = 0;
    s.shading_rules.clear();
    for (const std::string_view text : w) {
        const bool is_material = text.starts_with("material:");
        if (!is_material && !text.starts_with("object:")) {
            s.shading = shading_word(text);
            if (++plain > 1) throw values::wrong("shading", "how the whole is shaded can be said once");
            continue;
        }
        const std::size_t begin = text.find(':') + 1, equals = text.rfind('=');
        if (equals == text.npos || equals <= begin)
            throw values::wrong("shading",
                                "'" + one_line(std::string(text), 60) + "' needs a name and '=' with how it is shaded",
                                "write for example material:glass=flat");
        s.shading_rules.push_back({is_material ? ShadingRule::Of::material : ShadingRule::Of::object,
                                   std::string(text.substr(begin, equals - begin)),
                                   shading_word(text.substr(equals + 1))});
    }
}

Written write_shading(const PictureRequest& r) {
    Written all;
    if (r.settings.shading != defaults_beside(r).settings.shading) all = name_in(shading_words, r.settings.shading);
    for (const ShadingRule& rule : r.settings.shading_rules)
        all.push_back((rule.of == ShadingRule::Of::material ? "material:" : "object:") + rule.name + "=" +
                      name_in(shading_words, rule.shading)[0]);
    return all;
}

float pixels(const char* key, const std::string& text) {
    const double size = values::number(key, text);
    if (!(size > 0 && size <= 256)) throw values::wrong(key, "must be more than 0 and at most 256 pixels");
    return float(size);
}

void read_wireframe(PictureRequest& r, Words w) {
    if (w[0] != "on") return;
    r.settings.edges = true;
    r.settings.surfaces = false;
}

void read_point_sprites(PictureRequest& r, Words w) {
    if (w[0] != "on") return;
    r.settings.points = PointShape::disc;  // `points`, which is read later, may select squares
    r.settings.surfaces = false;
}

constexpr RenderKey table_of_picture[] = {
    {"preset", Kind::value, read_preset, RL_WRITE(r.preset, (name_in(preset_words, r.preset)))},
    {"engine", Kind::value, read_engine, RL_WRITE(r.engine, {r.engine})},
    {"method", Kind::value, read_method, RL_WRITE(r.settings.method, (name_in(method_words, r.settings.method)))},
    RL_INTEGER_KEY("max-depth", r.settings.max_depth, 0, 64),
    RL_KEY("naive", flag, r.settings.naive, w[0] == "on", {"on"}),
    RL_NUMBER_KEY("naive-limit", r.settings.naive_limit, 0, 1e18),
    RL_INTEGER_KEY("radiosity-elements", r.settings.radiosity.elements, 1, max_radiosity_elements),
    RL_NUMBER_KEY("radiosity-unshot", r.settings.radiosity.unshot, 0.0001, 1),
    {"resolution", Kind::value, read_resolution, write_resolution},
    {"window", Kind::value, read_window, RL_WRITE(r.settings.window, {text_of_window(r.settings.window)})},
    RL_INTEGER_KEY("seed", r.settings.paths.seed, 0, 2147483647),
    {"max-seconds", Kind::value,
     [](PictureRequest& r, Words w) {
         r.settings.paths.max_seconds = values::number("max-seconds", w[0], 0, 1e9);
         set_plain_paths(r.settings);
     },
     RL_WRITE(r.settings.paths.max_seconds, {text_of(r.settings.paths.max_seconds)})},
    {"noise", Kind::value,
     [](PictureRequest& r, Words w) {
         r.settings.paths.noise = values::number("noise", w[0], 0, 1e9);
         set_plain_paths(r.settings);
     },
     RL_WRITE(r.settings.paths.noise, {text_of(r.settings.paths.noise)})},
    {"samples", Kind::value,
     [](PictureRequest& r, Words w) { r.settings.samples = values::integer("samples", w[0], 1, max_paths_per_pixel); },
     write_samples},
    RL_NUMBER_KEY("clamp", r.settings.paths.clamp, 0, 1e18),
    RL_WORD_KEY("light-sampling", r.settings.paths.light_sampling, sampling_words),
    RL_KEY("denoise", flag, r.settings.paths.denoise, w[0] == "on", {"on"}),
    RL_INTEGER_KEY("anisotropy", r.settings.anisotropy, 1, 16),
    RL_KEY("background", value, r.settings.background, values::background("background", w[0]),
           {background_of(r.settings.background)}),
    {"channels", Kind::value, read_channels, write_channels},
    {"channel-files", Kind::value, read_channel_files, RL_WRITE(r.channel_files, {channel_files_of(r.channel_files)})},
    RL_WORD_KEY("exr-colors", r.half_colors, exr_color_words),
    {"shading", Kind::list, read_shading, write_shading},
    RL_WORD_KEY("front-face", r.settings.front_face, front_words),
    RL_WORD_KEY("cull", r.settings.cull, cull_words),
    RL_WORD_KEY("visibility", r.settings.visibility, visibility_words),
    RL_WORD_KEY("interpolation", r.settings.interpolation, interpolation_words),
    RL_KEY("edges", flag, r.settings.edges, w[0] == "on", {"on"}),
    {"wireframe", Kind::flag, read_wireframe,
     [](const PictureRequest& r) -> Written {
         return !r.settings.surfaces && r.settings.edges ? Written{"on"} : Written{};
     }},
    {"point-sprites", Kind::flag, read_point_sprites,
     [](const PictureRequest& r) -> Written {
         return !r.settings.surfaces && r.settings.points != PointShape::none ? Written{"on"} : Written{};
     }},
    RL_WORD_KEY("points", r.settings.points, point_words),
    RL_KEY("grid", flag, r.overlays.grid, w[0] == "on", {"on"}),
    RL_KEY("axis", flag, r.overlays.axis, w[0] == "on", {"on"}),
    RL_KEY("filename", flag, r.overlays.filename, w[0] == "on", {"on"}),
    RL_KEY("metadata", flag, r.overlays.metadata, w[0] == "on", {"on"}),
    RL_KEY("line-width", value, r.settings.line_width, pixels("line-width", w[0]),
           {text_of_float(r.settings.line_width)}),
    RL_KEY("point-size", value, r.settings.point_size, pixels("point-size", w[0]),
           {text_of_float(r.settings.point_size)}),
    RL_KEY("line-color", value, r.settings.line_color, values::display_color("line-color", w[0]),
           {color_of(r.settings.line_color.xyz())}),
};

}  // namespace

constinit const KeyTable picture_keys = table_of_picture;

}  // namespace rakelight::keys
