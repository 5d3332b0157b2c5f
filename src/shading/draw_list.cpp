// SPDX-License-Identifier: Apache-2.0
#include "shading/draw_list.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "math/linear.h"
#include "scene/materials/texture_uses.h"
#include "scene/placement.h"
#include "shading/choices.h"
#include "shading/posed_draw_list.h"
#include "shading/remarks/normal_map_remarks.h"

namespace rakelight::shading {
namespace {

void extend(Bounds& bounds, const Draw& draw) {
    const Bounds own{cast<double>(draw.low), cast<double>(draw.high)};
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 at = transform_point(draw.to_world, own.corner(corner));
        bounds.low = min(bounds.low, at);
        bounds.high = max(bounds.high, at);
    }
}

/// The box of each mesh; meshes that share their positions are measured once, those that have a pose each.
class BoxTable {
public:
    BoxTable(const std::vector<Mesh>& meshes, const geometry::MeshPoses& poses, Context& context)
        : meshes_(meshes), poses_(poses), context_(context), first_(meshes.size()) {
        std::vector<std::uint32_t> order(meshes.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto block = [&](std::uint32_t m) { return meshes[m].positions.identity(); };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return block(a) != block(b) ? std::less<>()(block(a), block(b)) : a < b;
        });
        for (std::size_t i = 0; i < order.size(); ++i)
            first_[order[i]] = i > 0 && block(order[i]) == block(order[i - 1]) ? first_[order[i - 1]] : order[i];
        boxes_.resize(meshes.size());
        is_known_.resize(meshes.size());
    }
    geometry::Box of(std::uint32_t mesh) {
        if (const auto pose = poses_.find(mesh); pose != poses_.end())
            return geometry::posed_box(pose->second, context_);
        const std::uint32_t first = first_[mesh];
        if (!is_known_[first]) {
            boxes_[first] = geometry::empty_box();
            geometry::extend_box(meshes_[first].positions, boxes_[first].low, boxes_[first].high);
        }
        is_known_[first] = true;
        return boxes_[first];
    }

private:
    const std::vector<Mesh>& meshes_;
    const geometry::MeshPoses& poses_;
    Context& context_;
    std::vector<std::uint32_t> first_;  ///< [meshes] the first one of the same positions
    std::vector<geometry::Box> boxes_;
    std::vector<bool> is_known_;
};

void add_draws(DrawList& list, const geometry::MeshPoses& poses, std::uint64_t placements, Context& context) {
    const Scene& scene = list.scene;
    BoxTable boxes(scene.meshes, poses, context);
    list.draws.reserve(placements);
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            if (mesh.indices.empty()) continue;
            Draw draw;
            draw.node = n;
            draw.mesh = m;
            draw.material = mesh.material == no_index ? std::uint32_t(scene.materials.size()) : mesh.material;
            draw.to_world = list.node_to_world[n] * translation(mesh.origin);
            draw.mirrored = determinant(upper_left(draw.to_world)) < 0;
            const geometry::Box box = boxes.of(m);
            draw.low = box.low, draw.high = box.high;
            if (!(draw.low.x <= draw.high.x)) continue;
            extend(list.bounds, draw);
            (mesh.topology == Topology::triangles ? list.draws : list.line_draws).push_back(draw);
        }
}

/// All materials of the scene and the default one, which meshes without a material have.
void add_materials(DrawList& list) {
    const std::size_t count = list.scene.materials.size();
    list.materials.resize(count + 1);
    for (std::size_t i = 0; i <= count; ++i) {
        DrawMaterial& out = list.materials[i];
        out.scene_material = i < count ? std::uint32_t(i) : no_index;
        const Material& m = list.scene_material(out);
        out.two_sided = is_two_sided(m);
        out.classical = m.model == MaterialModel::classical;
        out.factors = material_factors(m);
    }
    for (const Draw& draw : list.draws) list.materials[draw.material].is_drawn = true;
}

