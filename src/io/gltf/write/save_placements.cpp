// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_placements.h"

#include <map>

namespace rakelight::io::gltf {
std::vector<std::uint32_t> origins(const Scene& before, const Scene& after) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_source;
    for (std::uint32_t i = 0; i < before.meshes.size(); ++i)
        by_source.emplace(std::pair(before.meshes[i].source_mesh, before.meshes[i].source_primitive), i);
    std::vector<std::uint32_t> result(after.meshes.size());
    for (std::uint32_t i = 0; i < result.size(); ++i)
        result[i] = i < before.meshes.size()
                        ? i
                        : by_source.at({after.meshes[i].source_mesh, after.meshes[i].source_primitive});
    return result;
}

std::vector<MeshVersion> mesh_versions(const Scene& before, const Scene& after, bool keep_instances, Context& context) {
    std::vector<MeshVersion> versions;
    std::map<std::uint32_t, std::map<std::vector<std::uint32_t>, std::size_t>>
        of_mesh;  // by the file's mesh: its versions
    std::map<std::uint32_t, std::size_t> of_node;
    bool is_kept = false, is_stuck = false;
    for (std::size_t n = 0; n < before.nodes.size(); ++n) {
        const Node& node = before.nodes[n];
        if (node.meshes.empty() || node.source_node == no_index) continue;
        const std::uint32_t mesh = before.meshes[node.meshes[0]].source_mesh;
        auto& known = of_mesh[mesh];
        const auto placed = of_node.find(node.source_node);
        const std::vector<std::uint32_t>& wanted = after.nodes[n].meshes;
        auto version = known.find(wanted);
        if (placed != of_node.end()) {
            is_stuck = is_stuck || version == known.end() || version->second != placed->second;
            continue;
        }
        if (keep_instances && !known.empty() && version == known.end()) {
            is_kept = true;
            version = known.begin();
        }
        if (version == known.end()) {
            // The first result of smooth_scene() replaces the mesh that it came from.
            versions.push_back({mesh, wanted, {}, known.empty()});
            version = known.emplace(wanted, versions.size() - 1).first;
        }
        versions[version->second].nodes.push_back(node.source_node);
        of_node[node.source_node] = version->second;
    }
    Report& report = context.report();
    if (is_kept)
        report.add(Remark::warning, before.source, {},
                   "instances that touch different objects share one mesh: its normals are correct only for the first "
                   "of them");
    if (is_stuck)
        report.add(Remark::warning, before.source, {},
                   "the instances of EXT_mesh_gpu_instancing share one mesh: its normals are correct only for the "
                   "first of them");
    return versions;
}

}  // namespace rakelight::io::gltf
