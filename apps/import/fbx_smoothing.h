// SPDX-License-Identifier: Apache-2.0
// Smoothing groups of FBX files for the meshes that Assimp makes of their geometries.
#pragma once
#include <assimp/scene.h>

#include <cstdint>
#include <map>
#include <vector>

#include "fbx_geometry.h"

namespace rakelight::import_helper {

/// What the triangles of one mesh have of the file.
struct MeshSmoothing {
    std::vector<std::uint32_t> masks;  ///< by vertex of the aiMesh: groups of its polygon; or empty
    std::vector<vec3> fans;            ///< by vertex: equal where smooth edges join the corners at one point; or empty
    bool is_empty() const { return masks.empty() && fans.empty(); }
};

/// Assimp writes out a vertex for each corner, in the order of the file, and a mesh for each material of a geometry. A mesh has the
/// groups of the geometry whose corners lie where its vertices do.
class FbxSmoothing {
public:
    FbxSmoothing() = default;
    explicit FbxSmoothing(std::vector<FbxGeometry> geometries);
    MeshSmoothing of(const aiMesh& mesh) const;
    bool has_unknown_kinds() const { return has_unknown_; }

private:
    struct Polygons {
        std::vector<std::uint32_t> of_corner;  ///< the polygon of each corner
        std::uint32_t count = 0;
        std::vector<vec3> fans;  ///< by corner, of geometries with smooth edges
    };
    /// The corners of one material, or all.
    struct Choice {
        std::size_t geometry = 0;
        std::int32_t material = 0;
        bool is_all = true;
    };
    void add_choices(std::size_t geometry);
    std::vector<std::uint32_t> corners_of(const Choice& choice) const;
    bool lies_at(const aiMesh& mesh, std::size_t geometry, const std::vector<std::uint32_t>& corners) const;

    std::vector<FbxGeometry> geometries_;
    std::vector<Polygons> polygons_;               ///< [geometries]
    std::multimap<std::size_t, Choice> by_count_;  ///< by their number of corners
    bool has_unknown_ = false;
};

}  // namespace rakelight::import_helper
