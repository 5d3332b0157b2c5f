// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/spokes.h"

#include <algorithm>
#include <bit>

namespace rakelight::geometry {
namespace {

constexpr double most_bend_rad = radians(0.02);

bool are_flat(const GroupFace& a, const GroupFace& b) {
    constexpr float least_cosine = 0.9997f;  // within which the slack of two faces can bring them
    if (!(dot(a.normal, b.normal) > least_cosine)) return false;
    const vec3 across = cross(a.normal, b.normal);
    const float most = float(most_bend_rad) + a.slack_rad + b.slack_rad;
    return dot(across, across) < most * most;
}

}  // namespace

void Spokes::read(const GroupRings& rings, std::uint32_t group) {
    const std::span<const std::uint32_t> corners = rings.corners[group];
    if (const std::size_t most = std::max<std::size_t>(corners.size(), few); face_.size() < most)
        face_.resize(most), next_.resize(most), previous_.resize(most);
    group_ = group, count_ = 0, sum_ = squares_ = 0;
    for (const std::uint32_t corner : corners) {
        const std::uint32_t face = corner / 3, k = corner - 3 * face;
        if (!rings.is_face(face)) continue;
        const std::uint32_t* const at = rings.group_of_corner.data() + 3 * std::size_t(face);
        std::uint32_t next = at[k == 2 ? 0 : k + 1], previous = at[k == 0 ? 2 : k - 1];
        if (rings.faces[face].is_mirrored) std::swap(next, previous);
        face_[count_] = face, next_[count_] = next, previous_[count_] = previous;
        ++count_;
        sum_ += std::uint64_t(next) - previous;
        squares_ += std::uint64_t(next) * next - std::uint64_t(previous) * previous;
    }
    if (count_ <= few) match();
}

// Without branches, because in no mesh they could be foretold.
void Spokes::match() {
    const std::uint32_t all = (1u << count_) - 1;
    std::uint32_t met = 0, unlike = 0;
    for (std::uint32_t i = 0; i < count_; ++i) {
        std::uint32_t bits = 0;
        for (std::uint32_t j = 0; j < few; ++j) bits |= std::uint32_t(previous_[j] == next_[i]) << j;
        bits &= all;
        matches_[i] = bits;
        met |= bits;
        unlike |= (bits & (bits - 1)) | std::uint32_t(next_[i] == group_);
    }
    closes_ = unlike == 0 && met == all;
}

void Spokes::put_ring(std::vector<std::uint32_t>& to) const {
    constexpr std::uint32_t most_searched = 64;
    const std::size_t first = to.size();
    const std::span<const std::uint32_t> next(next_.data(), count_), previous(previous_.data(), count_);
    if (count_ <= few && closes_) {
        to.insert(to.end(), next.begin(), next.end());
        return;
    }
    for (const std::span<const std::uint32_t> side : {next, previous})
        for (const std::uint32_t other : side) {
            if (other == group_) continue;
            if (count_ > most_searched || std::find(to.begin() + std::ptrdiff_t(first), to.end(), other) == to.end())
                to.push_back(other);
        }
    if (count_ <= most_searched) return;
    std::sort(to.begin() + std::ptrdiff_t(first), to.end());
    to.erase(std::unique(to.begin() + std::ptrdiff_t(first), to.end()), to.end());
}

void Spokes::put_flat_pairs(const GroupRings& rings, std::vector<FacePair>& to) {
    if (count_ > few) return put_any_pairs(rings, to);
    for (std::uint32_t i = 0; i < count_; ++i)
        for (std::uint32_t bits = matches_[i]; bits != 0; bits &= bits - 1) {
            const std::uint32_t a = face_[i], b = face_[std::uint32_t(std::countr_zero(bits))];
            if (are_flat(rings.faces[a], rings.faces[b]) && next_[i] > group_) to.emplace_back(a, b);
        }
}

void Spokes::put_any_pairs(const GroupRings& rings, std::vector<FacePair>& to) {
    constexpr std::ptrdiff_t most_at_edge = 64;
    ahead_.clear(), behind_.clear();
    for (std::uint32_t i = 0; i < count_; ++i) {
        if (next_[i] > group_) ahead_.emplace_back(next_[i], face_[i]);
        if (previous_[i] > group_) behind_.emplace_back(previous_[i], face_[i]);
    }
    std::sort(behind_.begin(), behind_.end());
    for (const FacePair& a : ahead_) {
        const auto first = std::lower_bound(behind_.begin(), behind_.end(), FacePair{a.first, 0});
        const auto last = std::upper_bound(first, behind_.end(), FacePair{a.first, 0xffffffffu});
        if (last - first > most_at_edge) continue;
        for (auto b = first; b != last; ++b)
            if (are_flat(rings.faces[a.second], rings.faces[b->second])) to.emplace_back(a.second, b->second);
    }
}

}  // namespace rakelight::geometry
