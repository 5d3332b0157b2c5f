// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/repair_borders.h"

#include <algorithm>
#include <cstdio>

#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/validate.h>

#include "base/format_text.h"
#include "prepare/moving_placements.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/normals/turned_normals.h"
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

/// A set of meshes that may match.
struct BorderSet {
    MatchOptions options;
    PlacedParts parts;
    bool moves = false;
};

/// The sets in which each scope's meshes match: `object`, `model`.
class BorderSets {
public:
    BorderSets(const Scene& scene, const BorderRequest& request)
        : scene_(scene), request_(request), world_(bind_pose_matrices(scene)) {
        for (const Scope scope : {Scope::object, Scope::model}) {
            BorderSet& set = sets_.emplace_back();
            set.options = request.options;
            set.options.scope = scope;
            if (request.source) set.options.keep_flat = false;
        }
        for (const Instance& instance : drawn_instances(scene)) add(instance);
    }
    std::vector<BorderSet>& sets() { return sets_; }

private:
    void add(const Instance& instance) {
        const Mesh& mesh = scene_.meshes[instance.mesh];
        if (mesh.normals.empty()) return;
        NormalRule rule{.scope = request_.options.scope, .crease_angle_rad = own_crease_angle(mesh)};
        if (request_.source) {
            rule = normal_rule(scene_, mesh, *request_.source);
            if (rule.joins_seams) rule.scope = Scope::model;
        }
        if (rule.scope == Scope::face) return;
        BorderSet& set = sets_[rule.scope == Scope::object ? 0 : 1];
        set.parts.add(instance, mesh, world_[instance.node]);
        set.parts.meshes.back().crease_angle_rad = rule.crease_angle_rad;
        set.options.keep_flat = set.options.keep_flat || rule.joins_seams;
        set.moves = set.moves || !mesh.targets.empty() || follows_skin(scene_, scene_.nodes[instance.node], mesh);
    }

    const Scene& scene_;
    const BorderRequest& request_;
    const std::vector<dmat4> world_;
    std::vector<BorderSet> sets_;
};

/// The instances of a posed scene in the order of matching. An animated mesh has one instance, possibly at another
/// node; the others keep their order.
std::vector<Instance> found_again(const Scene& scene, const std::vector<Instance>& matched) {
    std::vector<std::vector<Instance>> shown(scene.meshes.size());
    for (const Instance& instance : drawn_instances(scene)) shown[instance.mesh].push_back(instance);
    std::vector<std::size_t> next(scene.meshes.size(), 0);
    std::vector<Instance> found;
    for (const Instance& instance : matched) found.push_back(shown[instance.mesh].at(next[instance.mesh]++));
    return found;
}

/// Both together.
MatchReport sum(const MatchReport& a, const MatchReport& b) {
    MatchReport all;
    all.leading = a.leading + b.leading, all.following = a.following + b.following;
    all.turned = a.turned + b.turned;
    all.max_deg = std::max(a.max_deg, b.max_deg);
    if (all.turned > 0)
        all.mean_deg = (a.mean_deg * double(a.turned) + b.mean_deg * double(b.turned)) / double(all.turned);
    all.vertices_not_searched = a.vertices_not_searched + b.vertices_not_searched;
    return all;
}

/// Why no mesh is matched.
std::string why_none(NormalSource source) {
    if (source == NormalSource::file) return "'normals' file keeps what the file has";
    return "faces are flat here, or have no normals; 'normals' model smooths";
}

bool is_within_objects(const BorderRequest& request) {
    return request.source ? request.source == NormalSource::object : request.options.scope == Scope::object;
}

std::string digits(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

}  // namespace

Scene join_borders(Scene scene, const BorderRequest& request, BorderOutcome& outcome, Context& context,
                   std::vector<BoundBorders>* moving) {
    std::vector<BoundBorders> matched;
    {
        BorderSets sets(scene, request);
        for (BorderSet& set : sets.sets()) {
            if (set.parts.meshes.empty()) continue;
            outcome.takes_part = true;
            set.parts.check_memory(context);
            BorderMatch match = match_borders(set.parts.meshes, set.options, context);
            if (!match.is_empty()) matched.push_back({std::move(match), std::move(set.parts.instances), set.moves});
        }
    }
    for (BoundBorders& set : matched) {
        MatchReport one;
        Scene joined = join_borders(scene, set, request.keep_instances, one, context);
        outcome.report = sum(outcome.report, one);
        if (moving && set.moves)
            moving->push_back(std::move(set));
        else
            scene = std::move(joined);
    }
    return scene;
}

Scene join_borders(Scene scene, const BoundBorders& borders, bool keep_instances, MatchReport& report,
                   Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    PlacedParts parts;
    std::vector<std::span<const vec4>> tangents;
    for (const Instance& instance : found_again(scene, borders.instances)) {
        parts.add(instance, scene.meshes[instance.mesh], world[instance.node]);
        tangents.push_back(scene.meshes[instance.mesh].tangents);
    }
    std::vector<MeshSeams> turned = join_borders(borders.match, parts.meshes, tangents, report, context);
    return with_turned_normals(std::move(scene), parts, std::move(turned), keep_instances, context);
}

void join_kept_normals(Scene& scene) {
    for (Mesh& mesh : scene.meshes) {
        if (mesh.normals.empty() || mesh.topology != Topology::triangles) continue;
        NormalChoice choice{.missing_are_flat = scene.missing_normals_are_flat};
        if (mesh.normal_choice) choice = *mesh.normal_choice;
        if (choice.source != NormalSource::automatic) continue;
        choice.source = NormalSource::seams;
        mesh.normal_choice = choice;
    }
}

Scene repair_borders(const Scene& scene, const MatchOptions& options, Context& context, MatchReport* borders,
                     bool keep_instances) {
    validate(scene);
    BorderOutcome outcome;
    Scene out = join_borders(scene, {.options = options, .keep_instances = keep_instances}, outcome, context);
    if (borders) *borders = outcome.report;
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

void report_borders(const Scene& scene, const BorderRequest& request, const BorderOutcome& outcome, Report& report) {
    const MatchReport& borders = outcome.report;
    const auto say = [&](Remark kind, std::string text) {
        report.add(kind, scene.source, {}, std::move(text), {"border-distance"});
    };
    if (!outcome.takes_part)
        report.add(Remark::warning, scene.source, {},
                   "'border-distance' turns nothing: " + why_none(request.source.value_or(NormalSource::flat)),
                   {"border-distance", "normals"});
    else if (borders.following == 0)
        say(Remark::warning,
            "'border-distance' " + digits(request.options.distance) + " turns nothing: no borders of different meshes" +
                (is_within_objects(request) ? " of one object" : "") +
                " run along each other as near as that; where some do, `rakelight inspect` proposes a distance");
    else
        report.add(Remark::note, scene.source, {}, describe(borders));
    if (borders.vertices_not_searched > 0)
        say(Remark::warning, format_text("{} border vertices were not searched for borders beside them: too many edges "
                                         "are near one another for 'border-distance' {}",
                                         borders.vertices_not_searched, digits(request.options.distance)));
}

std::string describe(const MatchReport& borders) {
    std::string text = format_text("{} border vertices follow {} leading ones; {} normals turn", borders.following,
                                   borders.leading, borders.turned);
    if (borders.turned > 0)
        text += " (at most " + digits(borders.max_deg) + " degrees, " + digits(borders.mean_deg) + " on average)";
    return text;
}

}  // namespace rakelight
