// SPDX-License-Identifier: Apache-2.0
#include "shading/shading_choice.h"

#include <algorithm>

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
        const NodeChoice above = node.parent == none ? NodeChoice{} : nodes_[node.parent];
        nodes_[n] = {last_rule(ShadingRule::Of::object, node.name, above.rule),
                     node.shading ? node.shading : above.own};
    }
}

bool ShadingChoice::is_all_alike() const {
    const auto has_own = [](const auto& one) { return one.shading.has_value(); };
    return settings_.shading != Shading::automatic && settings_.shading_rules.empty() &&
           !(settings_.own_shading && (std::any_of(scene_.nodes.begin(), scene_.nodes.end(), has_own) ||
                                       std::any_of(scene_.materials.begin(), scene_.materials.end(), has_own)));
}

Shading ShadingChoice::of(std::uint32_t node, std::uint32_t material) const {
    if (nodes_.empty()) return settings_.shading;
    const NodeChoice& of_node = nodes_[node];
    const Material* const m = material == none ? nullptr : &scene_.materials[material];
    const std::ptrdiff_t rule = m ? last_rule(ShadingRule::Of::material, m->name, of_node.rule) : of_node.rule;
    if (rule >= 0) return settings_.shading_rules[std::size_t(rule)].shading;
    if (settings_.own_shading && m && m->shading) return *m->shading;
    return settings_.own_shading && of_node.own ? *of_node.own : settings_.shading;
}

}  // namespace rakelight::shading
