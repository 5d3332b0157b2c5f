// SPDX-License-Identifier: Apache-2.0
#include "render/remarks/why_black.h"

#include <rakelight/scene/scene_queries.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "base/format_text.h"
#include "image/tone.h"
#include "image/tone_curves.h"
#include "math/functions.h"
#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/light_cutoff.h"
#include "scene/placement.h"
#include "shading/choices.h"
#include "shading/lights/lights.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

constexpr double least_visible = 1.5e-4;  ///< linear; less is code 0 of sRGB (0.5 / 255 / 12.92)

double largest(vec3 c) { return double(std::max({c.x, c.y, c.z})); }
bool is_black(vec3 c) { return largest(c) < least_visible; }

std::vector<bool> used_materials(const Scene& scene, bool& uses_default) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Node& node : scene.nodes)
        for (const std::uint32_t m : node.meshes)
            if (const std::uint32_t material = scene.meshes[m].material; material < used.size())
                used[material] = true;
            else
                uses_default = true;
    return used;
}

/// Whether a test holds for all materials that something has, the default one too.
template <class Test>
bool all_materials(const Scene& scene, const Test& test) {
    bool uses_default = false;
    const std::vector<bool> used = used_materials(scene, uses_default);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i] && !test(scene.materials[i])) return false;
    return !uses_default || test(Material{});
}

bool is_diffuse_model(Lighting lighting) {
    return lighting == Lighting::lambert || lighting == Lighting::oren_nayar || lighting == Lighting::oren_nayar_full;
}

/// Metal all over: it has no diffuse reflection but by the models that have nothing else.
bool is_metal(const Material& m) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    return m.model == MaterialModel::metallic_roughness && p.metallic >= 1 && !p.texture;
}

/// Gives no light and has no diffuse reflection: all that could be seen of it are highlights.
bool has_highlights_at_most(const Material& m, Lighting lighting) {
    if (m.model == MaterialModel::unlit) return is_black(m.base_color.xyz());
    return is_black(m.emission) && (is_black(m.base_color.xyz()) || (is_metal(m) && !is_diffuse_model(lighting)));
}

/// May have a highlight, a coat or a sheen. Microfacets reflect at grazing angles for any color.
bool has_highlights(const Material& m, Lighting lighting) {
    if (m.model == MaterialModel::unlit || is_diffuse_model(lighting)) return false;
    if (m.model == MaterialModel::classical) return !is_black(m.classical.specular);
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    if (lighting == Lighting::phong || lighting == Lighting::blinn_phong)
        return !is_black(m.base_color.xyz()) || (p.specular > 0 && !is_metal(m));
    return p.specular > 0 || p.metallic > 0 || p.clearcoat > 0 || !is_black(p.sheen_color);
}

/// Has textures or vertex colors that may be black where it is seen.
bool is_painted(const Scene& scene) {
    if (!all_materials(scene, [](const Material& m) { return !m.base_color_texture; })) return true;
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& m) { return !m.colors.empty(); });
}

struct Reach {
    bool is_on = false;        ///< has any brightness at all
    bool ends_before = false;  ///< its range is shorter than the way to the model
    bool is_cut = false;       ///< that range is the one of PictureRequest::light_cutoff
    double at_most = 0;        ///< radiance of a white surface that it could make anywhere in the model's box
};

/// [m] from a point to a box.
double distance(dvec3 p, const Bounds& box) {
    const dvec3 nearest{std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y),
                        std::clamp(p.z, box.low.z, box.high.z)};
    return length(p - nearest);
}

Reach reach_of(const Light& light, dvec3 position, const Bounds& box) {
    const bool is_photometric = light.units == LightUnits::photometric;
    const double color = is_photometric
                             ? largest(light.color) * double(light.intensity)
                             : std::max({largest(light.ambient), largest(light.diffuse), largest(light.specular)});
    Reach reach{.is_on = color > 0, .at_most = is_photometric ? color / pi : color};
    if (light.type != LightType::point && light.type != LightType::spot) return reach;
    const double d = distance(position, box);
    reach.ends_before = d >= double(light.range);
    const double divisor =
        is_photometric ? d * d : double(light.constant) + double(light.linear) * d + double(light.quadratic) * d * d;
    const double d_by_range = d / double(light.range);
    const double window = std::max(0.0, 1 - d_by_range * d_by_range * d_by_range * d_by_range);
    reach.at_most = divisor > 0 ? reach.at_most * window / divisor : std::numeric_limits<double>::infinity();
    return reach;
}

