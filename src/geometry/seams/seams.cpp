// SPDX-License-Identifier: Apache-2.0
// Joins authored normals where meshes meet: shared places -> corners -> fans -> changed vertices.
#include <rakelight/geometry/seams.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/atomic_ref.h"
#include "geometry/corners/corner_bins.h"
#include "geometry/faults/place_classes.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/face_vote.h"
#include "geometry/input/perpendicular.h"
#include "geometry/seams/seam_fans.h"
#include "geometry/sums/finish_vertices.h"

namespace rakelight {
namespace geometry {
namespace {

constexpr double vanished_share = 1e-6;  // of the angles that were summed
constexpr std::uint32_t nobody = 0xffffffffu;
constexpr std::size_t most_rounds = 64;  // at one place

/// A global vertex index and its new normal.
struct Turn {
    std::uint32_t vertex;
    vec3 normal;
    float degrees;  ///< in the world
};

/// Memory for the corners and fans at one place.
struct Scratch {
    std::vector<dvec3> before;   ///< [corners] authored normals
    std::vector<dvec3> sums;     ///< [fans]
    std::vector<double> angles;  ///< [fans]
};

/// Result of one chunk of places.
struct Found {
    std::vector<Turn> turns;
    std::uint64_t flat_pairs = 0, crease_pairs = 0;
    bool needs_creases = false;
};

class SeamPass {
public:
    SeamPass(const PlacedMeshes& placed, const AttributeOptions& options, Context& context)
        : placed_(placed), input_(placed.input), context_(context) {
        for (const AttributeMesh& mesh : input_.meshes) {
            rules_.cosines.push_back(crease_cosine(crease_angle(mesh, options)));
            rules_.follows.push_back(follows_rule(mesh, options));
        }
    }

