// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/subdivide_scene.h"

#include <rakelight/base/report.h>
#include <rakelight/geometry/creases.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "base/format_text.h"
#include "geometry/faults/place_classes.h"
#include "geometry/input/union_find.h"
#include "math/linear.h"
#include "prepare/normals/smooth_selection.h"
#include "prepare/refine/subdivide_surface.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/faults.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

bool has_creases(const Subdivision& s) { return s.finds_creases || s.crease_angle_rad; }

Subdivision subdivision_of(const Mesh& mesh, const Subdivision& otherwise) {
    return mesh.subdivision.value_or(otherwise);
}

/// Instances that form one surface, with equal subdivision.
struct Group {
    std::vector<std::size_t> members;  ///< into Subdividing::instances_
    dmat4 to_world;                    ///< transform to the space of computation
    bool is_in_object = false;         ///< object space with one common matrix to the world
    std::size_t surface = 0;           ///< into Subdividing::surfaces_
};

class Subdividing {
public:
    Subdividing(Scene scene, const Subdivision& otherwise, Context& context)
        : scene_(std::move(scene)),
          otherwise_(otherwise),
          context_(context),
          world_(world_matrices(scene_)),
          charge_(context.memory()) {}

    /// Once.
    Scene run() {
        for (const Instance& instance : drawn_instances(scene_)) {
            const Mesh& mesh = scene_.meshes[instance.mesh];
            if (subdivision_of(mesh, otherwise_).level > 0) instances_.push_back(instance);
        }
        if (instances_.empty()) return std::move(scene_);
        weld();
        find_groups();
        build_surfaces();
        check_memory();
        std::vector<std::vector<Mesh>> made(surfaces_.size());
        context_.parallel_for(surfaces_.size(), [&](std::size_t i) { made[i] = surfaces_[i].run(context_); });
        report();
        place(std::move(made));
        return std::move(scene_);
    }

private:
    const Mesh& mesh_of(std::size_t i) const { return scene_.meshes[instances_[i].mesh]; }
    dmat4 matrix(std::size_t i) const { return world_[instances_[i].node]; }

