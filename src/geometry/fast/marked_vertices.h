// SPDX-License-Identifier: Apache-2.0
// Some vertices of a mesh or of all, a bit for each; their ranks, and the faces at them.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/fast/fast_state.h"

namespace rakelight::geometry {

class MarkedVertices {
public:
    MarkedVertices(std::size_t vertices, std::span<const std::uint32_t> marked) : words_(vertices / 64 + 1) {
        for (const std::uint32_t v : marked) mark(v);
    }
    void mark(std::uint32_t v) { words_[v >> 6] |= std::uint64_t(1) << (v & 63); }
    bool has(std::uint32_t v) const { return (words_[v >> 6] >> (v & 63) & 1) != 0; }
    std::span<const std::uint64_t> words() const { return words_; }

private:
    std::vector<std::uint64_t> words_;
};

/// Numbers the marked vertices from 0 on, in their order.
class VertexRanks {
public:
    explicit VertexRanks(const MarkedVertices& marks) : words_(marks.words()), before_(words_.size() + 1) {
        for (std::size_t w = 0; w < words_.size(); ++w)
            before_[w + 1] = before_[w] + std::uint32_t(std::popcount(words_[w]));
    }
    std::uint32_t count() const { return before_.back(); }
    std::uint32_t rank(std::uint32_t v) const {
        return before_[v >> 6] + std::uint32_t(std::popcount(words_[v >> 6] & ((std::uint64_t(1) << (v & 63)) - 1)));
    }
    /// Ascending.
    std::vector<std::uint32_t> all() const {
        std::vector<std::uint32_t> marked;
        marked.reserve(count());
        for (std::size_t w = 0; w < words_.size(); ++w)
            for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
                marked.push_back(std::uint32_t(w * 64 + std::size_t(std::countr_zero(left))));
        return marked;
    }

private:
    std::span<const std::uint64_t> words_;
    std::vector<std::uint32_t> before_;
};

/// Faces first .. last - 1 of a mesh.
struct FaceStretch {
    std::uint32_t mesh, first, last;
};
/// Those with a vertex between the smallest and the largest of their indices.
/// @param wanted  global indices, ascending
inline std::vector<FaceStretch> stretches_with(const FastState& state, std::span<const std::uint32_t> wanted) {
    const AttributeInput& input = state.input;
    const std::vector<std::size_t>& range_base = state.scratch.range_base;
    std::vector<FaceStretch> stretches;
    for (std::uint32_t m = 0; m < input.meshes.size(); ++m) {
        const std::uint32_t faces = input.triangle_base[m + 1] - input.triangle_base[m];
        for (std::size_t r = range_base[m]; r < range_base[m + 1]; ++r) {
            const VertexRange range = state.scratch.ranges[r];
            const auto at = std::lower_bound(wanted.begin(), wanted.end(), input.vertex_base[m] + range.first);
            if (at == wanted.end() || *at > input.vertex_base[m] + range.last) continue;
            const std::uint32_t first = std::uint32_t(r - range_base[m]) * faces_per_range;
            stretches.push_back({m, first, std::min(faces, first + faces_per_range)});
        }
    }
    return stretches;
}

/// Calls body(mesh, face) for the faces of a stretch that have a marked vertex.
template <class Body>
void for_each_marked_face(const AttributeInput& input, const MarkedVertices& marks, const FaceStretch& stretch,
                          const Body& body) {
    const std::uint32_t base = input.vertex_base[stretch.mesh];
    const std::uint32_t* const index = input.meshes[stretch.mesh].indices.data();
    for (std::uint32_t t = stretch.first; t != stretch.last; ++t) {
        const std::uint32_t* const corner = index + 3 * std::size_t(t);
        if (marks.has(base + corner[0]) || marks.has(base + corner[1]) || marks.has(base + corner[2]))
            body(stretch.mesh, t);
    }
}

}  // namespace rakelight::geometry
