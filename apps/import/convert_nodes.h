// SPDX-License-Identifier: Apache-2.0
// Nodes, joints, lights, cameras and animations of an aiScene -> the records of stream_format.h. Nothing is trusted: Assimp
// passes on what broken files contain.
#pragma once
#include <assimp/scene.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/name_table.h"
#include "source_format.h"

namespace rakelight::import_helper {

/// Nodes in an order where parents come first; parts_of_mesh: the Part numbers of every aiMesh.
class NodeTable {
public:
    NodeTable(const aiScene& scene, const std::vector<std::vector<std::uint32_t>>& parts_of_mesh, Document& out);
    std::uint32_t find(const aiString& name) const;  ///< the first node of that name, or nothing

private:
    NameMap<std::uint32_t> by_name_;
};

/// Joints of the whole scene, one for each node and inverse bind matrix.
class JointTable {
public:
    JointTable(const NodeTable& nodes, Document& out) : nodes_(nodes), out_(out) {}
    /// Its number, or nothing when the node is missing or the table is full.
    std::uint32_t number(const aiBone& bone);
    void collect(const aiScene& scene);

private:
    const NodeTable& nodes_;
    Document& out_;
    std::map<std::pair<std::uint32_t, std::vector<float>>, std::uint32_t> numbers_;
};

void convert_lamps_and_views(const aiScene& scene, const NodeTable& nodes, Document& out);
void convert_motions(const aiScene& scene, const NodeTable& nodes, Document& out);
AxisSystem axes_of(const aiScene& scene);

}  // namespace rakelight::import_helper
