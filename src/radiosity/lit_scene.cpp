// SPDX-License-Identifier: Apache-2.0
#include "radiosity/lit_scene.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <rakelight/geometry/attributes.h>

#include "math/linear.h"
#include "prepare/refine/refined_mesh.h"
#include "prepare/repair/turn_triangles.h"
#include "prepare/split_vertices.h"
#include "scene/charge_arrays.h"

namespace rakelight::radiosity {
namespace {

/// Triangles of one side of a part with one kind of material.
struct Piece {
    std::uint32_t part = 0;
    Mesh mesh;
    std::vector<vec3> light;   ///< [triangles]
    std::vector<vec3> factor;  ///< [triangles] factor of the light besides base color and its texture
    bool is_painted = true;    ///< multiply by the mesh's own vertex colors
    vec3 emission;             ///< added to it
};

/// [V] of each vertex the mean over its triangles.
std::vector<vec3> at_vertices(const Mesh& mesh, const std::vector<vec3>& of_triangles) {
    std::vector<vec3> out(mesh.positions.size());
    std::vector<float> count(mesh.positions.size(), 0);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const std::uint32_t v = mesh.indices[c];
        out[v] = out[v] + of_triangles[c / 3];
        ++count[v];
    }
    for (std::size_t v = 0; v < out.size(); ++v)
        if (count[v] > 0) out[v] = out[v] / count[v];
    return out;
}

/// Emission replaces the base color.
bool emits(const Material& m) { return !(m.emission == vec3{}); }

Mesh front_of(const Scene& scene, const Part& part, const geometry::FineMesh& fine) {
    Mesh coarse = scene.meshes[part.instance.mesh];
    coarse.smoothing = {};
    coarse.tangents = {};
    coarse.shape.reset();
    Mesh mesh = refined_mesh(coarse, fine);
    std::vector<vec3> normals(mesh.normals.begin(), mesh.normals.end());
    for (vec3& n : normals) n = normalize_or(n, vec3{0, 0, 1});
    mesh.normals = std::move(normals);
    return mesh;
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
        for (std::size_t i = 0; i < is_lit_.size(); ++i) {
            Material& m = scene_.materials[i];
            if (is_lit_[i]) m = unlit(m, shown_ == LitColors::radiance && emits(m) && !m.emission_texture);
        }
        std::ranges::move(emitting_, std::back_inserter(scene_.materials));
        return static_scene(std::move(scene_));
    }

private:
    void add_pieces(std::uint32_t part, Mesh front) {
        const std::uint32_t begin = elements_.base[part];
        const auto count = std::uint32_t(front.indices.size() / 3);
        if (parts_[part].is_two_sided && shown_ == LitColors::radiance) {
            add_piece(part, front, begin);
            add_piece(part, back_side(std::move(front)), begin + count);
        } else {
            add_piece(part, std::move(front), begin);
        }
    }

    /// @param begin  the side's first element
    void add_piece(std::uint32_t part, Mesh mesh, std::uint32_t begin) {
        const Material& material = scene_.materials[parts_[part].material];
        const bool is_light = shown_ == LitColors::irradiance;
        Piece reflecting{.part = part, .is_painted = !is_light},
            emitting{.part = part, .is_painted = false, .emission = material.emission};
        std::vector<std::uint32_t> reflects, sends;
        for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
            const std::uint32_t* const corner = mesh.indices.data() + 3 * std::size_t(t);
            const Element& e = elements_.list[begin + t];
            const bool is_emitting =
                !is_light && emits(material) && !(material.emission_texture && e.emission == dvec3{});
            std::vector<std::uint32_t>& indices = is_emitting ? sends : reflects;
            indices.insert(indices.end(), corner, corner + 3);
            Piece& piece = is_emitting ? emitting : reflecting;
            piece.light.push_back(cast<float>(light_[begin + t]));
            const auto share = is_light ? 1.0f : float(colors_.diffuse_share(material, mesh, corner));
            piece.factor.push_back(!is_emitting                ? vec3{share, share, share}
                                   : material.emission_texture ? vec3{}
                                                               : cast<float>(e.albedo));
        }
        const bool is_mixed = !reflects.empty() && !sends.empty();
        for (auto [piece, indices] : {std::pair{&reflecting, &reflects}, std::pair{&emitting, &sends}}) {
            if (indices->empty()) continue;
            piece->mesh = mesh;
            if (is_mixed) piece->mesh.indices = std::move(*indices);
            if (piece == &emitting && material.emission_texture)
                piece->mesh.material = emitting_copy(parts_[part].material);
            pieces_.push_back(std::move(*piece));
        }
    }

    /// Index of the material that shows the emission texture of another one.
    std::uint32_t emitting_copy(std::uint32_t material) {
        const auto [entry, is_new] =
            emitting_copies_.try_emplace(material, std::uint32_t(scene_.materials.size() + emitting_.size()));
        if (is_new) emitting_.push_back(unlit(scene_.materials[material], true));
        return entry->second;
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

    static std::vector<vec4> colors_of(const Piece& piece, const std::vector<vec3>& light) {
        const Block<vec4>& own = piece.mesh.colors;
        const std::vector<vec3> factor = at_vertices(piece.mesh, piece.factor);
        std::vector<vec4> out;
        out.reserve(light.size());
        for (std::size_t v = 0; v < light.size(); ++v) {
            const vec4 paint = own.empty() ? vec4{1, 1, 1, 1} : own[v];
            vec3 color = light[v] * factor[v] + piece.emission;
            if (piece.is_painted) color = color * paint.xyz();
            out.push_back({color.x, color.y, color.z, paint.w});
        }
        return out;
    }

    /// The first piece replaces the mesh, others become new meshes.
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

    /// @param as_emitter white with all light in vertex colors, or with the emission texture
    Material unlit(const Material& m, bool as_emitter) const {
        Material out;
        out.name = m.name;
        out.model = MaterialModel::unlit;
        out.base_color = m.base_color, out.base_color_texture = m.base_color_texture;
        out.opacity_texture = m.opacity_texture;
        out.alpha_mode = m.alpha_mode, out.alpha_cutoff = m.alpha_cutoff;
        if (shown_ == LitColors::irradiance || as_emitter) out.base_color = {1, 1, 1, m.base_color.w};
        if (as_emitter) out.base_color_texture = m.emission_texture;
        if (shown_ == LitColors::irradiance) out.base_color_texture = {};
        return out;
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
    std::map<std::uint32_t, std::uint32_t> emitting_copies_;  ///< by material
    std::vector<Material> emitting_;                          ///< beyond those of the scene
};

}  // namespace

Scene lit_scene(Scene scene, const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                const Elements& elements, const std::vector<dvec3>& light, const ColorMaps& colors, LitColors shown,
                Context& context) {
    return LitScene(std::move(scene), parts, meshes, elements, light, colors, shown, context).run();
}

Scene static_scene(Scene scene) {
    scene.lights.clear();
    if (scene.environment) scene.environment->is_light = false;
    for (std::size_t i = 0; scene.pose && i < scene.nodes.size(); ++i) scene.nodes[i].local = scene.pose->local[i];
    scene.pose = {};
    for (Node& node : scene.nodes) node.skin = no_index, node.morph_weights = {};
    scene.skins.clear(), scene.animations.clear();
    scene.normal_sides.reset();
    return scene;
}

}  // namespace rakelight::radiosity
