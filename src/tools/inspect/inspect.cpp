// SPDX-License-Identifier: Apache-2.0
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>
#include <rakelight/tools/inspect.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "base/name_table.h"
#include "geometry/faults/edge_census.h"
#include "geometry/faults/inside_out.h"
#include "geometry/faults/mesh_faults.h"
#include "geometry/faults/t_junctions.h"
#include "io/reader.h"
#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/missing_normals.h"
#include "prepare/pose_scene.h"
#include "prepare/prepare_scene.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"
#include "tools/inspect/borders.h"
#include "tools/inspect/matched_borders.h"
#include "tools/inspect/surfaces.h"
#include "tools/object_title.h"

namespace rakelight {
namespace {

using Has = ObjectSummary::Has;

/// Counts how many of an object's meshes have something.
class Tally {
public:
    void add(bool has) { ++(has ? yes_ : no_); }
    Has answer() const { return yes_ == 0 ? Has::no : no_ == 0 ? Has::yes : Has::some; }

private:
    int yes_ = 0, no_ = 0;
};

void count(ObjectSummary& object, const Mesh& mesh) {
    ++object.meshes;
    object.vertices += mesh.positions.size();
    object.triangles += mesh.triangle_count();
    if (mesh.topology == Topology::lines) object.lines += mesh.indices.size() / 2;
    if (mesh.topology == Topology::points) object.points += mesh.indices.size();
}

/// @param known  the names that the object has already: a file may give it a hundred thousand
void add_material(ObjectSummary& object, NameSet& known, const Scene& scene, std::uint32_t material) {
    if (material == no_index) return;
    std::string name = scene.materials[material].name;
    if (name.empty()) name = "material " + std::to_string(material);
    if (known.insert(name).second) object.materials.push_back(std::move(name));
}

ObjectSummary summarize(const Scene& scene, std::uint32_t number) {
    const Node& node = scene.nodes[number];
    ObjectSummary object;
    object.name = object_title(scene, number);
    object.node = number;
    Tally normals, tangents, texcoords, colors, groups, targets, influences;
    NameSet materials;
    for (const std::uint32_t index : node.meshes) {
        const Mesh& mesh = scene.meshes[index];
        count(object, mesh);
        add_material(object, materials, scene, mesh.material);
        const NormalGaps gaps = normal_gaps(mesh);
        normals.add(!mesh.normals.empty() && gaps.count == 0);
        if (gaps.count > 0 && !gaps.is_all) normals.add(true);
        tangents.add(!mesh.tangents.empty());
        texcoords.add(!mesh.texcoords.empty());
        colors.add(!mesh.colors.empty());
        groups.add(!mesh.smoothing.empty() || !mesh.smoothing_hint.empty());
        influences.add(node.skin != no_index && !mesh.influences.empty());
        targets.add(!mesh.targets.empty());
    }
    object.normals = normals.answer(), object.tangents = tangents.answer(), object.texcoords = texcoords.answer();
    object.colors = colors.answer(), object.smoothing_groups = groups.answer();
    object.skin = influences.answer(), object.morph_targets = targets.answer();
    return object;
}

void add_array(std::vector<ArraySummary>& arrays, const VertexArray& array, std::size_t vertices) {
    auto known = std::ranges::find(arrays, array.name, &ArraySummary::name);
    if (known == arrays.end()) {
        constexpr double most = std::numeric_limits<double>::infinity();
        arrays.push_back({array.name, array.components, most, -most, 0, 0});
        known = arrays.end() - 1;
    }
    known->vertices += vertices;
    known->components = std::max(known->components, array.components);
    for (const float v : array.values) {
        known->not_finite += !std::isfinite(v);
        if (std::isfinite(v))
            known->low = std::min(known->low, double(v)), known->high = std::max(known->high, double(v));
    }
}

/// Of the meshes that exist, each once.
std::vector<ArraySummary> summarize_arrays(const Scene& scene) {
    std::vector<ArraySummary> arrays;
    for (const Mesh& mesh : scene.meshes)
        for (const VertexArray& array : mesh.arrays) add_array(arrays, array, mesh.positions.size());
    for (ArraySummary& a : arrays)
        if (a.low > a.high) a.low = a.high = 0;
    return arrays;
}

/// [materials] How many of the objects have each.
std::vector<std::uint32_t> objects_of_materials(const Scene& scene, const std::vector<std::uint32_t>& objects) {
    std::vector<std::uint32_t> count(scene.materials.size(), 0), last(scene.materials.size(), no_index);
    for (const std::uint32_t node : objects)
        for (const std::uint32_t mesh : scene.nodes[node].meshes) {
            const std::uint32_t material = scene.meshes[mesh].material;
            if (material == no_index || last[material] == node) continue;
            last[material] = node;
            ++count[material];
        }
    return count;
}

SurfaceSummary summarize(const geometry::ObjectEdges& e, const geometry::ObjectFaults& f, std::uint64_t t_junctions) {
    SurfaceSummary s;
    s.edges = e.edges, s.open_edges = e.open, s.inconsistent_edges = e.inconsistent;
    s.non_manifold_edges = e.non_manifold, s.closed = e.is_closed();
    s.t_junctions = t_junctions;
    s.degenerate_faces = f.degenerate_faces;
    s.zero_normals = f.zero_normals, s.non_finite_normals = f.non_finite_normals;
    s.non_unit_normals = f.non_unit_normals;
    s.mirrored_positions = f.mirrored_places, s.mirror_split_vertices = f.mirror_split_vertices;
    return s;
}

void look_at_surfaces(Inspection& result, const geometry::PlacedMeshes& placed, const geometry::EdgeCensus& census,
                      const Context& context) {
    constexpr std::size_t most_places = 1000;
    const std::uint32_t objects = std::uint32_t(result.objects.size());
    const std::vector<geometry::ObjectFaults> faults = count_faults(placed, objects, context);
    const geometry::TJunctions t = find_t_junctions(placed, census.open_corners, objects, most_places, context);
    result.surfaces.reserve(objects);
    for (std::uint32_t i = 0; i < objects; ++i)
        result.surfaces.push_back(summarize(census.objects[i], faults[i], t.of_objects[i]));
    for (geometry::InsideOutBody& body : find_inside_out(placed, census.open_corners, context))
        result.inside_out.push_back({body.triangles, std::move(body.objects)});
    result.t_junctions = t.count;
    result.edges_not_searched = t.edges_not_searched;
    for (const geometry::TJunction& junction : t.places) {
        const std::uint32_t mesh = placed.input.mesh_of_vertex(junction.place);
        result.t_junction_places.push_back({placed.position(junction.place), placed.input.meshes[mesh].object,
                                            placed.object_of_triangle(junction.corner / 3)});
    }
}

/// Instances are inspected one by one, so a small file can cause much work.
void check_memory(const Surfaces& surfaces, Context& context) {
    constexpr std::uint64_t bytes_per_vertex = 32, bytes_per_corner = 8;  // at the peak: weld, edges
    constexpr std::uint64_t bytes_per_part = 3 * sizeof(AttributeMesh) + sizeof(ObjectSummary) + sizeof(SurfaceSummary);
    std::uint64_t bytes = surfaces.meshes.size() * bytes_per_part;
    for (const AttributeMesh& m : surfaces.meshes)
        bytes += bytes_per_vertex * m.positions.size() + bytes_per_corner * m.indices.size();
    context.memory().check(bytes, "inspecting the surfaces of all instances");
}

/// Border edges whose ends are seams, and then the places that no such edge reaches.
std::vector<SeamLine> find_seam_lines(const geometry::PlacedMeshes& placed, const geometry::EdgeCensus& census,
                                      const BorderReport& report) {
    std::vector<SeamLine> lines;
    std::vector<bool> reached(report.seams_at.size(), false);
    const auto find = [&](std::uint32_t place) {
        const auto at = std::lower_bound(report.seams_at.begin(), report.seams_at.end(), std::pair(place, 0.0f));
        return std::size_t(at != report.seams_at.end() && at->first == place ? at - report.seams_at.begin() : -1);
    };
    for (const geometry::PlaceEdge& edge : census.border_edges) {
        const std::size_t a = find(edge.a), b = find(edge.b), nowhere = std::size_t(-1);
        if (a != nowhere) reached[a] = true;
        if (b != nowhere) reached[b] = true;
        if (a == nowhere && b == nowhere) continue;
        lines.push_back({placed.position(edge.a), placed.position(edge.b), a == nowhere ? 0 : report.seams_at[a].second,
                         b == nowhere ? 0 : report.seams_at[b].second});
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const dvec3 p = placed.position(report.seams_at[i].first);
        if (!reached[i]) lines.push_back({p, p, report.seams_at[i].second, report.seams_at[i].second});
    }
    return lines;
}

/// @param border  with parts as its meshes
void name_meshes(BorderSummary& border, const Scene& scene, const Surfaces& surfaces) {
    border.mesh_a = surfaces.parts[border.mesh_a].mesh, border.mesh_b = surfaces.parts[border.mesh_b].mesh;
    border.material_a = scene.meshes[border.mesh_a].material, border.material_b = scene.meshes[border.mesh_b].material;
}

/// Whether any two meshes have a vertex at one place.
bool share_places(const geometry::PlacedMeshes& placed) {
    const std::vector<std::uint32_t>& base = placed.input.vertex_base;
    for (std::size_t m = 0; m + 1 < base.size(); ++m)
        for (std::uint32_t v = base[m]; v < base[m + 1]; ++v)
            if (placed.place[v] < base[m] || placed.place[v] >= base[m + 1]) return true;
    return false;
}

void look_at_borders(Inspection& result, const Scene& scene, const Surfaces& surfaces,
                     const geometry::PlacedMeshes& placed, const geometry::EdgeCensus& census,
                     const InspectOptions& options, Context& context) {
    const bool shares = share_places(placed), measures = options.border_distance > 0,
               proposes = !measures && options.surfaces && have_open_borders(placed, census) &&
                          can_propose_border_distance(result.file, census, context);
    SeamNormals normals;
    if (shares || measures || proposes) normals.before = normals_before(surfaces, options, context);
    if (shares || measures) normals.after = normals_after(surfaces, options, context);
    if (shares) {
        BorderReport report = find_borders(placed, normals, context);
        if (options.seam_lines) result.seam_lines = find_seam_lines(placed, census, report);
        result.seams = report.totals;
        result.borders = std::move(report.borders);
        for (BorderSummary& border : result.borders) name_meshes(border, scene, surfaces);
        result.borders_left_out = report.borders_left_out;
    }
    if (measures) look_at_matched_borders(result, surfaces, normals, options, context);
    if (proposes) propose_border_distance(result, surfaces, normals.before, options, context);
    result.shared_positions = result.seams.positions;
    for (std::size_t i = 0; i < surfaces.meshes.size(); ++i)
        if (surfaces.rules[i].keeps_given)
            result.seams.missing_normals += normal_gaps(surfaces.meshes[i].normals, surfaces.meshes[i].indices).count;
    result.seams.normals_before = name_of_source(surfaces);
    result.seams.normals_after = name_of_smoothing(surfaces, options);
    const geometry::CreaseRange creases =
        geometry::crease_range(surfaces.meshes, {.crease_angle_rad = options.prepare.crease_angle_rad});
    const auto rounded_deg = [](double rad) { return std::round(degrees(rad) * 1e9) / 1e9; };  // 60 and not 59.999...
    result.seams.crease_angle_deg = rounded_deg(creases.least);
    result.seams.crease_angle_max_deg = rounded_deg(creases.most);
    result.seams.creases_are_automatic = options.prepare.creases == Creasing::automatic;
}

void look_at_winding(Inspection& result, const geometry::EdgeCensus& census) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> edges;
    for (const geometry::InconsistentBorder& b : census.inconsistent_borders) {
        result.seams.inconsistent_edges += b.edges;
        result.inconsistent_pairs.push_back({b.object_a, b.object_b, b.edges});
        edges[{b.object_a, b.object_b}] = b.edges;
    }
    for (BorderSummary& border : result.borders)
        if (const auto found = edges.find({border.object_a, border.object_b}); found != edges.end())
            border.inconsistent_edges = found->second;
    std::vector<InconsistentPair>& pairs = result.inconsistent_pairs;
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const InconsistentPair& x, const InconsistentPair& y) { return x.edges > y.edges; });
    if (pairs.size() > most_borders) pairs.resize(most_borders);
}

}  // namespace

