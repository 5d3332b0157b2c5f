// SPDX-License-Identifier: Apache-2.0
// Scenes as prepare_scene() returns them, checked.
#pragma once
#include <rakelight/scene/validate.h>

#include "prepare/prepare_scene.h"
#include "unit/prepare/meshes.h"

namespace rakelight::test {

inline Scene prepared(const Scene& scene, PrepareOptions options = {}) {
    Context context;
    Scene out = prepare_scene(scene, options, context);
    validate(out);
    for (const Node& node : out.nodes)
        for (const std::uint32_t mesh : node.meshes)
            expect_unit(out.meshes[mesh].normals, out.meshes[mesh].positions.size());
    return out;
}

inline PrepareOptions by(NormalSource source) {
    PrepareOptions options;
    options.normals = source;
    return options;
}

}  // namespace rakelight::test