    std::vector<Turn> run(SeamReport& report) {
        std::vector<std::uint8_t> used(input_.vertex_count(), 0);
        shared_.assign(input_.vertex_count(), 0);
        mark_used(used);
        mark_shared(used);
        count_normals(used, report);
        const CornerBins bins = shared_corners();
        std::vector<Found> found = look_at_places(bins);
        if (std::ranges::any_of(found, &Found::needs_creases)) {
            rules_.creases = decide_creases(input_, placed_.place, face_normals(input_, context_), context_);
            found = look_at_places(bins);
        }
        std::vector<Turn> turns;
        for (const Found& f : found) {
            turns.insert(turns.end(), f.turns.begin(), f.turns.end());
            report.flat_pairs += f.flat_pairs;
            report.crease_pairs += f.crease_pairs;
        }
        std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.vertex < b.vertex; });
        return turns;
    }

private:
    template <class Body>
    void for_each_vertex(const Body& body) const {
        const std::vector<Chunk> chunks = make_chunks(input_.vertex_base, vertices_per_chunk);
        context_.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_range(chunks[c], input_.vertex_base,
                           [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                               for (std::uint32_t v = first; v != last; ++v) body(m, input_.vertex_base[m] + v);
                           });
        });
    }

    void mark_used(std::vector<std::uint8_t>& used) const {
        const std::vector<Chunk> chunks = make_chunks(input_.triangle_base, triangles_per_chunk);
        context_.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_range(
                chunks[c], input_.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                    const std::uint32_t* const index = input_.meshes[m].indices.data();
                    for (std::size_t k = 3 * std::size_t(first); k != 3 * std::size_t(last); ++k)
                        atomic_ref(used[input_.vertex_base[m] + index[k]]).store(1, std::memory_order_relaxed);
                });
        });
    }

    /// The smallest mesh at a place owns it; with another mesh the place is shared.
    void mark_shared(const std::vector<std::uint8_t>& used) {
        std::vector<std::uint32_t> owner(used.size(), nobody);
        for_each_vertex([&](std::uint32_t m, std::uint32_t v) {
            if (used[v] == 0) return;
            atomic_ref least(owner[placed_.place[v]]);
            std::uint32_t known = least.load(std::memory_order_relaxed);
            while (m < known && !least.compare_exchange_weak(known, m, std::memory_order_relaxed)) {
            }
        });
        for_each_vertex([&](std::uint32_t m, std::uint32_t v) {
            if (used[v] != 0 && owner[placed_.place[v]] != m)
                atomic_ref(shared_[placed_.place[v]]).store(1, std::memory_order_relaxed);
        });
    }

    void count_normals(const std::vector<std::uint8_t>& used, SeamReport& report) const {
        std::atomic<std::uint64_t> normals{0}, unusable{0};
        for_each_vertex([&](std::uint32_t m, std::uint32_t v) {
            if (used[v] == 0) return;
            normals.fetch_add(1, std::memory_order_relaxed);
            if (authored(m, v - input_.vertex_base[m]) == dvec3{}) unusable.fetch_add(1, std::memory_order_relaxed);
        });
        report.normals = normals, report.unusable = unusable;
    }

    CornerBins shared_corners() const {
        BlockArray<std::uint16_t> scratch;
        return CornerSort(input_, input_.vertex_count(), {}, scratch, context_).run([&](std::uint32_t m) {
            return [&, m](std::uint32_t corner) {
                const std::uint32_t place = placed_.place[input_.corner_vertex(m, corner)];
                return shared_[place] != 0 ? place : CornerSort::no_bin;
            };
        });
    }

    dvec3 authored(std::uint32_t m, std::uint32_t vertex) const {
        return given_normal(input_.placements[m], input_.meshes[m].normals[vertex]);
    }

    SeamCorner corner_at(std::uint32_t m, std::uint32_t corner) const {
        constexpr std::uint32_t after[] = {1, 2, 0};
        const AttributeMesh& mesh = input_.meshes[m];
        const Placement& placement = input_.placements[m];
        const std::uint32_t k = corner % 3;
        const std::uint32_t* const index = mesh.indices.data() + (corner - k - 3 * input_.triangle_base[m]);
        SeamCorner c;
        c.mesh = m, c.corner = corner;
        c.vertex = input_.vertex_base[m] + index[k];
        c.authored = authored(m, index[k]);
        const FaceCorners face = face_corners(mesh, index);
        const Direction normal = face_normal(placement, face);
        c.face = normal.unit;
        if (c.face == dvec3{}) return c;
        c.square = square_normal(mesh, placement, corner / 3 - input_.triangle_base[m], c.authored);
        const dvec3 angles = corner_weights<CornerWeight::angle>(placement, face, normal.length);
        c.angle = k == 0 ? angles.x : k == 1 ? angles.y : angles.z;
        c.next = other_corner(m, index[k], index[after[k]]);
        c.previous = other_corner(m, index[k], index[after[after[k]]]);
        return c;
    }

    OtherCorner other_corner(std::uint32_t m, std::uint32_t here, std::uint32_t vertex) const {
        const std::uint32_t place = placed_.place[input_.vertex_base[m] + vertex];
        const std::span<const vec3> positions = input_.meshes[m].positions;
        const dvec3 edge = cast<double>(positions[vertex]) - cast<double>(positions[here]);
        return {place, shared_[place] != 0, direction_of(input_.placements[m].linear * edge).unit, authored(m, vertex)};
    }

    std::vector<Found> look_at_places(const CornerBins& bins) const {
        std::vector<Found> found(input_.vertex_count() / vertices_per_chunk + 1);
        context_.parallel_for(found.size(), [&](std::size_t c) { found[c] = look_at_places(c, bins); });
        return found;
    }

    Found look_at_places(std::size_t chunk, const CornerBins& bins) const {
        Found found;
        SeamFans fans(rules_);
        std::vector<SeamCorner> corners;
        Scratch scratch;
        const std::size_t first = chunk * vertices_per_chunk,
                          last = std::min<std::size_t>(input_.vertex_count(), first + vertices_per_chunk);
        std::uint32_t m = 0;
        for (std::size_t place = first; place < last; ++place) {
            corners.clear();
            for (const std::uint32_t corner : bins[std::uint32_t(place)]) {
                if (corners.empty() || corner >= 3 * input_.triangle_base[m + 1])
                    m = input_.mesh_of_triangle(corner / 3);
                corners.push_back(corner_at(m, corner));
            }
            if (!corners.empty()) settle(std::uint32_t(place), corners, fans, scratch, found);
        }
        found.needs_creases = fans.needs_creases();
        return found;
    }

    /// Joins the fans at one place until nothing turns, as further calls would. Equal normals keep their joint and are
    /// joined first, so a round that turns any gives one normal to fans that had several, and they stay together: there
    /// are fewer such rounds than fans. Only where more than `most_rounds` fans meet can the limit end them earlier.
    void settle(std::uint32_t place, std::vector<SeamCorner>& corners, SeamFans& fans, Scratch& scratch,
                Found& found) const {
        scratch.before.clear();
        for (const SeamCorner& c : corners) scratch.before.push_back(c.authored);
        for (std::size_t round = 0; round < most_rounds; ++round) {
            fans.find(place, corners);
            if (!turn(corners, fans, scratch)) break;
        }
        found.flat_pairs += fans.flat_pairs(), found.crease_pairs += fans.crease_pairs();
        const std::size_t first = found.turns.size();
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (corners[i].authored != scratch.before[i]) add_turn(corners[i], scratch.before[i], found.turns);
        const auto begin = found.turns.begin() + std::ptrdiff_t(first);
        std::sort(begin, found.turns.end(), [](const Turn& a, const Turn& b) { return a.vertex < b.vertex; });
        found.turns.erase(
            std::unique(begin, found.turns.end(), [](const Turn& a, const Turn& b) { return a.vertex == b.vertex; }),
            found.turns.end());
    }

    /// Gives the corners of joined fans their common normal.
    /// @return whether any turned
    static bool turn(std::span<SeamCorner> corners, SeamFans& fans, Scratch& scratch) {
        const std::span<const AuthoredFan> list = fans.fans();
        scratch.sums.assign(list.size(), {});
        scratch.angles.assign(list.size(), 0);
        bool any = false;
        for (std::uint32_t f = 0; f < list.size(); ++f) {
            const std::uint32_t root = fans.joined(f);
            scratch.sums[root] += list[f].normal * list[f].angle;
            scratch.angles[root] += list[f].angle;
            any = any || fans.is_open(f);
        }
        if (!any) return false;
        any = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (fans.fan_of()[i] == SeamFans::no_fan) continue;
            const std::uint32_t root = fans.joined(fans.fan_of()[i]);
            const bool vanishes = !(length(scratch.sums[root]) > vanished_share * scratch.angles[root]);
            if (!fans.is_open(root) || vanishes) continue;
            const dvec3 normal = normalize_or(scratch.sums[root], corners[i].authored);
            any = any || normal != corners[i].authored;
            corners[i].authored = normal;
        }
        return any;
    }

    void add_turn(const SeamCorner& corner, dvec3 before, std::vector<Turn>& turns) const {
        const vec3 wanted = cast<float>(to_object(input_.placements[corner.mesh], corner.authored));
        const std::uint32_t vertex = corner.vertex - input_.vertex_base[corner.mesh];
        if (wanted == input_.meshes[corner.mesh].normals[vertex]) return;
        turns.push_back({corner.vertex, wanted, float(degrees(angle_between(before, corner.authored)))});
    }

    const PlacedMeshes& placed_;
    const AttributeInput& input_;
    Context& context_;
    SeamRules rules_;
    std::vector<std::uint8_t> shared_;  ///< [places] whether several meshes have faces there
};

