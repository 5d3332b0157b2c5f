// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/lights_cameras.h"

#include <algorithm>
#include <cmath>

#include <rakelight/scene/light_limits.h>

namespace rakelight::io::gltf {
namespace {

double positive(const Value& source, const char* name, std::optional<double> fallback = {}) {
    const std::optional<double> value = source.optional_number(name);
    if (!value && !fallback) source.fail(std::string(name) + " is missing");
    const double result = value.value_or(fallback.value_or(0));
    if (!(result > 0) || result > 1e30) source.fail(std::string(name) + " must be greater than 0 and at most 1e30");
    return result;
}

void read_perspective(const Value& source, Camera& camera) {
    camera.projection = Projection::perspective;
    camera.vertical_fov_rad = positive(source, "yfov");
    if (camera.vertical_fov_rad >= pi) source.fail("yfov must be less than pi");
    if (source.has("aspectRatio")) camera.aspect = positive(source, "aspectRatio");
    camera.z_near = positive(source, "znear");
    camera.z_far = source.has("zfar") ? positive(source, "zfar") : std::numeric_limits<double>::infinity();
}

/// xmag and ymag are half the visible width and height. Negative ones mirror the picture; the specification advises
/// against.
void read_orthographic(const Value& source, Camera& camera) {
    camera.projection = Projection::orthographic;
    const double x = std::fabs(source.number("xmag", 0)), y = std::fabs(source.number("ymag", 0));
    if (!(x > 0) || !(y > 0)) source.fail("xmag and ymag must not be zero");
    if (x > 1e30 || y > 1e30) source.fail("xmag and ymag must be at most 1e30");
    camera.half_height = y;
    camera.aspect = x / y;
    if (!(*camera.aspect > 0) || !std::isfinite(*camera.aspect)) source.fail("xmag and ymag are too different");
    camera.z_near = source.number("znear", 0);
    camera.z_far = positive(source, "zfar");
}

Camera read_camera(const Value& source, std::uint32_t index) {
    Camera camera;
    camera.name = Document::name_of(source, camera_kind, index);
    const std::string type = source.text("type");
    if (type == "perspective")
        read_perspective(source.object("perspective"), camera);
    else if (type == "orthographic")
        read_orthographic(source.object("orthographic"), camera);
    else
        source.fail("its type '" + one_line(type, 30) + "' is unknown");
    if (!(camera.z_near < camera.z_far)) source.fail("zfar must be greater than znear");
    return camera;
}

LightType light_type_of(const Value& source) {
    const std::string type = source.text("type");
    if (type == "directional") return LightType::directional;
    if (type == "point") return LightType::point;
    if (type == "spot") return LightType::spot;
    source.fail("its type '" + one_line(type, 30) + "' is unknown");
}

Light read_light(const Value& source, std::uint32_t index) {
    Light light;
    light.name = Document::name_of(source, light_kind, index);
    light.units = LightUnits::photometric;
    light.type = light_type_of(source);
    if (const auto color = source.numbers<3>("color"))
        light.color = {float((*color)[0]), float((*color)[1]), float((*color)[2])};
    if (light.color.x < 0 || light.color.y < 0 || light.color.z < 0) source.fail("its color must not be negative");
    light.intensity = source.real("intensity", 1);
    if (light.intensity < 0) source.fail("its intensity must not be negative");
    if (source.has("range")) light.range = std::max(float(positive(source, "range")), float(min_light_range));
    if (light.type != LightType::spot) return light;
    const Value spot = source.object("spot");
    light.inner_cone_rad = spot.real("innerConeAngle", 0);
    light.outer_cone_rad = spot.real("outerConeAngle", pi / 4);
    if (!(light.inner_cone_rad >= 0) || !(light.inner_cone_rad < light.outer_cone_rad) ||
        light.outer_cone_rad > float(pi / 2))
        source.fail("its cone angles must be 0 <= inner < outer <= pi / 2");
    return light;
}

}  // namespace

std::vector<std::uint32_t> read_cameras(const Document& document, const Nodes& nodes, Scene& scene) {
    struct Numbered {
        std::uint32_t index;
        Camera camera;
    };
    std::vector<Numbered> found;
    for (const PlacedNode& placed : nodes.placed()) {
        const Value node = document.element(node_kind, placed.file, document.root());
        if (!node.has("camera")) continue;
        read_or_drop(document, "a camera", [&] {
            const std::uint32_t index = node.index("camera");
            Camera camera = read_camera(document.element(camera_kind, index, node), index);
            camera.node = placed.scene;
            found.push_back({index, std::move(camera)});
        });
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Numbered& a, const Numbered& b) { return a.index < b.index; });
    std::vector<std::uint32_t> numbers;
    for (Numbered& numbered : found) {
        numbers.push_back(numbered.index);
        scene.cameras.push_back(std::move(numbered.camera));
    }
    return numbers;
}

std::vector<std::uint32_t> read_lights(const Document& document, const Nodes& nodes, Scene& scene) {
    const Value owner = document.root().extension("KHR_lights_punctual");
    std::vector<std::uint32_t> numbers;
    for (const PlacedNode& placed : nodes.placed()) {
        const Value node = document.element(node_kind, placed.file, document.root());
        const Value use = node.extension("KHR_lights_punctual");
        if (!use) continue;
        read_or_drop(document, "a light", [&] {
            const std::uint32_t index = use.required_index("light");
            Light light = read_light(document.element_of(owner, light_kind, index, use), index);
            light.node = placed.scene;
            scene.lights.push_back(std::move(light));
            numbers.push_back(index);
        });
    }
    return numbers;
}

}  // namespace rakelight::io::gltf
