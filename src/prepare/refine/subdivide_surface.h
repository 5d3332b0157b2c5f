// SPDX-License-Identifier: Apache-2.0
// Converts adjacent meshes to one subdivision surface and back.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "geometry/refine/subdivide.h"

namespace rakelight {

/// A mesh in the surface.
struct SurfacePart {
    const Mesh* mesh = nullptr;
    dmat4 to_surface;  ///< object space (with the mesh's origin) -> that of the surface; has an inverse
    std::vector<std::uint32_t> places;     ///< [V] equal values, over all parts: vertices at one place
    std::span<const std::uint8_t> hard{};  ///< [T] Creases::hard of the mesh; for Subdivision::finds_creases
};

/// Changes that the control surface required.
struct SurfaceFaults {
    std::uint64_t flat_faces = 0;    ///< dropped: fewer than three places
    std::uint64_t parted_edges = 0;  ///< SurfacePieces::parted_edges
};

/// Two steps, so that all surfaces of a scene are counted before any is refined.
class SurfaceSubdivider {
public:
    /// @param scale [m] length of one unit of the surface's space in world space, for Subdivision::edge
    SurfaceSubdivider(std::vector<SurfacePart> parts, const Subdivision& how, double scale);

    std::uint64_t control_faces() const { return control_.faces.count(); }
    std::uint64_t triangles() const;  ///< of the result
    std::uint64_t bytes() const;      ///< approximate peak during refinement
    int level() const { return control_.level; }
    geometry::Scheme scheme() const { return control_.scheme; }
    const SurfaceFaults& faults() const { return faults_; }

    /// [parts] triangles on the limit surface with its normals, without tangents; meshes without a face are empty.
    /// @throws Error as geometry::subdivide()
    std::vector<Mesh> run(Context& context) const;

private:
    void collect_faces();
    void add_face(std::size_t part, std::span<const std::uint32_t> vertices, std::uint32_t first_triangle,
                  std::uint32_t end_triangle);
    void mark_hard_edges(std::size_t part, std::size_t corners, std::uint32_t first_triangle,
                         std::uint32_t end_triangle);
    void choose_scheme();
    void choose_level(double scale);
    geometry::ControlValues control_values(std::size_t set) const;

    std::vector<SurfacePart> parts_;
    Subdivision how_;
    geometry::ControlSurface control_;
    std::vector<std::uint32_t> first_face_;     ///< [parts + 1]
    std::vector<std::uint32_t> mesh_vertices_;  ///< [corners] of the corner's part
    std::vector<std::uint8_t> is_hard_;         ///< PieceOptions::is_hard
    std::size_t texcoord_sets_ = 0;
    bool has_colors_ = false;
    SurfaceFaults faults_;
};

}  // namespace rakelight
