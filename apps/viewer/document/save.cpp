// SPDX-License-Identifier: Apache-2.0
#include "save.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/base/text.h>

#include "../motion/recorded_keys.h"
#include "material_sections.h"
#include "materials.h"
#include "shell_words.h"

#include <rakelight/world/render_keys.h>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

bool is_shape(const std::string& file) { return file.starts_with("builtin:"); }

/// A file's name from the folder of a world.
std::string from_folder(const std::string& file, const fs::path& folder) {
    if (file.empty() || is_shape(file)) return file;
    // By the names alone: what a link is called says which files lie beside it.
    const fs::path near = fs::absolute(file).lexically_normal(), from = fs::absolute(folder).lexically_normal();
    return near.lexically_proximate(from).generic_string();
}

fs::path folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/// Names of a world from another folder than its own.
void move_names(WorldFile& world, const fs::path& from, const fs::path& to) {
    const auto move = [&](std::string& name) {
        if (!name.empty() && !is_shape(name)) name = from_folder((from / name).string(), to);
    };
    for (WorldModel& model : world.models) move(model.file);
    if (world.environment) move(world.environment->file);
    for (WorldMaterial& material : world.materials)
        for (WorldValue& value : material.values)
            if (value.key.ends_with("_texture") && !value.words.empty()) move(value.words[0]);
}

/// Values with the names of pictures from a world's folder.
std::vector<WorldValue> values_in(std::vector<WorldValue> values, const fs::path& folder) {
    for (WorldValue& value : values)
        if (value.key.ends_with("_texture") && !value.words.empty())
            value.words[0] = from_folder(value.words[0], folder);
    return values;
}

WorldMaterial world_target(const MaterialTarget& target, const Scene& scene) {
    if (target.node == no_index) return {.name = target.name};
    const ObjectInWorld object = object_in_world(scene, target.node);
    return {.name = target.name, .model = object.model, .object = object.object};
}

void set_lights(WorldFile& world, std::vector<Light> lights) {
    for (WorldModel& model : world.models) model.lights = false;
    for (Light& light : lights) light.name = one_line(light.name, 100);
    world.lights = std::move(lights);
}

/// A name that no camera of the world has.
std::string camera_name(const WorldFile& world) {
    for (int i = 1;; ++i) {
        std::string name = i == 1 ? "recorded" : "recorded " + std::to_string(i);
        if (std::ranges::find(world.cameras, name, &Camera::name) == world.cameras.end()) return name;
    }
}

/// The recorded camera, which the picture looks through then. @return its number
std::uint32_t add_recorded_camera(WorldFile& world, const Look& look, const Camera& now, PictureRequest& request) {
    Camera camera = level_camera(look.world_up);
    camera.name = camera_name(world);
    camera.vertical_fov_rad = now.vertical_fov_rad;
    camera.z_near = now.z_near / 4, camera.z_far = now.z_far * 4;  // it comes nearer and goes farther than now
    camera.to_world[3] = now.to_world[3];
    request.view = {.camera = camera.name, .world_up = request.view.world_up};
    world.cameras.push_back(std::move(camera));
    return std::uint32_t(world.cameras.size() - 1);
}

/// Recorded keys as paths of the world. @param now  the camera that is seen now
void add_keys(WorldFile& world, const Look& look, const Camera& now, PictureRequest& request) {
    const Animation keys = animation_of_keys(look);
    std::uint32_t camera = no_index;
    for (const AnimationChannel& channel : keys.channels) {
        const bool is_camera = channel.path == AnimationPath::camera;
        if (is_camera && camera == no_index) camera = add_recorded_camera(world, look, now, request);
        // Lights that are off are not saved: what stands behind them moves up.
        const auto is_on = [&](std::uint32_t i) { return (*look.lights)[i].is_on; };
        if (!is_camera && !is_on(channel.element)) continue;
        std::uint32_t element = is_camera ? camera : 0;
        for (std::uint32_t i = 0; !is_camera && i < channel.element; ++i) element += is_on(i);
        WorldTrack& track = world.tracks.emplace_back();
        track.path = channel.path, track.element = element, track.property = channel.property;
        track.times.assign(channel.times.begin(), channel.times.end());
        track.values.assign(channel.values.begin(), channel.values.end());
    }
}

