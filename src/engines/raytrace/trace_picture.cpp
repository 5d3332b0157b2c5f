// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/trace_picture.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "cpu_shading/make_material_job.h"
#include "cpu_shading/make_mesh_view.h"
#include "engines/raytrace/media.h"
#include "math/linear.h"
#include "scene/materials/uv_matrix.h"
#include "scene/splat_mesh.h"
#include "shading/lights/lights.h"
#include "shading/shading_choice.h"

namespace rakelight::raytrace {
namespace {

/// Surfaces that cast shadows: blended ones do not, as in shadow maps, but on paths.
class ShadowFilter final : public RayFilter {
public:
    /// @param origin  about the eye
    ShadowFilter(const TracePicture& picture, vec3 origin, vec3 direction) : picture_(picture) {
        const vec3 ray[2] = {origin, direction};
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t c = 0; c < 3; ++c) numbers_[3 * k + c] = ray[k][c];
    }
    bool counts(const Meeting& meeting) const override {
        const bool is_filter = picture_.is_filter(meeting.draw);
        if (is_filter && !is_with_filters) return false;
        if (!is_filter && !picture_.is_path && picture_.is_blended(meeting.draw)) return false;
        return !picture_.is_masked(meeting.draw) || !picture_.is_cut_out(meeting, {numbers_, 1}, 0);
    }
    RayView ray() const { return {numbers_, 1}; }

    bool is_with_filters = false;  ///< what light goes through counts, too

private:
    const TracePicture& picture_;
    float numbers_[ray_planes] = {};  ///< no differentials: maps are read at their finest
};

void find_seen(const void* tracer, ShadowRays* rays) {
    const TileTracer& tile = *static_cast<const TileTracer*>(tracer);
    for (std::int32_t i = 0; i < rays->count; ++i) {
        vec3 seen{1, 1, 1};
        if (rays->length[i] >= 0 && !tile.context.cancelled()) {
            const vec3 origin{rays->origin[0][i], rays->origin[1][i], rays->origin[2][i]};
            const vec3 direction{rays->direction[0][i], rays->direction[1][i], rays->direction[2][i]};
            const Media media = tile.media ? tile.media[tile.hit_ray[rays->first + i]] : Media{};
            seen = tile.picture.light_reaching(origin, direction, rays->length[i], media);
            ++tile.shadow_rays;
        }
        for (std::size_t c = 0; c < 3; ++c) rays->seen[c][i] = seen[c];
    }
}

void set_rows(const dmat4& m, float (&to)[3][4]) {
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) to[r][c] = float(m[c][r]);
}

std::atomic<std::uint64_t> last_number{0};

bool lets_light_through(const cpu_shading::MaterialView& m) {
    return m.metallic_roughness != 0 ? m.transmission > 0 : m.filter[0] > 0 || m.filter[1] > 0 || m.filter[2] > 0;
}

/// Some point may: maps multiply roughness, and coats stand above.
bool mirrors(const cpu_shading::MaterialView& m) {
    if (m.metallic_roughness == 0)
        return m.mirror != shading::mirror_none && (m.specular[0] > 0 || m.specular[1] > 0 || m.specular[2] > 0);
    const auto may_mirror = [&m](float roughness, int role) {
        return roughness <= shading::widest_mirror || m.map[role].view != nullptr;
    };
    return may_mirror(m.roughness, role_metallic_roughness) ||
           (m.clearcoat > 0 && may_mirror(m.clearcoat_roughness, role_clearcoat_roughness));
}

/// Light from the environment comes along paths, and lighting is found where they meet surfaces.
void make_path_job(HitJob& job) {
    job.environment = nullptr;
    job.has_light_around = 1;  // the albedos that lobes are chosen by
    job.is_path = 1;
    if (job.lit_at == lit_at_corners) job.lit_at = lit_at_points;
}

/// @param eye  about the middle of the ray scene
ShapeView shape_view(const PlacedShape* placed, const Material& material, vec3 eye) {
    ShapeView view{};
    view.kind = shape_none;
    if (!placed) return view;
    // dP/du' = (vv dP/du - vu dP/dv) / determinant
    const UvMatrix m = tangent_matrix(material);
    const double determinant = m.uu * m.vv - m.uv * m.vu, sign = determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
    view.tangent_uv[0] = float(m.vv * sign), view.tangent_uv[1] = float(-m.vu * sign);
    const ExactShape& s = placed->shape;
    view.kind = std::int32_t(s.kind);
    view.radius = float(s.radius), view.tube_radius = float(s.tube_radius), view.height = float(s.height);
    view.width = float(s.width), view.depth = float(s.depth);
    set_rows(placed->to_object * translation(cast<double>(eye)), view.to_object);
    return view;
}

}  // namespace

