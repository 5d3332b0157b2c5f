// SPDX-License-Identifier: Apache-2.0
// A scene's points as rays hit them: discs that face the eye, of as many pixels as the other engines draw, in their own colors. They
// cast no shadows.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/context.h>

#include "engines/raytrace/ray_scene.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

class RayPoints {
public:
    /// A place about the eye and a radius [m].
    struct Disc {
        vec3 place;
        float radius;
    };
    struct Meeting {
        std::uint32_t draw = no_index;  ///< into DrawList::line_draws; no_index: none
        std::uint32_t point = 0;        ///< into the mesh's indices
        float t = 0;                    ///< where the ray hits the plane of the disc
    };

    /// @param rays, list  must outlive this
    /// @throws Error bad_file: over the memory budget; failed: cancelled
    RayPoints(const RayScene& rays, const shading::DrawList& list, const shading::PictureCamera& view, float size_px,
              Context& context);
    ~RayPoints();
    RayPoints(const RayPoints&) = delete;
    RayPoints& operator=(const RayPoints&) = delete;

    bool is_empty() const { return !scene_; }
    /// Of the discs whose planes a ray hits between `from` and `to` the one whose paraboloid is nearest, as the other engines have it
    /// (PointParaboloid of engines/raster/marks/tile_marks.h); of equal ones the first.
    /// @param origin      about the eye
    /// @param is_primary  the discs stand across the view axis; else across the ray
    /// @param with_blended  false: only opaque ones
    Meeting first(vec3 origin, vec3 direction, float from, float to, bool is_primary, bool with_blended) const;
    /// Linear RGB and opacity, 0 to 1.
    vec4 color(std::uint32_t draw, std::uint32_t point) const;

private:
    struct Cloud {
        std::vector<Disc> discs;
        vec4 color;
        std::uint32_t draw;  ///< into DrawList::line_draws
    };
    struct Ray;
    void add(std::uint32_t draw, const shading::PictureCamera& view, float size_px, Context& context);
    void build(Context& context);

    const RayScene& rays_;
    const shading::DrawList& list_;
    dvec3 ahead_;  ///< the view axis
    std::vector<Cloud> clouds_;
    MemoryCharge charge_;
    RTCScene scene_ = nullptr;
};

}  // namespace rakelight::raytrace
