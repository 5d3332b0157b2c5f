// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/motion/channel_targets.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/format_text.h"
#include "io/gltf/motion/pointer_table.h"

namespace rakelight::io::gltf {
namespace {

constexpr const char* extension_name = "KHR_animation_pointer";
constexpr const char* strength_place = "extensions/KHR_materials_emissive_strength/emissiveStrength";

std::optional<AnimationPath> node_path(std::string_view word) {
    if (word == "translation") return AnimationPath::translation;
    if (word == "rotation") return AnimationPath::rotation;
    if (word == "scale") return AnimationPath::scale;
    if (word == "weights") return AnimationPath::morph_weights;
    return std::nullopt;
}

std::uint32_t width_of(AnimationPath path) {
    return path == AnimationPath::rotation ? 4 : path == AnimationPath::morph_weights ? 1 : 3;
}

/// With an N for each number, so that pointers to the same of many elements are one remark.
[[noreturn]] void cannot_move(const std::string& pointer, const Value& channel) {
    std::string kind;
    for (const char c : one_line(pointer, 160)) {
        const bool is_digit = c >= '0' && c <= '9', continues = kind.ends_with("/N");
        if (is_digit && (kind.ends_with('/') || continues)) {
            if (!continues) kind += 'N';
        } else {
            kind += c;
        }
    }
    channel.fail("the property that its pointer '" + kind + "' names cannot be animated");
}

/// "/materials/12/alphaCutoff" behind "/materials/": the number, and what follows it.
struct Pointed {
    std::uint32_t index;
    std::string place;
};

std::optional<Pointed> behind(std::string_view prefix, std::string_view pointer) {
    if (!pointer.starts_with(prefix)) return std::nullopt;
    pointer.remove_prefix(prefix.size());
    std::uint32_t index = 0;
    const auto [end, fault] = std::from_chars(pointer.data(), pointer.data() + pointer.size(), index);
    if (fault != std::errc() || end == pointer.data() + pointer.size() || *end != '/') return std::nullopt;
    return Pointed{index, {end + 1, pointer.data() + pointer.size()}};
}

template <class Map>
std::vector<std::uint32_t> elements_in(const Map& map, std::uint32_t index) {
    const auto found = map.find(index);
    return found == map.end() ? std::vector<std::uint32_t>{} : found->second;
}

}  // namespace

ChannelTargets::ChannelTargets(const Document& document, const Nodes& nodes, const Materials& materials,
                               const std::vector<std::uint32_t>& cameras, const std::vector<std::uint32_t>& lights,
                               const Scene& scene)
    : document_(document), nodes_(nodes), materials_(materials), scene_(scene) {
    for (std::uint32_t i = 0; i < cameras.size(); ++i) cameras_[cameras[i]].push_back(i);
    for (std::uint32_t i = 0; i < lights.size(); ++i) lights_[lights[i]].push_back(i);
    if (document.count(animation_kind) == 0) return;
    for (const PlacedNode& placed : nodes.placed()) {
        const Value node = document.element(node_kind, placed.file, document.root());
        if (node.has("mesh") && !node.has("weights")) meshes_[node.index("mesh")].push_back(placed.scene);
    }
}

ChannelTarget ChannelTargets::of(const Value& channel) const {
    const Value target = channel.object("target");
    if (target.text("path") != "pointer") return of_node(target);
    const Value extension = target.extension(extension_name);
    if (!extension.has("pointer")) target.fail("its path is 'pointer', but it has none");
    return of_pointer(extension.text("pointer"), channel);
}

ChannelTarget ChannelTargets::of_node(const Value& target) const {
    const std::uint32_t index = target.index("node");
    if (index == no_index) return {};
    (void)document_.element(node_kind, index, target);
    const std::uint32_t node = nodes_.scene_index(index);
    if (node == no_index) return {};
    const std::string word = target.text("path");
    const std::optional<AnimationPath> path = node_path(word);
    if (!path) target.fail("its path '" + one_line(word, 30) + "' is not supported");
    return {*path, {}, {node}, width_of(*path), {}};
}

ChannelTarget ChannelTargets::of_pointer(const std::string& pointer, const Value& channel) const {
    if (const auto node = behind("/nodes/", pointer))
        if (node_path(node->place)) return of_node_part(node->index, node->place, channel);
    if (const auto mesh = behind("/meshes/", pointer))
        if (mesh->place == "weights") return of_mesh_weights(mesh->index, channel);
    for (const AnimationPath path : {AnimationPath::material, AnimationPath::light, AnimationPath::camera})
        if (const auto element = behind(pointer_prefix(path), pointer))
            if (row_at(path, element->place) || (path == AnimationPath::material && element->place == strength_place))
                return of_element(path, element->index, element->place, channel);
    cannot_move(pointer, channel);
}

ChannelTarget ChannelTargets::of_node_part(std::uint32_t node, const std::string& part, const Value& channel) const {
    (void)document_.element(node_kind, node, channel);
    const AnimationPath path = *node_path(part);
    ChannelTarget target{path, {}, {}, width_of(path), {}};
    if (const std::uint32_t placed = nodes_.scene_index(node); placed != no_index) target.elements = {placed};
    return target;
}

ChannelTarget ChannelTargets::of_mesh_weights(std::uint32_t mesh, const Value& channel) const {
    (void)document_.element(mesh_kind, mesh, channel);
    return {AnimationPath::morph_weights, {}, elements_in(meshes_, mesh), 1, {}};
}

ChannelTarget ChannelTargets::of_element(AnimationPath path, std::uint32_t index, const std::string& place,
                                         const Value& channel) const {
    const PointerRow* const row = row_at(path, place);
    ChannelTarget target{path, row ? row->property : "emission", {}, row ? row->width : 1, {}};
    if (path == AnimationPath::light) {
        (void)document_.element_of(document_.root().extension("KHR_lights_punctual"), light_kind, index, channel);
        target.elements = elements_in(lights_, index);
    } else if (path == AnimationPath::camera) {
        (void)document_.element(camera_kind, index, channel);
        target.elements = elements_in(cameras_, index);
        if (!target.elements.empty() && scene_.cameras[target.elements[0]].projection != row->projection)
            channel.fail(format_text("camera {} has no {}", index, place));
    } else {
        const Value material = document_.element(material_kind, index, channel);
        if (const std::uint32_t made = materials_.scene_index(index); made != no_index) target.elements = {made};
        if (place.starts_with("pbrMetallicRoughness/") && material.extension("KHR_materials_pbrSpecularGlossiness"))
            channel.fail(format_text("material {} uses its specular-glossiness parameters instead", index));
        if (target.property == "emission") set_emission(material, !row, target);
    }
    return target;
}

/// The scene's emission is the product of a color and a strength, one of which stays as it is.
void ChannelTargets::set_emission(const Value& material, bool is_strength, ChannelTarget& target) const {
    if (!is_strength) {
        const double strength = material.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1);
        target.factors = {float(std::clamp(strength, 0.0, 1e30))};
        return;
    }
    const auto color = material.numbers<3>("emissiveFactor").value_or(std::array<double, 3>{0, 0, 0});
    for (const double part : color) target.factors.push_back(float(std::clamp(part, 0.0, 1e30)));
}

}  // namespace rakelight::io::gltf
