// SPDX-License-Identifier: Apache-2.0
#include "tools/seam_normals.h"

#include <set>

namespace rakelight {
namespace {

/// Makes the normals of some of the parts.
void make_normals(std::vector<PartNormals>& normals, std::span<const AttributeMesh> meshes,
                  const std::vector<std::size_t>& parts, Scope scope, const InspectOptions& options, Context& context) {
    std::vector<AttributeMesh> chosen;
    std::uint64_t bytes = 0;
    for (const std::size_t part : parts) {
        chosen.push_back(meshes[part]);
        bytes += meshes[part].positions.size() * sizeof(vec3) + meshes[part].indices.size() * sizeof(std::uint32_t);
    }
    context.memory().check(bytes, "normals of all objects, to find their seams");
    AttributeOptions attributes;
    attributes.scope = scope;
    attributes.weight = options.prepare.weight;
    attributes.crease_angle_rad = options.prepare.crease_angle_rad;
    attributes.weld_distance = options.weld_distance;
    attributes.tangents = false;
    std::vector<MeshAttributes> made = compute_attributes(chosen, attributes, context);
    for (std::size_t i = 0; i < parts.size(); ++i) normals[parts[i]].made = std::move(made[i]);
}

}  // namespace

std::vector<PartNormals> normals_before(const Surfaces& surfaces, const InspectOptions& options, Context& context) {
    std::vector<PartNormals> normals(surfaces.meshes.size());
    std::vector<std::size_t> missing[3];  // by scope
    std::vector<AttributeMesh> meshes = surfaces.meshes;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const NormalRule& rule = surfaces.rules[i];
        if (!rule.groups)
            meshes[i].smoothing = {}, meshes[i].smoothing_hint = {}, meshes[i].group_kind = GroupKind::none;
        if (rule.keeps_given && !meshes[i].normals.empty())
            normals[i].given = meshes[i].normals;
        else
            missing[std::size_t(rule.scope)].push_back(i);
    }
    for (const Scope scope : {Scope::face, Scope::object, Scope::model})
        if (const auto& parts = missing[std::size_t(scope)]; !parts.empty())
            make_normals(normals, meshes, parts, scope, options, context);
    return normals;
}

std::vector<PartNormals> normals_after(const Surfaces& surfaces, const InspectOptions& options, Context& context) {
    std::vector<PartNormals> normals(surfaces.meshes.size());
    std::vector<std::size_t> all(surfaces.meshes.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    make_normals(normals, surfaces.meshes, all, Scope::model, options, context);
    return normals;
}

std::string name_of_source(const Surfaces& surfaces) {
    std::size_t missing = 0;
    std::set<Scope> scopes;
    for (std::size_t i = 0; i < surfaces.meshes.size(); ++i) {
        if (surfaces.rules[i].keeps_given && !surfaces.meshes[i].normals.empty()) continue;
        ++missing;
        scopes.insert(surfaces.rules[i].scope);
    }
    if (missing == 0) return surfaces.meshes.empty() ? "smoothed per object" : "the file's";
    const Scope scope = *scopes.begin();
    const std::string made = scopes.size() > 1        ? "made as the world says"
                             : scope == Scope::model  ? "smoothed over the model"
                             : scope == Scope::object ? "smoothed per object"
                                                      : "flat";
    if (missing == surfaces.meshes.size()) return made;
    return "the file's, " + made + " where it has none (" + std::to_string(missing) + " of " +
           std::to_string(surfaces.meshes.size()) + " meshes)";
}

}  // namespace rakelight