/// Alpha's other factors are divided out of the cutoff; that of vertices by its mean where something can be seen.
void find_texel_cutoffs(DrawList& list) {
    struct Sum {
        double alpha = 0, vertices = 0;
    };
    std::vector<Sum> sums(list.materials.size());
    std::vector<bool> seen(list.scene.meshes.size(), false);
    for (const Draw& draw : list.draws) {
        const MaterialFactors& m = list.material(draw).factors;
        if (!(m.alpha_cutoff > 0) || seen[draw.mesh]) continue;
        seen[draw.mesh] = true;
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        Sum& sum = sums[draw.material];
        if (mesh.colors.empty())
            sum.alpha += double(mesh.positions.size()), sum.vertices += double(mesh.positions.size());
        for (const vec4& color : mesh.colors)
            if (m.base_color[3] * color.w >= m.alpha_cutoff) sum.alpha += double(color.w), sum.vertices += 1;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const MaterialFactors& m = list.materials[i].factors;
        const double alpha = double(m.base_color[3]) * sums[i].alpha;
        const double cutoff = alpha > 0 ? double(m.alpha_cutoff) * sums[i].vertices / alpha : -1;
        if (cutoff <= 1) list.materials[i].texel_cutoff = float(cutoff);
    }
}

std::vector<TextureWish> wishes_of(const DrawList& list) {
    std::vector<TextureWish> wishes;
    for (const DrawMaterial& drawn : list.materials) {
        if (!drawn.is_drawn) continue;
        const Material& m = list.scene_material(drawn);
        for (const TextureRole* const role : roles_of(m))
            wishes.push_back({key_of(list, drawn, *role), role->number == role_normal || role->number == role_height,
                              role->number == role_emission});
    }
    return wishes;
}

/// Says which textures of the materials are there.
class TextureSearch {
public:
    TextureSearch(DrawList& list, const TextureCache& textures, Report& report)
        : list_(list), textures_(textures), report_(report), remarks_(list.scene, report) {}

    void run() {
        for (DrawMaterial& drawn : list_.materials) {
            if (!drawn.is_drawn) continue;
            const Material& m = list_.scene_material(drawn);
            if (m.model != MaterialModel::unlit && m.emission_texture && !find(drawn, texture_roles()[role_emission]))
                leave_out_emission(m, drawn);
            else
                look_for(m, drawn);
        }
    }

private:
    static constexpr std::uint32_t texcoord_sets = 2;

    /// Null: it could not be had, which has been said, or its coordinates are left out.
    const LoadedTexture* find(const DrawMaterial& drawn, const TextureRole& role) const {
        if (role.in(list_.scene_material(drawn)).texcoord_set >= texcoord_sets) return nullptr;
        return textures_.find(key_of(list_, drawn, role));
    }

    void leave_out_emission(Material m, DrawMaterial& drawn) {
        drop_emission(m, report_, list_.scene.source, m.name);
        std::fill(std::begin(drawn.factors.emission), std::end(drawn.factors.emission), 0.0f);
        look_for(m, drawn);
    }

    void look_for(const Material& m, DrawMaterial& drawn) {
        for (const TextureRole* const role : roles_of(m)) {
            const TextureUse& use = role->in(m);
            if (use.texcoord_set >= texcoord_sets) {
                report_.add(Remark::dropped, list_.scene.source, m.name,
                            "texture left out: only texture coordinate sets 0 and 1 are drawn");
                continue;
            }
            const LoadedTexture* const texture = find(drawn, *role);
            if (!texture) continue;
            if (role->number == role_normal) remarks_.look_at(m, use, *texture);
            if (role->number == role_height) remarks_.look_at_heights(m, use, *texture);
            drawn.maps.set(std::size_t(role->number));
        }
    }

    DrawList& list_;
    const TextureCache& textures_;
    Report& report_;
    NormalMapRemarks remarks_;
};

