// SPDX-License-Identifier: Apache-2.0
#include "world/join_scenes.h"

#include "scene/merge_scenes.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// Stores format-specific defaults of a part in Mesh::normal_choice.
void keep_normal_rule(const Scene& part, const MergeOffsets& by, Scene& whole) {
    if (!part.missing_normals_are_flat) return;
    for (std::size_t m = by.meshes; m < by.meshes + part.meshes.size(); ++m)
        if (!whole.meshes[m].normal_choice)
            whole.meshes[m].normal_choice = NormalChoice{NormalSource::automatic, true, {}};
}

}  // namespace

Scene join_scenes(const std::vector<Scene>& scenes, Context& context) {
    std::vector<ScenePart> parts;
    for (const Scene& scene : scenes) parts.push_back({scene, {}, true, true});
    MergedScene merged = merge_scenes(parts, context);
    Scene whole = std::move(merged.scene);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Scene& part = scenes[i];
        keep_normal_rule(part, merged.offsets[i], whole);
        if (whole.source.empty()) whole.source = part.source;
        if (!whole.environment && part.environment) whole.environment = part.environment;
        if (whole.fog.kind == FogKind::none) whole.fog = part.fog;
    }
    validate(whole);
    return whole;
}

}  // namespace rakelight
