// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_sums.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/cancel_check.h"
#include "geometry/borders/border_fits.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/corner_weights.h"
#include "geometry/input/orthogonality.h"
#include "geometry/input/perpendicular.h"
#include "geometry/sums/finish_vertices.h"

namespace rakelight::geometry {
namespace {

enum Role : std::uint8_t { no_part, leads, follows };

constexpr double cosine_of_45 = 0.70710678118654752;

double weight_of_corner(CornerWeight weight, const AttributeInput& input, std::uint32_t m, std::uint32_t corner) {
    const std::uint32_t k = corner % 3;
    const std::uint32_t* const index = input.meshes[m].indices.data() + (corner - k - 3 * input.triangle_base[m]);
    const FaceCorners face = face_corners(input.meshes[m], index);
    const Direction normal = face_normal(input.placements[m], face);
    if (normal.unit == dvec3{}) return 0;
    return corner_weights(weight, input.placements[m], face, normal.length)[k];
}

}  // namespace

BorderSums::BorderSums(const AttributeInput& input, std::span<const std::span<const vec4>> tangents,
                       const BorderNodes& nodes, std::span<const BorderLink> links, const BorderRings& rings,
                       CornerWeight weight)
    : input_(input),
      given_tangents_(tangents),
      nodes_(nodes),
      links_(links),
      rings_(rings),
      weight_(weight),
      is_open_(nodes.count(), 0),
      role_(nodes.count(), no_part),
      member_weight_(nodes.members.size(), 0),
      normals_(nodes.count()),
      sums_(nodes.count()),
      weights_(nodes.count(), 0) {
    for (const BorderLink& link : links) {
        if (link.counts_a() && role_[link.node_a] == no_part) role_[link.node_a] = leads;
        if (link.counts_b() && role_[link.node_b] == no_part) role_[link.node_b] = leads;
        role_[link.node] = follows;
    }
}

std::vector<MeshSeams> BorderSums::run(MatchReport& report, Context& context) {
    weigh_members(context);
    if (!given_tangents_.empty()) read_tangents();
    share_out();
    lead();
    if (!rings_.node.empty()) fit_leaders(context);
    if (!tangents_.empty()) lead_tangents();
    follow();
    std::vector<MeshSeams> out(input_.meshes.size());
    double sum = 0;
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
        report.leading += role_[node] == leads;
        report.following += role_[node] == follows;
        if (role_[node] != no_part) write(node, out, report, sum);
    }
    for (MeshSeams& mesh : out) {  // vertices of nodes are in the order of their places
        std::vector<std::size_t> order(mesh.vertices.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return mesh.vertices[a] < mesh.vertices[b]; });
        MeshSeams sorted;
        for (const std::size_t i : order) {
            sorted.vertices.push_back(mesh.vertices[i]);
            sorted.normals.push_back(mesh.normals[i]);
            if (!mesh.tangents.empty()) sorted.tangents.push_back(mesh.tangents[i]);
        }
        mesh = std::move(sorted);
    }
    report.mean_deg = report.turned == 0 ? 0 : sum / double(report.turned);
    return out;
}

/// Votes of all linked nodes.
void BorderSums::weigh_members(Context& context) {
    CancelCheck check(context);
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
        if (role_[node] == no_part) continue;
        for (std::uint32_t i = nodes_.member_begin[node]; i < nodes_.member_begin[node + 1]; ++i) {
            const std::uint32_t m = mesh_of(i), v = nodes_.members[i] - input_.vertex_base[m];
            const dvec3 normal = given_normal(input_.placements[m], input_.meshes[m].normals[v]);
            if (normals_[node] == dvec3{}) normals_[node] = normal;
            for (const std::uint32_t corner : nodes_.corners_of(i)) {
                check();
                member_weight_[i] += weight_of_corner(weight_, input_, m, corner);
            }
            sums_[node] += normal * member_weight_[i];
            weights_[node] += member_weight_[i];
        }
    }
}

