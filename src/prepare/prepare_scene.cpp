// SPDX-License-Identifier: Apache-2.0
// prepare_scene(): repair, texture coordinates, normals of the chosen source, tangents where needed.
#include <algorithm>
#include <cmath>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include "base/enumerators.h"
#include "math/linear.h"
#include "prepare/bound_sides.h"
#include "prepare/moving_placements.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/normals/repair_seams.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/normals/tangent_report.h"
#include "prepare/pose_scene.h"
#include "prepare/prepare_scene.h"
#include "prepare/project_texcoords.h"
#include "prepare/refine/displace.h"
#include "prepare/refine/subdivide_scene.h"
#include "prepare/repair/repair.h"
#include "prepare/repair/turn_triangles.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/faults.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/material_table.h"
#include "scene/placement.h"
#include "scene/validate_parts.h"

namespace rakelight {
namespace {

/// The computed normals, for meshes without normals (or all meshes if the file's are ignored).
SmoothRequest request_for(const PrepareOptions& options) {
    SmoothRequest request;
    request.attributes.weight = options.weight;
    request.attributes.crease_angle_rad = options.crease_angle_rad;
    request.attributes.creases = options.creases;
    request.attributes.weld_distance = options.weld_distance;
    request.attributes.orthogonalize = options.orthogonalize;
    request.attributes.measure_orthogonality = options.measure_orthogonality;
    request.keep_instances = options.keep_instances;
    request.bitangents = options.bitangents;
    if (options.tangents) request.attributes.tangent_mode = request.kept_tangents = *options.tangents;
    if (options.all_tangents) request.tangents = TangentNeed::everywhere;
    request.only_missing = true;
    request.source = options.normals;
    return request;
}

BorderRequest border_request_for(const PrepareOptions& options) {
    BorderRequest request{.source = options.normals, .keep_instances = options.keep_instances};
    request.options.distance = options.border_distance;
    request.options.crease_angle_rad = options.crease_angle_rad;
    request.options.weld_distance = options.weld_distance;
    request.options.weight = options.weight;
    return request;
}

bool needs_tangents(const Scene& scene, const Mesh& mesh) {
    return mesh.material != no_index && needs_tangents(scene.materials[mesh.material]);
}

/// Whether any triangle has texture area; stops at the first one.
bool spans_texture(const Mesh& mesh, const TangentCoordinates& coordinates) {
    if (inverse(coordinates.matrix) == UvMatrix{0, 0, 0, 0}) return false;
    const Block<vec2>& uv = mesh.texcoords[coordinates.set];
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const vec2 a = uv[mesh.indices[3 * t]], b = uv[mesh.indices[3 * t + 1]], c = uv[mesh.indices[3 * t + 2]];
        if (double(b.x - a.x) * double(c.y - a.y) != double(c.x - a.x) * double(b.y - a.y)) return true;
    }
    return false;
}

/// Explains why a model looks faceted: glTF requires it.
void note_flat_meshes(const Scene& scene, Report& report) {
    for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        if (mesh.topology != Topology::triangles || !mesh.normals.empty()) continue;
        if (mesh.normal_choice && mesh.normal_choice->source != NormalSource::automatic) continue;  // requested
        if (normal_rule(scene, mesh, NormalSource::automatic).scope == Scope::face)
            report.add(Remark::note, scene.source, Place{"mesh", i, mesh.name}.text(),
                       "no normals: flat faces, as glTF says; 'normals' model smooths", {"normals"});
    }
}

bool has_coat_map(const Material& m) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    return m.model == MaterialModel::metallic_roughness && p.clearcoat > 0 && p.clearcoat_normal_texture;
}

/// The clearcoat map may use another texture coordinate set than the surface, and either set may be missing.
bool lacks_coat_coordinates(const Scene& scene, const Mesh& mesh) {
    const Material& m = scene.materials[mesh.material];
    return has_coat_map(m) && !has_coordinates(mesh, m.metallic_roughness.clearcoat_normal_texture.texcoord_set);
}

