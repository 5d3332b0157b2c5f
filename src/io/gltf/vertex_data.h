// SPDX-License-Identifier: Apache-2.0
// Vertex arrays of primitives as shared blocks, whether they lie in accessors or in a Draco buffer.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <rakelight/image/block.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/accessors.h"
#include "io/gltf/packed/draco.h"

namespace rakelight::io::gltf {

/// Blocks made from accessors, so that primitives that name the same accessor share one array.
struct BlockCache {
    std::map<std::uint32_t, Block<vec2>> vec2s;
    std::map<std::uint32_t, Block<vec3>> vec3s;
    std::map<std::uint32_t, Block<vec4>> tangents, colors;
    std::map<std::uint32_t, Block<float>> scalars;  ///< of attributes of the application's own
    std::map<std::uint32_t, double> steps;          ///< Mesh::position_step
};

/// The vertex arrays of one primitive.
class VertexData {
public:
    /// @param primitive  its object; decodes KHR_draco_mesh_compression where it is there
    VertexData(Accessors& accessors, BlockCache& cache, const Value& primitive);

    /// Elements of an attribute ("POSITION"); nullopt when the primitive has none.
    /// @throws Error: broken accessor, or another count than the first attribute had.
    std::optional<Elements> elements(const std::string& semantic, std::uint32_t components, std::uint32_t types);
    Block<vec2> vec2s(const std::string& semantic);
    Block<vec3> vec3s(const std::string& semantic);
    Block<vec4> tangents();
    Block<vec4> colors();  ///< linear RGBA; alpha 1 where the file has RGB
    /// An attribute of the application's own: its name begins with '_'. A broken one is left out with a remark.
    void read_array(const std::string& name, Mesh& mesh);
    double position_step();  ///< Mesh::position_step of the primitive's POSITION
    /// An attribute of a morph target: [V] or empty.
    Block<vec3> offsets(const Value& target, const std::string& semantic);

    /// Corners of the primitive before its mode is looked at: all < vertex_count(). @throws Error: out of range or
    /// restart value.
    /// @param charge  grows by what they take
    std::vector<std::uint32_t> corners(MemoryCharge& charge);
    std::uint64_t vertex_count() const { return count_.value_or(0); }

private:
    template <class T, class Make>
    Block<T> block(std::map<std::uint32_t, Block<T>>& cache, const Value& owner, const std::string& semantic,
                   std::uint32_t components, Make make);
    std::optional<Elements> find(const Value& owner, const std::string& semantic, const Expected& expected);
    void check_count(std::uint64_t count, const std::string& semantic);
    const Document& document() const { return accessors_.document(); }

    Accessors& accessors_;
    BlockCache& cache_;
    Value primitive_, attributes_, packed_attributes_;
    std::unique_ptr<DracoMesh> draco_;
    std::optional<std::uint64_t> count_;
};

}  // namespace rakelight::io::gltf
