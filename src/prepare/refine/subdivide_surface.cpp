// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/subdivide_surface.h"

#include <algorithm>
#include <cmath>

#include "base/cancel_check.h"
#include "geometry/refine/polygon_loops.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr std::uint32_t max_corners = 60000;  ///< of a polygon; OpenSubdiv uses 16 bits

bool is_mirrored(const SurfacePart& part) { return determinant(upper_left(part.to_surface)) < 0; }

/// Vertices of one part's fine corners: one for each combination of point, normal and values.
class CornerVertices {
public:
    explicit CornerVertices(std::size_t points) : newest_(points, no_index) {}

    /// @param key indices of normal and values
    std::uint32_t number(std::uint32_t point, std::span<const std::uint32_t> key) {
        for (std::uint32_t v = newest_[point]; v != no_index; v = older_[v])
            if (std::equal(key.begin(), key.end(), keys_.begin() + std::ptrdiff_t(v * key.size()))) return v;
        const std::uint32_t v = std::uint32_t(points_.size());
        points_.push_back(point);
        keys_.insert(keys_.end(), key.begin(), key.end());
        older_.push_back(newest_[point]);
        newest_[point] = v;
        return v;
    }
    const std::vector<std::uint32_t>& points() const { return points_; }
    std::uint32_t key(std::size_t vertex, std::size_t part, std::size_t parts) const {
        return keys_[vertex * parts + part];
    }

    void clear() {
        for (const std::uint32_t p : points_) newest_[p] = no_index;
        points_.clear();
        keys_.clear();
        older_.clear();
    }

private:
    std::vector<std::uint32_t> newest_;  ///< [points] chains of vertices
    std::vector<std::uint32_t> points_, older_, keys_;
};

/// The refined surface.
struct Refined {
    geometry::LimitSurface surface;
    std::vector<geometry::LimitValues> values;  ///< texture coordinates, then colors
};

/// The part's fine faces as triangles of its own vertices, which are appended to `vertices`.
std::vector<std::uint32_t> number_corners(const SurfacePart& part, const Refined& fine, std::uint32_t first_face,
                                          std::uint32_t end_face, CornerVertices& vertices, const Context& context) {
    const std::uint32_t n = fine.surface.corners_of_face;
    const bool turns = is_mirrored(part);
    std::vector<std::uint32_t> indices, key(1 + fine.values.size());
    indices.reserve(std::size_t(end_face - first_face) * 3 * (n - 2));
    vertices.clear();
    CancelCheck check(context);
    for (std::uint32_t f = first_face; f < end_face; ++f, check()) {
        std::uint32_t corners[4];
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::size_t c = std::size_t(f) * n + k;
            key[0] = fine.surface.normal_of[c];
            for (std::size_t i = 0; i < fine.values.size(); ++i) key[1 + i] = fine.values[i].corners[c];
            corners[k] = vertices.number(fine.surface.vertices[c], key);
        }
        for (std::uint32_t k = 2; k < n; ++k)
            indices.insert(indices.end(), {corners[0], corners[turns ? k : k - 1], corners[turns ? k - 1 : k]});
    }
    return indices;
}

/// Points and normals, transformed to the part's object space.
void set_points(Mesh& mesh, const SurfacePart& part, const Refined& fine, const CornerVertices& vertices,
                const Context& context) {
    dmat4 to_object;
    inverse_affine(part.to_surface, to_object);
    const bool stays = part.to_surface == dmat4{};
    const dmat3 back = upper_left(transpose(part.to_surface));
    std::vector<vec3> positions, normals;
    CancelCheck check(context);
    for (std::size_t v = 0; v < vertices.points().size(); ++v, check()) {
        const dvec3 p = fine.surface.positions[vertices.points()[v]];
        const dvec3 normal = fine.surface.normals[vertices.key(v, 0, 1 + fine.values.size())];
        positions.push_back(cast<float>(stays ? p : transform_point(to_object, p)));
        normals.push_back(cast<float>(stays ? normal : normalize_or(back * normal, {0, 0, 1})));
    }
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
}