/// Why maps and highlights that depend on texture coordinates have no effect on this mesh; null: they have, or there
/// are none, or only the clearcoat map lacks coordinates.
const char* fault_of_coordinates(const Scene& scene, const Mesh& mesh, Bump wanted) {
    const Material& m = scene.materials[mesh.material];
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    const Bump bump = bump_of(m, wanted);
    const bool heights = m.height_texture && reads_heights(bump), normals = m.normal_texture && bump != Bump::none,
               stretched = m.ward_alpha || (m.model == MaterialModel::metallic_roughness && p.anisotropy > 0);
    if (heights && !has_coordinates(mesh, m.height_texture.texcoord_set))
        return "the height map is not used: the mesh has no texture coordinates for it";
    if (normals && !heights && !has_coordinates(mesh, m.normal_texture.texcoord_set))
        return "the normal map is not used: the mesh has no texture coordinates for it";
    const bool coats = has_coat_map(m) && !lacks_coat_coordinates(scene, mesh);
    if (!heights && !normals && !coats && !stretched) return nullptr;
    const TangentCoordinates coordinates = tangent_coordinates(scene, mesh, TangentNeed::where_needed);
    if (!coordinates.exist())
        return "bumps and stretched highlights have no direction: the mesh has no texture coordinates";
    if (!mesh.tangents.empty() || spans_texture(mesh, coordinates)) return nullptr;
    return heights   ? "no triangle has an area in the height map: tangents have no direction"
           : normals ? "no triangle has an area in the normal map: tangents have no direction"
                     : "no triangle has an area in the texture: tangents have no direction";
}

void warn_of_tangents(const Scene& scene, Bump wanted, Report& report) {
    std::vector<bool> seen(scene.meshes.size(), false);
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || !needs_tangents(scene, mesh)) continue;
        seen[instance.mesh] = true;
        const std::string place = Place{"mesh", instance.mesh, mesh.name}.text();
        if (const char* const message = fault_of_coordinates(scene, mesh, wanted))
            report.add(Remark::warning, scene.source, place, message);
        if (lacks_coat_coordinates(scene, mesh))
            report.add(Remark::warning, scene.source, place,
                       "the normal map of the clearcoat is not used: the mesh has no texture coordinates for it");
    }
}

/// For missing coordinates; missing directions are reported by warn_of_tangents().
bool shows_one_color(const TextureRole& role, const Material& m) {
    return role.is_shown_by(m) && role.number != role_opacity && !role.is_direction();
}

/// The same as warn_of_tangents() for normal maps.
void warn_of_textures(const Scene& scene, Report& report) {
    std::vector<bool> seen(scene.meshes.size(), false);
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || mesh.material == no_index) continue;
        seen[instance.mesh] = true;
        const Material& m = scene.materials[mesh.material];
        for (const TextureRole& role : texture_roles()) {
            const TextureUse& use = role.in(m);
            if (!use || has_coordinates(mesh, use.texcoord_set) || !shows_one_color(role, m)) continue;
            report.add(Remark::warning, scene.source, Place{"mesh", instance.mesh, mesh.name}.text(),
                       mesh.texcoords.empty()
                           ? "a texture shows one color: the mesh has no texture coordinates; 'uv' makes some"
                           : "a texture shows one color: the mesh has no texture coordinates for it",
                       {"uv"});
            break;
        }
    }
}

