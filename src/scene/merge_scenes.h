// SPDX-License-Identifier: Apache-2.0
// Merges scenes.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A scene to merge; the same scene may be used several times.
struct ScenePart {
    const Scene& scene;
    std::optional<Node> root;  ///< a new parent of the part's roots; absent: they stay roots
    bool with_lights = true, with_cameras = true;
};

/// Index offsets of a part.
struct MergeOffsets {
    std::uint32_t nodes = 0, meshes = 0, materials = 0, textures = 0, skins = 0, lights = 0, cameras = 0;
};

struct MergedScene {
    Scene scene;
    std::vector<MergeOffsets> offsets;  ///< [parts]
};

/// Concatenates the parts; arrays and pictures are shared, tables are copied and charged to the budget before. Fog,
/// environments, poses and missing_normals_are_flat of the parts are ignored.
/// @throws Error bad_file: too many elements for 32-bit indices, over the memory budget; failed: cancelled
MergedScene merge_scenes(std::span<const ScenePart> parts, Context& context);

}  // namespace rakelight
