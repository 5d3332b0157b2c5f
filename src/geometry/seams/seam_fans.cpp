// SPDX-License-Identifier: Apache-2.0
#include "geometry/seams/seam_fans.h"

#include <rakelight/geometry/seams.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <tuple>

#include "geometry/groups/authored_normals.h"
#include "geometry/input/circular_order.h"

namespace rakelight::geometry {
namespace {

// Up to this number, different normals of one mesh, and faces at one edge, are compared pairwise, and all corners of a
// fan are measured.
constexpr std::size_t few_normals = 64, few_faces = 16, few_corners = 64;

auto key(dvec3 n) { return std::tuple(n.x, n.y, n.z); }

/// By the corners of its face, but for those that may turn.
bool is_authored_flat(const SeamCorner& c) {
    std::array<dvec3, 3> corners{c.authored};
    std::size_t count = 1;
    for (const OtherCorner* other : {&c.next, &c.previous}) {
        if (other->authored == dvec3{}) return false;
        if (!other->may_turn) corners[count++] = other->authored;
    }
    return are_authored_flat(std::span(corners.data(), count), c.face, c.square);
}

/// [rad] Between a face and the normals of its corners that count, in the plane perpendicular to an edge.
double tilt_across(const SeamCorner& c, dvec3 edge) {
    const auto across = [&](dvec3 v) { return v - edge * dot(v, edge); };
    const dvec3 face = across(c.face);
    double tilt = angle_between(across(c.authored), face);
    for (const OtherCorner* other : {&c.next, &c.previous}) {
        if (other->authored == dvec3{}) return pi;
        if (!other->may_turn) tilt = std::max(tilt, angle_between(across(other->authored), face));
    }
    return tilt;
}

}  // namespace

void SeamFans::find(std::uint32_t place, std::span<const SeamCorner> corners) {
    flat_pairs_ = crease_pairs_ = 0;
    find_fans(corners);
    sets_.reset(fans_.size());
    is_open_.assign(fans_.size(), 0);
    if (fans_.size() < 2) return;
    find_joints(place, corners);
    const bool is_simple =
        std::adjacent_find(fans_.begin(), fans_.end(),
                           [](const AuthoredFan& a, const AuthoredFan& b) { return a.mesh == b.mesh; }) == fans_.end();
    is_simple ? join_all() : join_nearest_first();
    for (const Joint& j : joints_)
        if (const std::uint32_t root = sets_.root(j.a); j.is_open && root == sets_.root(j.b)) is_open_[root] = 1;
}

void SeamFans::find_fans(std::span<const SeamCorner> corners) {
    fans_.clear();
    fan_of_.assign(corners.size(), no_fan);
    is_flat_.clear();
    for (const SeamCorner& c : corners) is_flat_.push_back(is_authored_flat(c));
    for (std::size_t first = 0; first < corners.size();) {
        std::size_t last = first + 1;
        while (last < corners.size() && corners[last].mesh == corners[first].mesh) ++last;
        find_fans_of_mesh(corners.subspan(first, last - first), std::uint32_t(first));
        first = last;
    }
}

/// Corners with a normal, sorted by it; `leads_` are the first of equal normals.
void SeamFans::sort_corners(std::span<const SeamCorner> corners) {
    order_.clear();
    leads_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        if (corners[i].authored != dvec3{}) order_.push_back(i);
    const auto key_of = [&](std::uint32_t i) { return key(corners[i].authored); };
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::tuple(key_of(a), a) < std::tuple(key_of(b), b); });
    for (std::uint32_t i = 0; i < order_.size(); ++i)
        if (i == 0 || key_of(order_[i]) != key_of(order_[i - 1])) leads_.push_back(i);
}

