// SPDX-License-Identifier: Apache-2.0
// Scenes put together into one.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A scene that becomes part of another one; the same scene may be there many times.
struct ScenePart {
    const Scene& scene;
    std::optional<Node> root;  ///< a new node above all of the part; absent: the part's roots are the whole's
    bool with_lights = true, with_cameras = true;
};

/// What becomes of the numbers of a part: each is that much larger.
struct MergeOffsets {
    std::uint32_t nodes = 0, meshes = 0, materials = 0, textures = 0, skins = 0, lights = 0, cameras = 0;
};

struct MergedScene {
    Scene scene;
    std::vector<MergeOffsets> offsets;  ///< [parts]
};

/// All of the parts, one after another; arrays and pictures are shared, tables are copied and charged to the budget
/// before. Fog, environments, poses and missing_normals_are_flat of the parts are ignored.
/// @throws Error bad_file: too many elements for 32-bit indices, more memory than the budget has; failed: cancelled
MergedScene merge_scenes(std::span<const ScenePart> parts, Context& context);

}  // namespace rakelight
