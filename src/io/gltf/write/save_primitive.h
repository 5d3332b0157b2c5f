// SPDX-License-Identifier: Apache-2.0
// One primitive of a glTF file with new normals, tangents and, where vertices were split, indices.
#pragma once
#include "io/gltf/vertex_data.h"
#include "io/gltf/write/save_data.h"
#include "io/gltf/write/save_storage.h"
#include "io/gltf/write/save_uses.h"

namespace rakelight::io::gltf {

/// Bitangents that are an attribute of their own; glTF has names with an underscore for what it does not know.
inline constexpr const char* bitangent_name = "_BITANGENT";

/// What became of a primitive.
struct PrimitiveEdit {
    bool unpacked = false;              ///< its Draco data was taken apart
    bool tangents_removed = false;      ///< the file's tangents went: nothing to make new ones from, or not wanted
    bool keeps_target_normals = false;  ///< of morph targets without new ones: offsets from normals that are no more
    bool widened = false;               ///< integers of 8 bits became float
    bool plain = false;                 ///< arrays that replaced meshopt-compressed ones are not compressed
};

class PrimitiveEditor {
public:
    PrimitiveEditor(Accessors& accessors, const DirectionStorage& storage, OrderedJson& root, NewData& data,
                    OwnArrays& own)
        : accessors_(accessors), storage_(storage), root_(root), data_(data), own_(own) {}

    /// @param json    the primitive, changed in place: NORMAL, TANGENT, indices, and all other attributes where
    /// vertices were split
    /// @param source  the same primitive as the reader sees it
    /// @param before  the mesh that the reader made of it  @param after  the same with its new attributes
    /// @param may_overwrite  nothing else refers to the primitive's old arrays: where they are its own, the new ones
    /// take their
    ///                       place in the file
    /// @throws Error bad_file: `before` is not what the file holds (it changed meanwhile)
    PrimitiveEdit edit(OrderedJson& json, const Value& source, const Mesh& before, const Mesh& after,
                       bool may_overwrite);

private:
    void extend(OrderedJson& owner, const Value& source, VertexData& vertices, std::span<const std::uint32_t> copied,
                const MorphTarget* target);
    void put_target(OrderedJson& json, const MorphTarget& target, bool may_overwrite);
    void put_offsets(OrderedJson& json, const char* name, const Block<vec3>& offsets, bool may_overwrite);
    void put(OrderedJson& attributes, const char* name, std::span<const float> numbers, ComponentType type,
             bool may_overwrite);
    std::string compression_of(const OrderedJson& accessor) const;
    bool is_plain_now(const OrderedJson& before, const OrderedJson& now) const;
    ComponentType index_type(const Value& source) const;
    Accessors& accessors_;
    const DirectionStorage& storage_;
    OrderedJson& root_;
    NewData& data_;
    OwnArrays& own_;
    BlockCache cache_;
};

/// For each vertex of `after` beyond those of `before`, the vertex that it copies; found by the corners.
std::vector<std::uint32_t> copied_vertices(const Mesh& before, const Mesh& after);

}  // namespace rakelight::io::gltf