/// @param first  where these corners begin among those of the place
void SeamFans::find_fans_of_mesh(std::span<const SeamCorner> corners, std::uint32_t first) {
    sort_corners(corners);
    const std::size_t count = leads_.size(), first_fan = fans_.size();
    const auto normal_of = [&](std::uint32_t lead) { return corners[order_[leads_[lead]]].authored; };
    alike_.reset(count);
    for (std::uint32_t a = 0; a < count && count <= few_normals; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (are_one_normal(normal_of(a), normal_of(b))) alike_.join(a, b);
    // One fan per set, in the order of their smallest normals; different normals are averaged by angle.
    fan_of_lead_.assign(count, no_fan);
    sums_.clear();
    for (std::uint32_t a = 0; a < count; ++a) {
        const std::uint32_t root = alike_.root(a);
        if (root == a) {
            fan_of_lead_[a] = std::uint32_t(fans_.size());
            fans_.push_back({corners[0].mesh, normal_of(a)});
            sums_.emplace_back();
        } else {
            sums_[fan_of_lead_[root] - first_fan].is_mixed = true;
        }
        const std::uint32_t fan = fan_of_lead_[a] = fan_of_lead_[root];
        const std::uint32_t end = a + 1 < count ? leads_[a + 1] : std::uint32_t(order_.size());
        for (std::uint32_t i = leads_[a]; i < end; ++i) {
            const SeamCorner& c = corners[order_[i]];
            fan_of_[first + order_[i]] = fan;
            fans_[fan].angle += c.angle;
            sums_[fan - first_fan].normals += c.authored * c.angle;
        }
    }
    for (std::size_t f = 0; f < sums_.size(); ++f)
        if (sums_[f].is_mixed)
            fans_[first_fan + f].normal = normalize_or(sums_[f].normals, fans_[first_fan + f].normal);
}

void SeamFans::sort_by_fan() {
    first_of_.assign(fans_.size() + 1, 0);
    for (const std::uint32_t fan : fan_of_)
        if (fan != no_fan) ++first_of_[fan + 1];
    std::partial_sum(first_of_.begin(), first_of_.end(), first_of_.begin());
    by_fan_.resize(first_of_.back());
    std::vector<std::uint32_t> next(first_of_.begin(), first_of_.end() - 1);
    for (std::uint32_t i = 0; i < fan_of_.size(); ++i)
        if (fan_of_[i] != no_fan) by_fan_[next[fan_of_[i]]++] = i;
}

void SeamFans::find_contacts(std::uint32_t place, std::span<const SeamCorner> corners) {
    contacts_.clear();
    spokes_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const SeamCorner& c = corners[i];
        if (c.face == dvec3{} || fan_of_[i] == no_fan) continue;
        if (c.next.place != place) spokes_.push_back({c.next.place, i, true});
        if (c.previous.place != place) spokes_.push_back({c.previous.place, i, false});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
        return std::tuple(a.place, a.index, a.outgoing) < std::tuple(b.place, b.index, b.outgoing);
    });
    for (std::size_t first = 0; first < spokes_.size();) {
        std::size_t last = first + 1;
        while (last < spokes_.size() && spokes_[last].place == spokes_[first].place) ++last;
        if (last - first > 1) look_at_edge(corners, std::span(spokes_).subspan(first, last - first));
        first = last;
    }
}

void SeamFans::find_joints(std::uint32_t place, std::span<const SeamCorner> corners) {
    joints_.clear();
    find_contacts(place, corners);
    sort_by_fan();
    std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
        return std::tuple(a.f, a.g, a.place, a.p, a.q) < std::tuple(b.f, b.g, b.place, b.p, b.q);
    });
    for (std::size_t first = 0; first < contacts_.size();) {
        std::size_t last = first + 1;
        while (last < contacts_.size() && contacts_[last].f == contacts_[first].f &&
               contacts_[last].g == contacts_[first].g)
            ++last;
        look_at_fans(place, corners, std::span(contacts_).subspan(first, last - first));
        first = last;
    }
}

