// SPDX-License-Identifier: Apache-2.0
// aiScene -> the records of stream_format.h. Nothing is trusted: Assimp passes on what broken files contain.
#pragma once
#include <assimp/scene.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/name_table.h"
#include "fbx_smoothing.h"
#include "io/import/stream_format.h"

namespace rakelight::import_helper {

using namespace io::import_stream;

/// What the ending of the file's name says about what Assimp's reader of that format does.
struct Format {
    std::string ending;          ///< lower case, without the dot
    bool file_normals = false;   ///< normals are the file's (FBX, DAE, X)
    bool hint_normals = false;   ///< normals were made from smoothing groups (3DS, ASE)
    bool max_placement = false;  ///< texture placement is 3ds Max's
};
Format format_of(const std::string& path);

/// A topology of an aiMesh: one Part. An aiMesh with triangles and lines makes two.
struct PartSource {
    std::uint32_t mesh = 0, topology = 0;
};

inline std::string text(const aiString& s) {
    const std::size_t size = s.length < sizeof s.data ? s.length : sizeof s.data - 1;
    return std::string(s.data, size);
}

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

std::vector<PartSource> list_parts(const aiScene& scene);
Part convert_part(const aiMesh& mesh, const PartSource& source, const Format& format, const FbxSmoothing& smoothing,
                  JointTable& joints);
void note_dropped(const aiScene& scene, Document& out);  ///< what list_parts and convert_part leave out

void convert_surfaces(const aiScene& scene, const Format& format, Document& out);
void convert_lamps_and_views(const aiScene& scene, const NodeTable& nodes, Document& out);
void convert_motions(const aiScene& scene, const NodeTable& nodes, Document& out);
AxisSystem axes_of(const aiScene& scene);

/// Joins the vertices of a part that are equal to the last bit in everything, and drops those that nothing uses.
/// @param met  out, for tests: slots of the table that were looked at and held another vertex; null: not wanted
void join_equal_vertices(Part& part, std::uint64_t* met = nullptr);

}  // namespace rakelight::import_helper