static void look_at_choices(Inspection& result, const Surfaces& surfaces, const InspectOptions& options,
                            Context& context) {
    AttributeOptions attributes;
    attributes.crease_angle_rad = options.prepare.crease_angle_rad;
    attributes.creases = options.prepare.creases;
    attributes.weld_distance = options.weld_distance;
    if (attributes.creases == Creasing::automatic)
        result.creases = find_creases(surfaces.meshes, attributes, context).report;
    if (options.prepare.weight == CornerWeight::automatic)
        result.choices = normal_choices(surfaces.meshes, attributes, context);
}

/// A file decides how many objects there are and how long their names and those of their materials.
static std::uint64_t bytes_of_objects(const Scene& scene, const std::vector<std::uint32_t>& objects) {
    constexpr std::uint64_t beside_text = 32;  // what an allocation takes more than is requested
    std::uint64_t bytes = 0;
    for (const std::uint32_t node : objects) {
        bytes += sizeof(ObjectSummary) + sizeof(SurfaceSummary) + scene.nodes[node].name.size() + 2 * beside_text;
        for (const std::uint32_t mesh : scene.nodes[node].meshes)
            if (const std::uint32_t material = scene.meshes[mesh].material; material != no_index)
                bytes += sizeof(std::string) + scene.materials[material].name.size() + beside_text;
    }
    return bytes;
}

