// SPDX-License-Identifier: Apache-2.0
// The camera of a sequence: chosen once, then moved by a turntable, or by the clip if it is the file's.
#pragma once
#include <functional>

#include "render/camera/camera_chooser.h"
#include "render/camera/camera_depths.h"
#include "render/sequence/sequence_plan.h"

#include <rakelight/scene/scene_queries.h>

namespace rakelight {

class SequenceViews {
public:
    /// @param requested_at  the scene, as requested, at a moment of the clip
    /// @param request  with its look
    SequenceViews(const SequencePlan& plan, const PictureRequest& request,
                  const std::function<Scene(double)>& requested_at, Context& context);

    /// @param scene  at the picture's moment
    Camera camera(const Scene& scene, double angle_rad) const;
    /// The bounding box of all that the sequence shows.
    const Bounds& bounds() const { return bounds_; }

private:
    Camera camera_of_file_in(const Scene& scene) const;
    NearestSurface nearest_in(const Scene& scene) const;
    void find_focal_point();

    ViewRequest view_;  ///< angles resolved
    double aspect_;
    Visibility visibility_;
    dvec3 axis_, focal_{0, 0, 0};
    Bounds bounds_{};
    Camera base_{};
    bool is_turned_, is_fitted_, follows_file_ = false;
};

}  // namespace rakelight
