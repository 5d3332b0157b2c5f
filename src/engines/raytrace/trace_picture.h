// SPDX-License-Identifier: Apache-2.0
// What stays the same for all rays of a picture.
#pragma once
#include <vector>

#include "cpu_shading/draw_list.h"
#include "engines/raytrace/kernels/trace_types.h"
#include "engines/raytrace/media.h"
#include "engines/raytrace/scene/mark_limits.h"
#include "engines/raytrace/scene/naive_scan.h"
#include "engines/raytrace/scene/ray_lines.h"
#include "engines/raytrace/scene/ray_points.h"
#include "engines/raytrace/scene/ray_scene.h"
#include "shading/draw_choices.h"
#include "shading/draw_frame.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

inline constexpr float step_behind = 1 + 4e-6f;  ///< where a ray continues behind what it met

/// Not to be copied or moved: its parts refer to each other.
class TracePicture {
public:
    /// @param list, rays, view, settings, kernels  must outlive this; the settings are checked
    TracePicture(const cpu_shading::DrawList& list, const RayScene& rays, const shading::PictureCamera& view,
                 const RenderSettings& settings, const Kernels& kernels, Context& context);
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    Meeting first(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const {
        if (!settings.surfaces) return {};
        return naive ? naive->first(origin, direction, from, to, filter)
                     : rays.first(origin, direction, from, to, filter);
    }
    bool is_blocked(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const {
        return naive ? naive->first(origin, direction, from, to, filter).draw != no_index
                     : rays.is_blocked(origin, direction, from, to, filter);
    }

    /// A job without hits and results.
    HitJob hit_job(std::uint32_t draw) const;
    /// The same for rays that come from a surface, or of hits that rays continue from. @param goes_on  HitJob::next will be set
    HitJob hit_job(std::uint32_t draw, bool is_from_surface, bool goes_on) const;
    /// About the coordinates of the ray scene.
    vec3 in_rays(vec3 about_eye) const { return about_eye + eye_; }

    /// Whether a meeting is with a line or a point: Meeting::draw is then list.draws.size() + its place in `marks`, and
    /// Meeting::triangle the number of the line or point.
    bool is_mark(std::uint32_t draw) const { return draw != no_index && draw >= list.draws.size(); }
    const shading::Draw& mark_draw(const Meeting& meeting) const { return *marks[mark_of(meeting)].draw; }
    vec4 mark_color(const Meeting& meeting) const;
    /// Up to where marks lie in front of a surface that a ray meets, or on it. @param surface  of no draw: nothing is met
    MarkLimit mark_limit(const Meeting& surface, vec3 origin, vec3 direction, bool is_primary) const;

    bool is_blended(std::uint32_t draw) const { return list.view(draw).blend != 0; }
    bool is_masked(std::uint32_t draw) const { return cutoffs_[draw] >= 0; }
    bool goes_on(std::uint32_t draw) const { return goes_on_[draw]; }      ///< rays are mirrored there, or go through
    bool is_filter(std::uint32_t draw) const { return is_filter_[draw]; }  ///< rays go through
    /// A classical material whose alpha says how much goes through.
    bool is_opened_by_alpha(std::uint32_t draw) const {
        return lets_through_[draw] && is_blended(draw) && list.view(draw).metallic_roughness == 0;
    }
    /// Whether culling leaves out the side that a ray hits.
    bool is_culled(const Meeting& meeting) const;
    /// Whether a ray hits the front. @param direction  in world axes
    bool meets_front(const Meeting& meeting, vec3 direction) const;
    /// What surfaces that light goes through, and the bodies behind them, leave of it.
    /// @param media  that the ray begins in
    vec3 light_through(const RayView& ray, float to, const RayFilter& filter, Media media) const;
    /// What of the light from a place arrives: nothing lies in the way, or only what light goes through.
    /// @param origin  about the eye
    vec3 light_reaching(vec3 origin, vec3 direction, float to, const Media& media) const;
    /// What a triangle emits where a ray, from `origin` about the eye, meets it at 1.
    vec3 emission_at(std::uint32_t draw, std::uint32_t triangle, vec3 origin, vec3 direction) const;
    /// Whether a masked surface is not there. @param ray  into `rays` of the job's planes
    bool is_cut_out(const Meeting& meeting, const RayView& planes, std::int32_t ray) const;

    const std::uint64_t number;  ///< of all pictures, from 1
    const cpu_shading::DrawList& list;
    const RayScene& rays;
    const NaiveScan* naive = nullptr;  ///< every ray is tested against every triangle
    const shading::PictureCamera& view;
    const RenderSettings& settings;
    const Kernels& kernels;
    const std::vector<MarkedDraw> marks;
    const RayPoints points;
    const RayLines lines;
    std::vector<lighting::LightParameters> lights;
    const bool is_path;         ///< light goes along paths: it is refracted by bodies, and blended surfaces shade
    bool has_filtered = false;  ///< some draw is culled, or has holes
    bool has_masked = false;    ///< some draw is masked
    bool has_holes = false;     ///< some draw is masked or blended: not all of it casts shadows
    bool has_filters = false;   ///< light goes through some draw
    int max_depth = 0;          ///< of reflections and refractions

private:
    std::size_t mark_of(const Meeting& meeting) const { return meeting.draw - list.draws.size(); }
    vec3 share_through(const Meeting& meeting, const RayView& planes) const;

    std::vector<dmat4> to_eye_;
    std::vector<shading::DrawFrame> frames_;
    std::vector<HitJob> jobs_;
    std::vector<shading::Culling> culling_;
    std::vector<float> cutoffs_;
    std::vector<bool> goes_on_, is_filter_, lets_through_;
    vec3 eye_;
    MarkLimits mark_limits_;
};

/// What kernels hand back with their shadow rays (HitJob::tracer).
struct TileTracer {
    const TracePicture& picture;
    const Context& context;
    std::uint64_t& shadow_rays;
    const std::int32_t* hit_ray;  ///< [hits] whose ray it is
    const Media* media;           ///< [rays] that they are in; null: in none
};

}  // namespace rakelight::raytrace
