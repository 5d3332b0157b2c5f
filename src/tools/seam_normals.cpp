// SPDX-License-Identifier: Apache-2.0
#include "tools/seam_normals.h"

#include <algorithm>

namespace rakelight {
namespace {

bool keeps_given(NormalSource source) { return source == NormalSource::automatic || source == NormalSource::file; }

Scope scope_of(NormalSource source) {
    switch (source) {
        case NormalSource::model:
            return Scope::model;
        case NormalSource::file:
        case NormalSource::flat:
            return Scope::face;
        default:
            return Scope::object;
    }
}

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

std::vector<PartNormals> normals_before(std::span<const AttributeMesh> meshes, const InspectOptions& options,
                                        Context& context) {
    std::vector<PartNormals> normals(meshes.size());
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (keeps_given(options.prepare.normals) && !meshes[i].normals.empty())
            normals[i].given = meshes[i].normals;
        else
            missing.push_back(i);
    if (!missing.empty()) make_normals(normals, meshes, missing, scope_of(options.prepare.normals), options, context);
    return normals;
}

std::vector<PartNormals> normals_after(std::span<const AttributeMesh> meshes, const InspectOptions& options,
                                       Context& context) {
    std::vector<PartNormals> normals(meshes.size());
    std::vector<std::size_t> all(meshes.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    make_normals(normals, meshes, all, Scope::model, options, context);
    return normals;
}

std::string name_of_source(std::span<const AttributeMesh> meshes, NormalSource source) {
    const Scope scope = scope_of(source);
    const char* made = scope == Scope::model    ? "smoothed over the model"
                       : scope == Scope::object ? "smoothed per object"
                                                : "flat";
    const auto given = std::count_if(meshes.begin(), meshes.end(),
                                     [&](const AttributeMesh& m) { return keeps_given(source) && !m.normals.empty(); });
    const std::size_t missing = meshes.size() - std::size_t(given);
    if (given == 0) return made;
    if (missing == 0) return "the file's";
    return "the file's, " + std::string(made) + " where it has none (" + std::to_string(missing) + " of " +
           std::to_string(meshes.size()) + " meshes)";
}

}  // namespace rakelight
