// SPDX-License-Identifier: Apache-2.0
#include <rakelight/inspect.h>

#include <algorithm>

#include "scene/scene_tools.h"
#include "tools/borders.h"

namespace rakelight {
namespace {

using Has = ObjectSummary::Has;

/// Counts how many of an object's meshes have something.
class Tally {
public:
    void add(bool has) { ++(has ? yes_ : no_); }
    Has answer() const { return yes_ == 0 ? Has::no : no_ == 0 ? Has::yes : Has::some; }

private:
    int yes_ = 0, no_ = 0;
};

void count(ObjectSummary& object, const Mesh& mesh) {
    ++object.meshes;
    object.vertices += mesh.positions.size();
    object.triangles += mesh.triangle_count();
    if (mesh.topology == Topology::lines) object.lines += mesh.indices.size() / 2;
    if (mesh.topology == Topology::points) object.points += mesh.indices.size();
}

void add_material(ObjectSummary& object, const Scene& scene, std::uint32_t material) {
    if (material == none) return;
    std::string name = scene.materials[material].name;
    if (name.empty()) name = "material " + std::to_string(material);
    if (std::find(object.materials.begin(), object.materials.end(), name) == object.materials.end())
        object.materials.push_back(std::move(name));
}

ObjectSummary summarize(const Scene& scene, std::uint32_t number) {
    const Node& node = scene.nodes[number];
    ObjectSummary object;
    object.name = node.name;
    object.node = number;
    Tally normals, tangents, texcoords, colors, groups, targets, influences;
    for (const std::uint32_t index : node.meshes) {
        const Mesh& mesh = scene.meshes[index];
        count(object, mesh);
        add_material(object, scene, mesh.material);
        normals.add(!mesh.normals.empty());
        tangents.add(!mesh.tangents.empty());
        texcoords.add(!mesh.texcoords.empty());
        colors.add(!mesh.colors.empty());
        groups.add(!mesh.smoothing.empty() || !mesh.smoothing_hint.empty());
        influences.add(node.skin != none && !mesh.influences.empty());
        targets.add(!mesh.targets.empty());
    }
    object.normals = normals.answer(), object.tangents = tangents.answer(), object.texcoords = texcoords.answer();
    object.colors = colors.answer(), object.smoothing_groups = groups.answer();
    object.skin = influences.answer(), object.morph_targets = targets.answer();
    return object;
}

}  // namespace

Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context) {
    Inspection result;
    result.file = scene.source;
    result.triangles = triangle_count(scene);
    std::vector<std::uint32_t> objects;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i)
        if (!scene.nodes[i].meshes.empty()) objects.push_back(i);
    for (const std::uint32_t node : objects) result.objects.push_back(summarize(scene, node));
    const Bounds bounds = world_bounds(scene);
    if (!bounds.empty()) result.low = bounds.low, result.high = bounds.high;
    // One object has no border, but what prepare says of its tangents may have been asked for.
    if (options.borders && (objects.size() > 1 || (options.prepare.measure_orthogonality && result.triangles > 0))) {
        SharedPositions shared = find_borders(prepare_scene(scene, options.prepare, context), objects, context);
        result.shared_positions = shared.positions;
        result.borders = std::move(shared.borders);
        result.borders_left_out = shared.borders_left_out;
    }
    result.scene = scene;
    result.scene.meshes.clear();
    return result;
}

}  // namespace rakelight
