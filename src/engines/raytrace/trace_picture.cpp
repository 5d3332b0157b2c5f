// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/trace_picture.h"

#include <algorithm>

#include "cpu_shading/make_material_job.h"
#include "cpu_shading/make_mesh_view.h"
#include "shading/lights.h"
#include "shading/shading_choice.h"

namespace rakelight::raytrace {
namespace {

constexpr float least_offset = 1e-6f;  ///< of the scene's reach, that shadow rays begin off a surface

/// Surfaces that throw shadows: blended ones do not, as in shadow maps.
class ShadowFilter final : public RayFilter {
public:
    /// @param origin  about the eye
    ShadowFilter(const TracePicture& picture, vec3 origin, vec3 direction) : picture_(picture) {
        const vec3 ray[2] = {origin, direction};
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t c = 0; c < 3; ++c) numbers_[3 * k + c] = ray[k][c];
    }
    bool counts(const Meeting& meeting, bool) const override {
        if (picture_.is_blended(meeting.draw)) return false;
        return !picture_.is_masked(meeting.draw) || !picture_.is_cut_out(meeting, {numbers_, 1}, 0);
    }

private:
    const TracePicture& picture_;
    float numbers_[ray_planes] = {};  ///< no differentials: masks are read at their finest
};

void find_seen(const void* tracer, ShadowRays* rays) {
    const TracePicture& picture = *static_cast<const TracePicture*>(tracer);
    for (std::int32_t i = 0; i < rays->count; ++i) {
        rays->seen[i] = 1;
        if (!(rays->length[i] >= 0)) continue;
        const vec3 origin{rays->origin[0][i], rays->origin[1][i], rays->origin[2][i]};
        const vec3 direction{rays->direction[0][i], rays->direction[1][i], rays->direction[2][i]};
        const ShadowFilter filter(picture, origin, direction);
        const RayFilter* const holes = picture.has_holes ? &filter : nullptr;
        if (picture.rays.is_blocked(picture.in_rays(origin), direction, 0, rays->length[i], holes)) rays->seen[i] = 0;
    }
}

void set_rows(const dmat4& m, float (&to)[3][4]) {
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) to[r][c] = float(m[c][r]);
}

}  // namespace

TracePicture::TracePicture(const cpu_shading::DrawList& of_list, const RayScene& of_rays, const shading::View& of_view,
                           const RenderSettings& of_settings, const Kernels& of_kernels, Context& context)
    : list(of_list), rays(of_rays), view(of_view), settings(of_settings), kernels(of_kernels) {
    const dvec3 eye = view.camera_to_world[3].xyz();
    lights = shading::make_lights(list.scene, list.node_to_world, eye);
    eye_ = cast<float>(eye - rays.origin());
    const std::size_t count = list.draws.size();
    to_eye_.reserve(count), frames_.reserve(count), jobs_.reserve(count);
    const std::vector<Shading> shading = shading::choose_shading(list, settings, {}, context);
    for (std::uint32_t d = 0; d < count; ++d) {
        const shading::Draw& draw = list.draws[d];
        to_eye_.push_back(view.world_to_eye * draw.to_world);
        frames_.emplace_back(list, draw, to_eye_.back(), view, settings.front_face);
        HitJob job{};
        static_cast<MaterialJob&>(job) = cpu_shading::make_material_job(list, list.views, draw, settings, view, false);
        job.lights = lights.data();
        job.light_count = std::int32_t(lights.size());
        job.mesh = cpu_shading::make_mesh_view(list.scene.meshes[draw.mesh], frames_.back());
        set_rows(to_eye_.back(), job.to_eye);
        culling_.push_back(shading::culling_of(list, draw, settings));
        job.front_is_negative = culling_.back().front_is_negative;
        if (shading[d] == Shading::unlit) job.unlit = 1;
        if (shading[d] == Shading::flat || shading[d] == Shading::gouraud) {
            job.bump = 0;
            job.lit_at = shading::is_lit_per_face(list, draw, shading[d]) ? lit_at_faces : lit_at_corners;
            job.roughness = cpu_shading::mean_roughness(*job.material);
        }
        if (settings.shadows) job.find_seen = find_seen, job.tracer = this;
        job.offset = least_offset * rays.reach();
        job.kernel =
            job.lit_at != lit_at_points ? cpu_shading::kernel_every : cpu_shading::kernel_for(job, settings.shadows);
        cutoffs_.push_back(shading::mask_cutoff(list.view(d), job.relief.limit_silhouette));
        has_holes = has_holes || cutoffs_.back() >= 0 || is_blended(d);
        has_filtered = has_filtered || cutoffs_.back() >= 0 || culling_.back().back || culling_.back().front;
        jobs_.push_back(job);
    }
}

HitJob TracePicture::hit_job(std::uint32_t draw) const { return jobs_[draw]; }

bool TracePicture::is_culled(std::uint32_t draw, bool is_against) const {
    const shading::Culling& c = culling_[draw];
    return is_against == c.front_is_negative ? c.front : c.back;
}

bool TracePicture::is_cut_out(const Meeting& meeting, const RayView& planes, std::int32_t ray) const {
    std::int32_t all_rays[batch_padding + 1], triangles[batch_padding + 1];
    float alpha[batch_padding + 1];
    std::fill(std::begin(all_rays), std::end(all_rays), ray);
    std::fill(std::begin(triangles), std::end(triangles), std::int32_t(meeting.triangle));
    HitJob job = jobs_[meeting.draw];
    job.count = 1;
    job.ray = all_rays, job.triangle = triangles, job.rays = planes, job.alpha = alpha;
    kernels.alpha(&job);
    return alpha[0] < cutoffs_[meeting.draw];
}

}  // namespace rakelight::raytrace
