// SPDX-License-Identifier: Apache-2.0
#include "materials.h"

#include <algorithm>

#include <rakelight/io/world_words.h>

namespace rakelight::viewer {
namespace {

bool has_meshes_without_material(const Scene& scene) {
    return std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return mesh.material == no_index; });
}

std::uint32_t root_of(const Scene& scene, std::uint32_t node) {
    while (scene.nodes[node].parent != no_index) node = scene.nodes[node].parent;
    return node;
}

bool is_number(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void set_material(Look& look, const MaterialTarget& target, const std::string& key_and_value) {
    const std::string words[] = {key_and_value};
    const std::vector<WorldValue> set = material_values(words);
    auto found = std::ranges::find(look.materials, target, &MaterialEdit::target);
    if (found == look.materials.end()) found = look.materials.insert(found, MaterialEdit{target, {}});
    for (const WorldValue& value : set) {
        std::erase_if(found->values, [&](const WorldValue& v) { return v.key == value.key; });
        found->values.push_back(value);
    }
}

const std::vector<WorldValue>* edited_values(const Look& look, const MaterialTarget& target) {
    const auto found = std::ranges::find(look.materials, target, &MaterialEdit::target);
    return found == look.materials.end() ? nullptr : &found->values;
}

void forget_material(Look& look, const MaterialTarget& target) {
    std::erase_if(look.materials, [&](const MaterialEdit& edit) { return edit.target == target; });
}

Scene with_edits(Scene scene, const std::vector<MaterialEdit>& edits, Context& context) {
    std::vector<MaterialChanges> changes;
    changes.reserve(edits.size());
    for (const MaterialEdit& edit : edits) changes.push_back({edit.target, edit.values});
    return changes.empty() ? scene : with_material_changes(std::move(scene), changes, context);
}

std::string material_name(const Scene& scene, std::uint32_t material) {
    return material < scene.materials.size() ? scene.materials[material].name : "default";
}

std::uint32_t source_material(const Scene& scene, const std::vector<MaterialEdit>& edits, std::uint32_t material) {
    const auto first_own = std::uint32_t(scene.materials.size() + (has_meshes_without_material(scene) ? 1 : 0));
    std::uint32_t next = first_own;
    std::vector<std::pair<std::uint32_t, std::size_t>> own;  // nodes and their meshes that have own ones
    for (const MaterialEdit& edit : edits) {
        if (edit.target.node >= scene.nodes.size()) continue;
        const std::vector<std::uint32_t>& meshes = scene.nodes[edit.target.node].meshes;
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const std::uint32_t source = scene.meshes[meshes[i]].material;
            const std::pair place{edit.target.node, i};
            const bool is_meant = edit.target.name == "*" || edit.target.name == material_name(scene, source);
            if (!is_meant || std::ranges::find(own, place) != own.end()) continue;
            if (next++ == material) return source;
            own.push_back(place);
        }
    }
    return material;
}

MaterialTarget target_of(const Scene& scene, std::uint32_t material, std::uint32_t node) {
    const std::string name = material_name(scene, material);
    return name.empty() ? target_in_object(scene, material, node) : MaterialTarget{.name = name};
}

MaterialTarget target_in_object(const Scene& scene, std::uint32_t material, std::uint32_t node) {
    const std::string name = material_name(scene, material);
    return {.name = name.empty() ? "*" : name, .node = node};
}

std::string title_of(const Scene& scene, const MaterialTarget& target) {
    if (target.node == no_index) return one_line(target.name, 40);
    const std::string object = object_title(scene, target.node);
    return target.name == "*" ? object : one_line(target.name, 40) + " of " + object;
}

std::string object_title(const Scene& scene, std::uint32_t node) {
    if (node >= scene.nodes.size() || scene.nodes[node].name.empty()) return "node " + std::to_string(node);
    return one_line(scene.nodes[node].name, 40);
}

std::vector<std::uint32_t> objects_with(const Scene& scene, std::uint32_t material) {
    std::vector<std::uint32_t> objects;
    const auto has_it = [&](std::uint32_t mesh) { return scene.meshes[mesh].material == material; };
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n)
        if (std::ranges::any_of(scene.nodes[n].meshes, has_it)) objects.push_back(n);
    return objects;
}

ObjectInWorld object_in_world(const Scene& scene, std::uint32_t node) {
    if (node >= scene.nodes.size()) throw Error(ErrorCode::usage, "there is no node " + std::to_string(node));
    const bool is_world = is_world_file(scene.source);
    const std::uint32_t root = is_world ? root_of(scene, node) : no_index;
    const auto is_in_part = [&](std::uint32_t n) { return !is_world || root_of(scene, n) == root; };
    const std::string& name = scene.nodes[node].name;
    std::size_t twins = 0;
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n)
        twins += scene.nodes[n].name == name && !scene.nodes[n].meshes.empty() && is_in_part(n);
    const bool is_told_by_name = twins == 1 && !name.empty() && !is_number(name) && one_line(name, 200) == name;
    return {is_world ? scene.nodes[root].name : std::string(),
            is_told_by_name ? name : std::to_string(is_world ? node - root - 1 : node)};
}

std::uint32_t same_object(const Scene& from, std::uint32_t node, const Scene& to) {
    if (node >= from.nodes.size()) return no_index;
    const ObjectInWorld object = object_in_world(from, node);
    const bool is_world = is_world_file(to.source);
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = 0; n < to.nodes.size(); ++n) {
        if (to.nodes[n].meshes.empty() || to.nodes[n].name != from.nodes[node].name) continue;
        const std::uint32_t root = is_world ? root_of(to, n) : 0;
        const bool is_there = !is_world || to.nodes[root].name == object.model;
        const bool is_meant = !is_number(object.object) ||  // by its name alone
                              std::to_string(is_world ? n - root - 1 : n) == object.object;
        if (is_there && is_meant) found.push_back(n);
    }
    return found.size() == 1 ? found[0] : no_index;
}

std::vector<std::string> carry_edits(std::vector<MaterialEdit>& edits, const Scene& from, const Scene& to) {
    std::vector<std::string> gone;
    std::vector<MaterialEdit> kept;
    for (MaterialEdit& edit : edits) {
        const std::string title = title_of(from, edit.target);
        const bool is_of_object = edit.target.node != no_index;
        if (is_of_object) edit.target.node = same_object(from, edit.target.node, to);
        if (is_of_object && edit.target.node == no_index)
            gone.push_back(title);
        else
            kept.push_back(std::move(edit));
    }
    edits = std::move(kept);
    return gone;
}

}  // namespace rakelight::viewer
