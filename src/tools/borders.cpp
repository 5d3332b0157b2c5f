// SPDX-License-Identifier: Apache-2.0
#include "tools/borders.h"

#include <algorithm>
#include <bit>
#include <map>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// Objects that meet at one position are paired with each other up to this many; more (a fan of hundreds of parts in
/// one point) would make a quadratic number of pairs.
constexpr std::size_t max_objects_at_position = 8;

/// One use of a mesh by an object, placed in the world.
struct Placement {
    std::uint32_t object = 0, mesh = 0;
    dmat4 to_world;
    mat3 normals_to_world;
};

struct Entry {
    std::uint64_t hash;
    std::uint32_t placement, vertex;
};

/// What is drawn at one position by one object.
struct Corner {
    std::uint32_t object = 0;
    vec3 normal;
};

std::uint64_t mix(std::uint64_t h) {  // the finalizer of MurmurHash3, Appleby 2011
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
    return h ^ (h >> 33);
}

std::uint64_t hash_of(dvec3 p) {
    // + 0.0 makes -0 to +0
    return mix(std::bit_cast<std::uint64_t>(p.x + 0.0) +
               mix(std::bit_cast<std::uint64_t>(p.y + 0.0) + mix(std::bit_cast<std::uint64_t>(p.z + 0.0))));
}

class BorderFinder {
public:
    BorderFinder(const Scene& scene, const std::vector<std::uint32_t>& objects, Context& context) : scene_(scene) {
        collect_placements(objects);
        collect_entries(context);
    }

    SharedPositions run() {
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.hash != b.hash             ? a.hash < b.hash
                   : a.placement != b.placement ? a.placement < b.placement
                                                : a.vertex < b.vertex;
        });
        for (std::size_t i = 0; i < entries_.size();) {
            std::size_t end = i + 1;
            while (end < entries_.size() && entries_[end].hash == entries_[i].hash) ++end;
            if (end - i > 1) visit_hash(i, end);
            i = end;
        }
        return summarize();
    }

