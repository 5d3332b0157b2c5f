// SPDX-License-Identifier: Apache-2.0
#include "shading/behind.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engines/empty_pixel.h"
#include "math/linear.h"
#include "shading/draw_choices.h"

namespace rakelight::shading {
namespace {

/// The power of two whose ratio to `side` is nearest to 1.
int nearest_power(int side) {
    const auto below = int(std::bit_floor(unsigned(side)));
    const bool is_nearer_above = std::int64_t(side) * side > 2 * std::int64_t(below) * below;
    return std::clamp(is_nearer_above ? 2 * below : below, 1, 2048);
}

void put(const dvec3& v, double one, float (&to)[4]) {
    to[0] = float(v.x), to[1] = float(v.y), to[2] = float(v.z), to[3] = float(one);
}

}  // namespace

bool shows_behind(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    const DrawMaterial& material = list.material(draw);
    const MaterialFactors& m = material.factors;
    return material.is_drawn && m.metallic_roughness != 0 && m.transmission > 0 && settings.lighting_text.empty() &&
           lighting_of(list, draw, settings) == Lighting::pbr;
}

bool needs_behind(const DrawList& list, const RenderSettings& settings) {
    return settings.colors && settings.surfaces &&
           std::ranges::any_of(list.draws, [&](const Draw& draw) { return shows_behind(list, draw, settings); });
}

bool is_behind(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    return list.material(draw).factors.blend == 0 && !shows_behind(list, draw, settings);
}

PictureCamera camera_behind(const PictureCamera& view) {
    PictureCamera behind = view;
    behind.width = nearest_power(view.width), behind.height = nearest_power(view.height);
    return behind;
}

RenderSettings settings_behind(const RenderSettings& settings, const PictureCamera& behind) {
    RenderSettings s = settings;
    s.width = behind.width, s.height = behind.height;
    s.window = {};
    s.channels = 0;
    s.edges = false;
    s.points = PointShape::none;
    const vec3 seen = light_of_background(settings);
    s.background = {seen.x, seen.y, seen.z, 1};
    s.composites_background = true;
    s.ambient_occlusion = false;
    return s;
}

BehindFactors behind_factors(const PictureCamera& behind) {
    const dvec3 right = behind.camera_to_world[0].xyz() * behind.scale_x,
                up = behind.camera_to_world[1].xyz() * behind.scale_y, back = behind.camera_to_world[2].xyz();
    BehindFactors out{};
    // u = (x / w + 1) / 2, v = (1 - y / w) / 2; w = -z of the camera in perspective, else 1.
    const dvec3 w = behind.orthographic ? dvec3{} : -back;
    const double one = behind.orthographic ? 1 : 0;
    put((right + w) * 0.5, 0.5 * one, out.to_u);
    put((w - up) * 0.5, 0.5 * one, out.to_v);
    put(w, one, out.to_w);
    out.last_level = float(std::bit_width(unsigned(std::max(behind.width, behind.height))) - 1);
    return out;
}

float thickness_scale(const Draw& draw) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += length(draw.to_world[c].xyz());
    return float(sum / 3);
}

}  // namespace rakelight::shading
