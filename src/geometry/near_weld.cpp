// SPDX-License-Identifier: Apache-2.0
// A grid of cells much wider than the distance; a place within half the distance of a cell's wall enters the neighbor too, so
// every close pair meets in some cell (about 1.4 entries a place). The distance is that of the two meshes that reach farthest; other
// pairs must lie closer. Wider cells would need fewer entries, but the small parts of a wide scene would crowd in them.
#include "geometry/near_weld.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <tuple>

#include "geometry/rounding_reach.h"
#include "geometry/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr double cell_width = 8;           // in distances
constexpr std::size_t crowded = 1024;      // places in one cell: more is no model but an attack, or a distance far too large
constexpr std::uint32_t partitions = 256;  // of the cells, by hash

struct Entry {
    std::uint64_t cell;
    dvec3 position;
    std::uint32_t vertex, mesh, object;
};

/// A place that several meshes have vertices at: its representative and one of the meshes.
using SharedPlace = std::pair<std::uint32_t, std::uint32_t>;

class NearWeld {
public:
    NearWeld(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, Context& context)
        : representative_(representative), input_(input), key_(key), context_(context),
          chunks_(make_chunks(input.vertex_base, vertices_per_chunk)) {}

    void run(double distance) {
        by_meshes_ = distance < 0;
        if (by_meshes_) {
            number_matrices();
            for (const AttributeMesh& m : input_.meshes) quantized_ = quantized_ || m.position_step > 0;
            if (matrices_ < 2 && !quantized_) return;
        }
        const Box box = bounds();
        const double diagonal = box.diagonal();
        if (!(diagonal > 0) || !(diagonal < std::numeric_limits<float>::max())) return;
        distance_ = by_meshes_ ? widest_reach(box) : distance;
        origin_ = box.low;
        if (!(diagonal / distance_ < 1e15)) return;  // below the rounding of the positions: exact
        if (distance_ * cell_width > diagonal) origin_ = box.low - dvec3{1, 1, 1} * distance_;
        if (quantized_) find_shared_places();
        join(close_pairs());
    }

private:
    void number_matrices() {
        std::map<std::vector<double>, std::uint32_t> number;
        for (const Placement& p : input_.placements) {
            std::vector<double> key(16);
            std::memcpy(key.data(), &p.to_world, sizeof p.to_world);
            matrix_.push_back(number.try_emplace(key, std::uint32_t(number.size())).first->second);
        }
        matrices_ = number.size();
    }

    double widest_reach(const Box& box) {
        reach_ = rounding_reach(input_, box, context_);
        return 2 * *std::max_element(reach_.begin(), reach_.end());
    }

