// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/fitted_places.h"

#include <algorithm>
#include <atomic>

#include "base/atomic_ref.h"

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
        for (const std::uint32_t v : vertex) atomic_ref(marks[topology_.group[v]]).store(1, std::memory_order_relaxed);
    }

    /// Faces, rings and planes.
    /// @param near_fits  where; empty: everywhere
    /// @return false: a plane of a fitted place reaches farther
    bool find_neighbors(std::span<const std::uint8_t> near_fits) {
        out_.rings = group_faces(topology_, from_.input, near_fits, scratch_, context_);
        const std::vector<std::vector<Spokes::FacePair>> pairs = read_spokes(near_fits);
        if (!from_.is_automatic || out_.places.empty()) return true;
        out_.planes = face_planes(out_.rings, pairs, from_.input.triangle_count(), near_fits, scratch_, context_);
        return near_fits.empty() || !out_.planes.has_open() ||
               std::none_of(out_.places.begin(), out_.places.end(), [&](const FittedPlace& place) {
                   return out_.planes.has_open(out_.rings.corners[place.group]);
               });
    }

    using FacePairs = std::vector<Spokes::FacePair>;

    /// Rings and fitted places. @return [chunks] flat faces that share an edge
    std::vector<FacePairs> read_spokes(std::span<const std::uint8_t> near_fits) {
        const std::size_t count = topology_.group.size(),
                          chunks = (count + vertices_per_chunk - 1) / vertices_per_chunk;
        out_.rings.ring_begin = scratch_.take_words(), out_.rings.ring_size = scratch_.take_words();
        out_.rings.ring_begin.assign(count, 0), out_.rings.ring_size.assign(count, 0);
        out_.rings.ring_members.resize(chunks);
        std::vector<FacePairs> pairs(chunks);
        std::vector<std::vector<FittedPlace>> parts(chunks);
        context_.parallel_for(chunks, [&](std::size_t c) { read_spokes(c, near_fits, pairs[c], parts[c]); });
        std::size_t sum = 0;
        for (const auto& part : parts) sum += part.size();
        context_.memory().check(sum * sizeof(FittedPlace), "fitting normals");
        out_.places.reserve(sum);
        for (const auto& part : parts) out_.places.insert(out_.places.end(), part.begin(), part.end());
        return pairs;
    }
    void read_spokes(std::size_t chunk, std::span<const std::uint8_t> near_fits, FacePairs& pairs,
                     std::vector<FittedPlace>& places) {
        GroupRings& rings = out_.rings;
        const std::size_t first = chunk * vertices_per_chunk,
                          last = std::min(topology_.group.size(), first + vertices_per_chunk);
        Spokes spokes;
        std::vector<std::uint32_t>& members = rings.ring_members[chunk];
        members.reserve(rings.corners.begin[last] - rings.corners.begin[first] + (last - first));
        for_each_group(topology_, first, last, [&](std::uint32_t g) {
            if (!near_fits.empty() && near_fits[g] == 0) return;
            spokes.read(rings, g);
            rings.ring_begin[g] = std::uint32_t(members.size());
            spokes.put_ring(members);
            rings.ring_size[g] = std::uint32_t(members.size()) - rings.ring_begin[g];
            if (from_.is_automatic) spokes.put_flat_pairs(rings, pairs);
            const Spread spread = from_.spread.empty() ? Spread::unknown : from_.spread[g];
            if (spread == Spread::wide || (spread == Spread::unknown && needs_fit(g, spokes)))
                places.push_back({g, rings.ring_size[g] > spokes.count(), place_faces(rings, spokes)});
        });
    }

    /// By the weight of Max the normal would be off by more than a little.
    bool needs_fit(std::uint32_t g, const Spokes& spokes) const {
        if (spokes.count() == 0) return false;
        const dvec3 n = by_max(g);
        double least = 1, most_across = 0;
        for (std::uint32_t i = 0; i < spokes.count(); ++i) {
            const dvec3 face = out_.rings.normal(spokes.face(i)), across = cross(face, n);
            least = std::min(least, dot(face, n)), most_across = std::max(most_across, dot(across, across));
        }
        if (!from_.is_automatic || !(least > mild_cosine) || (spokes.count() == 1 && is_tip(g))) return true;
        return !spokes.goes_around() && !(most_across < flat_sine * flat_sine);
    }
    /// Whether a surface goes on from the only face at a group.
    bool is_tip(std::uint32_t g) const {
        std::size_t around = 0;
        for (const std::uint32_t corner : out_.rings.corners[g])
            if (out_.rings.is_face(corner / 3))
                around += out_.rings.corners.size(out_.rings.next(corner)) +
                          out_.rings.corners.size(out_.rings.previous(corner));
        return around > 4;
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
    planes = {}, places.clear();
}

FittedPlaces find_fitted_places(const FitInput& from, GeneralScratch& scratch, Context& context) {
    return Finder(from, scratch, context).run();
}

}  // namespace rakelight::geometry