void BorderSums::read_tangents() {
    tangents_.resize(nodes_.members.size());
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
        if (role_[node] == no_part) continue;
        const std::uint32_t first = nodes_.member_begin[node];
        for (std::uint32_t i = first; i < nodes_.member_begin[node + 1]; ++i) {
            const std::uint32_t m = mesh_of(i);
            Tangent& t = tangents_[i];
            t.lead = i;
            if (given_tangents_[m].empty()) continue;
            const vec4 given = given_tangents_[m][nodes_.members[i] - input_.vertex_base[m]];
            t.unit = direction_of(input_.placements[m].linear * cast<double>(given.xyz())).unit;
            t.hand = t.unit == dvec3{} ? 0 : (given.w < 0 ? -1 : 1) * input_.placements[m].flip;
            for (std::uint32_t k = first; k < std::min(i, first + 64) && t.hand != 0; ++k) {  // only a few are compared
                const Tangent& other = tangents_[k];
                if (other.lead == k && other.hand == t.hand && are_one_normal(other.unit, t.unit)) {
                    t.lead = k;
                    break;
                }
            }
            tangents_[t.lead].sum += t.unit * member_weight_[i];
        }
    }
}

/// The target normal of a following node.
dvec3 BorderSums::between(const BorderLink& link) const {
    return normalize_or(normals_[link.node_a] * (1 - link.t) + normals_[link.node_b] * link.t, normals_[link.node]);
}
dvec3 BorderSums::tangent_between(const BorderLink& link) const {
    const dvec3 sum = tangents_[link.member_a].unit * (1 - link.t) + tangents_[link.member_b].unit * link.t;
    return sum - normals_[link.node] * dot(normals_[link.node], sum);
}

/// Votes are passed to the followed nodes, deepest links first. Nodes whose followers all agree already do not change,
/// so a second run changes nothing.
void BorderSums::share_out() {
    for (const BorderLink& link : links_) {
        if (!(angle_between(normals_[link.node], between(link)) > continuous_rad)) continue;
        if (link.counts_a()) is_open_[link.node_a] = 1;
        if (link.counts_b()) is_open_[link.node_b] = 1;
    }
    for (std::size_t l = links_.size(); l-- > 0;) {
        const BorderLink& link = links_[l];
        sums_[link.node_a] += sums_[link.node] * (1 - link.t);
        weights_[link.node_a] += weights_[link.node] * (1 - link.t);
        sums_[link.node_b] += sums_[link.node] * link.t;
        weights_[link.node_b] += weights_[link.node] * link.t;
        if (!tangents_.empty()) share_tangents(link);
    }
}

bool BorderSums::agrees(const Tangent& own, const BorderLink& link) const {
    const auto is_like = [&](std::uint32_t member) {
        const Tangent& other = tangents_[member];
        return other.hand == own.hand && dot(other.unit, own.unit) >= cosine_of_45;
    };
    return own.hand != 0 && (!link.counts_a() || is_like(link.member_a)) &&
           (!link.counts_b() || is_like(link.member_b));
}

void BorderSums::share_tangents(const BorderLink& link) {
    for (std::uint32_t i = nodes_.member_begin[link.node]; i < nodes_.member_begin[link.node + 1]; ++i) {
        if (tangents_[i].lead != i || !agrees(tangents_[i], link)) continue;
        const bool is_open = angle_between(tangents_[i].unit, tangent_between(link)) > continuous_rad;
        const auto give = [&](std::uint32_t member, double share) {
            Tangent& to = tangents_[tangents_[member].lead];
            to.sum += tangents_[i].sum * share;
            to.received = to.received || is_open;
        };
        if (link.counts_a()) give(link.member_a, 1 - link.t);
        if (link.counts_b()) give(link.member_b, link.t);
    }
}

/// Projected on the plane of its node's normal; nothing if the projection vanishes.
void BorderSums::set_tangent(std::uint32_t member, dvec3 sum) {
    const auto above = std::upper_bound(nodes_.member_begin.begin(), nodes_.member_begin.end(), member);
    const dvec3 normal = normals_[std::size_t(above - nodes_.member_begin.begin()) - 1];
    const dvec3 across = sum - normal * dot(normal, sum);
    if (!(length(across) > 1e-6 * length(sum))) return;
    tangents_[member].unit = direction_of(across).unit;
    tangents_[member].is_set = true;
}