    void weld() {
        std::vector<AttributeMesh> meshes;
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            const Mesh& mesh = mesh_of(i);
            meshes.push_back({.object = instances_[i].node,
                              .positions = mesh.positions,
                              .indices = mesh.indices,
                              .to_world = matrix(i) * translation(mesh.origin),
                              .position_step = mesh.position_step});
        }
        geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context_);
        charge_.grow(placed.place.size() * sizeof(std::uint32_t) * 2, what);  // with find_groups()'s list
        place_ = std::move(placed.place);
        vertex_base_ = std::move(placed.input.vertex_base);
        find_hard_edges(meshes);
    }

    /// Of the whole model, as `--crease auto` finds them.
    void find_hard_edges(std::span<const AttributeMesh> meshes) {
        bool is_asked = false;
        for (std::size_t i = 0; i < instances_.size(); ++i)
            is_asked = is_asked || subdivision_of(mesh_of(i), otherwise_).finds_creases;
        if (is_asked) hard_ = find_creases(meshes, {}, context_).hard;
    }

    void find_groups() {
        geometry::UnionFind sets;
        sets.reset(instances_.size());
        std::vector<std::uint32_t> first_at(place_.size(),
                                            no_index);  // place -> instance that uses it, of each subdivision the first
        std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> others;
        std::vector<Subdivision> requested;
        for (std::uint32_t i = 0; i < instances_.size(); ++i) {
            const Subdivision subdivision = subdivision_of(mesh_of(i), otherwise_);
            const auto known = std::find(requested.begin(), requested.end(), subdivision);
            const std::size_t number = std::size_t(known - requested.begin());
            if (known == requested.end()) requested.push_back(subdivision);
            dmat4 inverse;
            if (!inverse_affine(matrix(i), inverse)) continue;  // singular: separately, in object space
            for (const std::uint32_t v : mesh_of(i).indices) {
                const std::uint32_t p = place_[vertex_base_[i] + v];
                std::uint32_t& first = number == 0 ? first_at[p] : others.try_emplace({p, number}, i).first->second;
                if (first == no_index) first = i;
                sets.join(first, i);
            }
        }
        std::vector<std::size_t> group_of(instances_.size(), no_index);
        for (std::uint32_t i = 0; i < instances_.size(); ++i) {
            std::size_t& group = group_of[sets.root(i)];
            if (group == no_index) {
                group = groups_.size();
                groups_.emplace_back();
            }
            groups_[group].members.push_back(i);
        }
        for (Group& group : groups_) choose_space(group);
    }

    void choose_space(Group& group) {
        const dmat4 first = matrix(group.members[0]);
        dmat4 inverse;
        const bool is_one =
            std::all_of(group.members.begin(), group.members.end(), [&](std::size_t i) { return matrix(i) == first; });
        const bool keeps_angles =
            !has_creases(subdivision_of(mesh_of(group.members[0]), otherwise_)) || is_similarity(first);
        group.is_in_object = is_one && (keeps_angles || !inverse_affine(first, inverse));
        if (group.is_in_object) group.to_world = first;
    }

    /// Longest axis: world length of one unit of the space.
    static double scale_of(const dmat4& m) {
        return std::sqrt(std::max({dot(m[0], m[0]), dot(m[1], m[1]), dot(m[2], m[2])}));
    }

    void build_surfaces() {
        std::map<std::pair<std::vector<std::uint32_t>, double>, std::size_t> known;  // meshes and scale
        for (Group& group : groups_) {
            const Subdivision subdivision = subdivision_of(mesh_of(group.members[0]), otherwise_);
            const double scale = subdivision.edge > 0 ? scale_of(group.to_world) : 1;
            std::vector<std::uint32_t> meshes;
            for (const std::size_t i : group.members) meshes.push_back(instances_[i].mesh);
            if (group.is_in_object) {
                const auto [entry, is_new] = known.try_emplace({meshes, scale}, surfaces_.size());
                group.surface = entry->second;
                if (!is_new) continue;
            } else {
                group.surface = surfaces_.size();
            }
            context_.throw_if_cancelled();
            charge_surface(group);
            std::vector<SurfacePart> parts;
            for (const std::size_t i : group.members) {
                const Mesh& mesh = mesh_of(i);
                const dvec3 origin = mesh.origin - mesh_of(group.members[0]).origin;
                const auto places = place_.begin() + std::ptrdiff_t(vertex_base_[i]);
                parts.push_back({&mesh,
                                 group.is_in_object ? translation(origin) : matrix(i) * translation(mesh.origin),
                                 {places, places + std::ptrdiff_t(mesh.positions.size())},
                                 hard_.empty() ? std::span<const std::uint8_t>{} : hard_[i]});
            }
            surfaces_.emplace_back(std::move(parts), subdivision, scale);
        }
    }

    /// The control surface and the temporary memory of splitting it.
    void charge_surface(const Group& group) {
        constexpr std::uint64_t kept_a_vertex = 32, kept_a_corner = 12, for_a_corner = 72, arrays = 12;
        std::uint64_t vertices = 0, corners = 0;
        for (const std::size_t i : group.members)
            vertices += mesh_of(i).positions.size(), corners += mesh_of(i).indices.size();
        const std::uint64_t a_part = sizeof(SurfacePart) + sizeof(Mesh) + 4 * bytes_beside_array;  // and its result
        charge_.grow(vertices * kept_a_vertex + corners * kept_a_corner + sizeof(SurfaceSubdivider) +
                         arrays * bytes_beside_array + group.members.size() * a_part,
                     what);
        context_.memory().check(corners * for_a_corner, what);
    }

    /// Memory of the results, and temporary memory of surfaces computed in parallel.
    void check_memory() const {
        std::uint64_t triangles = 0, all = 0, largest = 0;
        for (const SurfaceSubdivider& s : surfaces_) {
            triangles += s.triangles();
            all += s.bytes();
            largest = std::max(largest, s.bytes());
        }
        const std::uint64_t at_once = std::min(all, largest * std::uint64_t(context_.threads()));
        try {
            context_.memory().check(triangles * 60 + at_once, format_text("subdivision into {} triangles", triangles));
        } catch (const Error& error) {
            throw error.advising(", or subdivide by fewer levels");
        }
    }

    void report() const {
        std::uint64_t faces = 0, triangles = 0, flat = 0, parted = 0;
        std::size_t loops = 0;
        int low = 8, high = 1;
        for (const SurfaceSubdivider& s : surfaces_) {
            faces += s.control_faces();
            triangles += s.triangles();
            flat += s.faults().flat_faces;
            parted += s.faults().parted_edges;
            loops += s.scheme() == geometry::Scheme::loop;
            low = std::min(low, s.level()), high = std::max(high, s.level());
        }
        std::size_t moving = 0;
        std::vector<bool> seen(scene_.meshes.size(), false);
        for (const Instance& i : instances_) {
            const Mesh& mesh = scene_.meshes[i.mesh];
            if (!seen[i.mesh]) moving += !mesh.influences.empty() || !mesh.targets.empty();
            seen[i.mesh] = true;
        }
        const std::string scheme = loops == 0                  ? "Catmull-Clark"
                                   : loops == surfaces_.size() ? "Loop"
                                                               : "Catmull-Clark and Loop";
        const std::string levels = low == high ? std::to_string(low) : format_text("{} to {}", low, high);
        const auto add = [&](Remark kind, const std::string& text) {
            context_.report().add(kind, scene_.source, {}, text);
        };
        add(Remark::note, format_text("subdivided by {} {} ({}): {} faces of {} surfaces became {} triangles", levels,
                                      high == 1 ? "level" : "levels", scheme, faces, surfaces_.size(), triangles));
        if (flat > 0)
            add(Remark::dropped, format_text("{} triangles with corners at one place are not subdivided", flat));
        if (parted > 0)
            add(Remark::warning, format_text("{} edges have more than two faces, or faces that turn opposite ways: the "
                                             "subdivided surface is parted there",
                                             parted));
        if (moving > 0)
            add(Remark::dropped, format_text("joint influences and morph targets of {} subdivided {} left out", moving,
                                             moving == 1 ? "mesh is" : "meshes are"));
    }

    /// The first surface of a mesh replaces it, others get new meshes.
    void place(std::vector<std::vector<Mesh>>&& made) {
        std::vector<bool> is_taken(scene_.meshes.size(), false);
        std::vector<std::vector<std::uint32_t>> numbers(made.size());
        AddedMeshes added(scene_, context_);
        for (const Group& group : groups_) {
            std::vector<std::uint32_t>& of_surface = numbers[group.surface];
            const bool is_new = of_surface.empty();
            for (std::size_t k = 0; k < group.members.size(); ++k) {
                const Instance& instance = instances_[group.members[k]];
                if (is_new) {
                    const bool is_first = !is_taken[instance.mesh];
                    is_taken[instance.mesh] = true;
                    Mesh& mesh = made[group.surface][k];
                    of_surface.push_back(is_first ? instance.mesh : added.add(std::move(mesh)));
                    if (is_first) scene_.meshes[instance.mesh] = std::move(mesh);
                }
                scene_.nodes[instance.node].meshes[instance.slot] = of_surface[k];
            }
        }
    }

    static constexpr const char* what = "the control surface of a subdivision";
    Scene scene_;
    const Subdivision& otherwise_;
    Context& context_;
    const std::vector<dmat4> world_;
    std::vector<Instance> instances_;
    std::vector<std::vector<std::uint8_t>> hard_;  // [instances_][T] as Creases::hard; empty: not asked for
    std::vector<std::uint32_t> place_, vertex_base_;
    std::vector<Group> groups_;
    std::vector<SurfaceSubdivider> surfaces_;
    MemoryCharge charge_;  ///< of the lists above
};

}  // namespace

bool wants_subdivision(const Scene& scene, const Subdivision& otherwise) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
        return mesh.triangle_count() > 0 && subdivision_of(mesh, otherwise).level > 0;
    });
}

Scene subdivide_scene(Scene scene, const Subdivision& otherwise, Context& context) {
    if (const char* const fault = fault_of(otherwise)) throw Error(ErrorCode::usage, fault);
    return Subdividing(std::move(scene), otherwise, context).run();
}

}  // namespace rakelight
