// SPDX-License-Identifier: Apache-2.0
// Facade: where a scene comes from.
#include <rakelight/render.h>

#include "io/reader.h"
#include "prepare/prepare.h"

namespace rakelight {
namespace {
constexpr const char* builtin_prefix = "builtin:";
}

Scene load(const std::string& path, const LoadOptions& options, Context& context) {
    if (path.starts_with(builtin_prefix)) {
        if (path != "builtin:teapot")
            throw Error(ErrorCode::not_found, "there is no such built-in model", {}, "builtin:teapot is one")
                .with_file(path);
        Scene scene = make_teapot();
        scene.source = path;
        return scene;
    }
    return io::read_scene(path, {.allow_outside = options.allow_outside}, context);
}

}  // namespace rakelight
