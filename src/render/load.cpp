// SPDX-License-Identifier: Apache-2.0
// Facade: where a scene comes from.
#include <rakelight/render.h>

#include <cstring>

#include "io/reader.h"
#include "prepare/prepare.h"
#include "prepare/primitives.h"
#include "render/load_world.h"

namespace rakelight {
namespace {
constexpr const char* builtin_prefix = "builtin:";
}

Scene load(const std::string& path, const LoadOptions& options, Context& context) {
    if (path.starts_with(builtin_prefix)) {
        const std::string name = path.substr(std::strlen(builtin_prefix));
        if (const auto shape = primitive_named(name)) return make_primitive({.shape = *shape}, &context.memory());
        if (name == "teapot") return make_teapot(10, &context.memory());
        throw Error(ErrorCode::not_found, "there is no such built-in model", {},
                    "builtin:teapot, sphere, cylinder, cone, torus and plane are there")
            .with_file(path);
    }
    if (is_world_file(path)) return load_world(path, options, context);
    return io::read_scene(path, {.allow_outside = options.allow_outside}, context);
}

}  // namespace rakelight