/// Subdivided meshes have the limit surface's normals, which no crease angle and no scope of smoothing changes.
Scene subdivided(Scene scene, const PrepareOptions& options, Context& context) {
    if (!wants_subdivision(scene, options.subdivision)) return scene;
    std::vector<Block<vec3>> before;
    for (const Mesh& mesh : scene.meshes) before.push_back(mesh.positions);
    Scene out = subdivide_scene(std::move(scene), options.subdivision, context);
    for (std::size_t i = 0; i < out.meshes.size(); ++i) {
        const NormalRule rule = normal_rule(out, out.meshes[i], options.normals);
        const bool are_flat = !rule.keeps_given && rule.scope == Scope::face;
        if (are_flat && (i >= before.size() || !(out.meshes[i].positions == before[i]))) out.meshes[i].normals = {};
    }
    return out;
}

/// Removes shapes of meshes whose triangles were changed or are requested.
void drop_shapes(Scene& scene, const std::set<const void*>& kept, const PrepareOptions& options) {
    for (Mesh& mesh : scene.meshes) {
        if (!mesh.shape) continue;
        const NormalRule rule = normal_rule(scene, mesh, options.normals);
        if (options.tessellate || !rule.keeps_given || !kept.contains(mesh.positions.identity())) mesh.shape.reset();
    }
}
/// Of those that have a shape.
std::set<const void*> places_of(const Scene& scene) {
    std::set<const void*> places;
    for (const Mesh& mesh : scene.meshes)
        if (mesh.shape) places.insert(mesh.positions.identity());
    return places;
}

/// The stages for one scene. Results of a stage are charged before the next one allocates.
class Preparing {
public:
    Preparing(const Scene& scene, const PrepareOptions& options, Context& context)
        : options_(options), context_(context), request_(request_for(options)), own_(unpaid_arrays(scene)) {}

    /// The stages before the pose, for counter-clockwise triangles.
    BoundScene bind(Scene scene) const {
        Report& report = context_.report();
        BoundScene bound;
        if (wants_subdivision(scene, options_.subdivision))  // control nets are animated
            scene = paid(valid::posed_scene(std::move(scene), context_));
        scene.pose = {};
        if (is_posable(scene)) scene = with_own_meshes(std::move(scene), context_);
        check_nodes(scene, report);
        for (Mesh& mesh : scene.meshes) mesh.arrays.clear(), mesh.bitangents = {};
        scene = paid(repair_scene(std::move(scene), options_.normals, context_));
        const auto places = places_of(scene);
        scene = paid(subdivided(std::move(scene), options_, context_));
        drop_shapes(scene, places, options_);
        scene = paid(project_texcoords(std::move(scene), options_.uv, context_));
        warn_of_tangents(scene, options_.bump, report);
        warn_of_textures(scene, report);
        if (options_.normals == NormalSource::automatic) note_flat_meshes(scene, report);
        for (Mesh& mesh : scene.meshes)
            if (options_.tangents && (options_.all_tangents || needs_tangents(scene, mesh)))
                mesh.tangents = {};  // the file's do not count
        if (joins_borders() && options_.normals == NormalSource::automatic) join_kept_normals(scene);
        context_.throw_if_cancelled();
        if (options_.measure_orthogonality) report_kept_tangents(scene, report);
        scene = with_seams_joined(with_normals(std::move(scene), is_posable(scene) ? &bound.made : nullptr));
        const bool waits = wants_displacement(scene, options_.displacement);  // for the new surface
        const bool moves = is_posable(scene);
        bound.scene =
            waits && !moves ? std::move(scene) : paid(add_missing_tangents(std::move(scene), request_, context_));
        if (joins_borders() && !waits) bound = with_borders_joined(std::move(bound));
        if (moves) bound.scene.normal_sides = bound_sides(bound.scene, context_);
        return bound;
    }

    /// The pose and later stages.
    Scene finish(BoundScene bound, const Rare<ScenePose>& pose) const {
        UnposedScene unposed = finish_unposed(std::move(bound), pose);
        PoseTaker(unposed, context_).take_all();
        return paid(std::move(unposed.scene));
    }