    // Of quantized meshes that meet exactly, the next code is another place of the surface.
    void find_shared_places() {
        std::vector<std::vector<SharedPlace>> found(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            for_each_range(chunks_[c], input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                for (std::uint32_t v = input_.vertex_base[m] + first; v != input_.vertex_base[m] + last; ++v)
                    if (representative_[v] < input_.vertex_base[m]) found[c].emplace_back(representative_[v], m);
            });
        });
        for (const auto& part : found) shared_.insert(shared_.end(), part.begin(), part.end());
        std::sort(shared_.begin(), shared_.end());
        shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    }

    // The meshes beside its own that have a vertex at a place.
    std::span<const SharedPlace> others_at(std::uint32_t place) const {
        const auto first = std::lower_bound(shared_.begin(), shared_.end(), SharedPlace{place, 0});
        auto last = first;
        while (last != shared_.end() && last->first == place) ++last;
        return {first, last};
    }

    bool have_a_mesh_in_common(const Entry& a, const Entry& b) const {
        const auto at_a = others_at(a.vertex), at_b = others_at(b.vertex);
        const auto has = [](std::span<const SharedPlace> list, std::uint32_t mesh) {
            return std::any_of(list.begin(), list.end(), [&](const SharedPlace& p) { return p.second == mesh; });
        };
        if (a.mesh == b.mesh || has(at_a, b.mesh) || has(at_b, a.mesh)) return true;
        return std::any_of(at_a.begin(), at_a.end(), [&](const SharedPlace& p) { return has(at_b, p.second); });
    }

    // How far apart the two may lie to be one place; < 0: they are two.
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
        const bool by_step = by_meshes_ && (input_.meshes[a.mesh].position_step > 0 || input_.meshes[b.mesh].position_step > 0);
        return !by_step || !have_a_mesh_in_common(a, b);
    }

    // Calls body(mesh, vertex, position) for each place of finite position, once.
    template <class Body>
    void for_each_place(std::size_t chunk, const Body& body) const {
        for_each_range(chunks_[chunk], input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t v = first; v != last; ++v) {
                if (representative_[input_.vertex_base[m] + v] != input_.vertex_base[m] + v) continue;
                const dvec3 p = input_.placements[m].position(input_.meshes[m].positions[v]);
                if (is_finite(p)) body(m, input_.vertex_base[m] + v, p);
            }
        });
    }

    Box bounds() const {
        std::vector<Box> boxes(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            for_each_place(c, [&](std::uint32_t, std::uint32_t, dvec3 p) { boxes[c].add(p); });
        });
        Box all;
        for (const Box& box : boxes) all.add(box);
        return all;
    }

    template <class Body>
    void for_each_cell(dvec3 p, const Body& body) const {
        const double size = distance_ * cell_width;
        std::uint64_t low[3], high[3];
        for (std::size_t a = 0; a < 3; ++a) {
            low[a] = std::uint64_t(std::fmax(0, (p[a] - origin_[a] - 0.5 * distance_) / size));
            high[a] = std::uint64_t(std::fmax(0, (p[a] - origin_[a] + 0.5 * distance_) / size));
        }
        for (std::uint64_t x = low[0]; x <= high[0]; ++x)
            for (std::uint64_t y = low[1]; y <= high[1]; ++y)
                for (std::uint64_t z = low[2]; z <= high[2]; ++z) {
                    std::uint64_t h = (x * 0x9e3779b97f4a7c15ull ^ y) * 0xbf58476d1ce4e5b9ull;
                    h = ((h ^ (h >> 31)) + z) * 0x94d049bb133111ebull;
                    body(h ^ (h >> 29));
                }
    }

    struct Pair {
        std::uint32_t a, b;
        double reach;
    };
    using Pairs = std::vector<Pair>;

    std::vector<Pairs> close_pairs() {
        std::vector<std::vector<std::vector<Entry>>> sent(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            sent[c].resize(partitions);
            for_each_place(c, [&](std::uint32_t m, std::uint32_t v, dvec3 p) {
                const std::uint32_t object = key_.object ? input_.meshes[m].object : 0;
                for_each_cell(p, [&](std::uint64_t cell) {
                    sent[c][cell % partitions].push_back({cell, p, v, m, object});
                });
            });
        });
        std::vector<Pairs> pairs(partitions);
        crowded_.assign(partitions, 0);
        context_.parallel_for(partitions, [&](std::size_t part) {
            std::vector<Entry> entries;
            UnionFind sets;
            for (const auto& chunk : sent) entries.insert(entries.end(), chunk[part].begin(), chunk[part].end());
            std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
                return std::tuple(a.cell, a.position.x, a.vertex) < std::tuple(b.cell, b.position.x, b.vertex);
            });
            for (std::size_t first = 0, last = 0; first < entries.size(); first = last) {
                while (last < entries.size() && entries[last].cell == entries[first].cell) ++last;
                if (last - first > crowded) crowded_[part] += last - first;
                else compare(std::span(entries).subspan(first, last - first), sets, pairs[part]);
            }
        });
        return pairs;
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

    void join(const std::vector<Pairs>& pairs) {
        UnionFind sets;
        sets.reset(representative_.size());
        struct Extent {
            Box box;
            double reach = 0;
        };
        std::map<std::uint32_t, Extent> extents;
        for (const Pairs& part : pairs)
            for (const Pair& pair : part) sets.join(pair.a, pair.b);
        for (const Pairs& part : pairs)
            for (const Pair& pair : part) {
                Extent& extent = extents[sets.root(pair.a)];
                extent.reach = std::max(extent.reach, pair.reach);
                for (const std::uint32_t v : {pair.a, pair.b}) {
                    const std::uint32_t m = input_.mesh_of_vertex(v);
                    extent.box.add(input_.placements[m].position(input_.meshes[m].positions[v - input_.vertex_base[m]]));
                }
            }
        std::uint64_t too_wide = 0, left = 0;
        std::erase_if(extents, [&](const auto& set) {
            const dvec3 size = set.second.box.high - set.second.box.low;
            const double widest = 2 * set.second.reach;
            const bool wide = size.x > widest || size.y > widest || size.z > widest;
            too_wide += wide;
            return wide;
        });
        for (const std::uint64_t count : crowded_) left += count;
        if (too_wide + left != 0)
            context_.report().add(Remark::warning, {}, {},
                                  std::to_string(too_wide) + " chains and " + std::to_string(left) +
                                      " crowded vertices lie too close together to be welded within a tolerance; kept exact");
        if (extents.empty()) return;
        for (std::uint32_t& r : representative_) {
            const std::uint32_t root = sets.root(r);
            if (root != r && extents.contains(root)) r = root;
        }
    }

    std::vector<std::uint32_t>& representative_;
    const AttributeInput& input_;
    WeldKey key_;
    Context& context_;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> matrix_;  // [meshes] equal numbers: equal matrices
    std::size_t matrices_ = 0;
    bool by_meshes_ = false, quantized_ = false;
    std::vector<double> reach_;          // [meshes] where the meshes set the distance
    std::vector<SharedPlace> shared_;    // sorted
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