/// All pairs, or for many faces each with its neighbors of other meshes around the edge.
void SeamFans::look_at_edge(std::span<const SeamCorner> corners, std::span<const Spoke> edge) {
    if (edge.size() <= few_faces) {
        for (std::size_t a = 0; a < edge.size(); ++a)
            for (std::size_t b = a + 1; b < edge.size(); ++b) look_at_pair(corners, edge[a], edge[b]);
        return;
    }
    std::vector<dvec3> normals;
    for (const Spoke& s : edge) normals.push_back(corners[s.index].face);
    const std::vector<std::uint32_t> order = circular_order(normals);
    const std::size_t count = order.size();
    const auto at = [&](std::size_t i) -> const Spoke& { return edge[order[i % count]]; };
    // next[i]: the first position behind i of another mesh; one sweep backwards over two turns of the circle
    std::vector<std::size_t> next(2 * count, 2 * count);
    for (std::size_t i = 2 * count - 1; i-- > 0;)
        next[i] = corners[at(i).index].mesh != corners[at(i + 1).index].mesh ? i + 1 : next[i + 1];
    for (std::size_t i = 0; i < count; ++i)
        if (next[i] < 2 * count) look_at_pair(corners, at(i), at(next[i]));
}

void SeamFans::look_at_pair(std::span<const SeamCorner> corners, const Spoke& a, const Spoke& b) {
    if (fan_of_[a.index] > fan_of_[b.index]) return look_at_pair(corners, b, a);
    const SeamCorner &p = corners[a.index], &q = corners[b.index];
    if (p.mesh == q.mesh) return;
    const double cosine = dot(p.face, q.face);
    if (!are_soft(p, a.outgoing, q, b.outgoing, cosine)) return;
    const dvec3 along = a.outgoing ? p.next.direction : p.previous.direction;
    contacts_.push_back({fan_of_[a.index], fan_of_[b.index], a.index, b.index, a.place, along, cosine,
                         length(p.authored - q.authored) > continuous_rad});
}

/// By the angles of both meshes, and by the rule if either follows it. Equal normals were authored soft.
bool SeamFans::are_soft(const SeamCorner& p, bool p_outgoing, const SeamCorner& q, bool q_outgoing, double cosine) {
    if (!(cosine >= std::max(rules_.cosines[p.mesh], rules_.cosines[q.mesh]))) return false;
    if (!rules_.follows[p.mesh] && !rules_.follows[q.mesh]) return true;
    if (cosine >= cosine_of_always_soft || dot(p.authored, q.authored) >= cosine_of_flat) return true;
    if (!rules_.creases) {
        needs_creases_ = true;
        return false;
    }
    return rules_.creases->are_soft(p_outgoing ? p.corner : corner_before(p.corner),
                                    q_outgoing ? q.corner : corner_before(q.corner), cosine);
}

/// @param contacts  of two fans
void SeamFans::look_at_fans(std::uint32_t place, std::span<const SeamCorner> corners,
                            std::span<const Contact> contacts) {
    const std::uint32_t f = contacts[0].f, g = contacts[0].g;
    const dvec3 apart = fans_[f].normal - fans_[g].normal;
    Lean lean_f, lean_g;
    if (std::ranges::any_of(contacts, &Contact::is_open)) {
        lean_f = lean(corners, f, contacts, &Contact::p);
        lean_g = lean(corners, g, contacts, &Contact::q);
    }
    for (const Contact& c : contacts) {
        const double bend = angle_between(corners[c.p].face, corners[c.q].face);
        // Triangles of bent polygons may lie in one plane.
        const bool bends = c.is_open && bend > radians(authored_flat_deg),
                   turns = c.is_open &&
                           angle_between(corners[c.p].authored, corners[c.q].authored) > radians(3 * authored_flat_deg),
                   is_flat = (bends || turns) && is_flat_[c.p] != 0 && is_flat_[c.q] != 0,
                   is_crease = bends && !is_flat && shows_crease(lean_f, bend) && shows_crease(lean_g, bend);
        if (place < c.place) flat_pairs_ += is_flat, crease_pairs_ += is_crease;
        if (!is_flat && !is_crease) joints_.push_back({f, g, dot(apart, apart), c.cosine, c.is_open});
    }
}

