// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "geometry/fast/fast_scatter.h"
#include "geometry/fits/fitted_places.h"
#include "math/functions.h"

namespace rakelight::geometry {
namespace {

/// What the faces at each vertex look like from its normal.
class Looks {
public:
    static constexpr int floats = normal_row_floats;
    static constexpr bool counts_degenerate = false;
    explicit Looks(const FastState& state)
        : state_(state), hard_cosine_(hard_cosine(state.crease_rad)), bent_cosine_(bent_cosine(state)) {}

    float* data() const { return reinterpret_cast<float*>(state_.looks_at()); }
    void ready(LaneScratch&, std::uint32_t, std::uint32_t, std::uint32_t) const {}
    void set(ScatterJob& job, std::uint32_t m) const {
        job.normals = state_.out[m].normals.empty() ? nullptr : &state_.out[m].normals[0].x;
        job.hard_cosine = hard_cosine_;
        job.bent_cosine = bent_cosine_;
    }
    auto kernel() const { return state_.look_kernels.scatter; }
    // Without area, or a sliver: its place is left to the general path.
    bool add_odd(const ScatterJob&, std::uint32_t, std::uint32_t, FastParcel<floats> (&parcels)[3]) const {
        for (FastParcel<floats>& parcel : parcels) parcel.row[3] = hard_face;
        return true;
    }

private:
    /// Faces within it of a normal are joined with each other: half the crease angle, but for the rounding of float.
    static float hard_cosine(double crease_rad) {
        constexpr double slack_rad = radians(0.05), most_rad = radians(60);
        return float(math::cos(std::min(0.5 * crease_rad - slack_rad, most_rad)));
    }

    /// Every face is bent for CornerWeight::fit, and none where nothing is fitted.
    static float bent_cosine(const FastState& state) {
        if (!state.fits) return -2;
        return state.options.weight == CornerWeight::automatic ? float(mild_cosine) : 2.0f;
    }

    const FastState& state_;
    float hard_cosine_, bent_cosine_;
};

void add_classes(FastState& state) {
    std::vector<std::vector<Duplicate>>& classes = state.scratch.classes;
    LookRow* const rows = state.looks_at();
    for_each_in_lanes(state, classes.size(), [&](LaneScratch&, std::size_t t) {
        for_each_class(classes[t], [rows](std::span<const std::uint32_t> members) {
            LookRow sum{};
            for (const std::uint32_t v : members) {
                sum.ends[0] += rows[v].ends[0], sum.ends[1] += rows[v].ends[1];
                sum.turns += rows[v].turns, sum.bends += rows[v].bends;
            }
            for (const std::uint32_t v : members) rows[v] = sum;
        });
    });
}

/// Whether all faces are joined. True for vertices without faces.
bool is_calm(const LookRow& row) {
    return row.ends[0] == 0 && row.ends[1] == 0 && row.turns <= 1 && row.bends < hard_face;
}

}  // namespace

std::vector<std::uint32_t> look_at_places(FastState& state) {
    if (state.fits && state.tangents) state.scratch.looks.reserve(state.input.vertex_count());
    const Looks looks(state);
    FastScatter<Looks>(state, looks).run();
    add_classes(state);
    const std::size_t count = state.input.vertex_count(), step = vertices_per_chunk;
    std::vector<std::vector<std::uint32_t>> parts((count + step - 1) / step);
    const LookRow* const rows = state.looks_at();
    for_each_in_lanes(state, parts.size(), [&](LaneScratch&, std::size_t c) {
        for (std::size_t v = c * step; v < std::min(count, (c + 1) * step); ++v)
            if (!is_calm(rows[v])) parts[c].push_back(std::uint32_t(v));
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace rakelight::geometry
