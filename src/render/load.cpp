// SPDX-License-Identifier: Apache-2.0
// Facade: where a scene comes from.
#include <rakelight/render.h>

#include <cstring>

#include "io/reader.h"
#include "render/load_world.h"
#include "render/make_shape.h"

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
}  // namespace

Scene load(const std::string& path, const LoadOptions& options, Context& context) {
    if (path.starts_with(builtin_prefix)) {
        const std::string words = path.substr(std::strlen(builtin_prefix)), name = words.substr(0, words.find(':'));
        if (name == "teapot" || primitive_named(name)) return load_shape(words, path, context);
        throw Error(ErrorCode::not_found, "there is no such built-in model", {},
                    "builtin:teapot, sphere, cylinder, cone, torus and plane are there")
            .with_file(path);
    }
    if (is_world_file(path)) return load_world(path, options, context);
    return io::read_scene(path, {.allow_outside = options.allow_outside}, context);
}

}  // namespace rakelight