void set_values(Mesh& mesh, const Refined& fine, const CornerVertices& vertices) {
    const auto value = [&](std::size_t v, std::size_t i) {
        return fine.values[i].values[vertices.key(v, 1 + i, 1 + fine.values.size())];
    };
    for (std::size_t set = 0; set < mesh.texcoords.size(); ++set) {
        std::vector<vec2> texcoords;
        for (std::size_t v = 0; !mesh.texcoords[set].empty() && v < vertices.points().size(); ++v)
            texcoords.push_back({float(value(v, set).x), float(value(v, set).y)});
        mesh.texcoords[set] = std::move(texcoords);
    }
    std::vector<vec4> colors;
    for (std::size_t v = 0; !mesh.colors.empty() && v < vertices.points().size(); ++v)
        colors.push_back(cast<float>(value(v, fine.values.size() - 1)));
    mesh.colors = std::move(colors);
}

Mesh mesh_of(const SurfacePart& part, const Refined& fine, std::uint32_t first_face, std::uint32_t end_face,
             CornerVertices& vertices, const Context& context) {
    Mesh mesh = *part.mesh;
    mesh.indices = number_corners(part, fine, first_face, end_face, vertices, context);
    set_points(mesh, part, fine, vertices, context);
    context.throw_if_cancelled();
    set_values(mesh, fine, vertices);
    mesh.tangents = {};
    mesh.smoothing = {};
    mesh.smoothing_kind = SmoothingKind::none;
    mesh.smoothing_hint = {};
    mesh.polygons = {};
    mesh.subdivision = Subdivision{};  // done
    mesh.influences = {}, mesh.more_influences = {};
    mesh.targets = {};
    mesh.position_step = 0;
    return mesh;
}

bool is_finite_value(dvec4 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

SurfaceSubdivider::SurfaceSubdivider(std::vector<SurfacePart> parts, const Subdivision& how, double scale)
    : parts_(std::move(parts)), how_(how) {
    control_.level = how.level;
    control_.sharpness = how.sharpness;
    control_.sharpens_corners = !how.round_corners;
    choose_scheme();
    collect_faces();
    choose_level(scale);
    geometry::PieceOptions options{.sharpens_corners = control_.sharpens_corners};
    if (how.crease_angle_rad && how.sharpness > 0) options.crease_angle_rad = *how.crease_angle_rad;
    options.is_hard = std::move(is_hard_);
    geometry::SurfacePieces pieces = geometry::part_surface(control_.faces, control_.positions, options);
    const std::vector<dvec3> places = std::move(control_.positions);
    control_.positions.clear();
    for (const std::uint32_t place : pieces.place_of) control_.positions.push_back(places[place]);
    control_.faces.corners = std::move(pieces.vertices);
    control_.creases = std::move(pieces.creases);
    control_.pinned = std::move(pieces.pinned);
    faults_.parted_edges = pieces.parted_edges;
    for (const SurfacePart& part : parts_) {
        texcoord_sets_ = std::max(texcoord_sets_, part.mesh->texcoords.size());
        has_colors_ = has_colors_ || !part.mesh->colors.empty();
    }
}

void SurfaceSubdivider::choose_scheme() {
    const auto has_polygons = [](const SurfacePart& part) {
        const Block<std::uint32_t>& numbers = part.mesh->polygons;
        return std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end();
    };
    const bool is_loop = how_.scheme == SubdivisionScheme::automatic
                             ? std::none_of(parts_.begin(), parts_.end(), has_polygons)
                             : how_.scheme == SubdivisionScheme::loop;
    control_.scheme = is_loop ? geometry::Scheme::loop : geometry::Scheme::catmull_clark;
}

/// Replaces corners by places, indexed in the order of first use.
void SurfaceSubdivider::collect_faces() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        first_face_.push_back(control_.faces.count());
        const Mesh& mesh = *parts_[i].mesh;
        const bool keeps_polygons = control_.scheme == geometry::Scheme::catmull_clark;
        const geometry::PolygonLoops loops = geometry::polygon_loops(
            mesh.indices, keeps_polygons ? mesh.polygons.span() : std::span<const std::uint32_t>{});
        std::vector<std::uint32_t> seen;
        for (std::uint32_t f = 0; f < loops.faces.count(); ++f) {
            const std::span<const std::uint32_t> corners(loops.faces.corners.data() + loops.faces.first[f],
                                                         loops.faces.size(f));
            seen.clear();
            for (const std::uint32_t v : corners) seen.push_back(parts_[i].places[v]);
            std::sort(seen.begin(), seen.end());
            const bool is_simple =
                corners.size() <= max_corners && std::adjacent_find(seen.begin(), seen.end()) == seen.end();
            if (is_simple || corners.size() == 3) {
                add_face(i, corners, loops.first_triangle[f], loops.first_triangle[f + 1]);
                continue;
            }
            for (std::uint32_t t = loops.first_triangle[f]; t < loops.first_triangle[f + 1]; ++t)
                add_face(i, {mesh.indices.data() + 3 * std::size_t(t), 3}, t, t + 1);
        }
    }
    first_face_.push_back(control_.faces.count());
    std::vector<std::uint32_t>& corners = control_.faces.corners;
    std::vector<std::uint32_t> used(corners);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<std::uint32_t> number(used.size(), no_index);
    std::size_t c = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        for (const std::size_t end = control_.faces.first[first_face_[i + 1]]; c < end; ++c) {
            std::uint32_t& n =
                number[std::size_t(std::lower_bound(used.begin(), used.end(), corners[c]) - used.begin())];
            if (n == no_index) {
                n = std::uint32_t(control_.positions.size());
                const vec3 p = parts_[i].mesh->positions[mesh_vertices_[c]];
                control_.positions.push_back(transform_point(parts_[i].to_surface, cast<double>(p)));
            }
            corners[c] = n;
        }
}