/// Over all corners of a fan; of very many, over those whose faces have an edge of the contacts.
/// @param own  which corners of the contacts are the fan's
SeamFans::Lean SeamFans::lean(std::span<const SeamCorner> corners, std::uint32_t fan, std::span<const Contact> contacts,
                              std::uint32_t Contact::*own) const {
    Lean out;
    const auto add = [&](const SeamCorner& c, std::span<const Contact> edges) {
        if (c.face == dvec3{}) return;
        double least = pi;
        for (const Contact& edge : edges) least = std::min(least, tilt_across(c, edge.along));
        out.across = std::max(out.across, least);
        out.whole = std::max(out.whole, angle_between(c.authored, c.face));
        out.is_shown = out.is_shown || !c.next.may_turn || !c.previous.may_turn;
    };
    const std::span all = std::span(by_fan_).subspan(first_of_[fan], first_of_[fan + 1] - first_of_[fan]);
    if (all.size() <= few_corners)
        for (const std::uint32_t i : all) add(corners[i], contacts);
    else
        for (const Contact& c : contacts) add(corners[c.*own], {&c, 1});
    return out;
}

/// Whether the normals of one side say that an edge is a crease: `authored_crease_share`.
bool SeamFans::shows_crease(const Lean& lean, double bend) {
    const double largest = authored_crease_share * bend;
    if (lean.is_shown) return lean.across <= largest;
    return lean.whole <= largest && bend > radians(silent_crease_deg);
}

/// With one fan per mesh there is no conflict.
void SeamFans::join_all() {
    for (const Joint& j : joints_) sets_.join(j.a, j.b);
}

/// Ordered by geometry only, so that the order of meshes has no effect; ties are decided by index.
bool SeamFans::comes_before(const Joint& x, const Joint& y) const {
    if (x.apart != y.apart) return x.apart < y.apart;
    if (x.bend != y.bend) return x.bend > y.bend;
    const auto normals = [&](const Joint& j) {
        const auto a = key(fans_[j.a].normal), b = key(fans_[j.b].normal);
        return a < b ? std::pair(a, b) : std::pair(b, a);
    };
    const auto nx = normals(x), ny = normals(y);
    return nx != ny ? nx < ny : std::tuple(x.a, x.b) < std::tuple(y.a, y.b);
}

/// Joints in order of closest normals, except those that would connect two fans of one mesh.
void SeamFans::join_nearest_first() {
    std::sort(joints_.begin(), joints_.end(), [&](const Joint& a, const Joint& b) { return comes_before(a, b); });
    std::vector<std::set<std::uint32_t>> meshes(fans_.size());  // of the fans of each root
    for (std::size_t f = 0; f < fans_.size(); ++f) meshes[f] = {fans_[f].mesh};
    std::set<std::pair<std::uint32_t, std::uint32_t>> refused;  // pairs of roots
    for (const Joint& j : joints_) {
        const std::uint32_t a = sets_.root(j.a), b = sets_.root(j.b);
        if (a == b || refused.contains(std::minmax(a, b))) continue;
        std::set<std::uint32_t>&small = meshes[a].size() < meshes[b].size() ? meshes[a] : meshes[b],
        &large = &small == &meshes[a] ? meshes[b] : meshes[a];
        if (std::any_of(small.begin(), small.end(), [&](std::uint32_t m) { return large.contains(m); })) {
            refused.insert(std::minmax(a, b));
            continue;
        }
        large.insert(small.begin(), small.end());
        std::set<std::uint32_t> all = std::move(large);
        small.clear();
        sets_.join(a, b);
        meshes[sets_.root(a)] = std::move(all);
    }
}

}  // namespace rakelight::geometry
