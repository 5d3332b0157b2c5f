// SPDX-License-Identifier: Apache-2.0
// Which lines and points of a picture rays hit: those of the scene, edges and vertices of triangles where settings ask for
// them. They are not lit, and cast no shadows. raster/marks/marks.cpp has the same choices for the engine soft.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/context.h>

#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

/// The lines or the points of a draw.
struct MarkedDraw {
    const shading::Draw* draw = nullptr;
    const Mesh* mesh = nullptr;
    bool is_line = false;
    vec4 color;                           ///< linear RGB and opacity
    bool has_vertex_colors = false;       ///< which multiply RGB
    std::vector<std::uint32_t> vertices;  ///< of edges and vertices; empty: the mesh's indices
    MemoryCharge charge;                  ///< pays for them

    std::size_t count() const {
        return (vertices.empty() ? mesh->indices.size() : vertices.size()) / (is_line ? 2 : 1);
    }
    std::uint32_t vertex(std::size_t i) const { return vertices.empty() ? mesh->indices[i] : vertices[i]; }
    /// Linear RGB and opacity, 0 to 1. @param part  of a line, from its first end to its second
    vec4 color_at(std::uint32_t number, float part) const;
};

/// @param list  must outlive the result
/// @throws Error bad_file: over the memory budget; failed: cancelled
std::vector<MarkedDraw> marked_draws(const shading::DrawList& list, const shading::PictureCamera& view,
                                     const RenderSettings& settings, Context& context);

}  // namespace rakelight::raytrace
