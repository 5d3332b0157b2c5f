// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/displace.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <tuple>

#include "base/cancel_check.h"
#include "geometry/refine/tessellate.h"
#include "math/functions.h"
#include "math/linear.h"
#include "prepare/refine/displace_parts.h"
#include "prepare/refine/refined_mesh.h"
#include "scene/charge_arrays.h"
#include "scene/drawn_vertices.h"

namespace rakelight {
namespace {

dmat3 normal_matrix(const dmat4& to_world) {
    const dmat3 linear = upper_left(to_world), c = cofactor(linear);
    const double sign = determinant(linear) < 0 ? -1 : 1;
    return {{c[0] * sign, c[1] * sign, c[2] * sign}};
}

bool same_shape(const Mesh& a, const Mesh& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x == y || std::equal(x.begin(), x.end(), y.begin(), y.end());
    };
    return same(a.indices, b.indices) && same(a.positions, b.positions);
}

/// The stages of displacing a scene.
class Displacer {
public:
    Displacer(Scene scene, const Displacement& options, Context& context)
        : scene_(std::move(scene)),
          options_(options),
          context_(context),
          parts_(collect_parts(scene_, options, context)) {}

    /// Once.
    Scene run() {
        if (std::none_of(parts_.begin(), parts_.end(), [](const DisplacedPart& p) { return p.material != nullptr; }))
            return std::move(scene_);
        cut();
        refine();
        collect_classes();
        read_heights();
        move();
        place();
        return std::move(scene_);
    }

private:
    bool is_changed(std::size_t i) const { return parts_[i].material != nullptr || !fine_.meshes[i].middle_of.empty(); }

    void cut() {
        std::vector<AttributeMesh> meshes;
        for (const DisplacedPart& p : parts_) {
            const Mesh& mesh = scene_.meshes[p.instance.mesh];
            meshes.push_back({.object = p.instance.node,
                              .positions = mesh.positions,
                              .indices = mesh.indices,
                              .to_world = p.to_world,
                              .position_step = mesh.position_step});
        }
        const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context_);
        const std::uint64_t most = std::min(options_.max_triangles, std::uint64_t(1) << 32);
        check_memory(meshes, most);
        std::vector<std::uint8_t> moves(placed.place.size(), 0);  // some displaced mesh has a vertex at the place
        for (std::uint32_t v = 0; v < placed.place.size(); ++v)
            if (parts_[placed.input.mesh_of_vertex(v)].material) moves[placed.place[v]] = 1;
        std::vector<geometry::CoarseMesh> coarse = geometry::coarse_meshes(placed);
        for (std::size_t i = 0; i < parts_.size(); ++i)
            for (std::uint32_t v = placed.input.vertex_base[i];
                 !parts_[i].material && v < placed.input.vertex_base[i + 1]; ++v)
                coarse[i].on_border.push_back(moves[placed.place[v]]);
        const double diagonal = world_bounds(scene_).diagonal();
        edge_ = options_.edge > 0 ? options_.edge : diagonal / 250;
        if (!(edge_ > 0)) edge_ = 1;
        fine_ = geometry::tessellate(coarse, edge_, most + count_triangles(false), context_);
        if (!fine_.is_complete) warn_of_limit();
    }

    /// Neighbors of a displaced mesh are tessellated in the same way.
    void check_memory(const std::vector<AttributeMesh>& meshes, std::uint64_t most) const {
        constexpr std::uint64_t a_vertex = 104, a_corner = 12, a_triangle = 96;
        std::uint64_t bytes = most * a_triangle + meshes.size() * (sizeof(Mesh) + sizeof(DisplacedPart));
        for (const AttributeMesh& m : meshes) bytes += m.positions.size() * a_vertex + m.indices.size() * a_corner;
        context_.memory().check(bytes, "displaced triangles");
    }

