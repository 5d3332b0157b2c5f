// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_stages.h"

#include <cmath>
#include <cstring>

#include "base/atomic_ref.h"

namespace rakelight::geometry {
namespace {

// Stricter than the finish, which gets the sums accepted here.
constexpr float stricter = 1.01f, class_normal_share = weak_normal_share * stricter;
constexpr float cos_45 = 0.70710678f, cos_margin = 1e-4f;
constexpr float cos_margin_of_fits = 0.25f;  // whose normals are not yet known
constexpr std::size_t max_members = 16;      // for pairwise comparison of tangents; larger classes use the general path

struct TangentRow8 {
    vec3 normal;
    float hand;
    vec3 tangent;
    float weight;
};
static_assert(sizeof(TangentRow8) == tangent_row_floats * sizeof(float));

class ClassJoin {
public:
    ClassJoin(FastState& state, std::span<const std::uint32_t> members) : state_(state), members_(members) {}

    void run() {
        const std::size_t count = members_.size();
        vec3 normal;
        float weight = 0;
        std::size_t silent = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const float* row = state_.row(members_[i]);
            normal += vec3{row[0], row[1], row[2]};
            weight += row[state_.floats() - 1];
            silent += row[state_.floats() - 1] == 0;
        }
        if (weight == 0) return;
        if (silent != 0) count_isolated();
        const bool is_weak = !(dot(normal, normal) >= weight * weight * class_normal_share * class_normal_share);
        const bool is_left = is_weak || (state_.tangents && !join_tangents(normal * (1 / length(normal))));
        for (std::size_t i = 0; i < count; ++i) {
            float* row = state_.row(members_[i]);
            std::memcpy(row, &normal, sizeof normal);  // those that are left, too: looks begin from one normal
            if (is_left) {
                row[state_.floats() - 1] = -1;
                continue;
            }
            // The finish compares hand with weight; the tangents of this class are already checked.
            float& own = row[state_.floats() - 1];
            own = state_.tangents && row[3] != 0 ? std::fabs(row[3]) : weight;
        }
    }

private:
    void count_isolated() const {
        for (const std::uint32_t v : members_)
            if (state_.row(v)[state_.floats() - 1] == 0)
                atomic_ref(state_.isolated[state_.input.mesh_of_vertex(v)]).fetch_add(1, std::memory_order_relaxed);
    }

    // False: undecidable in float.
    bool join_tangents(vec3 n) const {
        const std::size_t count = members_.size();
        if (count > max_members) return false;
        TangentRow8* rows[max_members];
        vec3 direction[max_members];
        std::size_t set[max_members];
        for (std::size_t i = 0; i < count; ++i) {
            rows[i] = reinterpret_cast<TangentRow8*>(state_.row(members_[i]));
            set[i] = i;
            if (rows[i]->hand == 0 && !state_.is_textured(state_.input.mesh_of_vertex(members_[i]))) continue;
            if (rows[i]->hand == 0 || std::fabs(rows[i]->hand) != rows[i]->weight) return false;
            direction[i] = across(n, rows[i]->tangent);
            if (is_weak(direction[i], rows[i]->hand)) return false;
            direction[i] = direction[i] * (1 / length(direction[i]));
        }
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = a + 1; b < count; ++b) {
                if (!(rows[a]->hand * rows[b]->hand > 0)) continue;
                const float cosine = dot(direction[a], direction[b]);
                if (std::fabs(cosine - cos_45) < (state_.fits ? cos_margin_of_fits : cos_margin)) return false;
                if (cosine > cos_45) join(set, count, set[a], set[b]);
            }
        return add_sets(n, rows, set, count);
    }

    static void join(std::size_t* set, std::size_t count, std::size_t a, std::size_t b) {
        const std::size_t low = std::min(a, b), high = std::max(a, b);
        for (std::size_t i = 0; i < count; ++i)
            if (set[i] == high) set[i] = low;
    }

    bool add_sets(vec3 n, TangentRow8* const* rows, const std::size_t* set, std::size_t count) const {
        vec3 tangent[max_members];
        float hand[max_members] = {};
        for (std::size_t i = 0; i < count; ++i) {
            tangent[set[i]] += rows[i]->tangent;
            hand[set[i]] += rows[i]->hand;
        }
        for (std::size_t i = 0; i < count; ++i)
            if (hand[i] != 0 && is_weak(across(n, tangent[i]), hand[i])) return false;
        for (std::size_t i = 0; i < count; ++i) {
            rows[i]->tangent = tangent[set[i]];
            rows[i]->hand = hand[set[i]];
        }
        return true;
    }

    static vec3 across(vec3 n, vec3 t) { return t - n * dot(n, t); }
    bool is_weak(vec3 t, float hand) const {
        const float least = hand * state_.weak_tangent() * stricter;
        return !(dot(t, t) >= least * least);
    }

    FastState& state_;
    std::span<const std::uint32_t> members_;  // ascending: sums are made in this order
};

}  // namespace

void join_classes(FastState& state, std::vector<Duplicate>& duplicates) {
    std::sort(duplicates.begin(), duplicates.end(), [](const Duplicate& a, const Duplicate& b) {
        return a.winner != b.winner ? a.winner < b.winner : a.vertex < b.vertex;
    });
    for (const Duplicate& d : duplicates) {
        __builtin_prefetch(state.row(d.winner), 1);
        __builtin_prefetch(state.row(d.vertex), 1);
    }
    for_each_class(duplicates, [&](std::span<const std::uint32_t> members) { ClassJoin(state, members).run(); });
}

}  // namespace rakelight::geometry
