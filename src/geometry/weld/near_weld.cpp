// SPDX-License-Identifier: Apache-2.0
#include "geometry/weld/near_weld.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <tuple>

#include "base/format_text.h"
#include "geometry/input/union_find.h"
#include "geometry/weld/near_cells.h"
#include "geometry/weld/rounding_tolerances.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t crowded = 1024;  // places in one cell: more means a hostile file, or a far too large distance

struct Entry {
    dvec3 position;
    std::uint32_t vertex, mesh, object;
};

/// A place that several meshes have vertices at: its representative and one of the meshes.
using SharedPlace = std::pair<std::uint32_t, std::uint32_t>;

class NearWeld {
public:
    NearWeld(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, Context& context)
        : representative_(representative),
          input_(input),
          key_(key),
          context_(context),
          chunks_(make_chunks(input.vertex_base, vertices_per_chunk)) {}

    void run(double distance) {
        by_meshes_ = distance < 0;
        if (by_meshes_) {
            number_matrices();
            for (const AttributeMesh& m : input_.meshes) quantized_ = quantized_ || m.position_step > 0;
            if (matrices_ < 2 && !quantized_) return;
        }
        const WorldBox box = bounds();
        const double diagonal = box.diagonal();
        if (!(diagonal > 0) || !(diagonal < std::numeric_limits<float>::max())) return;
        distance_ = by_meshes_ ? widest_reach(box) : distance;
        origin_ = box.low;
        if (!(diagonal / distance_ < 1e15)) return;  // below the rounding of the positions: exact
        if (quantized_) find_shared_places();
        join(close_pairs());
    }

private:
    void number_matrices() {
        std::map<std::vector<double>, std::uint32_t> number;
        std::vector<std::uint32_t> of_distinct;
        for (const Placement& p : input_.placements.distinct()) {
            std::vector<double> key(16);
            std::memcpy(key.data(), &p.to_world, sizeof p.to_world);
            of_distinct.push_back(number.try_emplace(key, std::uint32_t(number.size())).first->second);
        }
        for (std::size_t m = 0; m < input_.meshes.size(); ++m)
            matrix_.push_back(of_distinct[input_.placements.number(m)]);
        matrices_ = number.size();
    }

    double widest_reach(const WorldBox& box) {
        reach_ = rounding_tolerances(input_, box, context_);
        return 2 * *std::max_element(reach_.begin(), reach_.end());
    }

