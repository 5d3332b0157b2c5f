// SPDX-License-Identifier: Apache-2.0
// Points as rays hit them: discs or squares that face the eye, of as many pixels as the other engines draw.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>

#include "engines/raytrace/scene/ray_marks.h"
#include "engines/raytrace/scene/ray_scene.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

class RayPoints {
public:
    /// A place about the eye and a radius [m].
    struct Disc {
        vec3 place;
        float radius;
    };

    /// @param rays, marks  must outlive this
    /// @throws Error bad_file: over the memory budget; failed: cancelled
    RayPoints(const RayScene& rays, const std::vector<MarkedDraw>& marks, const shading::PictureCamera& view,
              const RenderSettings& settings, Context& context);
    ~RayPoints();
    RayPoints(const RayPoints&) = delete;
    RayPoints& operator=(const RayPoints&) = delete;

    bool is_empty() const { return !scene_; }
    /// Of the discs whose planes a ray hits the one whose paraboloid is nearest, as the other engines have it (PointParaboloid of
    /// engines/raster/marks/tile_marks.h). They stand across the view axis to primary rays, to others across the ray.
    MarkMeeting first(const MarkQuery& query) const;

private:
    struct Cloud {
        std::vector<Disc> discs;
        std::uint32_t mark, run;
        float opacity;
    };
    struct Ray;
    void add(std::uint32_t mark, const MarkedDraw& marked, const shading::PictureCamera& view, float size_px,
             Context& context);
    void build(Context& context);

    const RayScene& rays_;
    dvec3 ahead_, right_, up_;  ///< the camera's axes
    bool are_squares_;
    float widest_ = 0;  ///< [m] the greatest radius
    std::vector<Cloud> clouds_;
    MemoryCharge charge_;
    RTCScene scene_ = nullptr;
};

}  // namespace rakelight::raytrace