TracePicture::TracePicture(const cpu_shading::DrawList& of_list, const RayScene& of_rays,
                           const shading::PictureCamera& of_view, const RenderSettings& of_settings,
                           const Kernels& of_kernels, Context& context)
    : number(++last_number),
      list(of_list),
      rays(of_rays),
      view(of_view),
      settings(of_settings),
      kernels(of_kernels),
      marks(marked_draws(list, view, settings, context)),
      points(rays, marks, view, settings, context),
      lines(rays, marks, view, settings.line_width, context),
      is_path(of_settings.method == RayMethod::path),
      max_depth(of_settings.method == RayMethod::cast ? 0 : of_settings.max_depth),
      mark_limits_(view, settings) {
    const dvec3 eye = view.camera_to_world[3].xyz();
    lights = shading::make_lights(list.scene, list.node_to_world, eye);
    eye_ = cast<float>(eye - rays.origin());
    const std::size_t count = list.draws.size();
    to_eye_.reserve(count), frames_.reserve(count), jobs_.reserve(count);
    const std::vector<Shading> shading = shading::choose_shading(list, settings, view, context);
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
        job.is_of_splats = is_of_splats(list.scene.meshes[draw.mesh]);
        job.shape = shape_view(rays.shape_of(d), list.scene_material(list.material(draw)), eye_);
        culling_.push_back(shading::culling_of(list, draw, settings));
        job.front_is_negative = culling_.back().front_is_negative;
        if (shading[d] == Shading::unlit) job.unlit = 1;
        if (shading[d] == Shading::flat || shading[d] == Shading::gouraud) {
            job.bump = 0;
            job.lit_at = shading::is_lit_per_face(list, draw, shading[d]) ? lit_at_faces : lit_at_corners;
            job.roughness = cpu_shading::mean_roughness(*job.material);
        }
        if (settings.shadows) job.find_seen = find_seen;
        for (std::size_t c = 0; c < 3; ++c) job.to_rays[c] = eye_[c];
        job.kernel =
            job.lit_at != lit_at_points ? cpu_shading::kernel_every : cpu_shading::kernel_for(job, settings.shadows);
        cutoffs_.push_back(shading::mask_cutoff(list.view(d), job.relief.limit_silhouette));
        if (is_path) make_path_job(job);
        const bool follows = (max_depth > 0 || is_path) && shading[d] != Shading::unlit && !job.material->unlit;
        lets_through_.push_back(follows && lets_light_through(*job.material));
        is_filter_.push_back(is_path ? (lets_through_[d] && job.material->is_body == 0) || is_blended(d)
                                     : bool(lets_through_[d]));
        goes_on_.push_back(is_filter_.back() || (follows && mirrors(*job.material)));
        has_filters = has_filters || is_filter_.back();
        has_holes = has_holes || cutoffs_.back() >= 0 || is_blended(d) || is_filter_.back();
        has_masked = has_masked || cutoffs_.back() >= 0;
        has_filtered = has_filtered || cutoffs_.back() >= 0 || culling_.back().back || culling_.back().front;
        jobs_.push_back(job);
    }
}

vec4 TracePicture::mark_color(const Meeting& meeting) const {
    const MarkedDraw& m = marks[mark_of(meeting)];
    const vec4 color = m.color_at(meeting.triangle, meeting.part);
    return m.is_line ? vec4{color.x, color.y, color.z, color.w * lines.coverage()} : color;
}

MarkLimit TracePicture::mark_limit(const Meeting& surface, vec3 origin, vec3 direction, bool is_primary) const {
    const auto alike = [](float limit) { return MarkLimit{limit, limit}; };
    if (surface.draw == no_index) return alike(is_primary ? float(view.z_far) : std::numeric_limits<float>::infinity());
    if (jobs_[surface.draw].shape.kind != shape_none) return alike(surface.t * step_behind);
    const Mesh& mesh = list.scene.meshes[list.draws[surface.draw].mesh];
    const std::uint32_t* const index = mesh.indices.data() + 3 * std::size_t(surface.triangle);
    std::array<dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = transform_point(to_eye_[surface.draw], cast<double>(mesh.positions[index[k]]));
    return mark_limits_.on_triangle(corners, surface.t, origin, direction, is_primary);
}

vec3 TracePicture::light_reaching(vec3 origin, vec3 direction, float to, const Media& media) const {
    ShadowFilter filter(*this, origin, direction);
    if (is_blocked(in_rays(origin), direction, 0, to, has_holes ? &filter : nullptr)) return {};
    if (!has_filters && media.innermost() == no_index) return {1, 1, 1};
    filter.is_with_filters = true;
    return light_through(filter.ray(), to, filter, media);
}

HitJob TracePicture::hit_job(std::uint32_t draw) const { return jobs_[draw]; }

HitJob TracePicture::hit_job(std::uint32_t draw, bool is_from_surface, bool goes_on) const {
    HitJob job = jobs_[draw];
    if (goes_on) job.kernel = cpu_shading::kernel_every;
    if (is_from_surface) job.orthographic = job.viewer_at_infinity = 0;
    return job;
}

bool TracePicture::is_culled(const Meeting& meeting) const {
    const shading::Culling& c = culling_[meeting.draw];
    return meeting.is_against == c.front_is_negative ? c.front : c.back;
}

