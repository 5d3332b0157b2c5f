// SPDX-License-Identifier: Apache-2.0
#include "shading/shading_choice.h"

#include <algorithm>

#include "shading/draw_choices.h"
#include "shading/edge_lengths.h"

namespace rakelight::shading {

/// The last of the rules that is for this name, if it comes after rule `known`; else that one.
std::ptrdiff_t ShadingChoice::last_rule(ShadingRule::Of of, const std::string& name, std::ptrdiff_t known) const {
    const std::vector<ShadingRule>& rules = settings_.shading_rules;
    for (auto r = std::ptrdiff_t(rules.size()) - 1; r > known; --r)
        if (rules[std::size_t(r)].of == of && rules[std::size_t(r)].name == name) return r;
    return known;
}

ShadingChoice::ShadingChoice(const Scene& scene, const RenderSettings& settings) : scene_(scene), settings_(settings) {
    if (is_all_alike()) return;
    nodes_.resize(scene.nodes.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {  // parents come first
        const Node& node = scene.nodes[n];
        const NodeChoice above = node.parent == no_index ? NodeChoice{} : nodes_[node.parent];
        nodes_[n] = {last_rule(ShadingRule::Of::object, node.name, above.rule),
                     node.shading ? node.shading : above.own};
    }
}

bool ShadingChoice::is_all_alike() const {
    const auto has_own = [](const auto& one) { return one.shading.has_value(); };
    return settings_.shading != Shading::automatic && settings_.shading_rules.empty() &&
           !(settings_.material_shading && (std::any_of(scene_.nodes.begin(), scene_.nodes.end(), has_own) ||
                                            std::any_of(scene_.materials.begin(), scene_.materials.end(), has_own)));
}

Shading ShadingChoice::of(std::uint32_t node, std::uint32_t material) const {
    if (nodes_.empty()) return settings_.shading;
    const NodeChoice& of_node = nodes_[node];
    const Material* const m = material == no_index ? nullptr : &scene_.materials[material];
    const std::ptrdiff_t rule = m ? last_rule(ShadingRule::Of::material, m->name, of_node.rule) : of_node.rule;
    if (rule >= 0) return settings_.shading_rules[std::size_t(rule)].shading;
    if (settings_.material_shading && m && m->shading) return *m->shading;
    return settings_.material_shading && of_node.own ? *of_node.own : settings_.shading;
}

namespace {

/// Gouraud shading has neither shadows, nor bumps, nor a roughness that changes from pixel to pixel, nor layers.
bool needs_pixels(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    const DrawMaterial& material = list.material(draw);
    return settings.shadows || material.maps[role_metallic_roughness] || has_layers(material.factors) ||
           bump_of(list, draw, settings) != Bump::none;
}

}  // namespace

std::set<std::uint32_t> measured_meshes(const DrawList& list, const RenderSettings& settings) {
    std::set<std::uint32_t> meshes;
    const ShadingChoice choice(list.scene, settings);
    if (choice.is_all_alike()) return meshes;
    for (const Draw& draw : list.draws)
        if (choice.of(draw.node, list.material(draw).scene_material) == Shading::automatic &&
            !needs_pixels(list, draw, settings))
            meshes.insert(draw.mesh);
    return meshes;
}

std::vector<Shading> choose_shading(const DrawList& list, const RenderSettings& settings, const PictureCamera& view,
                                    Context& context) {
    std::vector<Shading> out(list.draws.size(), settings.shading);
    const ShadingChoice choice(list.scene, settings);
    if (choice.is_all_alike()) return out;
    context.parallel_for(out.size(), [&](std::size_t d) {
        const Draw& draw = list.draws[d];
        out[d] = choice.of(draw.node, list.material(draw).scene_material);
        if (out[d] != Shading::automatic) return;
        const bool is_fine =
            !needs_pixels(list, draw, settings) && edges_are_within(list, draw, view, double(automatic_gouraud_px));
        out[d] = is_fine ? Shading::gouraud : Shading::phong;
    });
    return out;
}

}  // namespace rakelight::shading