std::vector<Reach> lights_that_are_on(const Scene& scene, double cutoff) {
    const std::vector<dmat4> world = world_matrices(scene);
    const Bounds box = world_bounds(scene);
    std::vector<Reach> list;
    for (const Light& light : scene.lights) {
        Reach reach = reach_of(light, shading::place_of(light, world).position, box);
        reach.is_cut = is_cut(light, cutoff);
        if (reach.is_on) list.push_back(reach);
    }
    return list;
}

/// Where the ranges of all lights end before the model: whose doing that is.
std::string why_out_of_range(const std::vector<Reach>& lights, const std::string& all) {
    const auto cut = std::count_if(lights.begin(), lights.end(), [](const Reach& r) { return r.is_cut; });
    std::string out = "it is outside the range of " + all;
    if (cut == 0) return out;
    if (std::size_t(cut) == lights.size())
        return "'light-cutoff' ends " + all + " before it; a smaller value reaches farther";
    return format_text("{}; of {} the range is set by 'light-cutoff': a smaller value reaches farther", out, cut);
}

std::string why_unlit(const Scene& scene, const PictureRequest& request, const std::vector<Reach>& lights) {
    const std::string all = lights.size() == 1 ? "the light" : format_text("all {} lights", lights.size());
    if (lights.empty()) return "no light is brighter than 0";
    if (std::all_of(lights.begin(), lights.end(), [](const Reach& r) { return r.ends_before; }))
        return why_out_of_range(lights, all);
    double sum = 0;
    for (const Reach& r : lights) sum += r.ends_before ? 0 : r.at_most;
    const bool has_cut = std::any_of(lights.begin(), lights.end(), [](const Reach& r) { return r.is_cut; });
    if (sum * math::exp2(request.tone.exposure_ev) < least_visible)
        return "too little of " + all + " reaches it; see intensity and attenuation of lights, 'light-intensity', " +
               (has_cut ? "'light-cutoff', " : "") + "'exposure'";
    if (all_materials(scene, [&](const Material& m) {
            return has_highlights_at_most(m, shading::lighting_of(m, request.settings.lighting));
        }))
        return "its materials have only highlights, and its visible surfaces are not lit or reflect the lights "
               "elsewhere";
    const bool has_spot =
        std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.type == LightType::spot; });
    const std::string cone = lights.size() == 1 ? "outside its cone" : "outside their cones";
    std::string why = "no light reaches its visible surfaces: they face away from " + all;
    if (has_spot) why += (request.settings.shadows ? ", " : " or ") + cone;
    if (request.settings.shadows) why += " or in shadow";
    return why + (is_painted(scene) ? "; or its textures or vertex colors are black" : "");
}

}  // namespace

bool is_code(vec3 linear, std::uint8_t code) {
    const vec4 color{linear.x, linear.y, linear.z, 1};
    std::uint8_t rgb[3];
    to_srgb8({&color, 1}, 3, rgb);
    return rgb[0] == code && rgb[1] == code && rgb[2] == code;
}

bool shows_as(const PictureRequest& request, vec3 linear, std::uint8_t code) {
    return is_code(ToneCurve(request.tone)(linear), code);
}

bool is_unlit(const Scene& scene, const PictureRequest& request) {
    return request.settings.shading == Shading::unlit ||
           all_materials(scene, [](const Material& m) { return m.model == MaterialModel::unlit; });
}

bool has_blended(const Scene& scene) {
    return !all_materials(scene, [](const Material& m) { return m.alpha_mode != AlphaMode::blend; });
}

std::string why_black(const Scene& scene, const PictureRequest& request) {
    const bool is_fog_black = scene.fog.kind != FogKind::none && shows_as(request, scene.fog.color, 0);
    const bool has_own_colors = is_unlit(scene, request);
    if (has_own_colors && !is_fog_black) return "it is shown in its own colors, and they are black";
    if (all_materials(scene, [&](const Material& m) {
            const Lighting lighting = shading::lighting_of(m, request.settings.lighting);
            return has_highlights_at_most(m, lighting) && !has_highlights(m, lighting);
        }))
        return "its materials are black";
    if (is_fog_black)
        return std::string("the fog, which is black, hides it, or ") +
               (has_own_colors ? "its own colors are black" : "too little light reaches its visible surfaces");
    if (is_lit_by_environment(scene) && scene.environment->intensity > 0)
        return "no light reaches its visible surfaces, not even the environment's";
    return why_unlit(scene, request, lights_that_are_on(scene, request.light_cutoff));
}

}  // namespace rakelight
