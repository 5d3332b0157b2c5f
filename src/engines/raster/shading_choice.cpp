// SPDX-License-Identifier: Apache-2.0
// How often lighting is evaluated on each draw: by the settings, by rules for objects and materials, by what the scene
// says of them, or by the size of its triangles.
#include <algorithm>
#include <optional>

#include "engines/raster/full_jobs.h"
#include "engines/raster/light_points.h"

namespace rakelight::raster {
namespace {

/// The last of the rules that is for this name, if it comes after rule `known`; else that one.
std::ptrdiff_t last_rule(const RenderSettings& settings, ShadingRule::Of of, const std::string& name,
                         std::ptrdiff_t known) {
    const std::vector<ShadingRule>& rules = settings.shading_rules;
    for (auto r = std::ptrdiff_t(rules.size()) - 1; r > known; --r)
        if (rules[std::size_t(r)].of == of && rules[std::size_t(r)].name == name) return r;
    return known;
}

/// What nodes are to be shaded like, with all that hangs from them.
struct NodeChoice {
    std::ptrdiff_t rule = -1;    ///< the last that fits its name or one of those that it hangs from; -1: none
    std::optional<Shading> own;  ///< its own, else that of the nearest node above that has one
};

/// [nodes] Parents come first.
std::vector<NodeChoice> choices_of_nodes(const FrontEnd& front) {
    const std::vector<Node>& nodes = front.list.scene.nodes;
    std::vector<NodeChoice> choices(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const NodeChoice above = nodes[n].parent == none ? NodeChoice{} : choices[nodes[n].parent];
        choices[n] = {last_rule(front.settings, ShadingRule::Of::object, nodes[n].name, above.rule),
                      nodes[n].shading ? nodes[n].shading : above.own};
    }
    return choices;
}

Shading wanted(const FrontEnd& front, const Draw& draw, const NodeChoice& of_node) {
    const RenderSettings& s = front.settings;
    const std::uint32_t number = front.list.materials[draw.material].scene_material;
    const Material* const material = number == none ? nullptr : &front.list.scene.materials[number];
    const std::ptrdiff_t rule =
        material ? last_rule(s, ShadingRule::Of::material, material->name, of_node.rule) : of_node.rule;
    if (rule >= 0) return s.shading_rules[std::size_t(rule)].shading;
    if (s.own_shading && material && material->shading) return *material->shading;
    return s.own_shading && of_node.own ? *of_node.own : s.shading;
}

/// Whether what the settings say of the whole is what all of it is shaded like.
bool is_all_alike(const FrontEnd& front) {
    const auto has_own = [](const auto& one) { return one.shading.has_value(); };
    const Scene& scene = front.list.scene;
    return front.settings.shading != Shading::automatic && front.settings.shading_rules.empty() &&
           !(front.settings.own_shading && (std::any_of(scene.nodes.begin(), scene.nodes.end(), has_own) ||
                                            std::any_of(scene.materials.begin(), scene.materials.end(), has_own)));
}

/// Gouraud shading has neither shadows, nor bumps, nor a roughness that changes from pixel to
/// pixel, nor layers.
bool needs_pixels(const FrontEnd& front, std::uint32_t draw) {
    const MaterialView& m = front.list.materials[front.list.draws[draw].material].view;
    return front.settings.shadows || m.metallic_roughness_map.view || has_layers(m) ||
           bump_of(front, draw) != Bump::none;
}

/// Whether no edge of a triangle that the whole picture (not only its window) may show is longer than this.
bool edges_are_within(const FrontEnd& front, std::uint32_t number, double pixels) {
    const ScreenVertices screen = front.screen[number];
    const Block<std::uint32_t>& indices = front.list.scene.meshes[front.list.draws[number].mesh].indices;
    constexpr std::uint32_t all_codes = (1u << outcode_bits) - 1;
    const double limit = pixels * (1 << subpixel_bits), square = limit * limit;
    const auto is_long = [square](const ScreenVertex& a, const ScreenVertex& b) {
        const double dx = double(a.x) - double(b.x), dy = double(a.y) - double(b.y);
        return dx * dx + dy * dy > square;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const ScreenVertex &a = screen[indices[i]], &b = screen[indices[i + 1]], &c = screen[indices[i + 2]];
        if ((a.bits & b.bits & c.bits & all_codes) != 0) continue;  // outside of one plane
        const std::uint32_t any = (a.bits | b.bits | c.bits) & all_codes;
        if ((any & cutting_planes) != 0 || is_long(a, b) || is_long(b, c) || is_long(c, a)) return false;
    }
    return true;
}

}  // namespace

void choose_shading(FrontEnd& front, Context& context) {
    front.shading.assign(front.list.draws.size(), front.settings.shading);
    if (is_all_alike(front)) return;
    const std::vector<NodeChoice> choices = choices_of_nodes(front);
    context.parallel_for(front.list.draws.size(), [&](std::size_t d) {
        const Draw& draw = front.list.draws[d];
        Shading shading = wanted(front, draw, choices[draw.node]);
        if (shading == Shading::automatic) {
            const bool is_fine = !front.clip[d].empty() && !needs_pixels(front, std::uint32_t(d)) &&
                                 edges_are_within(front, std::uint32_t(d), automatic_gouraud_px);
            shading = is_fine ? Shading::gouraud : Shading::phong;
        }
        front.shading[d] = shading;
    });
}

bool is_lit_at_corners(const FrontEnd& front, std::uint32_t draw) {
    return front.shading[draw] == Shading::flat || front.shading[draw] == Shading::gouraud;
}

}  // namespace rakelight::raster
