// SPDX-License-Identifier: Apache-2.0
#include "world/join_scenes.h"

#include <rakelight/scene/validate.h>

#include <algorithm>

#include "scene/merge_scenes.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

/// Stores format-specific defaults of a part in Mesh::normal_choice.
void keep_normal_rule(const Scene& part, const MergeOffsets& by, Scene& whole) {
    if (!part.missing_normals_are_flat) return;
    for (std::size_t m = by.meshes; m < by.meshes + part.meshes.size(); ++m)
        if (!whole.meshes[m].normal_choice)
            whole.meshes[m].normal_choice = NormalChoice{NormalSource::automatic, true, {}};
}

/// The first one's. A file with Z up names the whole only if Z is up in all of it, because its name gives the up axis.
std::string source_of(const std::vector<Scene>& scenes) {
    const auto is_such = [](const Scene& scene) { return is_z_up(scene.source); };
    const auto named = std::ranges::find_if(scenes, [](const Scene& scene) { return !scene.source.empty(); });
    if (named == scenes.end() || (is_such(*named) && !std::ranges::all_of(scenes, is_such))) return {};
    return named->source;
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
        if (!whole.environment && part.environment) whole.environment = part.environment;
        if (whole.fog.kind == FogKind::none) whole.fog = part.fog;
    }
    whole.source = source_of(scenes);
    validate(whole);
    return whole;
}

}  // namespace rakelight
