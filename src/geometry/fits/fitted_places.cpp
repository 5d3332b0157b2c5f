// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/fitted_places.h"

#include <algorithm>
#include <atomic>

namespace rakelight::geometry {
namespace {

/// The same at open borders and creases, outside of which the surface goes on. Unit vectors of float are too long or too
/// short by as much as the cosine of this angle differs from 1, so that it is compared as a sine.
constexpr double flat_sine = radians(0.02);

class Finder {
public:
    Finder(const FitInput& from, GeneralScratch& scratch, Context& context)
        : from_(from), topology_(from.topology), scratch_(scratch), context_(context) {}

    FittedPlaces run() {
        std::vector<std::uint8_t> near_fits = groups_near_fits();
        if (!find_neighbors(near_fits)) {
            out_.release(scratch_);
            find_neighbors({});
        }
        return std::move(out_);
    }

private:
    dvec3 by_max(std::uint32_t g) const { return cast<double>(from_.by_max[g]); }

    /// [groups] Those that are not mild, and their neighbors: all that is asked for corners. Empty: all.
    std::vector<std::uint8_t> groups_near_fits() const {
        std::vector<std::uint8_t> marks;
        if (from_.spread.empty()) return marks;
        const AttributeInput& input = from_.input;
        marks.assign(topology_.group.size(), 0);
        const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
        context_.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_range(
                chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                    for (std::uint32_t t = input.triangle_base[m] + first; t != input.triangle_base[m] + last; ++t)
                        mark_around(m, t, marks);
                });
        });
        return marks;
    }
    void mark_around(std::uint32_t m, std::uint32_t triangle, std::vector<std::uint8_t>& marks) const {
        std::uint32_t vertex[3];
        bool is_near = false;
        for (std::uint32_t k = 0; k < 3; ++k) {
            vertex[k] = topology_.vertex_of(from_.input, m, 3 * triangle + k);
            is_near |= from_.spread[vertex[k]] != Spread::mild;
        }
        if (!is_near) return;
        for (const std::uint32_t v : vertex)
            std::atomic_ref(marks[topology_.group[v]]).store(1, std::memory_order_relaxed);
    }

    /// Faces, rings and planes.
    /// @param near_fits  where; empty: everywhere
    /// @return false: a plane of a fitted place reaches farther
    bool find_neighbors(std::span<const std::uint8_t> near_fits) {
        out_.rings = group_faces(topology_, from_.input, near_fits, scratch_, context_);
        out_.groups = groups_to_fit(near_fits);
        out_.rings.ring_begin = scratch_.take_words(), out_.rings.ring_size = scratch_.take_words();
        add_rings(out_.rings, topology_, with_neighbors(), context_);
        if (!from_.is_automatic || out_.groups.empty()) return true;
        out_.planes = face_planes(out_.rings, topology_, from_.input.triangle_count(), near_fits, scratch_, context_);
        return near_fits.empty() || std::none_of(out_.groups.begin(), out_.groups.end(), [&](std::uint32_t g) {
                   return out_.planes.has_open(out_.rings.corners[g]);
               });
    }

    /// Of groups, in any order.
    struct Tally {
        std::uint64_t sum = 0, squares = 0;
        void add(std::uint64_t group) { sum += group, squares += group * group; }
        bool operator==(const Tally&) const = default;
    };

    /// By the weight of Max the normal would be off by more than a little.
    bool needs_fit(std::uint32_t g) const {
        const std::span<const std::uint32_t> corners = out_.rings.corners[g];
        if (corners.empty()) return false;
        const dvec3 n = by_max(g);
        double least = 1, most_across = 0;
        std::uint32_t faces = 0;
        Tally ahead, behind;  // equal where faces go around
        for (const std::uint32_t corner : corners) {
            if (!out_.rings.is_face(corner / 3)) continue;
            const dvec3 face = out_.rings.normal(corner / 3), across = cross(face, n);
            least = std::min(least, dot(face, n)), most_across = std::max(most_across, dot(across, across));
            ++faces;
            ahead.add(out_.rings.next(corner)), behind.add(out_.rings.previous(corner));
        }
        if (!from_.is_automatic || !(least > mild_cosine) || (faces == 1 && is_tip(corners))) return true;
        return ahead != behind && !(most_across < flat_sine * flat_sine);
    }
    /// Whether a surface goes on from the only face at a group.
    bool is_tip(std::span<const std::uint32_t> corners) const {
        std::size_t around = 0;
        for (const std::uint32_t corner : corners)
            if (out_.rings.is_face(corner / 3))
                around += out_.rings.corners.size(out_.rings.next(corner)) +
                          out_.rings.corners.size(out_.rings.previous(corner));
        return around > 4;
    }
    /// Ascending.
    std::vector<std::uint32_t> groups_to_fit(std::span<const std::uint8_t> near_fits) const {
        const std::size_t count = topology_.group.size(), step = vertices_per_chunk;
        std::vector<std::vector<std::uint32_t>> parts((count + step - 1) / step);
        context_.parallel_for(parts.size(), [&](std::size_t c) {
            for_each_group(topology_, c * step, std::min(count, (c + 1) * step), [&](std::uint32_t g) {
                const Spread spread = from_.spread.empty() ? Spread::unknown : from_.spread[g];
                if (spread == Spread::mild || (!near_fits.empty() && near_fits[g] == 0)) return;
                if (spread == Spread::wide || needs_fit(g)) parts[c].push_back(g);
            });
        });
        std::vector<std::uint32_t> all;
        for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

    /// [groups] marks of the fitted ones and of their neighbors.
    std::vector<std::uint8_t> with_neighbors() {
        std::vector<std::uint8_t> marks(topology_.group.size(), 0);
        const auto mark = [&](std::uint32_t g) { std::atomic_ref(marks[g]).store(1, std::memory_order_relaxed); };
        const std::size_t count = out_.groups.size(), step = 1u << 12;
        context_.parallel_for((count + step - 1) / step, [&](std::size_t c) {
            for (std::size_t i = c * step; i < std::min(count, (c + 1) * step); ++i) {
                mark(out_.groups[i]);
                for (const std::uint32_t corner : out_.rings.corners[out_.groups[i]])
                    mark(out_.rings.next(corner)), mark(out_.rings.previous(corner));
            }
        });
        return marks;
    }

    const FitInput& from_;
    const Topology& topology_;
    GeneralScratch& scratch_;
    Context& context_;
    FittedPlaces out_;
};

}  // namespace

void FittedPlaces::release(GeneralScratch& scratch) {
    rings.release(scratch);
    scratch.give(planes.plane_of);
    planes = {}, groups.clear();
}

FittedPlaces find_fitted_places(const FitInput& from, GeneralScratch& scratch, Context& context) {
    return Finder(from, scratch, context).run();
}

}  // namespace rakelight::geometry
