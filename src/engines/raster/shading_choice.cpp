// SPDX-License-Identifier: Apache-2.0
// How often lighting is evaluated on each draw: by the settings, by rules for objects and materials, or by the size of
// its triangles.
#include <algorithm>

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

/// [nodes] the last rule that fits, -1: none. A node's own name counts, and those of all it hangs from; parents come
/// first.
std::vector<std::ptrdiff_t> rules_of_nodes(const FrontEnd& front) {
    const std::vector<Node>& nodes = front.list.scene.nodes;
    std::vector<std::ptrdiff_t> rules(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const std::ptrdiff_t inherited = nodes[n].parent == none ? -1 : rules[nodes[n].parent];
        rules[n] = last_rule(front.settings, ShadingRule::Of::object, nodes[n].name, inherited);
    }
    return rules;
}

/// @param of_node  the last rule for the draw's object, -1: none
Shading wanted(const FrontEnd& front, const Draw& draw, std::ptrdiff_t of_node) {
    const std::uint32_t material = front.list.materials[draw.material].scene_material;
    const std::ptrdiff_t rule = material == none ? of_node
                                                 : last_rule(front.settings, ShadingRule::Of::material,
                                                             front.list.scene.materials[material].name, of_node);
    return rule < 0 ? front.settings.shading : front.settings.shading_rules[std::size_t(rule)].shading;
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
    const std::vector<ScreenVertex>& screen = front.screen[number];
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
    const Shading for_all = front.settings.shading;
    front.shading.assign(front.list.draws.size(), for_all);
    if (for_all != Shading::automatic && front.settings.shading_rules.empty()) return;
    const std::vector<std::ptrdiff_t> rules = rules_of_nodes(front);
    context.parallel_for(front.list.draws.size(), [&](std::size_t d) {
        const Draw& draw = front.list.draws[d];
        Shading shading = wanted(front, draw, rules[draw.node]);
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