bool TracePicture::meets_front(const Meeting& meeting, vec3 direction) const {
    const shading::Draw& draw = list.draws[meeting.draw];
    bool is_against = meeting.is_against;
    if (!rays.shape_of(meeting.draw)) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        const auto corner = [&](std::size_t k) {
            return cast<double>(mesh.positions[mesh.indices[3 * std::size_t(meeting.triangle) + k]]);
        };
        const dvec3 normal = cofactor(upper_left(draw.to_world)) * cross(corner(1) - corner(0), corner(2) - corner(0));
        is_against = dot(normal, cast<double>(direction)) < 0;
    }
    return is_against == culling_[meeting.draw].front_is_negative;
}

vec3 TracePicture::light_through(const RayView& ray, float to, const RayFilter& filter, Media media) const {
    constexpr int most_surfaces = 64;
    const auto vector = [&ray](std::size_t at) { return vec3{ray.planes[at], ray.planes[at + 1], ray.planes[at + 2]}; };
    const vec3 origin = in_rays(vector(ray_o)), direction = vector(ray_d);
    const float meters = length(direction);
    vec3 light{1, 1, 1};
    float from = 0, outside = 0;  // on the ray; outside: what lies in no body that is known, up to now
    for (int i = 0; i < most_surfaces && std::max({light.x, light.y, light.z}) > 1e-4f; ++i) {
        const Meeting m = first(origin, direction, from, to, &filter);
        const float end = m.draw == no_index ? to : m.t, part = (end - from) * meters;
        if (media.innermost() != no_index)
            light = light * absorbed(list.materials[media.innermost()].factors, part);
        else
            outside += part;
        if (m.draw == no_index) return light;
        light = light * share_through(m, ray);
        from = m.t * step_behind;
        const shading::MaterialFactors& surface = list.view(m.draw);
        const std::uint32_t body = list.draws[m.draw].material;
        if (surface.is_body == 0) continue;
        if (meets_front(m, direction)) {
            media.enter(body);
        } else if (!media.holds(body)) {  // the ray started inside, which was unknown
            light = light * absorbed(surface, std::exchange(outside, 0.0f));
        } else {
            media.leave(body);
        }
    }
    return {};
}

namespace {

/// A job of one hit, with room for what kernels read and write past it.
struct OneHit {
    std::int32_t ray[batch_padding + 1], triangle[batch_padding + 1];
    float t[batch_padding + 1], red[batch_padding + 1], green[batch_padding + 1], blue[batch_padding + 1],
        alpha[batch_padding + 1];
    HitJob job;

    OneHit(const HitJob& of, const Meeting& meeting, const RayView& planes, std::int32_t number) : job(of) {
        std::fill(std::begin(ray), std::end(ray), number);
        std::fill(std::begin(triangle), std::end(triangle), std::int32_t(meeting.triangle));
        std::fill(std::begin(t), std::end(t), meeting.t);
        job.count = 1;
        job.ray = ray, job.triangle = triangle, job.t = t, job.rays = planes;
        job.red = red, job.green = green, job.blue = blue, job.alpha = alpha;
    }
    OneHit(const OneHit&) = delete;
    OneHit& operator=(const OneHit&) = delete;
};

}  // namespace

vec3 TracePicture::share_through(const Meeting& meeting, const RayView& planes) const {
    const OneHit hit(jobs_[meeting.draw], meeting, planes, 0);
    kernels.through(&hit.job);
    return {hit.red[0], hit.green[0], hit.blue[0]};
}

vec3 TracePicture::emission_at(std::uint32_t draw, std::uint32_t triangle, vec3 origin, vec3 direction) const {
    const cpu_shading::MaterialView& m = *jobs_[draw].material;
    const vec3 plain{m.emission[0], m.emission[1], m.emission[2]};
    if (jobs_[draw].unlit == 0 && m.map[role_emission].view == nullptr && m.clearcoat == 0 && !is_blended(draw) &&
        !is_masked(draw))
        return plain;
    float planes[ray_planes] = {};
    for (std::size_t c = 0; c < 3; ++c)
        planes[std::size_t(ray_o) + c] = origin[c], planes[std::size_t(ray_d) + c] = direction[c];
    const OneHit hit(jobs_[draw], {draw, triangle, 1}, {planes, 1}, 0);
    kernels.emission(&hit.job);
    const vec3 own{hit.red[0], hit.green[0], hit.blue[0]};
    if (is_masked(draw)) return hit.alpha[0] < cutoffs_[draw] ? vec3{} : own;
    return is_blended(draw) ? own * std::clamp(hit.alpha[0], 0.0f, 1.0f) : own;
}

bool TracePicture::is_cut_out(const Meeting& meeting, const RayView& planes, std::int32_t ray) const {
    const OneHit hit(jobs_[meeting.draw], meeting, planes, ray);
    kernels.alpha(&hit.job);
    return hit.alpha[0] < cutoffs_[meeting.draw];
}

}  // namespace rakelight::raytrace
