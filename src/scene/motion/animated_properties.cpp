// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/animated_properties.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/light_limits.h>

#include "math/default_up.h"
#include "math/linear.h"
#include "scene/materials/material_table.h"

namespace rakelight {
namespace {

using Values = std::span<const float>;

/// A property with its setter.
template <class Element>
struct Setter {
    std::string name;
    std::uint32_t width;
    std::function<void(Element&, Values)> set;
};

float unit(float v) { return std::clamp(v, 0.0f, 1.0f); }
float not_negative(float v) { return std::max(v, 0.0f); }
vec3 color(Values v) { return {not_negative(v[0]), not_negative(v[1]), not_negative(v[2])}; }
dvec3 place(Values v) { return {v[0], v[1], v[2]}; }

void add_textures(std::vector<Setter<Material>>& rows) {
    for (const TextureRole& role : texture_roles()) {
        const std::string key = role.key;
        rows.push_back({key + ".offset", 2, [&role](Material& m, Values v) {
                            role.in(m).transform.offset = {v[0], v[1]};
                        }});
        rows.push_back({key + ".scale", 2, [&role](Material& m, Values v) {
                            role.in(m).transform.scale = {v[0], v[1]};
                        }});
        rows.push_back(
            {key + ".rotation", 1, [&role](Material& m, Values v) { role.in(m).transform.rotation_rad = v[0]; }});
    }
}

void add_parameters(std::vector<Setter<Material>>& rows) {
    for (const MaterialParameter& p : metallic_roughness_parameters()) {
        if (p.color) {
            rows.push_back({p.key, 3, [&p](Material& m, Values v) { m.metallic_roughness.*p.color = color(v); }});
            continue;
        }
        rows.push_back({p.key, 1, [&p](Material& m, Values v) {
                            const float x = p.gltf_range == MaterialParameter::Range::unit ? unit(v[0])
                                            : p.gltf_range == MaterialParameter::Range::not_negative
                                                ? not_negative(v[0])
                                                : v[0];
                            m.metallic_roughness.*p.number = x;
                        }});
    }
}

const std::vector<Setter<Material>>& material_rows() {
    static const std::vector<Setter<Material>> rows = [] {
        std::vector<Setter<Material>> r = {
            {"base_color", 4,
             [](Material& m, Values v) {
                 m.base_color = {color(v).x, color(v).y, color(v).z, unit(v[3])};
             }},
            {"emission", 3, [](Material& m, Values v) { m.emission = color(v); }},
            {"alpha_cutoff", 1, [](Material& m, Values v) { m.alpha_cutoff = not_negative(v[0]); }},
            {"normal_scale", 1, [](Material& m, Values v) { m.normal_scale = v[0]; }},
            {"occlusion_strength", 1, [](Material& m, Values v) { m.occlusion_strength = unit(v[0]); }},
        };
        add_parameters(r);
        add_textures(r);
        return r;
    }();
    return rows;
}

const std::vector<Setter<Light>>& light_rows() {
    static const std::vector<Setter<Light>> rows = {
        {"position", 3, [](Light& l, Values v) { l.position = place(v); }},
        {"direction", 3, [](Light& l, Values v) { l.direction = normalize_or(place(v), l.direction); }},
        {"ambient", 3, [](Light& l, Values v) { l.ambient = color(v); }},
        {"diffuse", 3, [](Light& l, Values v) { l.diffuse = color(v); }},
        {"specular", 3, [](Light& l, Values v) { l.specular = color(v); }},
        {"color", 3, [](Light& l, Values v) { l.color = color(v); }},
        {"intensity", 1, [](Light& l, Values v) { l.intensity = not_negative(v[0]); }},
        {"range", 1,
         [](Light& l, Values v) {
             l.range = v[0] > 0 ? std::max(v[0], float(min_light_range)) : std::numeric_limits<float>::infinity();
         }},
        {"inner_cone", 1, [](Light& l, Values v) { l.inner_cone_rad = std::clamp(v[0], 0.0f, float(pi / 2)); }},
        {"outer_cone", 1, [](Light& l, Values v) { l.outer_cone_rad = std::clamp(v[0], 0.0f, float(pi / 2)); }},
    };
    return rows;
}

void place_eye(Camera& c, dvec3 eye) { c.to_world[3] = {eye.x, eye.y, eye.z, 1}; }

void turn_to(Camera& c, dvec3 target) {
    const dvec3 eye = c.to_world[3].xyz();
    if (dot(target - eye, target - eye) > 0) c.to_world = look_at(eye, target, c.to_world[1].xyz());
}

void turn_up(Camera& c, dvec3 up) {
    const dvec3 eye = c.to_world[3].xyz();
    const dvec3 view = -c.to_world[2].xyz();
    c.to_world = look_at(eye, eye + view, is_along(up, view) ? default_up(view).up : up);
}

double length_of(float v) { return std::max(double(v), 1e-9); }

/// Orthographic cameras with their own aspect keep their width.
void set_half_height(Camera& c, double height) {
    if (c.aspect && !c.half_width) c.aspect = *c.aspect * (c.half_height / height);
    c.half_height = height;
}

void set_half_width(Camera& c, double width) {
    if (c.aspect && !c.half_width)
        c.aspect = width / c.half_height;
    else
        c.half_width = width;
}

/// Clamps the field of view to its valid range.
double field_of_view(float v) { return std::clamp(double(v), 1e-4, pi - 1e-4); }

const std::vector<Setter<Camera>>& camera_rows() {
    static const std::vector<Setter<Camera>> rows = {
        {"position", 3, [](Camera& c, Values v) { place_eye(c, place(v)); }},
        {"target", 3, [](Camera& c, Values v) { turn_to(c, place(v)); }},
        {"vertical_fov", 1, [](Camera& c, Values v) { c.vertical_fov_rad = field_of_view(v[0]); }},
        {"up", 3, [](Camera& c, Values v) { turn_up(c, place(v)); }},
        {"near", 1, [](Camera& c, Values v) { c.z_near = v[0]; }},
        {"far", 1, [](Camera& c, Values v) { c.z_far = v[0]; }},
        {"half_height", 1, [](Camera& c, Values v) { set_half_height(c, length_of(v[0])); }},
        {"half_width", 1, [](Camera& c, Values v) { set_half_width(c, length_of(v[0])); }},
        {"aspect", 1, [](Camera& c, Values v) { c.aspect = std::max(double(v[0]), 1e-6); }},
    };
    return rows;
}

template <class Element>
void add_rows(std::vector<AnimatedProperty>& all, AnimationPath path, const std::vector<Setter<Element>>& rows) {
    for (const Setter<Element>& row : rows) all.push_back({path, row.name, row.width});
}

template <class Element>
void set(const std::vector<Setter<Element>>& rows, std::string_view name, Element& element, Values values) {
    const auto row = std::ranges::find(rows, name, &Setter<Element>::name);
    if (row != rows.end()) row->set(element, values);
}

}  // namespace

std::span<const AnimatedProperty> animated_properties() {
    static const std::vector<AnimatedProperty> all = [] {
        std::vector<AnimatedProperty> rows;
        add_rows(rows, AnimationPath::material, material_rows());
        add_rows(rows, AnimationPath::light, light_rows());
        add_rows(rows, AnimationPath::camera, camera_rows());
        return rows;
    }();
    return all;
}

const AnimatedProperty* animated_property(AnimationPath path, std::string_view name) {
    for (const AnimatedProperty& row : animated_properties())
        if (row.path == path && row.name == name) return &row;
    return nullptr;
}

void set_property(Scene& scene, const AnimatedProperty& property, std::uint32_t element,
                  std::span<const float> values) {
    if (property.path == AnimationPath::material)
        set(material_rows(), property.name, scene.materials[element], values);
    else if (property.path == AnimationPath::light)
        set(light_rows(), property.name, scene.lights[element], values);
    else
        set(camera_rows(), property.name, scene.cameras[element], values);
}

void settle(Camera& camera, const Camera& before) {
    const bool is_fine =
        camera.z_near < camera.z_far && (camera.z_near > 0 || camera.projection == Projection::orthographic);
    if (!is_fine) camera.z_near = before.z_near, camera.z_far = before.z_far;
}

void settle(Light& light) { light.inner_cone_rad = std::min(light.inner_cone_rad, light.outer_cone_rad); }

}  // namespace rakelight
