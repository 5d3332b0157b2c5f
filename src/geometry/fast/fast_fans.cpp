// SPDX-License-Identifier: Apache-2.0
// Places where the look from the normal does not decide: their faces are walked over common edges, like
// JoinRules::is_calm().
#include "geometry/fast/fast_stages.h"

#include "geometry/fast/marked_vertices.h"
#include "geometry/groups/join_rules.h"
#include "geometry/input/face_vote.h"
#include "math/functions.h"

namespace rakelight::geometry {
namespace {

struct FanFace {
    vec3 normal;  ///< unit; zero: no area
    vec3 p[3];
};
class Fans {
public:
    Fans(FastState& state, std::span<const std::uint32_t> open)
        : state_(state),
          input_(state.input),
          marks_(state.input.vertex_count(), open),
          ranks_(marks_),
          open_(open),
          place_of_(open.size()),
          least_cosine_(float(math::cos(state.crease_rad)) + slack) {}

    ~Fans() {
        GeneralScratch& scratch = state_.scratch.general;
        scratch.give(faces_), scratch.give(places_), scratch.give(corners_);
    }
    Fans(const Fans&) = delete;
    Fans& operator=(const Fans&) = delete;

    /// Ascending vertices of places that stay open.
    std::vector<std::uint32_t> run() {
        number_places();
        const std::vector<FaceStretch> stretches = stretches_with(state_, open_);
        const std::vector<std::uint32_t> first = count_faces(stretches);
        state_.context.parallel_for(stretches.size(), [&](std::size_t s) { read(stretches[s], first[s]); });
        sort_corners(first.back());
        std::vector<std::uint8_t> is_joined(open_.size());
        constexpr std::size_t step = 1u << 12;
        state_.context.parallel_for((open_.size() + step - 1) / step, [&](std::size_t c) {
            for (std::size_t p = c * step; p < std::min(open_.size(), (c + 1) * step); ++p)
                is_joined[p] = is_one_fan(std::uint32_t(p)) ? 1 : 0;
        });
        std::vector<std::uint32_t> left;
        for (std::size_t i = 0; i < open_.size(); ++i)
            if (is_joined[place_of_[i]] == 0) left.push_back(open_[i]);
        return left;
    }

private:
    static constexpr float slack = 1e-5f;  // what float could decide otherwise than double stays open
    static constexpr std::size_t most = 16;
    static constexpr std::uint32_t none = 0xffffffffu;

    /// Members of a class have the number of the smallest one.
    void number_places() {
        for (std::uint32_t i = 0; i < open_.size(); ++i) place_of_[i] = i;
        for (const std::vector<Duplicate>& classes : state_.scratch.classes)
            for_each_class(classes, [&](std::span<const std::uint32_t> members) {
                if (!marks_.has(members[0])) return;
                for (const std::uint32_t v : members) place_of_[ranks_.rank(v)] = ranks_.rank(members[0]);
            });
    }

    /// [stretches + 1] Where the faces of each begin in faces_.
    std::vector<std::uint32_t> count_faces(const std::vector<FaceStretch>& stretches) {
        std::vector<std::uint32_t> first(stretches.size() + 1);
        state_.context.parallel_for(stretches.size(), [&](std::size_t s) {
            for_each_marked_face(input_, marks_, stretches[s], [&](std::uint32_t, std::uint32_t) { ++first[s + 1]; });
        });
        for (std::size_t s = 0; s < stretches.size(); ++s) first[s + 1] += first[s];
        state_.context.memory().check(first.back() * (sizeof(FanFace) + 6 * sizeof(std::uint32_t)), "faces at creases");
        faces_ = state_.scratch.general.take<FanFace>(first.back());
        places_ = state_.scratch.general.take<std::uint32_t>(3 * std::size_t(first.back()));
        return first;
    }

    void read(const FaceStretch& stretch, std::uint32_t first) {
        const std::uint32_t base = input_.vertex_base[stretch.mesh];
        const AttributeMesh& mesh = input_.meshes[stretch.mesh];
        FanFace* face = faces_.data() + first;
        std::uint32_t* place = places_.data() + 3 * std::size_t(first);
        for_each_marked_face(input_, marks_, stretch, [&](std::uint32_t, std::uint32_t t) {
            const std::uint32_t* const index = mesh.indices.data() + 3 * std::size_t(t);
            const FaceCorners corners = face_corners(mesh, index);
            face->normal = cast<float>(direction_of(cross(corners.e1, corners.e2)).unit);
            for (std::size_t k = 0; k < 3; ++k) {
                face->p[k] = mesh.positions[index[k]];
                *place++ = marks_.has(base + index[k]) ? place_of_[ranks_.rank(base + index[k])] : none;
            }
            ++face;
        });
    }

    /// By place, in the order of the faces.
    void sort_corners(std::uint32_t faces) {
        begin_.assign(open_.size() + 2, 0);
        for (std::size_t c = 0; c < 3 * std::size_t(faces); ++c)
            if (places_[c] != none) ++begin_[places_[c] + 2];
        for (std::size_t p = 0; p <= open_.size(); ++p) begin_[p + 1] += begin_[p];
        corners_ = state_.scratch.general.take<std::uint32_t>(begin_.back());
        for (std::size_t c = 0; c < 3 * std::size_t(faces); ++c)
            if (places_[c] != none) corners_[begin_[places_[c] + 1]++] = std::uint32_t(c);
    }

    struct FanCorner {
        const vec3 *normal, *next, *previous;
    };

    /// Whether the faces of a place are one chain over common edges, each within the crease angle of the one before.
    bool is_one_fan(std::uint32_t place) const {
        const std::size_t count = begin_[place + 1] - begin_[place];
        if (count > most) return false;
        FanCorner fan[most];
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t corner = corners_[begin_[place] + i], k = corner % 3;
            const FanFace& face = faces_[corner / 3];
            if (face.normal == vec3{}) return false;
            fan[i] = {&face.normal, &face.p[(k + 1) % 3], &face.p[(k + 2) % 3]};
            if (!(dot(*fan[i].normal, *fan[0].normal) >= float(looks_away) + slack)) return false;
        }
        std::size_t met = count > 0 ? 1 : 0;
        for (const bool forwards : {true, false})
            for (std::size_t at = 0; met < count;) {
                const vec3 end = forwards ? *fan[at].next : *fan[at].previous;
                std::size_t j = met;
                while (j < count && !((forwards ? *fan[j].previous : *fan[j].next) == end)) ++j;
                if (j == count || !(dot(*fan[at].normal, *fan[j].normal) >= least_cosine_)) break;
                std::swap(fan[j], fan[met]);
                at = met++;
            }
        return met == count;
    }

    FastState& state_;
    const AttributeInput& input_;
    MarkedVertices marks_;
    VertexRanks ranks_;
    std::span<const std::uint32_t> open_;
    std::vector<std::uint32_t> place_of_;  // [open] index in open
    float least_cosine_;
    BlockArray<FanFace> faces_;
    BlockArray<std::uint32_t> places_;   // [3 * faces_] or none
    std::vector<std::uint32_t> begin_;   // [open + 2] of corners_; the last two are equal
    BlockArray<std::uint32_t> corners_;  // 3 * face + corner
};

}  // namespace

std::vector<std::uint32_t> walk_fans(FastState& state, std::span<const std::uint32_t> open) {
    return Fans(state, open).run();
}

}  // namespace rakelight::geometry
