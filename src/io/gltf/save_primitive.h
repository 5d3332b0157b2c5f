// SPDX-License-Identifier: Apache-2.0
// One primitive of a glTF file with new normals, tangents and, where vertices were split, indices.
#pragma once
#include "io/gltf/save_data.h"
#include "io/gltf/vertex_data.h"

namespace rakelight::io::gltf {

/// What became of a primitive.
struct PrimitiveEdit {
    bool unpacked = false;              ///< its Draco data was taken apart
    bool tangents_removed = false;      ///< the file's tangents went: nothing to make new ones from, or not wanted
    bool keeps_target_normals = false;  ///< morph targets with normals: offsets from normals that are no more
};

class PrimitiveEditor {
public:
    PrimitiveEditor(Accessors& accessors, OrderedJson& root, NewData& data)
        : accessors_(accessors), root_(root), data_(data) {}

    /// @param json    the primitive, changed in place: NORMAL, TANGENT, indices, and all other attributes where
    /// vertices were split
    /// @param source  the same primitive as the reader sees it
    /// @param before  the mesh that the reader made of it  @param after  the same with its new attributes
    /// @throws Error bad_file: `before` is not what the file holds (it changed meanwhile)
    PrimitiveEdit edit(OrderedJson& json, const Value& source, const Mesh& before, const Mesh& after);

private:
    void extend(OrderedJson& owner, const Value& source, VertexData& vertices, bool is_target,
                std::span<const std::uint32_t> copied);
    ComponentType index_type(const Value& source) const;
    Accessors& accessors_;
    OrderedJson& root_;
    NewData& data_;
    BlockCache cache_;
};

/// For each vertex of `after` beyond those of `before`, the vertex that it copies; found by the corners.
std::vector<std::uint32_t> copied_vertices(const Mesh& before, const Mesh& after);

}  // namespace rakelight::io::gltf
