// SPDX-License-Identifier: Apache-2.0
#include "geometry/seam_fans.h"

#include <rakelight/seams.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "geometry/authored_normals.h"
#include "geometry/circular_order.h"

namespace rakelight::geometry {
namespace {

// Up to this number, different normals of one mesh, and faces at one edge, are compared pairwise.
constexpr std::size_t few_normals = 64, few_faces = 16;

auto key(dvec3 n) { return std::tuple(n.x, n.y, n.z); }

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
    leans_.clear();
    for (const SeamCorner& c : corners)
        leans_.push_back(c.face == dvec3{} ? 0 : std::max(c.others_lean, angle_between(c.authored, c.face)));
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
        }
        const std::uint32_t fan = fan_of_lead_[a] = fan_of_lead_[root];
        const std::uint32_t end = a + 1 < count ? leads_[a + 1] : std::uint32_t(order_.size());
        for (std::uint32_t i = leads_[a]; i < end; ++i) {
            const SeamCorner& c = corners[order_[i]];
            fan_of_[first + order_[i]] = fan;
            fans_[fan].angle += c.angle;
            fans_[fan].lean = std::max(fans_[fan].lean, leans_[first + order_[i]]);
            sums_[fan - first_fan] += c.authored * c.angle;
        }
    }
    if (count == sums_.size()) return;
    for (std::size_t f = 0; f < sums_.size(); ++f)
        fans_[first_fan + f].normal = normalize_or(sums_[f], fans_[first_fan + f].normal);
}

void SeamFans::find_joints(std::uint32_t place, std::span<const SeamCorner> corners) {
    joints_.clear();
    spokes_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const SeamCorner& c = corners[i];
        if (c.face == dvec3{} || fan_of_[i] == no_fan) continue;
        if (c.next != place) spokes_.push_back({c.next, i, true});
        if (c.previous != place) spokes_.push_back({c.previous, i, false});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
        return std::tuple(a.place, a.index, a.outgoing) < std::tuple(b.place, b.index, b.outgoing);
    });
    for (std::size_t first = 0; first < spokes_.size();) {
        std::size_t last = first + 1;
        while (last < spokes_.size() && spokes_[last].place == spokes_[first].place) ++last;
        if (last - first > 1) look_at_edge(place, corners, std::span(spokes_).subspan(first, last - first));
        first = last;
    }
}

/// All pairs, or for many faces each with its neighbors of other meshes around the edge.
void SeamFans::look_at_edge(std::uint32_t place, std::span<const SeamCorner> corners, std::span<const Spoke> edge) {
    if (edge.size() <= few_faces) {
        for (std::size_t a = 0; a < edge.size(); ++a)
            for (std::size_t b = a + 1; b < edge.size(); ++b) look_at_pair(place, corners, edge[a], edge[b]);
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
        if (next[i] < 2 * count) look_at_pair(place, corners, at(i), at(next[i]));
}

void SeamFans::look_at_pair(std::uint32_t place, std::span<const SeamCorner> corners, const Spoke& a, const Spoke& b) {
    const SeamCorner &p = corners[a.index], &q = corners[b.index];
    if (p.mesh == q.mesh) return;
    const double cosine = dot(p.face, q.face);
    if (!(cosine >= std::max(cosines_[p.mesh], cosines_[q.mesh]))) return;
    if (stays_hard(a.index, b.index, angle_between(p.face, q.face), place < a.place)) return;
    const auto [f, g] = std::minmax(fan_of_[a.index], fan_of_[b.index]);
    joints_.push_back(
        {f, g, dot(fans_[f].normal, fans_[g].normal), cosine, length(p.authored - q.authored) > continuous_rad});
}

/// @param a, b  corners of the two faces of an edge
/// @param bend  [rad] between these faces
/// @param counts  whether this is the edge's first end
bool SeamFans::stays_hard(std::uint32_t a, std::uint32_t b, double bend, bool counts) {
    if (!(bend > radians(authored_flat_deg))) return false;
    const bool is_flat = std::max(leans_[a], leans_[b]) <= radians(authored_flat_deg);
    const double lean = std::max(fans_[fan_of_[a]].lean, fans_[fan_of_[b]].lean);
    if (!is_flat && !is_authored_crease(lean, bend)) return false;
    (is_flat ? flat_pairs_ : crease_pairs_) += counts;
    return true;
}

/// With one fan per mesh there is no conflict.
void SeamFans::join_all() {
    for (const Joint& j : joints_) sets_.join(j.a, j.b);
}

/// Ordered by geometry only, so that the order of meshes has no effect; ties are decided by index.
bool SeamFans::comes_before(const Joint& x, const Joint& y) const {
    if (x.nearness != y.nearness) return x.nearness > y.nearness;
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