/// All but nodes and meshes, of which there may be millions.
static Scene without_objects(const Scene& scene) {
    Scene out;
    out.source = scene.source;
    out.materials = scene.materials, out.textures = scene.textures;
    out.lights = scene.lights, out.cameras = scene.cameras;
    out.skins = scene.skins, out.animations = scene.animations;
    out.fog = scene.fog, out.environment = scene.environment;
    out.missing_normals_are_flat = scene.missing_normals_are_flat;
    out.charges = scene.charges;
    return out;
}

Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context) {
    if (!std::isfinite(options.weld_distance)) throw Error(ErrorCode::usage, "the weld distance must be finite");
    if (!(options.border_distance >= 0) || !std::isfinite(options.border_distance))
        throw Error(ErrorCode::usage, "the border distance must be 0 or more and finite");
    check_options(options.prepare);
    validate(scene);
    Inspection result;
    result.file = scene.source;
    result.unit = io::length_unit(scene.source);
    context.progress("inspect", 0);
    result.triangles = triangle_count(scene);
    std::vector<std::uint32_t> objects;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i)
        if (!scene.nodes[i].meshes.empty()) objects.push_back(i);
    const MemoryCharge charge(context.memory(), bytes_of_objects(scene, objects), "the list of objects");
    result.objects.reserve(objects.size());
    for (const std::uint32_t node : objects) result.objects.push_back(summarize(scene, node));
    result.material_objects = objects_of_materials(scene, objects);
    result.arrays = summarize_arrays(scene);
    const std::optional<Scene> posed = posed_outline(scene, context);
    const Bounds bounds = world_bounds(posed ? *posed : scene);
    result.is_posed = posed.has_value();
    if (!bounds.empty()) result.low = bounds.low, result.high = bounds.high;
    if (options.borders || options.surfaces) {
        const Surfaces surfaces = collect_surfaces(scene, objects, options.prepare.normals);
        check_memory(surfaces, context);
        const geometry::PlacedMeshes placed = geometry::place_vertices(surfaces.meshes, options.weld_distance, context);
        const geometry::EdgeCensus census = count_edges(placed, std::uint32_t(objects.size()), context);
        context.throw_if_cancelled();
        context.progress("inspect", 0.3);
        if (options.surfaces) look_at_surfaces(result, placed, census, context);
        context.throw_if_cancelled();
        if (makes_normals(surfaces)) look_at_choices(result, surfaces, options, context);
        context.progress("inspect", 0.6);
        if (options.borders) look_at_borders(result, scene, surfaces, placed, census, options, context);
        look_at_winding(result, census);
        if (options.borders && !scene.skins.empty())
            warn_of_parting_vertices(scene, drawn_instances(scene), bind_pose_matrices(scene), context);
    }
    // Only what it says of the tangents is wanted.
    if (options.prepare.measure_orthogonality && result.triangles > 0)
        valid::prepare_scene(scene, options.prepare, context);
    result.scene = without_objects(scene);
    return result;
}

}  // namespace rakelight
