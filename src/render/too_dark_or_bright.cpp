// SPDX-License-Identifier: Apache-2.0
#include "render/too_dark_or_bright.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/tone.h"
#include "image/tone_curves.h"
#include "math/functions.h"
#include "math/linear.h"
#include "render/picture_steps.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

constexpr double most_white = 2.0 / 3;  ///< of what the model covers; above that a remark is due
constexpr double least_black = 0.9;  ///< the same of multisampled pictures, whose edges are mixed with the background
constexpr double least_visible = 1.5e-4;  ///< linear; less is code 0 of sRGB (0.5 / 255 / 12.92)

bool is_black(vec3 c) { return c.x <= 0 && c.y <= 0 && c.z <= 0; }
double largest(vec3 c) { return double(std::max({c.x, c.y, c.z})); }

/// Pixels of the background that are as `code` in red, green and blue.
std::uint64_t background_pixels(const PictureRequest& request, const RenderStats& stats, std::uint8_t code) {
    const Window window = whole_window(request.settings);
    const vec3 shown = ToneCurve(request.tone)(request.settings.background.xyz());
    const vec4 color{shown.x, shown.y, shown.z, 1};
    std::uint8_t rgb[3];
    to_srgb8({&color, 1}, 3, rgb);
    if (rgb[0] != code || rgb[1] != code || rgb[2] != code) return 0;
    return std::uint64_t(window.width) * std::uint64_t(window.height) - stats.pixels_covered;
}

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

/// Whether a test holds for all materials that something has; the default one is lit and white.
template <class Test>
bool all_materials(const Scene& scene, const Test& test) {
    bool uses_default = false;
    const std::vector<bool> used = used_materials(scene, uses_default);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i] && !test(scene.materials[i])) return false;
    return !uses_default;
}

/// Nothing of the model is lit.
bool is_unlit(const Scene& scene, const PictureRequest& request) {
    return request.settings.shading == Shading::unlit ||
           all_materials(scene, [](const Material& m) { return m.model == MaterialModel::unlit; });
}

/// Reflects nothing and gives no light. (Metallic-roughness materials reflect something whatever their color.)
bool is_black_material(const Material& m) {
    return is_black(m.base_color.xyz()) &&
           (m.model == MaterialModel::unlit ||
            (m.model == MaterialModel::classical && is_black(m.classical.specular) && is_black(m.emission)));
}

struct Reach {
    bool is_on = false;        ///< has any brightness at all
    bool ends_before = false;  ///< its range is shorter than the way to the model
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
    reach.at_most = divisor > 0 ? reach.at_most / divisor : std::numeric_limits<double>::infinity();
    return reach;
}

std::vector<Reach> lights_that_are_on(const Scene& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    const Bounds box = world_bounds(scene);
    std::vector<Reach> list;
    for (const Light& light : scene.lights) {
        const Reach reach = reach_of(light, light.node == none ? light.position : world[light.node][3].xyz(), box);
        if (reach.is_on) list.push_back(reach);
    }
    return list;
}

std::string why_black(const Scene& scene, const PictureRequest& request) {
    if (is_unlit(scene, request)) return "it is shown in its own colors, and those are";
    if (all_materials(scene, is_black_material)) return "its materials are black";
    if (is_lit_by_environment(scene) && scene.environment->intensity > 0)
        return "no light falls on what is seen of it, the environment's neither";
    const std::vector<Reach> lights = lights_that_are_on(scene);
    const std::string all = lights.size() == 1 ? "the light" : "all " + std::to_string(lights.size()) + " lights";
    if (lights.empty()) return "no light has any brightness";
    if (std::all_of(lights.begin(), lights.end(), [](const Reach& r) { return r.ends_before; }))
        return "it is out of the range of " + all;
    double sum = 0;
    for (const Reach& r : lights) sum += r.ends_before ? 0 : r.at_most;
    if (sum * math::exp2(request.tone.exposure_ev) < least_visible)
        return "too little of " + all +
               " reaches it; see intensity and attenuation of lights, --light-intensity, --exposure";
    const bool has_spot =
        std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.type == LightType::spot; });
    const std::string cone = lights.size() == 1 ? "outside of its cone" : "outside of cones";
    std::string why = "no light falls on what is seen of it: that is turned away from " + all;
    if (has_spot) why += (request.settings.shadows ? ", " : " or ") + cone;
    if (request.settings.shadows) why += " or in shadow";
    return why;
}

}  // namespace

void ExtremePixels::add(std::uint64_t black, std::uint64_t white) {
    if (black > 0) black_.fetch_add(black, std::memory_order_relaxed);
    if (white > 0) white_.fetch_add(white, std::memory_order_relaxed);
}

void ExtremePixels::add(std::span<const std::uint32_t> srgb8) {
    constexpr std::size_t block = 16;  // a fixed count, so that the compiler makes vectors of it
    constexpr std::uint32_t rgb = 0xFFFFFF;
    std::uint32_t black = 0, white = 0;
    std::size_t i = 0;
    for (; i + block <= srgb8.size(); i += block)
        for (std::size_t k = 0; k < block; ++k) {
            black += std::uint32_t((srgb8[i + k] & rgb) == 0);
            white += std::uint32_t((srgb8[i + k] & rgb) == rgb);
        }
    for (; i < srgb8.size(); ++i) {
        black += std::uint32_t((srgb8[i] & rgb) == 0);
        white += std::uint32_t((srgb8[i] & rgb) == rgb);
    }
    add(black, white);
}

void ExtremePixels::add_row(const std::byte* row, std::size_t count, int channels) {
    std::uint64_t black = 0, white = 0;
    for (std::size_t i = 0; i < count; ++i, row += channels) {
        black += std::uint64_t((row[0] | row[1] | row[2]) == std::byte{0});
        white += std::uint64_t((row[0] & row[1] & row[2]) == std::byte{255});
    }
    add(black, white);
}

void remark_extremes(const Scene& scene, const PictureRequest& request, const PictureResult& result, Report& report) {
    const RenderStats& stats = result.stats;
    const bool has_sky = scene.environment && scene.environment->is_background;
    if (stats.pixels_covered == 0 || stats.pixels_marked > 0 || has_sky) return;
    const auto share = [&](std::uint64_t all, std::uint8_t code) {
        return (double(all) - double(background_pixels(request, stats, code))) / double(stats.pixels_covered);
    };
    if (share(result.black_pixels, 0) >= (request.settings.samples > 1 ? least_black : 1.0))
        report.add(Remark::warning, request.input, "", "all of the model came out black: " + why_black(scene, request));
    const double white = share(result.white_pixels, 255);
    if (white > most_white && !is_unlit(scene, request))
        report.add(Remark::warning, request.input, "",
                   std::to_string(int(std::lround(100 * std::min(white, 1.0)))) +
                       " % of what the model covers is white, 1 or more in red, green and blue: see --exposure, "
                       "--tone-mapping, --light-intensity");
}

}  // namespace rakelight