    /// Decides which vertices must be posed here: those of grouped meshes (recomputed normals), of matched borders
    /// (joined again), and all for displacement. Others are posed by the engine (for gl see Renderer::pose_meshes()).
    UnposedScene finish_unposed(BoundScene bound, const Rare<ScenePose>& pose) const {
        UnposedScene unposed{std::move(bound.scene)};
        if (is_posable(unposed.scene)) {
            unposed.scene.pose = pose;
            unposed = valid::unposed_scene(std::move(unposed.scene), context_);
            PoseTaker taker(unposed, context_);
            for (const GeneratedAttributes& made : bound.made)
                for (const std::uint32_t mesh : made.numbers) taker.take(mesh);
            for (const BoundBorders& set : bound.borders)
                for (const Instance& instance : set.instances) taker.take(instance.mesh);
            for (const GeneratedAttributes& made : bound.made) recompute_attributes(made, unposed.scene, context_);
            MatchReport unread;
            for (const BoundBorders& set : bound.borders)
                unposed.scene = join_borders(std::move(unposed.scene), set, options_.keep_instances, unread, context_);
            unposed.scene = paid(std::move(unposed.scene));
        }
        if (!wants_displacement(unposed.scene, options_.displacement)) return unposed;
        PoseTaker(unposed, context_).take_all();
        unposed.scene.normal_sides = nullptr;  // of other triangles
        BoundScene rough{paid(add_missing_tangents(displaced(paid(std::move(unposed.scene))), request_, context_))};
        unposed.scene = joins_borders() ? with_borders_joined(std::move(rough)).scene : std::move(rough.scene);
        return unposed;
    }

    Scene paid(Scene scene) const {
        charge_new_arrays(scene, own_, context_);
        return scene;
    }

private:
    /// Missing normals, one pass per scope: all meshes with scope model are smoothed together, first, while the normals
    /// beside them are those of the file.
    Scene with_normals(Scene scene, std::vector<GeneratedAttributes>* made) const {
        SmoothRequest request = request_;
        request.made = made;
        if (is_published(request.kept_tangents))
            request.tangents = TangentNeed::none;  // add_missing_tangents() makes them
        for (const Scope scope : {Scope::model, Scope::object, Scope::face}) {
            request.attributes.scope = scope;
            scene = paid(smooth_meshes(std::move(scene), request, context_));
        }
        return scene;
    }

    /// Over all parts with this option together.
    Scene with_seams_joined(Scene scene) const {
        const auto asks = [&](const Mesh& mesh) { return normal_rule(scene, mesh, options_.normals).joins_seams; };
        if (std::none_of(scene.meshes.begin(), scene.meshes.end(), asks)) return scene;
        SeamReport seams;
        const SeamRequest request{{.crease_angle_rad = options_.crease_angle_rad,
                                   .creases = options_.creases,
                                   .weld_distance = options_.weld_distance},
                                  options_.normals,
                                  options_.keep_instances};
        scene = paid(join_seams(std::move(scene), request, seams, context_));
        if (seams.turned + seams.flat_pairs + seams.crease_pairs > 0)
            context_.report().add(Remark::note, scene.source, {}, describe(seams));
        return scene;
    }

    bool joins_borders() const { return options_.border_distance > 0; }

    /// Immediately for static scenes; animated ones are deferred to finish(), with a remark.
    BoundScene with_borders_joined(BoundScene bound) const {
        const BorderRequest request = border_request_for(options_);
        BorderOutcome outcome;
        bound.scene = paid(join_borders(std::move(bound.scene), request, outcome, context_, &bound.borders));
        report_borders(bound.scene, request, outcome, context_.report());
        return bound;
    }

    Scene displaced(Scene scene) const {
        if (!wants_displacement(scene, options_.displacement)) return scene;
        context_.throw_if_cancelled();
        const auto places = places_of(scene);
        scene = paid(displace_scene(std::move(scene), options_.displacement, context_));
        drop_shapes(scene, places, options_);
        SmoothRequest again = request_;  // the new surface's, over all objects
        again.attributes.scope = Scope::model;
        again.every_scope = true;
        return paid(smooth_meshes(std::move(scene), again, context_));
    }

