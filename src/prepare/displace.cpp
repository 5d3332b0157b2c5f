// SPDX-License-Identifier: Apache-2.0
#include "prepare/displace.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "geometry/place_classes.h"
#include "geometry/tessellate.h"
#include "math/functions.h"
#include "math/linear.h"
#include "prepare/height_field.h"
#include "prepare/variants.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

const Material* displaced_material(const Scene& scene, const Mesh& mesh, const Displacement& options) {
    if (mesh.material == none) return nullptr;
    const Material& m = scene.materials[mesh.material];
    const bool is_wanted = m.bump == Bump::automatic ? options.is_on : m.bump == Bump::displacement;
    const std::uint32_t set = m.height_texture.texcoord_set;
    const bool has_map = m.height_texture && set < mesh.texcoords.size() && !mesh.texcoords[set].empty();
    return is_wanted && has_map ? &m : nullptr;
}

/// A placement of a mesh, and what is made of it.
struct Part {
    Instance instance;
    dmat4 to_world, to_object;           ///< with the mesh's origin
    const Material* material = nullptr;  ///< null: not displaced
    std::shared_ptr<const HeightField> heights;
    double depth = 0, level = 0;  ///< [m] from the lowest to the highest point; height 0..1 that stays where it is
    std::vector<float> offset;    ///< [V'] m
};

dmat3 normal_matrix(const dmat4& to_world) {
    const dmat3 linear = upper_left(to_world), c = cofactor(linear);
    const double sign = determinant(linear) < 0 ? -1 : 1;
    return {{c[0] * sign, c[1] * sign, c[2] * sign}};
}

/// [m] that 1 in texture coordinates is long, by the areas of all triangles here and there; 0: none has any there.
double texture_width(const Mesh& mesh, const Part& part) {
    const Block<vec2>& uv = mesh.texcoords[part.material->height_texture.texcoord_set];
    double area = 0, texture_area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return transform_point(part.to_world, cast<double>(mesh.positions[mesh.indices[i + k]]));
        };
        const vec2 a = uv[mesh.indices[i]], b = uv[mesh.indices[i + 1]], c = uv[mesh.indices[i + 2]];
        area += length(cross(at(1) - at(0), at(2) - at(0)));
        texture_area += std::abs(double(b.x - a.x) * double(c.y - a.y) - double(c.x - a.x) * double(b.y - a.y));
    }
    return texture_area > 0 ? std::sqrt(area / texture_area) : 0;
}

/// What of an attribute the middle of an edge has.
template <class T>
T halfway(T a, T b) {
    return (a + b) * 0.5f;
}
vec4 halfway_tangent(vec4 a, vec4 b) { return {(a.x + b.x) * 0.5f, (a.y + b.y) * 0.5f, (a.z + b.z) * 0.5f, a.w}; }

template <class T, class Half>
Block<T> refined(const Block<T>& from, const geometry::FineMesh& fine, const Half& half) {
    if (from.empty()) return {};
    std::vector<T> out(from.begin(), from.end());
    out.reserve(fine.places.size());
    for (const auto& [a, b] : fine.middle_of) out.push_back(half(out[a], out[b]));
    return out;
}

Mesh refined_mesh(const Mesh& coarse, const geometry::FineMesh& fine) {
    Mesh mesh = coarse;
    mesh.positions = refined(coarse.positions, fine, halfway<vec3>);
    mesh.normals = refined(coarse.normals, fine, halfway<vec3>);
    mesh.tangents = refined(coarse.tangents, fine, halfway_tangent);
    for (Block<vec2>& set : mesh.texcoords) set = refined(set, fine, [](vec2 a, vec2 b) { return (a + b) * 0.5f; });
    mesh.colors = refined(coarse.colors, fine, halfway<vec4>);
    if (!coarse.smoothing.empty()) {
        std::vector<std::uint32_t> groups;
        for (const std::uint32_t t : fine.source_triangle) groups.push_back(coarse.smoothing[t]);
        mesh.smoothing = std::move(groups);
    }
    mesh.indices = fine.indices;
    mesh.smoothing_hint = {};
    mesh.polygons = {};
    mesh.influences = {};
    mesh.targets.clear();
    return mesh;
}

bool same_shape(const Mesh& a, const Mesh& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x == y || std::equal(x.begin(), x.end(), y.begin(), y.end());
    };
    return same(a.indices, b.indices) && same(a.positions, b.positions);
}

