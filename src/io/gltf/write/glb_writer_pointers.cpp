// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/glb_writer_pointers.h"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

std::vector<std::string> parts_of(const std::string& place) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end; (end = place.find('/', begin)) != std::string::npos; begin = end + 1)
        parts.push_back(place.substr(begin, end - begin));
    parts.push_back(place.substr(begin));
    return parts;
}

/// Whether a material that is written as glTF's own still has it: classical ones are converted, unlit ones have a color alone.
bool has_property(const Material& m, const PointerRow& row) {
    const bool is_of_color = row.property == "base_color" || row.property == "alpha_cutoff" ||
                             row.texture == "pbrMetallicRoughness/baseColorTexture";
    if (m.model == MaterialModel::unlit) return is_of_color;
    const bool is_of_all = row.property == "emission" || row.property == "normal_scale" ||
                           row.property == "occlusion_strength" || row.property == "alpha_cutoff";
    return m.model == MaterialModel::metallic_roughness || is_of_all;
}

}  // namespace

MovedMaterials::MovedMaterials(const Scene& scene)
    : is_moved_(scene.materials.size(), false), strength_(scene.materials.size(), 1.0f) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const vec3 e = scene.materials[i].emission;
        strength_[i] = std::max({1.0f, e.x, e.y, e.z});
    }
    for (const Animation& animation : scene.animations)
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.path != AnimationPath::material || channel.element == no_index) continue;
            is_moved_[channel.element] = true;
            if (channel.property != "emission" || channel.values.empty()) continue;
            float& strength = strength_[channel.element];
            strength = std::max(strength, *std::max_element(channel.values.begin(), channel.values.end()));
        }
}

void PointerWriter::used(const std::string& extension) {
    if (std::find(extensions_.begin(), extensions_.end(), extension) == extensions_.end())
        extensions_.push_back(extension);
}

/// A pointer names a member of an object that is there. Extensions are made where they are not: they say what is so without them.
bool PointerWriter::make_parent(OrderedJson& element, const std::string& place) {
    const std::vector<std::string> parts = parts_of(place);
    OrderedJson* at = &element;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const bool is_extension = i > 0 && parts[i - 1] == "extensions";
        if (!at->contains(parts[i])) {
            if (!is_extension && parts[i] != "extensions") return false;
            (*at)[parts[i]] = OrderedJson::object();
        }
        if (is_extension) used(parts[i]);
        at = &(*at)[parts[i]];
    }
    return true;
}

std::vector<WrittenPointer> PointerWriter::of_material(const AnimationChannel& channel) {
    const PointerRow* const row = row_of(channel.path, channel.property);
    if (!row || !has_property(scene_.materials[channel.element], *row)) return {};
    OrderedJson& json = root_["materials"][channel.element];
    // Extensions are made only in a texture that is there.
    const bool has_texture = row->texture.empty() || [&] {
        const OrderedJson::json_pointer at("/" + row->texture);
        return json.contains(at);
    }();
    if (!has_texture || !make_parent(json, row->place)) return {};
    const float divisor = row->property == "emission" ? moved_.emission_strength(channel.element) : 1.0f;
    return {{format_text("{}{}/{}", pointer_prefix(channel.path), channel.element, row->place), row->width, divisor}};
}

std::vector<WrittenPointer> PointerWriter::of_light(const AnimationChannel& channel) {
    const Light& light = scene_.lights[channel.element];
    const PointerRow* const row = row_of(channel.path, channel.property);
    const std::size_t number = lights_[channel.element];
    if (!row || number == no_index || light.units != LightUnits::photometric) return {};
    if (row->property == "range" && light.type == LightType::directional) return {};
    if (!make_parent(root_["extensions"]["KHR_lights_punctual"]["lights"][number], row->place)) return {};
    return {{format_text("{}{}/{}", pointer_prefix(channel.path), number, row->place), row->width, 1}};
}

std::vector<WrittenPointer> PointerWriter::of_camera(const AnimationChannel& channel) {
    const Camera& camera = scene_.cameras[channel.element];
    std::vector<WrittenPointer> all;
    const auto add = [&](std::string_view property) {
        const PointerRow* const row = row_of(channel.path, property, camera.projection);
        if (row)
            all.push_back({format_text("{}{}/{}", pointer_prefix(channel.path), channel.element, row->place), 1, 1});
    };
    add(channel.property);
    // glTF's width does not follow the height by itself.
    if (channel.property == "half_height" && !camera.aspect && !camera.half_width) add("half_width");
    return all;
}

std::vector<WrittenPointer> PointerWriter::pointers_of(const AnimationChannel& channel) {
    if (channel.element == no_index) return {};
    if (channel.path == AnimationPath::material) return of_material(channel);
    return channel.path == AnimationPath::light ? of_light(channel) : of_camera(channel);
}

}  // namespace rakelight::io::gltf
