// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <optional>

#include <rakelight/scene/words.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/world/settings_file.h>

#include "io/world/read_settings.h"
#include "world/keys/lighting_text.h"

namespace rakelight {
namespace {

bool has(std::span<const WorldValue> values, std::string_view key) {
    return std::ranges::find(values, key, &WorldValue::key) != values.end();
}

/// Whether a given setting overrides one of the file: the same key, another camera placement,
/// a crease angle for automatic creases, or a preset.
bool is_overridden(std::span<const WorldValue> given, std::string_view key) {
    if (is_preset_key(key) && sets_preset(given)) return true;
    if (key == "crease" && has(given, "crease-angle")) return true;
    if (!places_camera(key)) return has(given, key);
    return std::ranges::any_of(given, [](const WorldValue& value) { return places_camera(value.key); });
}

/// File names are relative to the world's folder.
void resolve(WorldValue& value, const std::string& world, bool allow_outside) {
    for (std::string& word : value.words) {
        std::string file = resolve_in_world(world, word, allow_outside);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored))
            throw Error(
                ErrorCode::not_found,
                "'" + one_line(word, 80) +
                    (std::filesystem::exists(file, ignored) ? "' is not a regular file" : "': there is no such file"));
        word = std::move(file);
    }
}

const RenderKey& known(const WorldValue& value) {
    if (value.key != "material") return require_render_key(value.key);
    throw Error(ErrorCode::bad_file, "'material' is no key of [render]", {}, "[[material]] changes materials");
}

/// Flags in files must be booleans, not words.
void check_flag(const WorldValue& value, const RenderKey& key) {
    const bool is_flag = key.kind == RenderKey::Kind::flag || key.kind == RenderKey::Kind::on_off;
    if (is_flag && value.words != std::vector<std::string>{"on"} && value.words != std::vector<std::string>{"off"})
        throw Error(ErrorCode::bad_file, "'" + value.key + "' must be true or false");
}

bool names_shader(const WorldValue& value) { return value.key == "vertex-shader" || names_lighting_file(value); }

/// A world comes from anywhere, and a driver's compiler bounds neither its memory nor its time (docs/untrusted-files.md).
void refuse_shader(const WorldValue& value) {
    const std::string file = value.words.empty() ? "" : " '" + one_line(value.words[0], 80) + "'";
    throw Error(ErrorCode::bad_file, "a world may not name the GLSL file" + file + " by itself", {},
                "use 'allow-shaders' if you trust the file")
        .naming({"allow-shaders"});
}

/// Separates the file's settings into applied and overridden ones.
class Taking {
public:
    Taking(const std::string& path, const RenderOverrides& overrides, const LoadOptions& options)
        : path_(path), overrides_(overrides), options_(options) {}

    void take(WorldValue value) {
        try {
            const bool is_wanted = !overrides_.accepts || overrides_.accepts(value.key);
            const RenderKey& key = known(value);
            if (is_overridden(overrides_.values, value.key)) return overridden.push_back(value.key);
            if (!is_wanted) return;
            check_flag(value, key);
            if (!options_.allow_shaders && names_shader(value)) refuse_shader(value);
            if (names_files(value)) resolve(value, path_, options_.allow_outside);
            taken.push_back(std::move(value));
        } catch (const Error& error) {
            const ErrorCode code = error.code() == ErrorCode::usage ? ErrorCode::bad_file : error.code();
            throw error.as(code).at(to_text(value.place)).about(value.key, error.related()).with_file(path_);
        }
    }

    std::vector<WorldValue> taken;
    std::vector<std::string> overridden;

private:
    const std::string& path_;
    const RenderOverrides& overrides_;
    const LoadOptions& options_;
};

/// The settings of an error: the first word of the main one, then the related ones.
std::vector<std::string> settings_of(const Error& error) {
    std::vector<std::string> all = error.related();
    if (!error.setting().empty()) all.insert(all.begin(), error.setting().substr(0, error.setting().find(' ')));
    return all;
}

/// The error for a given setting that conflicts with one of the file: names both.
std::optional<Error> disagreement(const Error& error, const WorldRequest& world, std::span<const WorldValue> given) {
    std::string of_caller, of_world;
    for (const std::string& setting : settings_of(error)) {
        const auto value = std::ranges::find(world.applied, setting, &WorldValue::key);
        if (has(given, setting))
            of_caller = "'" + setting + "' is given";
        else if (value != world.applied.end())
            of_world = "'" + setting + "' is of " + one_line(world.picture.input, 80) + ", " + to_text(value->place);
    }
    if (of_caller.empty() || of_world.empty()) return {};
    return Error(ErrorCode::usage, error.reason(), {}, of_world + ", " + of_caller)
        .about(error.setting(), settings_of(error));
}

}  // namespace

bool sets_preset(std::span<const WorldValue> settings) {
    const auto preset = std::ranges::find(settings, "preset", &WorldValue::key);
    return preset != settings.end() && !preset->words.empty() && !same_word(preset->words[0], "none");
}

bool sets_shading(std::span<const WorldValue> settings) {
    const auto shading = std::ranges::find(settings, "shading", &WorldValue::key);
    return shading != settings.end() && std::ranges::any_of(shading->words, [](const std::string& word) {
               return !word.starts_with("material:") && !word.starts_with("object:");
           });
}

Error at_world_value(const Error& error, const WorldRequest& world) {
    for (const std::string& setting : settings_of(error))
        if (const auto value = std::ranges::find(world.applied, setting, &WorldValue::key);
            value != world.applied.end())
            return error.as(ErrorCode::bad_file).at(to_text(value->place)).with_file(world.picture.input);
    return error;
}

namespace {

WorldRequest request_of(std::vector<WorldValue> render, const std::string& path, const LoadOptions& options,
                        const RenderOverrides& overrides, Look look) {
    Taking taking(path, overrides, options);
    for (WorldValue& value : render) taking.take(std::move(value));
    WorldRequest world;
    world.picture.input = path;
    world.picture.load = options;
    world.picture.look = look;
    world.applied = std::move(taking.taken);
    std::vector<WorldValue> all = world.applied;
    all.insert(all.end(), overrides.values.begin(), overrides.values.end());
    try {
        read_render_keys(all, world.picture);
    } catch (const Error& error) {
        if (const auto both = disagreement(error, world, overrides.values)) throw Error(*both);
        throw at_world_value(error, world);
    }
    world.picture.settings.material_shading = !sets_shading(overrides.values);
    std::vector<std::string>& overridden = world.picture.load.overridden;
    overridden.insert(overridden.end(), taking.overridden.begin(), taking.overridden.end());
    if (has(overrides.values, "up")) overridden.emplace_back("up");  // also where the file has none
    return world;
}

}  // namespace

WorldRequest read_world_request(const std::string& path, const LoadOptions& options, const RenderOverrides& overrides,
                                Context& context) {
    return request_of(read_world(path, context).render, path, options, overrides, Look::standard);
}

WorldRequest read_settings_file(const std::string& path, const LoadOptions& options, const RenderOverrides& overrides,
                                Context& context) {
    LoadOptions trusted = options;
    trusted.allow_shaders |=
        !is_world_file(path);  // settings that the user wrote, unlike a world, which may be anybody's
    WorldRequest request = request_of(io::world::read_settings(path, context), path, trusted, overrides, Look::plain);
    request.picture.load.allow_shaders = options.allow_shaders;
    return request;
}

PictureRequest request_of_world(const std::string& path, const LoadOptions& options, Context& context) {
    return read_world_request(path, options, {}, context).picture;
}

}  // namespace rakelight
