// SPDX-License-Identifier: Apache-2.0
// Surfaces for the samplers: every model and layer, narrow and wide.
#pragma once
#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {

/// How the sphere of directions is divided for a surface: about the mirror direction of v by the direction itself, or
/// about the normal by the halfway direction on its side, where lobes of facets keep their shape whatever v is: each such
/// direction mirrors v to one l, whichever side of it v is on.
enum class Division { by_direction, by_halfway };

struct PathCase {
    PathSurface surface;
    Division division = Division::by_halfway;
    double width = 0.5;  ///< of the lobe, as tan(angle / 2)
};

inline PathSurface ward_surface(const char* name, int form, float alpha_x, float alpha_y) {
    return {.name = name,
            .model = ward,
            .ward_form = form,
            .kd = {0.3f, 0.2f, 0.1f},
            .ks = {0.3f, 0.4f, 0.5f},
            .alpha_x = alpha_x,
            .alpha_y = alpha_y};
}

inline PathSurface without_diffuse(PathSurface s) {
    s.kd[0] = s.kd[1] = s.kd[2] = 0;
    return s;
}

inline PathSurface metal(const char* name, float alpha_x, float alpha_y) {
    return {.name = name,
            .model = pbr,
            .is_anisotropic = alpha_x != alpha_y ? 1 : 0,
            .ks = {1.0f, 0.7f, 0.3f},
            .alpha_x = alpha_x,
            .alpha_y = alpha_y};
}

inline PathSurface plastic(const char* name, float alpha) {
    return {.name = name,
            .model = pbr,
            .kd = {0.8f, 0.5f, 0.2f},
            .ks = {0.04f, 0.04f, 0.04f},
            .alpha_x = alpha,
            .alpha_y = alpha};
}

inline PathSurface with_sheen(PathSurface s, const char* name, float alpha) {
    s.name = name;
    s.has_sheen = 1, s.sheen[0] = 0.9f, s.sheen[1] = 0.5f, s.sheen[2] = 0.7f, s.sheen_alpha = alpha;
    return s;
}

inline PathSurface with_coat(PathSurface s, const char* name, float alpha) {
    s.name = name;
    s.has_coat = 1, s.coat = 0.8f, s.coat_alpha = alpha;
    return s;
}

inline PathSurface with_scattering(PathSurface s, const char* name) {
    s.name = name;
    s.has_scattering = 1;
    return s;
}

inline PathSurface with_two_normals(PathSurface s, const char* name) {
    s.name = name;
    s.has_two_normals = 1;
    return s;
}

inline std::vector<PathCase> path_cases() {
    const auto by_power = [](const char* name, int model, float exponent, int whole) {
        return PathSurface{.name = name,
                           .model = model,
                           .kd = {0.4f, 0.2f, 0.1f},
                           .ks = {0.3f, 0.5f, 0.7f},
                           .exponent = exponent,
                           .whole_exponent = whole};
    };
    const auto highlight = [&](const char* name, int model, float exponent) {
        return without_diffuse(by_power(name, model, exponent, 0));
    };
    using enum Division;
    return {
        {{.name = "Lambert", .model = lambert, .kd = {0.8f, 0.4f, 0.1f}}, by_direction, 1},
        {{.name = "Oren-Nayar", .model = oren_nayar, .kd = {0.8f, 0.4f, 0.1f}, .sigma = 0.5f}, by_direction, 1},
        {by_power("Phong 1", phong, 1, 1), by_direction, 0.8},
        {by_power("Phong 20", phong, 20, 20), by_direction, 0.3},
        {highlight("Phong 12.5 alone", phong, 12.5f), by_direction, 0.3},
        {highlight("Phong 2000 alone", phong, 2000), by_direction, 0.015},
        {by_power("Blinn-Phong 1", blinn_phong, 1, 0), by_halfway, 0.5},
        {by_power("Blinn-Phong 48", blinn_phong, 48, 48), by_halfway, 0.2},
        {highlight("Blinn-Phong 2.5 alone", blinn_phong, 2.5f), by_halfway, 0.4},
        {highlight("Blinn-Phong 2000 alone", blinn_phong, 2000), by_halfway, 0.015},
        {ward_surface("Ward 1992", 0, 0.2f, 0.4f), by_halfway, 0.2},
        {ward_surface("Ward Duer", 1, 0.2f, 0.2f), by_halfway, 0.15},
        {ward_surface("Ward bounded", 2, 0.5f, 0.1f), by_halfway, 0.15},
        {without_diffuse(ward_surface("Ward bounded, narrow", 2, 0.002f, 0.001f)), by_halfway, 0.001},
        {plastic("pbr", 0.3f), by_halfway, 0.3},
        {plastic("pbr, rough", 1), by_halfway, 0.5},
        {metal("metal 0.001", 0.001f, 0.001f), by_halfway, 0.0005},
        {metal("metal 0.1", 0.1f, 0.1f), by_halfway, 0.05},
        {metal("metal 1", 1, 1), by_halfway, 0.5},
        {metal("anisotropic 0.5 0.1", 0.5f, 0.1f), by_halfway, 0.2},
        {metal("anisotropic 0.003 0.001", 0.003f, 0.001f), by_halfway, 0.0008},
        {{.name = "black mirror", .model = pbr, .alpha_x = 0.4f, .alpha_y = 0.4f}, by_halfway, 0.3},
        {with_scattering(metal("", 0.8f, 0.8f), "scattering"), by_halfway, 0.4},
        {with_sheen(plastic("", 0.5f), "sheen", 0.25f), by_halfway, 0.4},
        {with_sheen({.model = pbr, .dielectric_f0 = 0, .f90 = 0}, "sheen alone", 0.1f), by_direction, 1},
        {with_coat(plastic("", 0.6f), "clearcoat", 0.15f), by_halfway, 0.15},
        {with_coat({.model = pbr, .dielectric_f0 = 0, .f90 = 0}, "clearcoat alone", 0.1f), by_halfway, 0.1},
        {with_two_normals(plastic("", 0.3f), "two normals"), by_halfway, 0.3},
        {with_two_normals(with_scattering(with_coat(with_sheen(metal("", 0.6f, 0.3f), "", 0.3f), "", 0.2f), ""),
                          "all layers"),
         by_halfway, 0.3},
    };
}

inline vec3 to_unit(vec3 a) { return normalize_or(a, vec3{0, 0, 1}); }

/// A frame that is none of the axes, with the other normals aslant, seen from v at an angle to n, off the tangent's plane.
inline Item seen_at(double degrees_off) {
    const vec3 n = to_unit(vec3{0.36f, -0.48f, -0.8f});
    const vec3 t = to_unit(vec3{0.8f, 0.6f, 0.0f}), b = cross(n, t);
    const double angle = radians(degrees_off), c = std::cos(angle), s = std::sin(angle);
    Item item;
    item.n = n, item.p = t;
    item.v = to_unit(n * float(c) + t * float(s * std::cos(0.7)) + b * float(s * std::sin(0.7)));
    item.ka = to_unit(n + t * 0.2f + b * 0.1f);
    item.kd = to_unit(n - t * 0.05f + b * 0.1f);
    return item;
}

}  // namespace rakelight::lighting_test