/// Shading of the whole that goes before what parts and materials say: [render] of a world says it by taking that away.
void take_own_shading(WorldFile& world, PictureRequest& request) {
    if (request.settings.material_shading) return;
    for (WorldModel& model : world.models) model.shading.reset();
    for (WorldPrimitive& shape : world.primitives) shape.shading.reset();
    for (WorldMaterial& material : world.materials)
        std::erase_if(material.values, [](const WorldValue& value) { return value.key == "shading"; });
    request.settings.material_shading = true;
}

std::vector<WorldValue> render_of(const PictureRequest& request, const fs::path& folder) {
    std::vector<WorldValue> values = written_render_keys(request);
    bool has_size = false;
    for (WorldValue& value : values) {
        has_size |= value.key == "resolution";
        if (names_files(value))
            for (std::string& word : value.words) word = from_folder(word, folder);
    }
    const RenderSettings& s = request.settings;
    const bool has_samples = std::ranges::find(values, "samples", &WorldValue::key) != values.end();
    if (!has_samples) values.push_back({.key = "look", .words = {"plain"}});  // else worlds have four
    if (!has_size)  // what is the default today need not be it forever
        values.push_back({.key = "resolution", .words = {std::to_string(s.width) + "," + std::to_string(s.height)}});
    return values;
}

bool is_flag(const RenderKey& key) { return key.kind == RenderKey::Kind::flag || key.kind == RenderKey::Kind::on_off; }

/// Settings that [render] of the model's world has and the look does not: they are at their defaults again.
std::vector<WorldValue> taken_back(const Model& model, const std::vector<WorldValue>& written) {
    const auto is_listed = [&](const WorldValue& value) {
        const bool is_place = places_camera(value.key);
        return std::ranges::any_of(
            written, [&](const WorldValue& w) { return w.key == value.key || (is_place && places_camera(w.key)); });
    };
    std::vector<WorldValue> back = model.world.render;
    std::erase_if(back,
                  [&](const WorldValue& v) { return is_listed(v) || v.key == "resolution" || v.key == "shading"; });
    return back;
}

std::string stem_of(const std::string& file) {
    std::string stem = is_shape(file) ? file.substr(8) : fs::path(file).stem().string();
    if (is_world_file(file)) stem = fs::path(stem).stem().string();
    for (char& c : stem) c = c == ':' || c == '=' || c == '/' ? '-' : c;
    return stem.empty() ? "picture" : stem;
}

std::string with_number(const std::string& name, int number, const std::string& ending) {
    return name + "-" + std::to_string(number) + ending;
}

/// The first that does not exist yet of "folder/name.ending", "folder/name-2.ending", ...
std::string free_beside(const std::string& model_file, const std::string& name, const std::string& ending) {
    const fs::path folder = is_shape(model_file) ? fs::path(".") : folder_of(model_file);
    std::error_code ignored;
    for (int i = 1;; ++i) {
        const std::string file = i == 1 ? name + ending : with_number(name, i, ending);
        const fs::path path = (folder / file).lexically_normal();
        if (!fs::exists(path, ignored)) return path.string();
    }
}

}  // namespace

