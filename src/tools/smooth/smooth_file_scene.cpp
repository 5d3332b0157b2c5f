// SPDX-License-Identifier: Apache-2.0
#include "tools/smooth/smooth_file_scene.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>

#include "prepare/normals/missing_normals.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/normals/repair_seams.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/materials/material_conversion.h"
#include "scene/motion/change_targets.h"

namespace rakelight {
namespace {

bool needs_tangents(const Scene& scene, const Mesh& mesh, TangentChoice choice) {
    if (choice != TangentChoice::automatic) return choice == TangentChoice::always;
    if (!mesh.tangents.empty()) return true;
    if (mesh.material == no_index) return false;
    return needs_tangents(scene.materials[mesh.material]);
}

/// The sets of `before`, with the vertices that were split off in `after` as copies.
std::vector<Block<vec2>> followed(const Mesh& before, const Mesh& after) {
    if (after.positions.size() == before.positions.size()) return before.texcoords;
    std::vector<std::uint32_t> source(after.positions.size() - before.positions.size(), 0);
    for (std::size_t c = 0; c < after.indices.size(); ++c)
        if (after.indices[c] >= before.positions.size())
            source[after.indices[c] - before.positions.size()] = before.indices[c];
    std::vector<Block<vec2>> sets;
    for (const Block<vec2>& set : before.texcoords) {
        std::vector<vec2> values(set.begin(), set.end());
        if (!values.empty())
            for (const std::uint32_t v : source) values.push_back(set[v]);
        sets.emplace_back(std::move(values));
    }
    return sets;
}

bool has_normals(const Scene& scene) {
    const std::vector<Instance> drawn = drawn_instances(scene);
    return std::any_of(drawn.begin(), drawn.end(),
                       [&](const Instance& i) { return !scene.meshes[i.mesh].normals.empty(); });
}

/// @param only_missing  of meshes that have no normals
Scene with_new_normals(const Scene& scene, const SmoothFileOptions& options, bool only_missing, Context& context) {
    SmoothRequest request;
    request.attributes = options.attributes;
    request.attributes.normals = true;
    request.tangents = TangentNeed::everywhere;
    request.only_missing = only_missing;
    Scene open =
        scene;  // without texture coordinates where no tangents are wanted: a mirrored chart then splits no vertex
    std::vector<bool> hidden(scene.meshes.size(), false);
    for (std::size_t i = 0; i < hidden.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        hidden[i] = (mesh.normals.empty() || !only_missing) && !needs_tangents(scene, mesh, options.tangents);
        if (hidden[i]) open.meshes[i].texcoords.clear();
    }
    Scene out = smooth_meshes(std::move(open), request, context);
    // A copy replaces the mesh in the same slot of its node.
    for (std::size_t n = 0; n < out.nodes.size(); ++n)
        for (std::size_t slot = 0; slot < out.nodes[n].meshes.size(); ++slot) {
            const std::uint32_t was = scene.nodes[n].meshes[slot];
            Mesh& mesh = out.meshes[out.nodes[n].meshes[slot]];
            if (hidden[was] && mesh.texcoords.empty()) mesh.texcoords = followed(scene.meshes[was], mesh);
        }
    return out;
}

Scene without_tangents(Scene scene, Context& context) {
    for (const Instance& instance : drawn_instances(scene)) {
        Mesh& mesh = scene.meshes[instance.mesh];
        mesh.tangents = {};
        if (std::ranges::any_of(mesh.targets, [](const MorphTarget& target) { return !target.tangents.empty(); }))
            change_targets(
                mesh, [](MorphTarget& target, std::size_t) { target.tangents = {}; }, context);
    }
    return scene;
}

/// What authors made stays, but at borders.
SmoothedScene repaired(const Scene& scene, const SmoothFileOptions& options, Context& context) {
    SmoothedScene out{with_new_normals(scene, options, true, context), SeamReport{}};
    out.missing_made = count_missing_normals(scene);
    if (options.tangents == TangentChoice::never) out.scene = without_tangents(std::move(out.scene), context);
    const AttributeOptions& a = options.attributes;
    const SeamRequest request{
        {.crease_angle_rad = a.crease_angle_rad, .creases = a.creases, .weld_distance = a.weld_distance},
        {},
        options.keep_instances};
    out.scene = join_seams(std::move(out.scene), request, *out.seams, context);
    if (options.tangents != TangentChoice::always) return out;
    SmoothRequest tangents;
    tangents.attributes = a;
    tangents.tangents = TangentNeed::everywhere;
    out.scene = add_missing_tangents(std::move(out.scene), tangents, context);
    return out;
}

/// Tangents and bitangents as the publication averages them, for the meshes that are to have tangents. On which side the bitangent lies
/// is in w, so that who does not read the bitangents has the nearest frame.
Scene with_bitangents(Scene scene, const SmoothFileOptions& options, Context& context) {
    SmoothRequest request;
    request.attributes = options.attributes;
    request.kept_tangents = TangentMode::published_no_handedness;
    request.bitangents = true;
    request.keep_instances = options.keep_instances;
    if (options.tangents == TangentChoice::always) request.tangents = TangentNeed::everywhere;
    return add_missing_tangents(std::move(scene), request, context);
}

/// Along borders that share no vertices.
void join_near_borders(SmoothedScene& smoothed, const SmoothFileOptions& options, Context& context) {
    const AttributeOptions& a = options.attributes;
    BorderRequest request{.keep_instances = options.keep_instances};
    request.options = {.distance = options.border_distance,
                       .scope = smoothed.seams ? Scope::model : a.scope,
                       .crease_angle_rad = a.crease_angle_rad,
                       .weld_distance = a.weld_distance,
                       .weight = a.weight,
                       .keep_flat = smoothed.seams.has_value()};
    BorderOutcome outcome;
    smoothed.scene = join_borders(std::move(smoothed.scene), request, outcome, context);
    smoothed.borders = outcome.report;
    report_borders(smoothed.scene, request, outcome, context.report());
}

/// Parts of a world file may have normals of their own kind; their crease angles count.
void warn_of_choices(const Scene& scene, Report& report) {
    const auto is_alike = [](NormalSource source) {
        return source != NormalSource::flat && source != NormalSource::object && source != NormalSource::file;
    };
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (mesh.normal_choice && !is_alike(mesh.normal_choice->source))
            report.add(Remark::warning, scene.source, {},
                       "what parts say of their normals has no effect: all are smoothed alike");
    }
}

void check(const SmoothFileOptions& options) {
    if (!(options.border_distance >= 0) || !std::isfinite(options.border_distance))
        throw Error(ErrorCode::usage, "the border distance must be 0 or more");
    if (options.bitangents && options.tangents == TangentChoice::never)
        throw Error(ErrorCode::usage, "bitangents need tangents");
}

}  // namespace

SmoothedScene smooth_for_file(const Scene& given, const SmoothFileOptions& options, Context& context) {
    check(options);
    const bool is_replaced = options.authored == AuthoredNormals::replaced;
    const std::optional<Scene> cleaned = is_replaced ? std::nullopt : without_useless_normals(given, context);
    const Scene& scene = cleaned ? *cleaned : given;
    warn_of_choices(scene, context.report());
    SharedCharge charge = share(MemoryCharge(context.memory(), table_bytes(scene), "the smoothed scene"));
    const bool keeps = !is_replaced && has_normals(scene);
    SmoothedScene out =
        keeps ? repaired(scene, options, context) : SmoothedScene{with_new_normals(scene, options, false, context)};
    if (options.border_distance > 0) join_near_borders(out, options, context);
    if (options.bitangents) out.scene = with_bitangents(std::move(out.scene), options, context);
    charge_new_arrays(out.scene, unpaid_arrays(given), context);
    out.scene.charges.push_back(std::move(charge));
    return out;
}

}  // namespace rakelight