void BorderSums::lead() {
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
        if (role_[node] != leads) continue;
        if (is_open_[node] != 0 && length(sums_[node]) > cancelled_share * weights_[node])
            normals_[node] = normalize_or(sums_[node], normals_[node]);
    }
}

/// Votes by angles beside those of `weight_`, then fits.
void BorderSums::fit_leaders(Context& context) {
    context.memory().check(nodes_.count() * sizeof(dvec3), "fitting borders");
    std::vector<dvec3> by_angle(nodes_.count());
    CancelCheck check(context);
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
        if (role_[node] == no_part) continue;
        for (std::uint32_t i = nodes_.member_begin[node]; i < nodes_.member_begin[node + 1]; ++i) {
            const std::uint32_t m = mesh_of(i), v = nodes_.members[i] - input_.vertex_base[m];
            double weight = 0;
            for (const std::uint32_t corner : nodes_.corners_of(i)) {
                check();
                weight += weight_of_corner(CornerWeight::angle, input_, m, corner);
            }
            by_angle[node] += given_normal(input_.placements[m], input_.meshes[m].normals[v]) * weight;
        }
    }
    for (std::size_t l = links_.size(); l-- > 0;) {
        by_angle[links_[l].node_a] += by_angle[links_[l].node] * (1 - links_[l].t);
        by_angle[links_[l].node_b] += by_angle[links_[l].node] * links_[l].t;
    }
    fit_borders(input_, nodes_, links_, rings_, {is_open_, by_angle, normals_}, context);
}

void BorderSums::lead_tangents() {
    for (std::uint32_t node = 0; node < nodes_.count(); ++node)
        for (std::uint32_t i = nodes_.member_begin[node]; role_[node] == leads && i < nodes_.member_begin[node + 1];
             ++i)
            if (const Tangent& lead = tangents_[tangents_[i].lead]; lead.received) set_tangent(i, lead.sum);
}

void BorderSums::follow() {
    for (const BorderLink& link : links_) {
        normals_[link.node] = between(link);
        if (tangents_.empty()) continue;
        for (std::uint32_t i = nodes_.member_begin[link.node]; i < nodes_.member_begin[link.node + 1]; ++i)
            if (agrees(tangents_[i], link)) set_tangent(i, tangent_between(link));
    }
}

/// To object space, as in finish_vertices().
vec4 BorderSums::tangent_in_object(std::uint32_t member, std::uint32_t mesh, dvec3 normal) const {
    const Tangent& t = tangents_[member];
    const Placement& placement = input_.placements[mesh];
    const dvec3 back = direction_of(times_transposed(placement.normal_to_world, t.unit)).unit;
    const dvec3 unit = direction_of(back - normal * dot(normal, back)).unit;
    if (unit == dvec3{}) return {0, 0, 0, 0};
    return {float(unit.x), float(unit.y), float(unit.z), t.hand * placement.flip < 0 ? -1.0f : 1.0f};
}

/// The changed members.
void BorderSums::write(std::uint32_t node, std::vector<MeshSeams>& out, MatchReport& report, double& sum) const {
    for (std::uint32_t i = nodes_.member_begin[node]; i < nodes_.member_begin[node + 1]; ++i) {
        const std::uint32_t m = mesh_of(i), v = nodes_.members[i] - input_.vertex_base[m];
        const Placement& placement = input_.placements[m];
        const dvec3 old = given_normal(placement, input_.meshes[m].normals[v]);
        const double turn = angle_between(old, normals_[node]);
        if (!(turn > continuous_rad)) continue;
        const dvec3 object = to_object(placement, normals_[node]);
        out[m].vertices.push_back(v);
        out[m].normals.push_back(cast<float>(object));
        if (!tangents_.empty())
            out[m].tangents.push_back(tangents_[i].is_set ? tangent_in_object(i, m, object) : vec4{0, 0, 0, 0});
        ++report.turned;
        report.max_deg = std::max(report.max_deg, degrees(turn));
        sum += degrees(turn);
    }
}

}  // namespace rakelight::geometry
