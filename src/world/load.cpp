// SPDX-License-Identifier: Apache-2.0
// Loading of scenes by name.
#include <rakelight/io/world_words.h>
#include <rakelight/world/load.h>
#include <rakelight_internal/base/file_ending.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "io/content_kind.h"
#include "io/reader.h"
#include "world/join_scenes.h"
#include "world/load_world.h"
#include "world/make_shape.h"

namespace rakelight {
namespace {
constexpr const char* builtin_prefix = "builtin:";

Scene load_shape(const std::string& words, const std::string& path, Context& context) {
    try {
        return make_shape(request_of(shape_of_words(words)), &context.memory());
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

/// The name of a file in memory; without an ending it gets one by content.
std::string named(const MemoryFile& file) {
    if (!file_ending(file.name).empty()) return file.name;
    const std::string_view ending =
        io::content_kind(std::span(*file.bytes).first(std::min<std::size_t>(64, file.bytes->size()))).ending;
    return ending.empty() ? file.name : file.name + "." + std::string(ending);
}

Scene load_single(const std::string& path, const LoadOptions& options, Context& context) {
    context.progress("load", 0);
    if (path.starts_with(builtin_prefix)) {
        const std::string words = path.substr(std::strlen(builtin_prefix)), name = words.substr(0, words.find(':'));
        if (name == "teapot" || primitive_named(name)) return load_shape(words, path, context);
        throw Error(ErrorCode::not_found, "there is no such built-in model", {},
                    "builtin:teapot, sphere, cylinder, cone, torus and plane are there")
            .with_file(path);
    }
    const auto in_memory = std::ranges::find(options.memory_files, path, &MemoryFile::name);
    if (in_memory != options.memory_files.end())
        return io::read_scene(named(*in_memory), in_memory->bytes, {.allow_outside = options.allow_outside}, context);
    if (is_world_file(path)) return load_world(path, read_world(path, context), options, context);
    return io::read_scene(path, {.allow_outside = options.allow_outside}, context);
}
}  // namespace

Scene load(const std::string& path, const LoadOptions& options, Context& context) {
    if (options.joined.empty()) return load_single(path, options, context);
    std::vector<Scene> scenes;
    scenes.push_back(load_single(path, options, context));
    for (const std::string& other : options.joined) {
        context.throw_if_cancelled();
        scenes.push_back(load_single(other, options, context));
    }
    return join_scenes(scenes, context);
}

Scene load(std::vector<std::byte> bytes, const std::string& path, const LoadOptions& options, Context& context) {
    try {
        if (is_world_file(path)) {
            const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            return load_world(path, parse_world(text), options, context);
        }
        MemoryCharge charge = MemoryCharge::of_file(context.memory(), bytes.size(), "the file");
        return io::read_scene(path, io::charged_bytes(std::move(bytes), std::move(charge)),
                              {.allow_outside = options.allow_outside}, context);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace rakelight