void SurfaceSubdivider::add_face(std::size_t part, std::span<const std::uint32_t> vertices,
                                 std::uint32_t first_triangle, std::uint32_t end_triangle) {
    const std::vector<std::uint32_t>& places = parts_[part].places;
    if (vertices.size() == 3) {
        const std::uint32_t a = places[vertices[0]], b = places[vertices[1]], c = places[vertices[2]];
        if (a == b || b == c || c == a) return void(++faults_.flat_faces);
    }
    const bool turns = is_mirrored(parts_[part]);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const std::uint32_t v = vertices[turns ? vertices.size() - 1 - k : k];
        control_.faces.corners.push_back(places[v]);
        mesh_vertices_.push_back(v);
    }
    control_.faces.end_face();
    if (how_.finds_creases && how_.sharpness > 0) mark_hard_edges(part, vertices.size(), first_triangle, end_triangle);
}

/// Of the last face: where its triangles have a hard edge.
void SurfaceSubdivider::mark_hard_edges(std::size_t part, std::size_t corners, std::uint32_t first_triangle,
                                        std::uint32_t end_triangle) {
    const std::span<const std::uint32_t> indices = parts_[part].mesh->indices;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> hard;
    for (std::uint32_t t = first_triangle; t < end_triangle; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if ((parts_[part].hard[t] >> k & 1) != 0)
                hard.push_back(std::minmax(indices[3 * std::size_t(t) + k], indices[3 * std::size_t(t) + (k + 1) % 3]));
    std::sort(hard.begin(), hard.end());
    const std::uint32_t* const vertex = mesh_vertices_.data() + mesh_vertices_.size() - corners;
    for (std::size_t k = 0; k < corners; ++k) {
        const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(vertex[k], vertex[(k + 1) % corners]);
        is_hard_.push_back(std::binary_search(hard.begin(), hard.end(), edge) ? 1 : 0);
    }
}

void SurfaceSubdivider::choose_level(double scale) {
    if (!(how_.edge > 0)) return;
    double longest = 0;  // squared
    const geometry::Polygons& faces = control_.faces;
    for (std::uint32_t f = 0; f < faces.count(); ++f)
        for (std::uint32_t c = faces.first[f]; c < faces.first[f + 1]; ++c) {
            const dvec3 d = control_.positions[faces.corners[faces.next(f, c)]] - control_.positions[faces.corners[c]];
            longest = std::max(longest, dot(d, d));
        }
    const double edge = how_.edge / (scale > 0 ? scale : 1);
    control_.level = 1;  // each level quarters the square
    while (control_.level < how_.level && longest > edge * edge * double(1u << (2 * control_.level))) ++control_.level;
}

std::uint64_t SurfaceSubdivider::triangles() const {
    const std::uint64_t faces = geometry::fine_face_count(control_.scheme, control_.level, control_.faces);
    return control_.scheme == geometry::Scheme::loop ? faces : 2 * faces;
}

std::uint64_t SurfaceSubdivider::bytes() const {
    const std::uint64_t faces = geometry::fine_face_count(control_.scheme, control_.level, control_.faces);
    const std::uint64_t values = texcoord_sets_ + has_colors_;
    return geometry::subdivision_bytes(control_.scheme, faces) + faces * (80 + values * 40);
}

geometry::ControlValues SurfaceSubdivider::control_values(std::size_t set) const {
    const bool is_color = set == texcoord_sets_;
    geometry::ControlValues out;
    out.rule = is_color || how_.uv == SubdivisionUv::linear ? geometry::ValueRule::linear
               : how_.uv == SubdivisionUv::smooth           ? geometry::ValueRule::smooth
                                                            : geometry::ValueRule::fixed_ends;
    const auto value_at = [&](const Mesh& mesh, std::uint32_t v) -> dvec4 {
        if (is_color) return mesh.colors.empty() ? dvec4{1, 1, 1, 1} : cast<double>(mesh.colors[v]);
        if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) return {0, 0, 0, 0};
        const vec2 uv = mesh.texcoords[set][v];
        return {double(uv.x), double(uv.y), 0, 0};
    };
    std::vector<std::uint32_t> newest(control_.positions.size(), no_index), older;  // chains of one vertex's values
    std::size_t c = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        for (const std::size_t end = control_.faces.first[first_face_[i + 1]]; c < end; ++c) {
            dvec4 value = value_at(*parts_[i].mesh, mesh_vertices_[c]);
            if (!is_finite_value(value)) value = {0, 0, 0, 1};
            std::uint32_t& head = newest[control_.faces.corners[c]];
            std::uint32_t n = head;
            while (n != no_index && !(out.values[n] == value)) n = older[n];
            if (n == no_index) {
                n = std::uint32_t(out.values.size());
                out.values.push_back(value);
                older.push_back(head);
                head = n;
            }
            out.corners.push_back(n);
        }
    return out;
}

std::vector<Mesh> SurfaceSubdivider::run(Context& context) const {
    Refined fine;
    const bool has_faces = control_.faces.count() > 0;
    if (has_faces) fine.surface = geometry::subdivide(control_, context);
    for (std::size_t set = 0; has_faces && set < texcoord_sets_ + has_colors_; ++set)
        fine.values.push_back(geometry::subdivide_values(control_, control_values(set), context));
    std::vector<Mesh> meshes;
    CornerVertices vertices(fine.surface.positions.size());
    std::uint64_t first = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        std::uint64_t count = first_face_[i + 1] - first_face_[i];
        if (control_.scheme == geometry::Scheme::catmull_clark)
            count = control_.faces.first[first_face_[i + 1]] - control_.faces.first[first_face_[i]];
        count <<= 2 * (control_.scheme == geometry::Scheme::loop ? control_.level : control_.level - 1);
        meshes.push_back(
            mesh_of(parts_[i], fine, std::uint32_t(first), std::uint32_t(first + count), vertices, context));
        first += count;
    }
    return meshes;
}

}  // namespace rakelight