    /// Triangles of displaced and tessellated meshes, or of the others.
    std::uint64_t count_triangles(bool displaced) const {
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if ((parts_[i].material != nullptr) != displaced) continue;
            count +=
                (displaced ? fine_.meshes[i].indices.size() : scene_.meshes[parts_[i].instance.mesh].indices.size()) /
                3;
        }
        return count;
    }

    void warn_of_limit() {
        char text[160];
        std::snprintf(text, sizeof text,
                      "displacement stops at %llu of %llu triangles: edges are up to %.3g m long, not %.3g m",
                      static_cast<unsigned long long>(count_triangles(true)),
                      static_cast<unsigned long long>(options_.max_triangles), fine_.longest_edge, edge_);
        context_.report().add(Remark::warning, scene_.source, {}, text);
    }

    void refine() {
        meshes_.resize(parts_.size());
        context_.parallel_for(parts_.size(), [&](std::size_t i) {
            const Mesh& mesh = scene_.meshes[parts_[i].instance.mesh];
            meshes_[i] = is_changed(i) ? refined_mesh(mesh, fine_.meshes[i]) : mesh;
            if (parts_[i].material) set_blur(meshes_[i], parts_[i]);
        });
    }

    /// Vertices at one place with one material use the same mip level, so that splitting a model into objects has no
    /// effect.
    void read_heights() {
        for_each_class([&](std::span<const Member> members) {
            const Material* const material = parts_[members[0].part].material;
            float blur = 0;
            for (const Member& m : members) {
                if (!material || parts_[m.part].material != material) return;
                blur = std::max(blur, parts_[m.part].blur[m.vertex]);
            }
            for (const Member& m : members) parts_[m.part].blur[m.vertex] = blur;
        });
        context_.parallel_for(parts_.size(), [&](std::size_t i) {
            DisplacedPart& part = parts_[i];
            if (!part.material) return;
            const Relief& relief = relief_of(*part.material, options_);
            const Block<vec2>& uv = meshes_[i].texcoords[part.material->height_texture.texcoord_set];
            part.offset.reserve(uv.size());
            CancelCheck check(context_);
            for (std::size_t v = 0; v < uv.size(); ++v, check()) {
                const double value = double(part.heights->at(uv[v], part.blur[v])), stays = 1 - double(relief.bias);
                part.offset.push_back(float(part.depth * ((relief.holds_depth ? 1 - value : value) - stays)));
            }
        });
        warn_of_lost_relief(scene_, parts_, fine_.longest_edge, context_.report());
    }

    /// Vertices grouped by place, in the order of parts and vertices.
    void collect_classes() {
        CancelCheck check(context_);
        for (std::uint32_t i = 0; i < parts_.size(); ++i)
            for (std::uint32_t v = 0; v < fine_.meshes[i].places.size(); ++v, check())
                members_.push_back({fine_.meshes[i].places[v], i, v});
        context_.throw_if_cancelled();
        std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
            return std::tie(a.place.x, a.place.y, a.place.z, a.part, a.vertex) <
                   std::tie(b.place.x, b.place.y, b.place.z, b.part, b.vertex);
        });
    }

    void move() {
        std::vector<std::vector<vec3>> positions;
        for (const Mesh& mesh : meshes_) positions.emplace_back(mesh.positions.begin(), mesh.positions.end());
        for_each_class([&](std::span<const Member> members) { move_class(members, positions); });
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (!is_changed(i)) continue;
            meshes_[i].positions = std::move(positions[i]);
            meshes_[i].normals = {};
            meshes_[i].tangents = {};
        }
    }

    /// The first instance replaces the mesh, instances with other results get their own.
    void place() {
        std::vector<std::vector<std::uint32_t>> made(scene_.meshes.size());
        AddedMeshes added(scene_, context_);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Instance& instance = parts_[i].instance;
            std::vector<std::uint32_t>& numbers = made[instance.mesh];
            const auto is_same = [&](std::uint32_t n) { return same_shape(scene_.meshes[n], meshes_[i]); };
            auto at = std::find_if(numbers.begin(), numbers.end(), is_same);
            if (at == numbers.end()) {
                const bool is_first = numbers.empty();
                at = numbers.insert(at, is_first ? instance.mesh : added.add(std::move(meshes_[i])));
                if (is_first) scene_.meshes[instance.mesh] = std::move(meshes_[i]);
            }
            scene_.nodes[instance.node].meshes[instance.slot] = *at;
        }
    }

    struct Member {
        dvec3 place;
        std::uint32_t part, vertex;
    };

    template <class Work>
    void for_each_class(const Work& work) const {
        CancelCheck check(context_);
        for (std::size_t first = 0; first < members_.size(); check()) {
            std::size_t end = first + 1;
            while (end < members_.size() && members_[end].place == members_[first].place) ++end;
            work(std::span(members_).subspan(first, end - first));
            first = end;
        }
    }

    void move_class(std::span<const Member> members, std::vector<std::vector<vec3>>& positions) {
        dvec3 normal{};
        double offset = 0;
        bool stays = false;
        for (const Member& m : members) {
            const DisplacedPart& part = parts_[m.part];
            stays |= part.material == nullptr;
            if (stays) break;
            const dvec3 n = normal_matrix(part.to_world) * cast<double>(meshes_[m.part].normals[m.vertex]);
            normal = normal + normalize_or(n, {0, 0, 0});
            offset += double(part.offset[m.vertex]);
        }
        const dvec3 way = stays ? dvec3{} : normalize_or(normal, {0, 0, 0}) * (offset / double(members.size()));
        for (const Member& m : members) {
            const bool is_new = m.vertex >= scene_.meshes[parts_[m.part].instance.mesh].positions.size();
            if (stays && !is_new) continue;  // bit-identical to its old position
            positions[m.part][m.vertex] = cast<float>(transform_point(parts_[m.part].to_object, m.place + way));
        }
    }

    Scene scene_;
    const Displacement& options_;
    Context& context_;
    std::vector<DisplacedPart> parts_;
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

Scene displace_scene(Scene scene, const Displacement& options, Context& context) {
    return Displacer(std::move(scene), options, context).run();
}

}  // namespace rakelight