/// Upper bound of the pass's memory besides the weld, as if every place were shared.
void check_memory(std::span<const AttributeMesh> meshes, Context& context) {
    std::uint64_t bytes = 0;
    for (const AttributeMesh& m : meshes) bytes += 14 * m.positions.size() + 6 * m.indices.size();
    context.memory().check(bytes, "joining the normals of meshes that meet");
}

}  // namespace
}  // namespace geometry

std::vector<MeshSeams> join_seams(std::span<const AttributeMesh> meshes, const SeamOptions& options, SeamReport& report,
                                  Context& context) {
    report = {};
    AttributeOptions checked;
    checked.crease_angle_rad = options.crease_angle_rad;
    checked.creases = options.creases;
    checked.weld_distance = options.weld_distance;
    geometry::check_options(checked);
    geometry::check_normals(meshes);
    std::vector<MeshSeams> out(meshes.size());
    geometry::check_memory(meshes, context);
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, options.weld_distance, context);
    const std::vector<geometry::Turn> turns = geometry::SeamPass(placed, checked, context).run(report);
    double sum = 0;
    for (const geometry::Turn& t : turns) {
        const std::uint32_t m = placed.input.mesh_of_vertex(t.vertex);
        out[m].vertices.push_back(t.vertex - placed.input.vertex_base[m]);
        out[m].normals.push_back(t.normal);
        report.max_deg = std::max(report.max_deg, double(t.degrees));
        sum += t.degrees;
    }
    report.turned = turns.size();
    report.mean_deg = turns.empty() ? 0 : sum / double(turns.size());
    return out;
}

namespace {

/// Rodrigues' rotation by the angle between two unit vectors, written with their cross product.
dvec3 turned(dvec3 v, dvec3 from, dvec3 to) {
    const dvec3 axis = cross(from, to);
    const double cosine = dot(from, to);
    if (cosine <= -1 + 1e-12) {  // half a turn about an arbitrary perpendicular axis
        const dvec3 across = geometry::perpendicular(from);
        return across * (2 * dot(across, v)) - v;
    }
    return v * cosine + cross(axis, v) + axis * (dot(axis, v) / (1 + cosine));
}

dvec3 unit(vec3 v) { return normalize_or(cast<double>(v), dvec3{0, 0, 1}); }

}  // namespace

vec4 turned_tangent(vec4 tangent, vec3 from, vec3 to) {
    const dvec3 normal = unit(to), t = turned(cast<double>(tangent.xyz()), unit(from), normal);
    const dvec3 across = t - normal * dot(normal, t);
    const dvec3 u = length(across) > 1e-6 * length(t) ? normalize_or(across, dvec3{}) : geometry::perpendicular(normal);
    return {float(u.x), float(u.y), float(u.z), tangent.w};
}

vec3 turned_along(vec3 vector, vec3 from, vec3 to) {
    return cast<float>(turned(cast<double>(vector), unit(from), unit(to)));
}

}  // namespace rakelight
