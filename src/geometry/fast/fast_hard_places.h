// SPDX-License-Identifier: Apache-2.0
// Places that the fast path leaves to the general one, with all faces that touch them. The general path's result at a place
// depends only on the faces there, but for fits.
#pragma once
#include "geometry/fast/marked_vertices.h"

namespace rakelight::geometry {

/// The part of one mesh that touches the places, with local indices.
struct PartMesh {
    std::uint32_t mesh = 0;
    std::vector<std::uint32_t> faces;     ///< of the mesh, ascending
    std::vector<std::uint32_t> vertices;  ///< of the mesh, ascending
    std::vector<std::uint8_t> is_wanted;  ///< [vertices]
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

class HardPlaces {
public:
    /// @param wanted  global indices, ascending; with a vertex all others at its place
    HardPlaces(FastState& state, std::span<const std::uint32_t> wanted);

    std::span<const PartMesh> parts() const { return parts_; }
    /// [parts] Views.
    std::span<const AttributeMesh> meshes() const { return meshes_; }
    /// [vertices of all parts]
    std::span<const std::uint8_t> wanted() const { return is_wanted_; }
    /// Of all parts: at most as many vertices are split.
    std::size_t corners() const;
    bool is_wanted(std::uint32_t vertex) const { return marks_.has(vertex); }

    /// Replaces the output at these places.
    /// @param results  [parts]
    /// @param splits   [meshes] gets the split vertices
    void take(std::span<const MeshAttributes> results, std::span<const AttributeBuffers> out,
              std::vector<SplitAttributes>& splits) const;

private:
    void collect_faces();
    void number(PartMesh& part) const;
    void take(const PartMesh& part, const MeshAttributes& result, const AttributeBuffers& out,
              SplitAttributes& split) const;

    FastState& state_;
    const AttributeInput& input_;
    std::span<const std::uint32_t> wanted_;
    MarkedVertices marks_;
    std::vector<PartMesh> parts_;
    std::vector<AttributeMesh> meshes_;
    std::vector<std::uint8_t> is_wanted_;
};

}  // namespace rakelight::geometry
