// SPDX-License-Identifier: Apache-2.0
#include "geometry/groups/join_rules.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/input/circular_order.h"
#include "math/functions.h"

namespace rakelight::geometry {
namespace {

// "At most c, inclusive": a hexagonal prism with c = 60 degrees must not break up by the rounding of its float positions.
constexpr double crease_slack = 1e-5;
// Sides of a shell: a neighbor beyond this angle (177 degrees) is on the other side.
constexpr double turned_back = -0.9986;
// Up to this number, pairs are compared directly.
constexpr std::size_t few = 16;

bool is_hinted(const AttributeMesh& mesh) { return mesh.smoothing.empty() && !mesh.smoothing_hint.empty(); }
bool is_grouped(const AttributeMesh& mesh) { return !mesh.smoothing.empty() && mesh.group_kind != GroupKind::none; }

}  // namespace

double crease_cosine(double crease_angle_rad) {
    const double limit = crease_angle_rad + crease_slack;
    return limit >= pi ? -2 : math::cos(limit);
}

JoinRules::JoinRules(const AttributeInput& input, const Topology& topology, const AttributeOptions& options,
                     JoinRule rule, const FaceNormals& normals, const CreaseEdges* creases)
    : input_(input),
      places_(topology.places->data()),
      normals_(normals.data()),
      creases_(creases),
      rule_(rule),
      groups_across_(options.groups_across) {
    const CreaseRange range = crease_range(input.meshes, options);
    min_cos_ = crease_cosine(range.least);
    joins_all_ = min_cos_ == -2 && !options.fans && !creases_;
    joins_some_ = crease_cosine(range.most) == -2 && !options.fans && !creases_;
    if (range.least != range.most)
        for (const AttributeMesh& mesh : input.meshes) own_cos_.push_back(crease_cosine(crease_angle(mesh, options)));
    for (const AttributeMesh& mesh : input.meshes) {
        has_own_angles_ |= mesh.crease_angle_rad >= 0;
        joins_some_ |=
            creases_ && !options.fans && mesh.crease_angle_rad >= 0 && crease_cosine(mesh.crease_angle_rad) == -2;
        has_hints_ |= is_hinted(mesh);
        has_groups_ |= is_hinted(mesh) || is_grouped(mesh);
    }
}

std::uint64_t JoinRules::authority_of(std::uint32_t m) const {
    const AttributeMesh& mesh = input_.meshes[m];
    if (rule_ != JoinRule::crease) return 0;
    if (is_hinted(mesh)) return std::uint64_t(mesh.object) << 2 | 3;
    if (!is_grouped(mesh)) return 0;
    const std::uint64_t kind = mesh.group_kind == GroupKind::masks ? 1 : 2;
    return (groups_across_ ? 1ull << 40 : std::uint64_t(mesh.object) << 2) | kind;
}

// A place of few faces, on the stack.
struct JoinRules::CalmFan {
    static constexpr std::size_t most = 16;
    std::size_t size = 0;
    std::uint32_t corner[most], next[most], previous[most];
    const dvec3* normal[most];
};

bool JoinRules::gather_calm(std::span<const std::uint32_t> corners, std::uint32_t& mesh, CalmFan& fan) const {
    constexpr std::uint32_t after[] = {1, 2, 0};
    fan.size = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t triangle = corners[i] / 3, k = corners[i] - 3 * triangle;
        if (triangle < input_.triangle_base[mesh] || triangle >= input_.triangle_base[mesh + 1])
            mesh = input_.mesh_of_triangle(triangle);
        const std::uint32_t* const face =
            input_.meshes[mesh].indices.data() + 3 * std::size_t(triangle - input_.triangle_base[mesh]);
        const std::uint32_t* const places = places_ + input_.vertex_base[mesh];
        fan.corner[i] = corners[i];
        fan.next[i] = places[face[after[k]]];
        fan.previous[i] = places[face[after[after[k]]]];
        fan.normal[i] = normals_ + triangle;
        if (*fan.normal[i] == dvec3{} || !(dot(*fan.normal[i], *fan.normal[0]) >= looks_away)) return false;
    }
    return true;
}

// Whether an edge is soft and has no other faces than two. @param forwards  the edge from the first face's corner
bool JoinRules::is_plainly_soft(std::uint32_t corner, std::uint32_t other, bool forwards) const {
    return creases_->is_plainly_soft(forwards ? corner : corner_before(corner)) &&
           creases_->is_plainly_soft(forwards ? corner_before(other) : other);
}

