// SPDX-License-Identifier: Apache-2.0
// One primitive of a glTF file with new normals, tangents and, where vertices were split, indices.
#pragma once
#include "io/gltf/vertex_data.h"
#include "io/gltf/write/save_changes.h"
#include "io/gltf/write/save_data.h"
#include "io/gltf/write/save_uses.h"

namespace rakelight::io::gltf {

/// What became of a primitive, beside its change.
struct PrimitiveEdit {
    bool unpacked = false;  ///< its Draco data was taken apart
    bool plain = false;     ///< arrays that replaced meshopt-compressed ones are not compressed
};

class PrimitiveEditor {
public:
    PrimitiveEditor(Accessors& accessors, OrderedJson& root, NewData& data, OwnArrays& own)
        : accessors_(accessors), root_(root), data_(data), own_(own) {}

    /// @param json    the primitive, changed in place: NORMAL, TANGENT, indices, and all other attributes where
    /// vertices were split
    /// @param source  the same primitive as the reader sees it
    /// @param before  the mesh that the reader made of it  @param after  the same with its new attributes
    /// @param may_overwrite  nothing else refers to the primitive's old arrays: where they are its own, the new ones
    /// take their
    ///                       place in the file
    /// @throws Error bad_file: `before` is not what the file holds (it changed meanwhile)
    PrimitiveEdit edit(OrderedJson& json, const Value& source, const Mesh& before, const Mesh& after,
                       const PrimitiveChange& change, bool may_overwrite);

private:
    void extend(OrderedJson& owner, const Value& source, VertexData& vertices, std::span<const std::uint32_t> copied,
                const MorphTarget* target);
    void put_target(OrderedJson& json, const MorphTarget& target, bool may_overwrite);
    void put_offsets(OrderedJson& json, const char* name, const Block<vec3>& offsets, bool may_overwrite);
    void put(OrderedJson& attributes, Direction direction, std::span<const float> numbers, ComponentType type,
             bool may_overwrite);
    std::string compression_of(const OrderedJson& accessor) const;
    bool is_plain_now(const OrderedJson& before, const OrderedJson& now) const;
    ComponentType index_type(const Value& source) const;
    Accessors& accessors_;
    OrderedJson& root_;
    NewData& data_;
    OwnArrays& own_;
    BlockCache cache_;
};

}  // namespace rakelight::io::gltf
