// SPDX-License-Identifier: Apache-2.0
#include "radiosity/lit_scene.h"

#include <rakelight/attributes.h>

#include "math/linear.h"
#include "prepare/back_side.h"
#include "prepare/refined_mesh.h"
#include "prepare/split_vertices.h"
#include "radiosity/still_scene.h"
#include "scene/charge_arrays.h"

namespace rakelight::radiosity {
namespace {

/// One side of a part.
struct Piece {
    std::uint32_t part = 0;
    Mesh mesh;
    std::vector<vec3> light;  ///< [triangles]
    vec3 albedo, emission;    ///< means over the part
    double diffuse_share = 1;
};

Mesh front_of(const Scene& scene, const Part& part, const geometry::FineMesh& fine) {
    Mesh coarse = scene.meshes[part.instance.mesh];
    coarse.smoothing = {};
    coarse.tangents = {};
    coarse.shape.reset();
    return refined_mesh(coarse, fine);
}

class LitScene {
public:
    LitScene(Scene scene, const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
             const Elements& elements, const std::vector<dvec3>& light, const ColorMaps& colors, LitColors shown,
             Context& context)
        : scene_(std::move(scene)),
          parts_(parts),
          elements_(elements),
          light_(light),
          colors_(colors),
          shown_(shown),
          context_(context) {
        for (std::uint32_t i = 0; i < parts.size(); ++i) add_pieces(i, front_of(scene_, parts[i], meshes[i]));
    }

    Scene run() {
        color_vertices();
        place();
        for (const Part& part : parts_) is_lit_.resize(scene_.materials.size()), is_lit_[part.material] = true;
        for (std::size_t i = 0; i < is_lit_.size(); ++i)
            if (is_lit_[i]) set_unlit(scene_.materials[i]);
        return still_scene(std::move(scene_));
    }

private:
    void add_pieces(std::uint32_t part, Mesh front) {
        const std::uint32_t begin = elements_.base[part];
        const auto count = std::uint32_t(front.indices.size() / 3);
        if (parts_[part].is_two_sided && shown_ == LitColors::leaving) {
            add_piece(part, front, begin);
            add_piece(part, back_side(std::move(front)), begin + count);
        } else {
            add_piece(part, std::move(front), begin);
        }
    }

    void add_piece(std::uint32_t part, Mesh mesh, std::uint32_t begin) {
        Piece piece{.part = part};
        dvec3 albedo{}, emission{};
        double share = 0, area = 0;
        const Material& material = scene_.materials[parts_[part].material];
        for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
            const Element& e = elements_.list[begin + t];
            piece.light.push_back(cast<float>(light_[begin + t]));
            albedo += e.albedo * e.area, emission += e.emission * e.area, area += e.area;
            share += e.area * colors_.diffuse_share(material, mesh, mesh.indices.data() + 3 * std::size_t(t));
        }
        if (area > 0) {
            piece.albedo = cast<float>(albedo / area), piece.emission = cast<float>(emission / area);
            piece.diffuse_share = share / area;
        }
        piece.mesh = std::move(mesh);
        pieces_.push_back(std::move(piece));
    }

    void color_vertices() {
        std::vector<AttributeMesh> meshes;
        std::vector<std::span<const vec3>> values;
        for (const Piece& piece : pieces_) {
            const Part& part = parts_[piece.part];
            meshes.push_back({.object = part.instance.node,
                              .positions = piece.mesh.positions,
                              .indices = piece.mesh.indices,
                              .to_world = part.to_world,
                              .position_step = piece.mesh.position_step});
            values.push_back(piece.light);
        }
        AttributeOptions options;
        options.tangents = false;
        const AttributePlan plan = group(meshes, options, context_);
        std::vector<MeshAttributes> vertices = accumulate(plan, meshes, context_);
        const std::vector<std::vector<vec3>> light = average(plan, meshes, values, context_);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            split_vertices(pieces_[i].mesh, std::move(vertices[i].indices), vertices[i].source_vertex, context_);
            pieces_[i].mesh.colors = colors_of(pieces_[i], light[i]);
        }
    }

    std::vector<vec4> colors_of(const Piece& piece, const std::vector<vec3>& light) const {
        const Material& material = scene_.materials[parts_[piece.part].material];
        const Block<vec4>& own = piece.mesh.colors;
        const bool emits = !(material.emission == vec3{});
        const auto share = float(piece.diffuse_share);
        std::vector<vec4> out;
        out.reserve(light.size());
        for (std::size_t v = 0; v < light.size(); ++v) {
            const vec4 paint = own.empty() ? vec4{1, 1, 1, 1} : own[v];
            vec3 color = light[v] * paint.xyz() * share;
            if (shown_ == LitColors::arriving)
                color = light[v];
            else if (emits)
                color = material.emission_texture ? material.emission : light[v] * piece.albedo + material.emission;
            out.push_back({color.x, color.y, color.z, paint.w});
        }
        return out;
    }

    /// The first piece of a mesh takes its place, others get one of their own.
    void place() {
        AddedMeshes added(scene_, context_);
        std::vector<bool> is_taken(scene_.meshes.size(), false);
        std::uint32_t last = no_index;
        for (Piece& piece : pieces_) {
            const Instance& at = parts_[piece.part].instance;
            charge_new_arrays(piece.mesh, scene_.meshes[at.mesh], context_);
            std::uint32_t number = at.mesh;
            if (is_taken[at.mesh])
                number = added.add(std::move(piece.mesh));
            else
                scene_.meshes[at.mesh] = std::move(piece.mesh), is_taken[at.mesh] = true;
            if (piece.part == last)
                scene_.nodes[at.node].meshes.push_back(number);
            else
                scene_.nodes[at.node].meshes[at.slot] = number;
            last = piece.part;
        }
    }

    void set_unlit(Material& m) const {
        Material out;
        out.name = m.name;
        out.model = MaterialModel::unlit;
        out.base_color = m.base_color, out.base_color_texture = m.base_color_texture;
        out.opacity_texture = m.opacity_texture;
        out.alpha_mode = m.alpha_mode, out.alpha_cutoff = m.alpha_cutoff;
        if (!(m.emission == vec3{})) {
            out.base_color = {1, 1, 1, m.base_color.w};
            out.base_color_texture = m.emission_texture;
        }
        if (shown_ == LitColors::arriving) out.base_color = {1, 1, 1, 1}, out.base_color_texture = {};
        m = std::move(out);
    }

    Scene scene_;
    const std::vector<Part>& parts_;
    const Elements& elements_;
    const std::vector<dvec3>& light_;
    const ColorMaps& colors_;
    const LitColors shown_;
    Context& context_;
    std::vector<Piece> pieces_;
    std::vector<bool> is_lit_;
};

}  // namespace

Scene lit_scene(Scene scene, const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                const Elements& elements, const std::vector<dvec3>& light, const ColorMaps& colors, LitColors shown,
                Context& context) {
    return LitScene(std::move(scene), parts, meshes, elements, light, colors, shown, context).run();
}

}  // namespace rakelight::radiosity