bool JoinRules::is_calm(std::span<const std::uint32_t> corners, std::uint32_t& mesh) const {
    CalmFan fan;
    if (rule_ != JoinRule::crease || has_groups_ || joins_all_ || (creases_ && has_own_angles_) ||
        corners.size() > CalmFan::most)
        return false;
    if (!gather_calm(corners, mesh, fan)) return false;
    // Walks from the first face in one direction, then in the other; visited faces move to the front.
    std::size_t met = 1;
    for (const bool forwards : {true, false}) {
        const std::uint32_t* const ahead = forwards ? fan.next : fan.previous;
        std::uint32_t* const behind = forwards ? fan.previous : fan.next;
        for (std::size_t at = 0; met < fan.size;) {
            std::size_t j = met;
            while (j < fan.size && behind[j] != ahead[at]) ++j;
            if (j == fan.size || !(dot(*fan.normal[at], *fan.normal[j]) >= min_cos_)) break;
            if (creases_ && !is_plainly_soft(fan.corner[at], fan.corner[j], forwards)) break;
            std::swap(fan.corner[j], fan.corner[met]);
            std::swap(fan.next[j], fan.next[met]);
            std::swap(fan.previous[j], fan.previous[met]);
            std::swap(fan.normal[j], fan.normal[met]);
            at = met++;
        }
    }
    return met == fan.size;
}

void JoinRules::gather(std::span<const std::uint32_t> corners, Fan& fan) const {
    const std::size_t count = corners.size();
    fan.corner.assign(corners.begin(), corners.end());
    fan.mesh.resize(count);
    fan.normal.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t triangle = corners[i] / 3;
        const bool as_before = i > 0 && triangle < input_.triangle_base[fan.mesh[i - 1] + 1];  // corners ascend
        fan.mesh[i] = as_before ? fan.mesh[i - 1] : input_.mesh_of_triangle(triangle);
        fan.normal[i] = normals_[triangle];
    }
    fan.authority.assign(count, 0);
    if (has_groups_) gather_groups(fan);
}

void JoinRules::gather_groups(Fan& fan) const {
    const std::size_t count = fan.size();
    fan.group.assign(count, 0);
    fan.kind.assign(count, GroupKind::none);
    fan.hint.resize(has_hints_ ? count : 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t m = fan.mesh[i], corner = fan.corner[i] - 3 * input_.triangle_base[m];
        const AttributeMesh& mesh = input_.meshes[m];
        fan.authority[i] = authority_of(m);
        if (fan.authority[i] == 0) continue;
        if (is_hinted(mesh)) {
            fan.hint[i] = mesh.smoothing_hint[corner] + vec3{};
        } else {
            fan.group[i] = mesh.smoothing[corner / 3];
            fan.kind[i] = mesh.group_kind;
        }
    }
}

void JoinRules::join(Fan& fan, UnionFind& sets) const {
    sets.reset(fan.size());
    if (rule_ == JoinRule::apart || fan.size() < 2) return;
    if (rule_ == JoinRule::crease && (joins_all_ || joins_some_)) join_everything(fan, sets);
    gather_places(fan);
    if (fan.size() <= few && creases_)
        join_pairs_by_rule(fan, sets);
    else if (fan.size() <= few)
        join_pairs(fan, sets);
    else
        join_edges(fan, sets);
    if (has_hints_ && rule_ == JoinRule::crease) join_hints(fan, sets);
}

void JoinRules::gather_places(Fan& fan) const {
    constexpr std::uint32_t after[] = {1, 2, 0};
    fan.next.resize(fan.size());
    fan.previous.resize(fan.size());
    for (std::size_t i = 0; i < fan.size(); ++i) {
        const std::uint32_t k = fan.corner[i] % 3, m = fan.mesh[i];
        const std::uint32_t* const face =
            input_.meshes[m].indices.data() + (fan.corner[i] - k - 3 * input_.triangle_base[m]);
        const std::uint32_t* const places = places_ + input_.vertex_base[m];
        fan.next[i] = places[face[after[k]]];
        fan.previous[i] = places[face[after[after[k]]]];
    }
}

// Compares all pairs, which is faster than sorting edges for few faces.
void JoinRules::join_pairs(const Fan& fan, UnionFind& sets) const {
    const std::uint32_t count = std::uint32_t(fan.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = fan.next[i], previous = fan.previous[i];
        for (std::uint32_t j = i + 1; j < count; ++j) {
            const bool opposite = next == fan.previous[j] || previous == fan.next[j];
            const bool alike = next == fan.next[j] || previous == fan.previous[j];
            if (!(opposite || (alike && rule_ == JoinRule::crease))) continue;
            if (fan.votes(i) && fan.votes(j) && joined(fan, i, j)) sets.join(i, j);
        }
    }
}