private:
    struct Pair {
        std::uint64_t positions = 0;
        std::vector<float> angles;
    };

    void collect_placements(const std::vector<std::uint32_t>& objects) {
        const std::vector<dmat4> world = world_matrices(scene_);
        for (std::uint32_t object = 0; object < objects.size(); ++object)
            for (const std::uint32_t mesh : scene_.nodes[objects[object]].meshes) {
                if (scene_.meshes[mesh].topology != Topology::triangles) continue;
                const dmat4& m = world[objects[object]];
                dmat3 c = cofactor(upper_left(m));
                if (determinant(upper_left(m)) < 0) c = {{-c[0], -c[1], -c[2]}};
                placements_.push_back({object,
                                       mesh,
                                       m * translation(scene_.meshes[mesh].origin),
                                       {{cast<float>(c[0]), cast<float>(c[1]), cast<float>(c[2])}}});
            }
    }

    void collect_entries(Context& context) {
        std::uint64_t vertices = 0;
        for (const Placement& p : placements_) vertices += scene_.meshes[p.mesh].positions.size();
        context.memory().check(vertices * sizeof(Entry), "looking for shared borders");
        entries_.reserve(vertices);
        std::vector<std::uint8_t> used;
        for (std::uint32_t i = 0; i < placements_.size(); ++i) {
            const Mesh& mesh = scene_.meshes[placements_[i].mesh];
            used.assign(mesh.positions.size(), 0);
            for (const std::uint32_t index : mesh.indices) used[index] = 1;
            for (std::uint32_t v = 0; v < used.size(); ++v)
                if (used[v] && is_finite(mesh.positions[v])) entries_.push_back({hash_of(position(i, v)), i, v});
        }
    }

    dvec3 position(std::uint32_t placement, std::uint32_t vertex) const {
        const Placement& p = placements_[placement];
        return transform_point(p.to_world, cast<double>(scene_.meshes[p.mesh].positions[vertex]));
    }

    vec3 normal(const Entry& e) const {
        const Placement& p = placements_[e.placement];
        const Mesh& mesh = scene_.meshes[p.mesh];
        if (mesh.normals.empty()) return {0, 0, 0};
        return normalize_or(p.normals_to_world * mesh.normals[e.vertex], vec3{0, 0, 0});
    }

    /// Entries of one hash; nearly always one position. Colliding others are told apart by comparing.
    void visit_hash(std::size_t begin, std::size_t end) {
        std::vector<std::uint8_t> done(end - begin, 0);
        for (std::size_t i = begin; i < end; ++i) {
            if (done[i - begin]) continue;
            const dvec3 here = position(entries_[i].placement, entries_[i].vertex);
            corners_.clear();
            for (std::size_t k = i; k < end; ++k) {
                if (done[k - begin] || !(position(entries_[k].placement, entries_[k].vertex) == here)) continue;
                done[k - begin] = 1;
                add_corner({placements_[entries_[k].placement].object, normal(entries_[k])});
            }
            visit_position();
        }
    }

    /// Vertices of one object that only differ in texture coordinates have one normal: kept once.
    void add_corner(const Corner& corner) {
        for (std::size_t i = corners_.size(); i-- > 0 && corners_[i].object == corner.object;)
            if (corners_[i].normal == corner.normal) return;
        corners_.push_back(corner);
    }

    void visit_position() {
        if (corners_.front().object == corners_.back().object) return;  // entries are in the order of the objects
        ++result_.positions;
        std::vector<std::pair<std::size_t, std::size_t>> runs;  // of one object each
        for (std::size_t i = 0; i < corners_.size() && runs.size() < max_objects_at_position;) {
            std::size_t end = i + 1;
            while (end < corners_.size() && corners_[end].object == corners_[i].object) ++end;
            runs.emplace_back(i, end);
            i = end;
        }
        for (std::size_t a = 0; a < runs.size(); ++a)
            for (std::size_t b = a + 1; b < runs.size(); ++b) add_pair(runs[a], runs[b]);
    }

    void add_pair(std::pair<std::size_t, std::size_t> a, std::pair<std::size_t, std::size_t> b) {
        Pair& pair = pairs_[{corners_[a.first].object, corners_[b.first].object}];
        ++pair.positions;
        float best = -1;
        vec3 best_a, best_b;
        for (std::size_t i = a.first; i < a.second; ++i)
            for (std::size_t k = b.first; k < b.second; ++k) {
                const float cosine = dot(corners_[i].normal, corners_[k].normal);
                if (cosine <= best) continue;
                best = cosine, best_a = corners_[i].normal, best_b = corners_[k].normal;
            }
        const dvec3 na = cast<double>(best_a), nb = cast<double>(best_b);
        const double angle = na == nb ? 0 : math::atan2(length(cross(na, nb)), dot(na, nb));
        pair.angles.push_back(float(degrees(angle)));
    }

    SharedPositions summarize() {
        for (auto& [objects, pair] : pairs_) {
            const auto middle = pair.angles.begin() + std::ptrdiff_t(pair.angles.size() / 2);
            std::nth_element(pair.angles.begin(), middle, pair.angles.end());
            const float median = *middle, largest = *std::max_element(middle, pair.angles.end());
            result_.borders.push_back({objects.first, objects.second, pair.positions, median, largest});
        }
        std::stable_sort(result_.borders.begin(), result_.borders.end(),
                         [](const BorderSummary& a, const BorderSummary& b) { return a.largest_deg > b.largest_deg; });
        if (result_.borders.size() > SharedPositions::max_borders) {
            result_.borders_left_out = result_.borders.size() - SharedPositions::max_borders;
            result_.borders.resize(SharedPositions::max_borders);
        }
        return std::move(result_);
    }

    const Scene& scene_;
    std::vector<Placement> placements_;
    std::vector<Entry> entries_;
    std::vector<Corner> corners_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Pair> pairs_;
    SharedPositions result_;
};

}  // namespace

SharedPositions find_borders(const Scene& scene, const std::vector<std::uint32_t>& objects, Context& context) {
    if (objects.size() < 2) return {};
    return BorderFinder(scene, objects, context).run();
}

}  // namespace rakelight
