// SPDX-License-Identifier: Apache-2.0
// What stays the same for all rays of a picture.
#pragma once
#include <vector>

#include "cpu_shading/draw_list.h"
#include "engines/raytrace/kernels/trace_types.h"
#include "engines/raytrace/ray_scene.h"
#include "shading/draw_choices.h"
#include "shading/draw_frame.h"
#include "shading/view.h"

namespace rakelight::raytrace {

/// Not to be copied or moved: its parts refer to each other.
class TracePicture {
public:
    /// @param list, rays, view, settings, kernels  must outlive this; the settings are checked
    TracePicture(const cpu_shading::DrawList& list, const RayScene& rays, const shading::View& view,
                 const RenderSettings& settings, const Kernels& kernels, Context& context);
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    /// A job without hits and results.
    HitJob hit_job(std::uint32_t draw) const;
    /// About the coordinates of the ray scene.
    vec3 in_rays(vec3 about_eye) const { return about_eye + eye_; }

    bool is_blended(std::uint32_t draw) const { return list.view(draw).blend != 0; }
    bool is_masked(std::uint32_t draw) const { return cutoffs_[draw] >= 0; }
    /// Whether culling leaves out the side that a ray meets. @param is_against  as RayFilter::counts()
    bool is_culled(std::uint32_t draw, bool is_against) const;
    /// Whether a masked surface is not there. @param ray  into `rays` of the job's planes
    bool is_cut_out(const Meeting& meeting, const RayView& planes, std::int32_t ray) const;

    const cpu_shading::DrawList& list;
    const RayScene& rays;
    const shading::View& view;
    const RenderSettings& settings;
    const Kernels& kernels;
    std::vector<lighting::LightParameters> lights;
    bool has_filtered = false;  ///< some draw is culled, or has holes
    bool has_holes = false;     ///< some draw is masked or blended: not all of it throws shadows

private:
    std::vector<dmat4> to_eye_;
    std::vector<shading::DrawFrame> frames_;
    std::vector<HitJob> jobs_;
    std::vector<shading::Culling> culling_;
    std::vector<float> cutoffs_;
    vec3 eye_;
};

}  // namespace rakelight::raytrace