void JoinRules::join_pairs_by_rule(const Fan& fan, UnionFind& sets) const {
    for (std::uint32_t i = 0; i < fan.size(); ++i)
        for (std::uint32_t j = i + 1; j < fan.size(); ++j) {
            if (!fan.votes(i) || !fan.votes(j)) continue;
            for (const bool out : {true, false})
                for (const bool other_out : {true, false}) {
                    const std::uint32_t end = out ? fan.next[i] : fan.previous[i];
                    if (end != (other_out ? fan.next[j] : fan.previous[j])) continue;
                    if (joined(fan, {end, i, out}, {end, j, other_out})) sets.join(i, j);
                }
        }
}

void JoinRules::join_edges(Fan& fan, UnionFind& sets) const {
    std::vector<Spoke>& spokes = fan.spokes;
    spokes.clear();
    for (std::uint32_t i = 0; i < fan.size(); ++i) {
        if (!fan.votes(i)) continue;
        spokes.push_back({fan.next[i], i, true});
        spokes.push_back({fan.previous[i], i, false});
    }
    std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
        return std::tuple(a.place, a.index, a.outgoing) < std::tuple(b.place, b.index, b.outgoing);
    });
    for (std::size_t first = 0; first < spokes.size();) {
        std::size_t last = first + 1;
        while (last < spokes.size() && spokes[last].place == spokes[first].place) ++last;
        if (last - first > 1) join_edge(fan, std::span(spokes).subspan(first, last - first), sets);
        first = last;
    }
}

// At an edge between two meshes the smaller angle applies.
double JoinRules::min_cos(const Fan& fan, std::uint32_t i, std::uint32_t j) const {
    return own_cos_.empty() ? min_cos_ : std::max(own_cos_[fan.mesh[i]], own_cos_[fan.mesh[j]]);
}

// Whether two faces with a common edge join; on sides of a shell they must use it in opposite directions.
bool JoinRules::joined(const Fan& fan, std::uint32_t i, std::uint32_t j) const {
    const double cosine = dot(fan.normal[i], fan.normal[j]);
    if (rule_ == JoinRule::side) return cosine > turned_back;
    if (fan.authority[i] == 0 || fan.authority[i] != fan.authority[j]) return cosine >= min_cos(fan, i, j);
    if (fan.kind[i] == GroupKind::masks) return (fan.group[i] & fan.group[j]) != 0;
    return fan.kind[i] == GroupKind::numbers && fan.group[i] != 0 && fan.group[i] == fan.group[j];
}
bool JoinRules::joined(const Fan& fan, const Spoke& a, const Spoke& b) const {
    return (rule_ == JoinRule::crease || a.outgoing != b.outgoing) && joined(fan, a.index, b.index) &&
           (!creases_ || obeys_rule(fan, a, b));
}

// Groups go before the rule.
bool JoinRules::obeys_rule(const Fan& fan, const Spoke& a, const Spoke& b) const {
    const std::uint32_t i = a.index, j = b.index;
    if (fan.authority[i] != 0 && fan.authority[i] == fan.authority[j]) return true;
    if (!follows_rule(fan.mesh[i]) && !follows_rule(fan.mesh[j])) return true;
    return creases_->are_soft(a.outgoing ? fan.corner[i] : corner_before(fan.corner[i]),
                              b.outgoing ? fan.corner[j] : corner_before(fan.corner[j]),
                              dot(fan.normal[i], fan.normal[j]));
}

void JoinRules::join_edge(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const {
    if (spokes.size() <= few) {
        for (std::size_t a = 0; a < spokes.size(); ++a)
            for (std::size_t b = a + 1; b < spokes.size(); ++b)
                if (joined(fan, spokes[a], spokes[b])) sets.join(spokes[a].index, spokes[b].index);
        return;
    }
    join_many_by_angle(fan, spokes, sets);
    if (rule_ == JoinRule::crease && has_groups_) join_many_by_group(fan, spokes, sets);
}

// Faces joined by one crease angle have that angle or a larger one: processes the faces around the edge for each angle.
void JoinRules::join_many_by_angle(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const {
    if (own_cos_.empty() || rule_ != JoinRule::crease) return join_around(fan, spokes, sets);
    std::vector<Spoke> sorted(spokes.begin(), spokes.end());
    const auto cosine = [&](const Spoke& s) { return own_cos_[fan.mesh[s.index]]; };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Spoke& a, const Spoke& b) { return cosine(a) < cosine(b); });
    for (std::size_t end = 1; end <= sorted.size(); ++end)
        if (end == sorted.size() || cosine(sorted[end]) != cosine(sorted[end - 1]))
            join_around(fan, std::span(sorted).first(end), sets);
}

