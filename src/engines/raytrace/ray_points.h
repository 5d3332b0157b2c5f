// SPDX-License-Identifier: Apache-2.0
// Points as rays hit them: discs or squares that face the eye, of as many pixels as the other engines draw.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/context.h>

#include "engines/raytrace/ray_marks.h"
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
        std::uint32_t mark = no_index;  ///< into the marks; no_index: none
        std::uint32_t point = 0;
        float t = 0;  ///< where the ray hits the plane of the disc
    };

    /// @param rays, marks  must outlive this
    /// @throws Error bad_file: over the memory budget; failed: cancelled
    RayPoints(const RayScene& rays, const std::vector<MarkedDraw>& marks, const shading::PictureCamera& view,
              const RenderSettings& settings, Context& context);
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

private:
    struct Cloud {
        std::vector<Disc> discs;
        std::uint32_t mark;
        float opacity;
    };
    struct Ray;
    void add(std::uint32_t mark, const MarkedDraw& marked, const shading::PictureCamera& view, float size_px,
             Context& context);
    void build(Context& context);

    const RayScene& rays_;
    dvec3 ahead_, right_, up_;  ///< the camera's axes
    bool are_squares_;
    std::vector<Cloud> clouds_;
    MemoryCharge charge_;
    RTCScene scene_ = nullptr;
};

}  // namespace rakelight::raytrace
