// SPDX-License-Identifier: Apache-2.0
// Which lines and points of a picture rays hit: those of the scene, edges and vertices of triangles where settings ask for
// them. They are not lit, and cast no shadows. raster/marks/marks.cpp has the same choices for the engine soft.
#pragma once
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <rakelight/base/context.h>

#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

/// Where a line or point is on a ray.
struct MarkPlace {
    float depth = std::numeric_limits<float>::lowest();  ///< along the ray; of a point where its paraboloid is
    std::uint32_t mark = no_index;                       ///< into the marks; no_index: none
    std::uint32_t number = 0;                            ///< of the line or point
};

/// Where a ray meets a line or point.
struct MarkMeeting : MarkPlace {
    float t = 0;     ///< along the ray
    float part = 0;  ///< of a line, from its first end to its second
};

/// What is asked for: the first line or point of those at `from` < t, up to `to`.
struct MarkQuery {
    vec3 origin, direction;  ///< the origin is about the eye
    float from = 0, to = 0;
    MarkPlace after;                    ///< only what comes behind it on the ray
    std::uint32_t left_out = no_index;  ///< this MarkedDraw::run
    bool is_primary = false;            ///< lines are strips of the picture and points discs across the view axis
    bool with_blended = true;           ///< false: only opaque ones

    /// The order on the ray. Of two at the same depth the later one of the scene lies over the other, as in soft; data channels
    /// hold the first.
    bool is_before(const MarkPlace& a, const MarkPlace& b) const {
        if (a.depth != b.depth) return a.depth < b.depth;
        const bool is_first = std::pair(a.mark, a.number) < std::pair(b.mark, b.number);
        return with_blended ? std::pair(b.mark, b.number) < std::pair(a.mark, a.number) : is_first;
    }
};

/// The lines or the points of a draw.
struct MarkedDraw {
    const shading::Draw* draw = nullptr;
    const Mesh* mesh = nullptr;
    bool is_line = false;
    vec4 color;                           ///< linear RGB and opacity
    bool has_vertex_colors = false;       ///< which multiply RGB
    std::vector<std::uint32_t> vertices;  ///< of edges and vertices; empty: the mesh's indices
    MemoryCharge charge;                  ///< pays for them
    /// Marks of one run that follow each other on a ray are laid once, so that joints are no darker than the rest; no_index: it is
    /// in none, since its vertices have colors.
    std::uint32_t run = no_index;

    std::size_t count() const {
        return (vertices.empty() ? mesh->indices.size() : vertices.size()) / (is_line ? 2 : 1);
    }
    std::uint32_t vertex(std::size_t i) const { return vertices.empty() ? mesh->indices[i] : vertices[i]; }
    /// Whether two blended lines of several colors share an end: they are laid once, too.
    bool are_joined(std::uint32_t a, std::uint32_t b) const;
    /// Linear RGB and opacity, 0 to 1. @param part  of a line, from its first end to its second
    vec4 color_at(std::uint32_t number, float part) const;
};

/// @param list  must outlive the result
/// @throws Error bad_file: over the memory budget; failed: cancelled
std::vector<MarkedDraw> marked_draws(const shading::DrawList& list, const shading::PictureCamera& view,
                                     const RenderSettings& settings, Context& context);

}  // namespace rakelight::raytrace