    const PrepareOptions& options_;
    Context& context_;
    const SmoothRequest request_;
    const std::set<const void*> own_;  ///< uncharged arrays of the caller
};

/// Temporary memory of the stages per node, instance and mesh: matrices and lists.
std::uint64_t working_bytes(const Scene& scene) {
    std::uint64_t bytes = scene.nodes.size() * 2 * sizeof(dmat4) + scene.meshes.size() * 64;
    for (const Node& node : scene.nodes) bytes += node.meshes.size() * 64;
    return bytes;
}

}  // namespace

void check_options(const PrepareOptions& o) {
    const auto require = [](bool is_fine, const std::string& fault) {
        if (!is_fine) throw Error(ErrorCode::usage, fault);
    };
    require(o.crease_angle_rad >= 0 && o.crease_angle_rad <= pi, "the crease angle must be 0 to 180 degrees");
    require(o.border_distance >= 0 && std::isfinite(o.border_distance), "the border distance must be 0 or more");
    require(exists(o.normals, NormalSource::seams), no_such("source of normals", o.normals));
    require(exists(o.weight, CornerWeight::automatic), no_such("weight", o.weight));
    require(exists(o.creases, Creasing::automatic), no_such("way to find creases", o.creases));
    require(exists(o.uv, UvProjection::cylinder), no_such("projection of texture coordinates", o.uv));
    require(exists(o.orthogonalize, Orthogonalize::off), no_such("way to orthogonalize", o.orthogonalize));
    require(exists(o.bump, Bump::displacement), no_such("bump technique", o.bump));
    const TangentMode tangents = o.tangents.value_or(TangentMode::averaged);
    require(exists(tangents, TangentMode::published_no_handedness), no_such("way to make tangents", tangents));
    require(!o.bitangents || is_published(tangents),
            "bitangents of their own are those of the tangents 'published' and 'published-no-handedness'");
    for (const char* const fault : {fault_of(o.subdivision), fault_of(o.displacement.relief)})
        require(!fault, fault ? fault : "");
    require(o.displacement.edge >= 0 && std::isfinite(o.displacement.edge),
            "the edge of a displacement must be 0 or more");
}

Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context) {
    validate(scene);
    return valid::prepare_scene(std::move(scene), options, context);
}

Scene valid::prepare_scene(Scene scene, const PrepareOptions& options, Context& context) {
    check_options(options);
    const MemoryCharge working(context.memory(), working_bytes(scene), "preparing the scene");
    const Preparing preparing(scene, options, context);
    const Rare<ScenePose> pose = scene.pose;
    if (!options.clockwise_fronts) return preparing.finish(preparing.bind(std::move(scene)), pose);
    TriangleTurner turner;
    scene = turner.turned(std::move(scene), context);
    scene = preparing.finish(preparing.bind(std::move(scene)), pose);
    scene.normal_sides = nullptr;  // of reversed triangles
    return preparing.paid(turner.turned(std::move(scene), context));
}

bool has_bind_pose(const Scene& scene, const PrepareOptions& options) {
    return is_posable(scene) && !options.clockwise_fronts && !wants_subdivision(scene, options.subdivision);
}

BoundScene bind_scene(Scene scene, const PrepareOptions& options, Context& context) {
    check_options(options);
    const MemoryCharge working(context.memory(), working_bytes(scene), "preparing the scene");
    return Preparing(scene, options, context).bind(std::move(scene));
}

Scene finish_scene(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options, Context& context) {
    const Preparing preparing(bound.scene, options, context);
    return preparing.finish(std::move(bound), pose);
}

UnposedScene finish_unposed(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options,
                            Context& context) {
    const Preparing preparing(bound.scene, options, context);
    return preparing.finish_unposed(std::move(bound), pose);
}

}  // namespace rakelight
