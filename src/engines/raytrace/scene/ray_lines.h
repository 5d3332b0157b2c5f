// SPDX-License-Identifier: Apache-2.0
// Lines as rays hit them: as many pixels wide as the other engines draw, with round ends.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>

#include "engines/raytrace/scene/ray_marks.h"
#include "engines/raytrace/scene/ray_scene.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

class RayLines {
public:
    /// Ends about the eye, and how far the line reaches around them. [m]
    struct Segment {
        vec3 a, b;
        float radius_a, radius_b;
    };

    /// @param rays, marks  must outlive this
    /// @throws Error bad_file: over the memory budget; failed: cancelled
    RayLines(const RayScene& rays, const std::vector<MarkedDraw>& marks, const shading::PictureCamera& view,
             float width_px, Context& context);
    ~RayLines();
    RayLines(const RayLines&) = delete;
    RayLines& operator=(const RayLines&) = delete;

    bool is_empty() const { return !scene_; }
    /// Opacity of lines thinner than a pixel, which are hit as if they were one wide.
    float coverage() const { return coverage_; }
    /// The nearest line: a strip of the picture to primary rays, to others a round body in space.
    MarkMeeting first(const MarkQuery& query) const;

private:
    struct Bundle {
        std::vector<Segment> segments;
        std::uint32_t mark, run;
        float opacity;
    };
    struct Ray;
    void add(std::uint32_t mark, const MarkedDraw& marked, const shading::PictureCamera& view, Context& context);
    void build(Context& context);

    const RayScene& rays_;
    const shading::PictureCamera& view_;
    dvec3 ahead_;      ///< the view axis
    double half_ = 0;  ///< [m] half the width, at 1 m
    float coverage_ = 1;
    std::vector<Bundle> bundles_;
    MemoryCharge charge_;
    RTCScene scene_ = nullptr;
};

}  // namespace rakelight::raytrace