WorldFile world_of(const Look& look, const Model& model, int width, int height, const std::string& path) {
    const fs::path folder = folder_of(path);
    WorldFile world;
    if (is_world_file(model.file)) {
        world = model.world;
        move_names(world, folder_of(model.file), folder);
    } else {
        WorldModel part{.file = from_folder(model.file, folder)};
        part.lights = !model.scene.lights.empty(), part.cameras = !model.scene.cameras.empty();
        part.name = stem_of(model.file);
        world.models.push_back(std::move(part));
    }
    PictureRequest request = request_of(look, width, height);
    if (request.lights) set_lights(world, *request.lights);
    if (request.lights && !request.lights->empty()) request.lights.reset();  // none is said by [render]
    add_keys(world, look, camera_of(look, model, width, height), request);
    for (const bool is_of_object : {false, true})
        for (const MaterialEdit& edit : look.materials)
            if ((edit.target.node != no_index) == is_of_object)
                set_values(world, world_target(edit.target, model.scene), values_in(edit.values, folder));
    set_values(world, {.name = "*"}, values_in(request.materials.values, folder));
    request.materials.values.clear();
    take_own_shading(world, request);
    world.render = render_of(request, folder);
    // Rays have them anyway, but other engines only if the document says so.
    if (request.engine == "trace" && request.settings.shadows && !look.shadows_by_nature)
        world.render.push_back({.key = "shadows", .words = {"on"}});
    world.remarks.clear();
    return world;
}

std::string not_saved(const Look& look) {
    std::string text;
    const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
    std::ptrdiff_t off = 0, following = 0;
    if (look.lights) {
        off = std::ranges::count(*look.lights, false, &LightItem::is_on);
        following = std::ranges::count(*look.lights, true, &LightItem::follows_camera);
    }
    if (off > 0) add(counted(std::uint64_t(off), "light that is off", "lights that are off"));
    if (following > 0)
        add("that " + counted(std::uint64_t(following), "light follows", "lights follow") + " the camera");
    if (look.channel) add("the data channel shown");
    return text;
}

std::string command_line_of(const Look& look, const Model& model, int width, int height) {
    PictureRequest request = request_of(look, width, height);
    std::string text = "rakelight render " + quoted(model.file) + " -o " + quoted(stem_of(model.file) + ".png");
    if (request.load.allow_outside) text += " --allow-outside";
    if (request.load.allow_shaders) text += " --allow-shaders";
    text += " --look plain";  // what the default look chose is reported below
    const bool is_listed = !request.settings.material_shading && request.settings.shading == Shading::phong;
    if (is_listed) text += " --shading phong";  // the default, but here it takes away what materials say
    request.settings.material_shading = true;
    const std::vector<WorldValue> written = written_render_keys(request);
    for (const WorldValue& value : written) {
        const RenderKey& key = require_render_key(value.key);
        for (const std::string& word : value.words)
            text += " --" + value.key + (is_flag(key) ? "=" : " ") + quoted(word);
    }
    for (const WorldValue& value : taken_back(model, written))
        if (is_flag(require_render_key(value.key)) && !value.words.empty())
            text += " --" + value.key + (value.words[0] == "on" ? "=off" : "=on");
    return text;
}

std::string not_on_command_line(const Look& look, const Model& model) {
    std::string text = look.materials.empty() ? "" : "changed materials";
    PictureRequest request = request_of(look, 1, 1);
    request.settings.material_shading = true;
    for (const WorldValue& value : taken_back(model, written_render_keys(request)))
        if (!is_flag(require_render_key(value.key))) text += (text.empty() ? "" : ", ") + value.key;
    return text;
}

std::string free_world_name(const std::string& model_file) {
    return free_beside(model_file, stem_of(model_file), ".scene.toml");
}

std::string free_seamless_name(const std::string& model_file) {
    const std::string ending = is_shape(model_file) ? "" : file_ending(model_file);
    const bool is_kept = ending == "glb" || ending == "gltf" || ending == "obj";
    return free_beside(model_file, stem_of(model_file) + "-seamless", is_kept ? "." + ending : ".glb");
}

std::string free_name(const std::string& model_file, const std::string& middle, const std::string& ending) {
    const std::string stem = stem_of(model_file) + middle;
    std::set<std::string> taken;  // up to their first dot
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(".", ignored)) {
        const std::string name = entry.path().filename().string();
        taken.insert(name.substr(0, name.find('.', std::min(stem.size(), name.size()))));
    }
    for (int i = 1;; ++i)
        if (!taken.contains(with_number(stem, i, ""))) return with_number(stem, i, ending);
}

}  // namespace rakelight::viewer