// All normals at an edge lie in the plane across it. The angle applies between faces of different authority, or of none
// (for shells: with opposite directions along the edge). Linking each face to the next such face on the circle joins
// all faces within the angle.
void JoinRules::join_around(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const {
    std::vector<dvec3> normals;
    for (const Spoke& s : spokes) normals.push_back(fan.normal[s.index]);
    const std::vector<std::uint32_t> order = circular_order(normals);
    const std::size_t count = order.size();
    const auto at = [&](std::size_t i) -> const Spoke& { return spokes[order[i % count]]; };
    const auto obeys_angle = [&](const Spoke& a, const Spoke& b) {
        if (rule_ == JoinRule::side) return a.outgoing != b.outgoing;
        return fan.authority[a.index] == 0 || fan.authority[a.index] != fan.authority[b.index];
    };
    // next[i]: the first position after i that i's face compares with; one backward sweep over two rounds of the
    // circle.
    for (const bool backwards : {false, true}) {
        std::vector<std::size_t> next(2 * count + 1, 2 * count);
        const auto turn = [&](std::size_t i) -> const Spoke& { return at(backwards ? 2 * count - 1 - i : i); };
        for (std::size_t i = 2 * count - 1; i-- > 0;) next[i] = obeys_angle(turn(i), turn(i + 1)) ? i + 1 : next[i + 1];
        for (std::size_t i = 0; i < count; ++i)
            if (next[i] < 2 * count && joined(fan, turn(i), turn(next[i])))
                sets.join(turn(i).index, turn(next[i]).index);
    }
}

void JoinRules::join_many_by_group(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const {
    std::vector<Spoke> sorted(spokes.begin(), spokes.end());
    const auto key = [&](const Spoke& s) { return std::tuple(fan.authority[s.index], fan.group[s.index]); };
    std::sort(sorted.begin(), sorted.end(),
              [&](const Spoke& a, const Spoke& b) { return key(a) != key(b) ? key(a) < key(b) : a.index < b.index; });
    std::uint64_t authority = 0;
    std::uint32_t first_of_bit[32] = {}, seen = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const std::uint32_t index = sorted[i].index, group = fan.group[index];
        if (fan.authority[index] != authority) seen = 0;
        authority = fan.authority[index];
        if (authority == 0 || group == 0) continue;
        if (fan.kind[index] == GroupKind::numbers && i > 0 && key(sorted[i - 1]) == key(sorted[i]))
            sets.join(sorted[i - 1].index, index);
        if (fan.kind[index] != GroupKind::masks) continue;
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            if ((group >> bit & 1) == 0) continue;
            if ((seen >> bit & 1) != 0)
                sets.join(first_of_bit[bit], index);
            else
                first_of_bit[bit] = index;
        }
        seen |= group;
    }
}

// At a crease angle of pi all faces subject to the angle are one group, with or without a common edge: one face of
// another authority, or of none, joins everything. Faces of meshes with a smaller angle are excluded.
void JoinRules::join_everything(const Fan& fan, UnionFind& sets) const {
    const auto takes_part = [&](std::size_t i) {
        return fan.votes(i) && !follows_rule(fan.mesh[i]) && (own_cos_.empty() || own_cos_[fan.mesh[i]] == -2);
    };
    std::size_t first = fan.size(), other = fan.size();
    for (std::size_t i = 0; i < fan.size() && other == fan.size(); ++i) {
        if (!takes_part(i)) continue;
        if (first == fan.size())
            first = i;
        else if (fan.authority[i] == 0 || fan.authority[i] != fan.authority[first])
            other = i;
    }
    if (other == fan.size()) return;
    for (std::size_t i = 0; i < fan.size(); ++i)
        if (takes_part(i)) sets.join(std::uint32_t(first), std::uint32_t(i));
}

void JoinRules::join_hints(const Fan& fan, UnionFind& sets) const {
    std::vector<std::uint32_t> hinted;
    for (std::uint32_t i = 0; i < fan.size(); ++i)
        if (fan.votes(i) && (fan.authority[i] & 3) == 3 && is_finite(fan.hint[i])) hinted.push_back(i);
    const auto key = [&](std::uint32_t i) {
        return std::tuple(fan.authority[i], fan.hint[i].x, fan.hint[i].y, fan.hint[i].z);
    };
    std::sort(hinted.begin(), hinted.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 1; i < hinted.size(); ++i)
        if (key(hinted[i - 1]) == key(hinted[i])) sets.join(hinted[i - 1], hinted[i]);
}

}  // namespace rakelight::geometry