/// All that one displacement of a scene goes through, stage by stage.
class Displacer {
public:
    Displacer(const Scene& scene, const Displacement& options, Context& context)
        : scene_(scene), options_(options), context_(context), out_(scene) {}

    Scene run() {
        collect_parts();
        if (std::none_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.material != nullptr; }))
            return scene_;
        cut();
        refine();
        collect_classes();
        move();
        place();
        return std::move(out_);
    }

private:
    bool is_changed(std::size_t i) const { return parts_[i].material != nullptr || !fine_.meshes[i].middle_of.empty(); }

    void collect_parts() {
        HeightFields fields(scene_, context_);
        const std::vector<dmat4> to_world = world_matrices(scene_);
        for (const Instance& instance : drawn_instances(scene_)) {
            const Mesh& mesh = scene_.meshes[instance.mesh];
            Part part{.instance = instance, .to_world = to_world[instance.node] * translation(mesh.origin)};
            part.material = displaced_material(scene_, mesh, options_);
            if (part.material && !inverse_affine(part.to_world, part.to_object)) part.material = nullptr;
            if (part.material) part.heights = fields.of(part.material->height_texture);
            if (!part.heights) part.material = nullptr;
            if (part.material) set_depth(mesh, part);
            if (!part.material && !inverse_affine(part.to_world, part.to_object)) continue;  // flat: no border to cut
            parts_.push_back(std::move(part));
        }
    }

    void set_depth(const Mesh& mesh, Part& part) {
        const Relief& relief = part.material->relief ? *part.material->relief : options_.relief;
        part.depth = double(relief.depth) * double(part.material->height_scale) * texture_width(mesh, part);
        part.level = 1 - double(relief.bias);
    }

    void cut() {
        std::vector<AttributeMesh> meshes;
        for (const Part& p : parts_) {
            const Mesh& mesh = scene_.meshes[p.instance.mesh];
            meshes.push_back({.object = p.instance.node,
                              .positions = mesh.positions,
                              .indices = mesh.indices,
                              .to_world = p.to_world,
                              .position_step = mesh.position_step});
        }
        const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context_);
        std::vector<std::uint8_t> moves(placed.place.size(), 0);  // some displaced mesh has a vertex at the place
        for (std::uint32_t v = 0; v < placed.place.size(); ++v)
            if (parts_[placed.input.mesh_of_vertex(v)].material) moves[placed.place[v]] = 1;
        std::vector<geometry::CoarseMesh> coarse(parts_.size());
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Mesh& mesh = scene_.meshes[parts_[i].instance.mesh];
            coarse[i].indices.assign(mesh.indices.begin(), mesh.indices.end());
            for (std::uint32_t v = placed.input.vertex_base[i]; v < placed.input.vertex_base[i + 1]; ++v) {
                const dvec3 p = placed.position(placed.place[v]);
                coarse[i].places.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});  // -0 becomes 0
                if (!parts_[i].material) coarse[i].on_border.push_back(moves[placed.place[v]]);
            }
        }
        const double diagonal = world_bounds(scene_).diagonal();
        edge_ = options_.edge > 0 ? options_.edge : diagonal / 250;
        if (!(edge_ > 0)) edge_ = 1;
        context_.memory().check(std::min<std::uint64_t>(options_.most_triangles, std::uint64_t(1) << 32) * 96,
                                "displaced triangles");
        fine_ = geometry::tessellate(coarse, edge_, options_.most_triangles, context_);
        if (fine_.is_complete) return;
        char text[160];
        std::snprintf(text, sizeof text,
                      "displacement stops at %llu triangles: edges are up to %.3g m long, not %.3g m",
                      static_cast<unsigned long long>(options_.most_triangles), fine_.longest_edge, edge_);
        context_.report().add(Remark::warning, scene_.source, {}, text);
    }

    void refine() {
        meshes_.resize(parts_.size());
        context_.parallel_for(parts_.size(), [&](std::size_t i) {
            const Mesh& mesh = scene_.meshes[parts_[i].instance.mesh];
            meshes_[i] = is_changed(i) ? refined_mesh(mesh, fine_.meshes[i]) : mesh;
            if (parts_[i].material) read_heights(i);
        });
    }

    void read_heights(std::size_t i) {
        Part& part = parts_[i];
        const Relief& relief = part.material->relief ? *part.material->relief : options_.relief;
        const Block<vec2>& uv = meshes_[i].texcoords[part.material->height_texture.texcoord_set];
        const double width = texture_width(scene_.meshes[part.instance.mesh], part);
        const double texels = width > 0 ? edge_ / width * part.heights->width() : 1;
        const int level = std::max(int(std::floor(math::log2(std::max(texels, 1.0)))), 0);
        part.offset.reserve(uv.size());
        for (const vec2 at : uv) {
            const double value = double(part.heights->at(at, level)), height = relief.holds_depth ? 1 - value : value;
            part.offset.push_back(float(part.depth * (height - part.level)));
        }
    }

    /// Vertices at one place, one after another, in the order of parts and vertices.
    void collect_classes() {
        for (std::uint32_t i = 0; i < parts_.size(); ++i)
            for (std::uint32_t v = 0; v < fine_.meshes[i].places.size(); ++v)
                members_.push_back({fine_.meshes[i].places[v], i, v});
        std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
            return std::tie(a.place.x, a.place.y, a.place.z, a.part, a.vertex) <
                   std::tie(b.place.x, b.place.y, b.place.z, b.part, b.vertex);
        });
    }

    void move() {
        std::vector<std::vector<vec3>> positions;
        for (const Mesh& mesh : meshes_) positions.emplace_back(mesh.positions.begin(), mesh.positions.end());
        for (std::size_t first = 0; first < members_.size();) {
            std::size_t end = first + 1;
            while (end < members_.size() && members_[end].place == members_[first].place) ++end;
            move_class(std::span(members_).subspan(first, end - first), positions);
            first = end;
        }
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (!is_changed(i)) continue;
            meshes_[i].positions = std::move(positions[i]);
            meshes_[i].normals = {};
            meshes_[i].tangents = {};
        }
    }

    /// The first placement of a mesh takes its place, others that came out differently get one of their own.
    void place() {
        std::vector<std::vector<std::uint32_t>> made(scene_.meshes.size());
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Instance& instance = parts_[i].instance;
            std::vector<std::uint32_t>& numbers = made[instance.mesh];
            const auto is_same = [&](std::uint32_t n) { return same_shape(out_.meshes[n], meshes_[i]); };
            auto at = std::find_if(numbers.begin(), numbers.end(), is_same);
            if (at == numbers.end()) {
                const bool is_first = numbers.empty();
                at = numbers.insert(at, is_first ? instance.mesh : std::uint32_t(out_.meshes.size()));
                if (is_first)
                    out_.meshes[instance.mesh] = std::move(meshes_[i]);
                else
                    out_.meshes.push_back(std::move(meshes_[i]));
            }
            out_.nodes[instance.node].meshes[instance.slot] = *at;
        }
    }

    struct Member {
        dvec3 place;
        std::uint32_t part, vertex;
    };

    void move_class(std::span<const Member> members, std::vector<std::vector<vec3>>& positions) {
        dvec3 normal{};
        double offset = 0;
        bool stays = false;
        for (const Member& m : members) {
            const Part& part = parts_[m.part];
            stays |= part.material == nullptr;
            if (stays) break;
            const dvec3 n = normal_matrix(part.to_world) * cast<double>(meshes_[m.part].normals[m.vertex]);
            normal = normal + normalize_or(n, {0, 0, 0});
            offset += double(part.offset[m.vertex]);
        }
        const dvec3 way = stays ? dvec3{} : normalize_or(normal, {0, 0, 0}) * (offset / double(members.size()));
        for (const Member& m : members) {
            const bool is_new = m.vertex >= scene_.meshes[parts_[m.part].instance.mesh].positions.size();
            if (stays && !is_new) continue;  // to the bit where it was
            positions[m.part][m.vertex] = cast<float>(transform_point(parts_[m.part].to_object, m.place + way));
        }
    }

    const Scene& scene_;
    const Displacement& options_;
    Context& context_;
    Scene out_;
    std::vector<Part> parts_;
    double edge_ = 0;
    geometry::Tessellation fine_;
    std::vector<Mesh> meshes_;
    std::vector<Member> members_;
};

}  // namespace

bool wants_displacement(const Scene& scene, const Displacement& options) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
        return mesh.topology == Topology::triangles && displaced_material(scene, mesh, options);
    });
}

Scene displace_scene(const Scene& scene, const Displacement& options, Context& context) {
    return Displacer(scene, options, context).run();
}

}  // namespace rakelight