/// Meshes without the texture coordinates of their clearcoat's normal map get a material without that map, which would
/// tilt all of the coat by one of its texels.
void drop_coat_normals(DrawList& list) {
    std::map<std::uint32_t, std::uint32_t> without;  // by the material with it
    for (Draw& draw : list.draws) {
        const DrawMaterial& drawn = list.material(draw);
        if (!drawn.maps[role_clearcoat_normal]) continue;
        const TextureUse& use = texture_roles()[role_clearcoat_normal].in(list.scene_material(drawn));
        if (has_coordinates(list.scene.meshes[draw.mesh], use.texcoord_set)) continue;
        const auto [known, is_new] = without.try_emplace(draw.material, std::uint32_t(list.materials.size()));
        if (is_new) {
            DrawMaterial plain = drawn;
            plain.maps.reset(role_clearcoat_normal);
            list.materials.push_back(plain);
        }
        draw.material = known->second;
    }
}

/// Of each mesh where it is drawn first: a table for each of its places would cost more than it mends.
void find_normal_sides(DrawList& list, Context& context) {
    if (list.scene.normal_sides && list.scene.normal_sides->size() == list.scene.meshes.size()) {
        list.normal_sides = *list.scene.normal_sides;
        return;
    }
    std::vector<AttributeMesh> meshes;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> seen(list.scene.meshes.size(), false);
    for (const Draw& draw : list.draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        if (seen[draw.mesh] || mesh.normals.empty() || !list.material(draw).classical) continue;
        seen[draw.mesh] = true;
        numbers.push_back(draw.mesh);
        AttributeMesh& m = meshes.emplace_back();
        m.positions = mesh.positions;
        m.indices = mesh.indices;
        m.normals = mesh.normals;
        m.to_world = draw.to_world;
    }
    list.normal_sides.assign(list.scene.meshes.size(), {});
    if (meshes.empty()) return;
    std::vector<geometry::NormalSides> sides = geometry::find_normal_sides(meshes, context);
    for (std::size_t i = 0; i < numbers.size(); ++i) list.normal_sides[numbers[i]] = std::move(sides[i]);
}

}  // namespace

TextureKey key_of(const DrawList& list, const DrawMaterial& material, const TextureRole& role) {
    const Texture& texture = list.scene.textures[role.in(list.scene_material(material)).texture];
    const Sampler& s = texture.sampler;
    TextureKey key{texture.image, role.space, s.wrap_u, s.wrap_v};
    const bool holds_alpha = role.number == role_base_color || role.number == role_opacity;
    if (holds_alpha && material.texel_cutoff > 0 && s.mip != MipFilter::none)
        key.test = {material.texel_cutoff, role.number == role_opacity ? 0 : 3, s.minify == Filter::linear};
    return key;
}

const Material& DrawList::scene_material(const DrawMaterial& material) const {
    static const Material otherwise;
    return material.scene_material == no_index ? otherwise : scene.materials[material.scene_material];
}

DrawList make_draw_list(Scene scene, TextureCache& textures, const TexturePacker& packer, Context& context) {
    return make_draw_list(std::move(scene), {}, textures, packer, context);
}

DrawList make_draw_list(Scene given, const geometry::MeshPoses& poses, TextureCache& textures,
                        const TexturePacker& packer, Context& context) {
    DrawList list;
    list.scene = std::move(given);
    const Scene& scene = list.scene;
    std::uint64_t placements = 0;
    for (const Node& node : scene.nodes) placements += node.meshes.size();
    list.charge =
        MemoryCharge(context.memory(), scene.nodes.size() * sizeof(dmat4) + placements * sizeof(Draw), "what is drawn");
    list.node_to_world = world_matrices(scene);
    add_draws(list, poses, placements, context);
    add_materials(list);
    find_texel_cutoffs(list);
    textures.update(wishes_of(list), packer, context);
    TextureSearch(list, textures, context.report()).run();
    drop_coat_normals(list);
    find_normal_sides(list, context);
    for (const Draw& draw : list.draws)
        if (!scene.meshes[draw.mesh].colors.empty()) list.materials[draw.material].factors.vertex_colors = 1;
    return list;
}

}  // namespace rakelight::shading