    // For quantized meshes that meet exactly, the next code is a different place.
    void find_shared_places() {
        std::vector<std::vector<SharedPlace>> found(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            for_each_range(
                chunks_[c], input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                    for (std::uint32_t v = input_.vertex_base[m] + first; v != input_.vertex_base[m] + last; ++v)
                        if (representative_[v] < input_.vertex_base[m]) found[c].emplace_back(representative_[v], m);
                });
        });
        for (const auto& part : found) shared_.insert(shared_.end(), part.begin(), part.end());
        std::sort(shared_.begin(), shared_.end());
        shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    }

    // The other meshes with a vertex at a place, ascending.
    std::span<const SharedPlace> others_at(std::uint32_t place) const {
        const auto first = std::lower_bound(shared_.begin(), shared_.end(), SharedPlace{place, 0});
        return {first, std::lower_bound(first, shared_.end(), SharedPlace{place + 1, 0})};
    }

    // Linear in the meshes at the two places, which may be thousands.
    bool have_a_mesh_in_common(const Entry& a, const Entry& b) const {
        const auto at_a = others_at(a.vertex), at_b = others_at(b.vertex);
        const auto has = [](std::span<const SharedPlace> list, std::uint32_t mesh) {
            return !list.empty() && std::binary_search(list.begin(), list.end(), SharedPlace{list[0].first, mesh});
        };
        if (a.mesh == b.mesh || has(at_a, b.mesh) || has(at_b, a.mesh)) return true;
        for (auto i = at_a.begin(), j = at_b.begin(); i != at_a.end() && j != at_b.end();) {
            if (i->second == j->second) return true;
            ++(i->second < j->second ? i : j);
        }
        return false;
    }

    // Largest distance at which the two are one place; < 0: never.
    double reach(const Entry& a, const Entry& b) const {
        if (a.object != b.object) return -1;
        if (!by_meshes_) return distance_;
        if (input_.meshes[a.mesh].position_step > 0 || input_.meshes[b.mesh].position_step > 0)
            return a.mesh == b.mesh ? -1 : reach_[a.mesh] + reach_[b.mesh];
        return matrix_[a.mesh] == matrix_[b.mesh] ? -1 : reach_[a.mesh] + reach_[b.mesh];
    }

    bool is_one_place(const Entry& a, const Entry& b) const {
        const double most = reach(a, b);
        const dvec3 d = b.position - a.position;
        if (!(most >= 0) || !(dot(d, d) <= most * most)) return false;
        const bool by_step =
            by_meshes_ && (input_.meshes[a.mesh].position_step > 0 || input_.meshes[b.mesh].position_step > 0);
        return !by_step || !have_a_mesh_in_common(a, b);
    }

    // Calls body(mesh, vertex, position) for each place of finite position, once.
    template <class Body>
    void for_each_place(std::size_t chunk, const Body& body) const {
        for_each_range(chunks_[chunk], input_.vertex_base,
                       [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                           for (std::uint32_t v = first; v != last; ++v) {
                               if (representative_[input_.vertex_base[m] + v] != input_.vertex_base[m] + v) continue;
                               const dvec3 p = input_.placements[m].position(input_.meshes[m].positions[v]);
                               if (is_finite(p)) body(m, input_.vertex_base[m] + v, p);
                           }
                       });
    }

    WorldBox bounds() const {
        std::vector<WorldBox> boxes(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            for_each_place(c, [&](std::uint32_t, std::uint32_t, dvec3 p) { boxes[c].add(p); });
        });
        WorldBox all;
        for (const WorldBox& box : boxes) all.add(box);
        return all;
    }

    struct Pair {
        std::uint32_t a, b;
        double reach;
    };
    using Pairs = std::vector<Pair>;

    std::vector<Pairs> close_pairs() {
        const NearCells cells(representative_, input_, origin_, distance_, context_);
        std::vector<Pairs> pairs(cells.partitions());
        crowded_.assign(cells.partitions(), 0);
        context_.parallel_for(cells.partitions(), [&](std::size_t part) {
            std::vector<Entry> entries;
            UnionFind sets;
            cells.for_each_shared_cell(std::uint32_t(part), [&](std::span<const std::uint32_t> cell) {
                if (cell.size() > crowded) {
                    crowded_[part] += cell.size();
                    return;
                }
                entries.clear();
                for (const std::uint32_t v : cell) entries.push_back(entry(v));
                std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
                    return std::tuple(a.position.x, a.vertex) < std::tuple(b.position.x, b.vertex);
                });
                compare(entries, sets, pairs[part]);
            });
        });
        return pairs;
    }

    Entry entry(std::uint32_t vertex) const {
        const std::uint32_t m = input_.mesh_of_vertex(vertex);
        const dvec3 p = input_.placements[m].position(input_.meshes[m].positions[vertex - input_.vertex_base[m]]);
        return {p, vertex, m, key_.object ? input_.meshes[m].object : 0};
    }

    // Sorted by x: only a window as wide as the distance is compared. Pairs that are already connected inside the cell are not
    // kept, so there are fewer of them than places, however many lie close together.
    void compare(std::span<const Entry> cell, UnionFind& sets, Pairs& pairs) const {
        sets.reset(cell.size());
        for (std::size_t i = 0; i < cell.size(); ++i)
            for (std::size_t j = i + 1; j < cell.size() && cell[j].position.x - cell[i].position.x <= distance_; ++j)
                if (is_one_place(cell[i], cell[j]) && sets.join(std::uint32_t(i), std::uint32_t(j)))
                    pairs.push_back({cell[i].vertex, cell[j].vertex, reach(cell[i], cell[j])});
    }

    void join(const std::vector<Pairs>& parts) {
        Pairs pairs;
        for (const Pairs& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
        UnionFind sets;
        if (!pairs.empty()) sets.reset(representative_.size());
        for (const Pair& pair : pairs) sets.join(pair.a, pair.b);
        // Sorted by their common place.
        std::sort(pairs.begin(), pairs.end(),
                  [&](const Pair& a, const Pair& b) { return sets.root(a.a) < sets.root(b.a); });
        std::vector<bool> is_welded(pairs.empty() ? 0 : representative_.size(), false);
        std::uint64_t too_wide = 0;
        for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
            const std::uint32_t root = sets.root(pairs[first].a);
            while (last < pairs.size() && sets.root(pairs[last].a) == root) ++last;
            is_welded[root] = !is_too_wide(std::span(pairs).subspan(first, last - first));
            too_wide += !is_welded[root];
        }
        const std::uint64_t left = std::accumulate(crowded_.begin(), crowded_.end(), std::uint64_t(0));
        if (too_wide + left != 0)
            context_.report().add(Remark::warning, {}, {},
                                  format_text("{} chains and {} crowded vertices lie too close together to be welded "
                                              "within a tolerance; kept exact",
                                              too_wide, left));
        if (pairs.empty()) return;
        for (std::uint32_t& r : representative_) {
            const std::uint32_t root = sets.root(r);
            if (root != r && is_welded[root]) r = root;
        }
    }

    bool is_too_wide(std::span<const Pair> component) const {
        WorldBox box;
        double reach = 0;
        for (const Pair& pair : component) {
            reach = std::max(reach, pair.reach);
            for (const std::uint32_t v : {pair.a, pair.b}) box.add(entry(v).position);
        }
        const dvec3 size = box.high - box.low;
        return size.x > 2 * reach || size.y > 2 * reach || size.z > 2 * reach;
    }

    std::vector<std::uint32_t>& representative_;
    const AttributeInput& input_;
    WeldKey key_;
    Context& context_;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> matrix_;  // [meshes] equal numbers: equal matrices
    std::size_t matrices_ = 0;
    bool by_meshes_ = false, quantized_ = false;
    std::vector<double> reach_;        // [meshes] where the meshes set the distance
    std::vector<SharedPlace> shared_;  // sorted
    double distance_ = 0;
    dvec3 origin_;
    std::vector<std::uint64_t> crowded_;
};

}  // namespace

void weld_near(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, double distance,
               Context& context) {
    if (distance != 0) NearWeld(representative, input, key, context).run(distance);
}

}  // namespace rakelight::geometry
