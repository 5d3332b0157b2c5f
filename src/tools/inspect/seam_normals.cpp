// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/seam_normals.h"

#include <algorithm>
#include <set>

#include "base/format_text.h"
#include "prepare/normals/missing_normals.h"

namespace rakelight {
namespace {

/// Makes the normals of some of the parts.
/// @param meshes  [parts] of those; only the first `count` get them
/// @param number_of  (i) -> the part that meshes[i] is
template <class NumberOf>
void make_normals(std::vector<PartNormals>& normals, std::span<const AttributeMesh> meshes, std::size_t count,
                  Scope scope, const InspectOptions& options, Context& context, const NumberOf& number_of) {
    std::uint64_t bytes = 0;
    for (const AttributeMesh& m : meshes)
        bytes += m.positions.size() * sizeof(vec3) + m.indices.size() * sizeof(std::uint32_t);
    context.memory().check(bytes, "normals of all objects, to find their seams");
    AttributeOptions attributes;
    attributes.scope = scope;
    attributes.weight = options.prepare.weight;
    attributes.crease_angle_rad = options.prepare.crease_angle_rad;
    attributes.creases = options.prepare.creases;
    attributes.weld_distance = options.weld_distance;
    attributes.tangents = false;
    std::vector<MeshAttributes> made = compute_attributes(meshes, attributes, context);
    for (std::size_t i = 0; i < count; ++i) {
        PartNormals& part = normals[number_of(i)];
        part.made = std::move(made[i].normals);
        part.indices = std::move(made[i].indices);
    }
}

/// The part as a mesh whose normals are made: but for gaps, those of the file are locked.
AttributeMesh part_to_make(const Surfaces& surfaces, std::uint32_t part, Block<std::uint8_t>& locks) {
    AttributeMesh mesh = surfaces.meshes[part];
    const NormalRule& rule = surfaces.rules[part];
    if (!rule.groups) mesh.smoothing = {}, mesh.smoothing_hint = {}, mesh.group_kind = GroupKind::none;
    if (rule.keeps_given && !mesh.normals.empty()) locks = authored_locks(mesh.normals);
    mesh.locked = locks;
    return mesh;
}

/// Whether the part's normals are used as they are.
bool is_given(const Surfaces& surfaces, std::uint32_t part) {
    const AttributeMesh& mesh = surfaces.meshes[part];
    return surfaces.rules[part].keeps_given && !mesh.normals.empty() &&
           normal_gaps(mesh.normals, mesh.indices).count == 0;
}

/// A part's positions with those that its made normals split.
std::vector<vec3> split_positions(const AttributeMesh& mesh, const PartNormals& part) {
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    positions.resize(part.made.size());
    for (std::size_t c = 0; c < part.indices.size(); ++c) positions[part.indices[c]] = mesh.positions[mesh.indices[c]];
    return positions;
}

/// Joins the normals of the parts whose rule says so where they meet.
void join_parts(std::vector<PartNormals>& normals, const Surfaces& surfaces, const InspectOptions& options,
                Context& context) {
    std::vector<std::uint32_t> parts;
    for (std::uint32_t i = 0; i < normals.size(); ++i)
        if (surfaces.rules[i].joins_seams) parts.push_back(i);
    if (parts.empty()) return;
    const MeshesWithNormals with = meshes_with_normals(surfaces, normals, parts, context);
    SeamReport report;
    const SeamOptions how{.crease_angle_rad = options.prepare.crease_angle_rad,
                          .creases = options.prepare.creases,
                          .weld_distance = options.weld_distance};
    apply(join_seams(with.meshes, how, report, context), parts, normals);
}

}  // namespace

bool makes_normals(const Surfaces& surfaces) {
    for (std::uint32_t i = 0; i < surfaces.meshes.size(); ++i)
        if (surfaces.rules[i].scope != Scope::face && !is_given(surfaces, i)) return true;
    return false;
}

std::vector<PartNormals> normals_before(const Surfaces& surfaces, const InspectOptions& options, Context& context) {
    std::vector<PartNormals> normals(surfaces.meshes.size());
    std::vector<std::uint32_t> missing[3];  // by scope
    std::vector<std::uint32_t> given;
    for (std::uint32_t i = 0; i < surfaces.meshes.size(); ++i) {
        if (is_given(surfaces, i))
            normals[i].given = surfaces.meshes[i].normals, given.push_back(i);
        else
            missing[std::size_t(surfaces.rules[i].scope)].push_back(i);
    }
    for (const Scope scope : {Scope::face, Scope::object, Scope::model}) {
        std::vector<std::uint32_t>& parts = missing[std::size_t(scope)];
        if (parts.empty()) continue;
        const std::size_t count = parts.size();  // those that are made; over the model the given ones lie beside them
        if (scope == Scope::model) parts.insert(parts.end(), given.begin(), given.end());
        std::vector<AttributeMesh> meshes;
        std::vector<Block<std::uint8_t>> locks(parts.size());
        meshes.reserve(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) meshes.push_back(part_to_make(surfaces, parts[i], locks[i]));
        make_normals(normals, meshes, count, scope, options, context, [&](std::size_t i) { return parts[i]; });
    }
    join_parts(normals, surfaces, options, context);
    return normals;
}

MeshesWithNormals meshes_with_normals(const Surfaces& surfaces, std::span<const PartNormals> normals,
                                      std::span<const std::uint32_t> parts, Context& context) {
    MeshesWithNormals out;
    out.meshes.reserve(parts.size());
    for (const std::uint32_t i : parts) {
        const PartNormals& part = normals[i];
        AttributeMesh& m = out.meshes.emplace_back(surfaces.meshes[i]);
        if (!part.given.empty()) continue;
        if (part.made.size() > m.positions.size()) {
            context.memory().check(part.made.size() * sizeof(vec3), "normals of all objects, to find their seams");
            m.positions = out.positions.emplace_back(split_positions(m, part));
            m.texcoords = {};
        }
        if (!part.indices.empty()) m.indices = part.indices;
        m.normals = part.made;
    }
    return out;
}

void apply(const std::vector<MeshSeams>& turned, std::span<const std::uint32_t> parts,
           std::vector<PartNormals>& normals) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (turned[i].vertices.empty()) continue;
        PartNormals& part = normals[parts[i]];
        if (!part.given.empty()) part.made.assign(part.given.begin(), part.given.end());
        part.given = {};
        for (std::size_t k = 0; k < turned[i].vertices.size(); ++k)
            part.made[turned[i].vertices[k]] = turned[i].normals[k];
    }
}

