// SPDX-License-Identifier: Apache-2.0
// A grid of cells much wider than the distance; a place within half the distance of a cell's wall enters the neighbor too, so
// every close pair meets in some cell (about 1.4 entries a place). Wider cells would need fewer entries, but the small parts of
// a wide scene, whose diagonal sets the distance, would crowd in them.
#include "geometry/near_weld.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "geometry/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr double cell_width = 8;           // in distances
constexpr std::size_t crowded = 1024;      // places in one cell: more is no model but an attack, or a distance far too large
constexpr std::uint32_t partitions = 256;  // of the cells, by hash

struct Entry {
    std::uint64_t cell;
    dvec3 position;
    std::uint32_t vertex, matrix, object;
};

struct Box {
    dvec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(dvec3 p) {
        low = min(low, p);
        high = max(high, p);
    }
};

class NearWeld {
public:
    NearWeld(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, Context& context)
        : representative_(representative), input_(input), key_(key), context_(context),
          chunks_(make_chunks(input.vertex_base, vertices_per_chunk)) {}

    void run(double distance) {
        number_matrices();
        const double half_step = distance < 0 ? widest_half_step() : 0;
        only_between_matrices_ = distance < 0 && half_step == 0;
        if (only_between_matrices_ && matrices_ < 2) return;
        const Box box = bounds();
        const double diagonal = length(box.high - box.low);
        if (!(diagonal > 0) || !(diagonal < std::numeric_limits<float>::max())) return;
        const double rounding = 4 * (double(std::nextafter(float(diagonal), INFINITY)) - float(diagonal));
        distance_ = distance < 0 ? std::fmax(rounding, half_step) : distance;
        origin_ = box.low;
        if (!(diagonal / distance_ < 1e15)) return;  // below the rounding of the positions: exact
        if (distance_ * cell_width > diagonal) origin_ = box.low - dvec3{1, 1, 1} * distance_;
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

    // Quantized positions stand up to half a step from where they were.
    double widest_half_step() const {
        double widest = 0;
        for (std::size_t m = 0; m < input_.meshes.size(); ++m)
            widest = std::fmax(widest, 0.5 * input_.meshes[m].position_step * input_.placements[m].scale);
        return std::isfinite(widest) ? widest : 0;
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
        for (const Box& box : boxes) {
            all.low = min(all.low, box.low);
            all.high = max(all.high, box.high);
        }
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

    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    std::vector<Pairs> close_pairs() {
        std::vector<std::vector<std::vector<Entry>>> sent(chunks_.size());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            sent[c].resize(partitions);
            for_each_place(c, [&](std::uint32_t m, std::uint32_t v, dvec3 p) {
                const std::uint32_t object = key_.object ? input_.meshes[m].object : 0;
                for_each_cell(p, [&](std::uint64_t cell) {
                    sent[c][cell % partitions].push_back({cell, p, v, matrix_[m], object});
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
            for (std::size_t j = i + 1; j < cell.size() && cell[j].position.x - cell[i].position.x <= distance_; ++j) {
                const dvec3 d = cell[j].position - cell[i].position;
                const bool may = cell[i].object == cell[j].object && (!only_between_matrices_ || cell[i].matrix != cell[j].matrix);
                if (may && dot(d, d) <= distance_ * distance_ && sets.join(std::uint32_t(i), std::uint32_t(j)))
                    pairs.emplace_back(cell[i].vertex, cell[j].vertex);
            }
    }

    void join(const std::vector<Pairs>& pairs) {
        UnionFind sets;
        sets.reset(representative_.size());
        std::map<std::uint32_t, Box> extent;
        for (const Pairs& part : pairs)
            for (const auto& [a, b] : part) sets.join(a, b);
        for (const Pairs& part : pairs)
            for (const auto& [a, b] : part)
                for (const std::uint32_t v : {a, b}) {
                    const std::uint32_t m = input_.mesh_of_vertex(v);
                    extent[sets.root(v)].add(
                        input_.placements[m].position(input_.meshes[m].positions[v - input_.vertex_base[m]]));
                }
        std::uint64_t too_wide = 0, left = 0;
        const double widest = 2 * distance_;
        std::erase_if(extent, [&](const auto& set) {
            const dvec3 size = set.second.high - set.second.low;
            const bool wide = size.x > widest || size.y > widest || size.z > widest;
            too_wide += wide;
            return wide;
        });
        for (const std::uint64_t count : crowded_) left += count;
        if (too_wide + left != 0)
            context_.report().add(Remark::warning, {}, {},
                                  std::to_string(too_wide) + " chains and " + std::to_string(left) +
                                      " crowded vertices lie too close together to be welded within a tolerance; kept exact");
        if (extent.empty()) return;
        for (std::uint32_t& r : representative_) {
            const std::uint32_t root = sets.root(r);
            if (root != r && extent.contains(root)) r = root;
        }
    }

    std::vector<std::uint32_t>& representative_;
    const AttributeInput& input_;
    WeldKey key_;
    Context& context_;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> matrix_;  // [meshes] equal numbers: equal matrices
    std::size_t matrices_ = 0;
    bool only_between_matrices_ = false;
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