/// The same parts, joined where they meet; what has no normals to keep is smoothed over the model.
static Surfaces joined_surfaces(Surfaces surfaces) {
    for (NormalRule& rule : surfaces.rules) {
        rule.scope = Scope::model, rule.joins_seams = true;
        rule.groups = rule.groups || rule.keeps_given;
    }
    return surfaces;
}

static bool keeps_authored(const Surfaces& surfaces, const InspectOptions& options) {
    return options.authored == AuthoredNormals::seams && keep_some(surfaces);
}

std::vector<PartNormals> normals_after(const Surfaces& surfaces, const InspectOptions& options, Context& context) {
    if (keeps_authored(surfaces, options)) return normals_before(joined_surfaces(surfaces), options, context);
    std::vector<PartNormals> normals(surfaces.meshes.size());
    make_normals(normals, surfaces.meshes, surfaces.meshes.size(), Scope::model, options, context,
                 [](std::size_t i) { return i; });
    return normals;
}

/// Any is one: files may hold zeros.
static bool has_given(const AttributeMesh& mesh) {
    return !mesh.normals.empty() && !normal_gaps(mesh.normals, mesh.indices).is_all;
}

static std::string name_of_unjoined(const Surfaces& surfaces) {
    std::size_t missing = 0;
    std::set<Scope> scopes;
    for (std::size_t i = 0; i < surfaces.meshes.size(); ++i) {
        if (surfaces.rules[i].keeps_given && has_given(surfaces.meshes[i])) continue;
        ++missing;
        scopes.insert(surfaces.rules[i].scope);
    }
    if (missing == 0) return surfaces.meshes.empty() ? "smoothed per object" : "the file's";
    const Scope scope = *scopes.begin();
    const std::string made = scopes.size() > 1        ? "computed as the world file says"
                             : scope == Scope::model  ? "smoothed over the model"
                             : scope == Scope::object ? "smoothed per object"
                                                      : "flat";
    if (missing == surfaces.meshes.size()) return made;
    const bool is_overruled = std::any_of(surfaces.rules.begin(), surfaces.rules.end(),
                                          [](const NormalRule& rule) { return !rule.keeps_given; });
    return format_text("the file's, {}{}{} of {} meshes)", made, is_overruled ? " of others (" : " where it has none (",
                       missing, surfaces.meshes.size());
}

std::string name_of_smoothing(const Surfaces& surfaces, const InspectOptions& options) {
    return keeps_authored(surfaces, options) ? "joined where parts meet" : "smoothed over the model";
}

std::string name_of_source(const Surfaces& surfaces) {
    const bool joins = std::any_of(surfaces.rules.begin(), surfaces.rules.end(),
                                   [](const NormalRule& rule) { return rule.joins_seams; });
    return name_of_unjoined(surfaces) + (joins ? ", joined where parts meet" : "");
}

}  // namespace rakelight
