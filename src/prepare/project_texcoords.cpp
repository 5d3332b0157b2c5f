// SPDX-License-Identifier: Apache-2.0
// Texture coordinates by projection, for models without any: box, sphere or cylinder around the world bounding box.
//
// Each corner gets coordinates; vertices whose corners differ (box edge, back seam, pole) are split. In all three
// projections the texture is upright and not mirrored seen from outside, and v points down.
// - box: each triangle from the side that its normal faces most (+X, -X, ... ; the first of equals), square texels: 1
//   is the longest edge of the bounding box
// - sphere: u = 1/2 + longitude / 2 pi, 1/2 in front (+Z) and the seam behind; v = angle from +Y / pi
// - cylinder: u as the sphere, v from the top to the bottom of the box. Triangles that face up or down (within 45
//   degrees) lie flat in the texture as the box has them, else the caps would have no area in it
//
// A triangle across the seam is unwrapped: its u continue beyond 1. A corner on the axis takes the mean u of the others.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/scene_queries.h>

#include "base/cancel_check.h"
#include "base/format_text.h"
#include "math/functions.h"
#include "math/linear.h"
#include "prepare/project_texcoords.h"
#include "prepare/split_vertices.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

struct Frame {
    dvec3 low, high, center;
    double longest;  ///< longest edge of the box, > 0
};

Frame frame_of(const Bounds& bounds) {
    if (bounds.empty()) return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1};
    const dvec3 size = bounds.high - bounds.low;
    const double longest = std::max({size.x, size.y, size.z});
    return {bounds.low, bounds.high, bounds.center(), longest > 0 && std::isfinite(longest) ? longest : 1};
}

/// One triangle's corners: places in the world and coordinates.
struct Corners {
    dvec3 p[3];
    dvec2 uv[3];
};

dvec3 face_direction(const Corners& c) { return normalize_or(cross(c.p[1] - c.p[0], c.p[2] - c.p[0]), dvec3{0, 0, 1}); }

void project_box(const Frame& f, Corners& c) {
    const dvec3 n = face_direction(c), size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    for (int k = 0; k < 3; ++k) {
        const dvec3 from_low = c.p[k] - f.low, from_high = f.high - c.p[k];
        dvec2 uv;
        if (size.x >= size.y && size.x >= size.z)
            uv = {n.x > 0 ? from_high.z : from_low.z, from_high.y};
        else if (size.y >= size.z)
            uv = {from_low.x, n.y > 0 ? from_low.z : from_high.z};
        else
            uv = {n.z > 0 ? from_low.x : from_high.x, from_high.y};
        c.uv[k] = {uv.x / f.longest, uv.y / f.longest};
    }
}

/// u around the y axis, unwrapped over the triangle.
void wrap_around(const Frame& f, Corners& c) {
    bool on_axis[3];
    double low = 2, high = -1, sum = 0;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        const dvec3 d = c.p[k] - f.center;
        on_axis[k] = std::max(std::fabs(d.x), std::fabs(d.z)) <= 1e-9 * f.longest;
        if (on_axis[k]) continue;
        double u = 0.5 + math::atan2(d.x, d.z) / (2 * pi);
        if (u >= 1) u -= 1;  // exactly at the seam: 0 and 1 are one place
        c.uv[k].x = u;
        low = std::min(low, u);
        high = std::max(high, u);
    }
    for (int k = 0; k < 3; ++k) {
        if (on_axis[k]) continue;
        if (high - low > 0.5 && c.uv[k].x < 0.5) c.uv[k].x += 1;
        sum += c.uv[k].x;
        ++count;
    }
    for (int k = 0; k < 3; ++k)
        if (on_axis[k]) c.uv[k].x = count > 0 ? sum / count : 0.5;
}

void project_sphere(const Frame& f, Corners& c) {
    wrap_around(f, c);
    for (int k = 0; k < 3; ++k) {
        const dvec3 d = normalize_or(c.p[k] - f.center, dvec3{0, 0, 1});
        c.uv[k].y = math::acos(std::clamp(d.y, -1.0, 1.0)) / pi;
    }
}

void project_cylinder(const Frame& f, Corners& c) {
    const dvec3 n = face_direction(c);
    if (2 * n.y * n.y > 1) {
        for (int k = 0; k < 3; ++k)
            c.uv[k] = {(c.p[k].x - f.low.x) / f.longest,
                       (n.y > 0 ? c.p[k].z - f.low.z : f.high.z - c.p[k].z) / f.longest};
        return;
    }
    wrap_around(f, c);
    const double height = f.high.y - f.low.y;
    for (int k = 0; k < 3; ++k) c.uv[k].y = height > 0 ? (f.high.y - c.p[k].y) / height : 0;
}

/// Incremental coordinates: a vertex has one entry for each different pair of its corners.
class VertexCoordinates {
public:
    explicit VertexCoordinates(std::size_t vertices) : uv_(vertices, vec2{0, 0}), next_(vertices, unused) {}

    /// The vertex (old or appended) that represents `v` with these coordinates.
    std::uint32_t vertex(std::uint32_t v, vec2 uv) {
        if (next_[v] == unused) {
            uv_[v] = uv;
            next_[v] = no_index;
            return v;
        }
        std::uint32_t at = v;
        for (int step = 0; step < searched && at != no_index; ++step, at = next_[at])
            if (uv_[at] == uv) return at;
        const auto added = std::uint32_t(uv_.size());
        uv_.push_back(uv);
        next_.push_back(next_[v]);
        next_[v] = added;
        source_vertex_.push_back(v);
        return added;
    }
    std::vector<vec2> take_coordinates() { return std::move(uv_); }
    const std::vector<std::uint32_t>& source_vertex() const { return source_vertex_; }

private:
    static constexpr std::uint32_t unused = no_index - 1;
    /// Maximum number of compared entries of a vertex, newest first: a fan of a million triangles around a pole, each
    /// with its own u, must not take quadratic time. Duplicate entries are harmless.
    static constexpr int searched = 16;
    std::vector<vec2> uv_;
    std::vector<std::uint32_t> next_;  // the next entry of the same vertex
    std::vector<std::uint32_t> source_vertex_;
};

Mesh projected(const Mesh& source, const dmat4& to_world, const Frame& frame, UvProjection projection,
               Context& context) {
    const dmat4 place = to_world * translation(source.origin);
    const bool mirrored = determinant(upper_left(place)) < 0;  // the drawn winding
    context.memory().check((source.positions.size() + source.indices.size()) * 24, "texture coordinates");
    VertexCoordinates coordinates(source.positions.size());
    std::vector<std::uint32_t> indices(source.indices.begin(), source.indices.end());
    CancelCheck check(context);
    for (std::size_t t = 0; t + 2 < indices.size(); t += 3, check()) {
        Corners c{};
        for (std::size_t k = 0; k < 3; ++k) {
            c.p[k] = transform_point(place, cast<double>(source.positions[indices[t + k]]));
            if (!is_finite(c.p[k])) c.p[k] = frame.center;
        }
        if (mirrored) std::swap(c.p[1], c.p[2]);
        if (projection == UvProjection::box)
            project_box(frame, c);
        else if (projection == UvProjection::sphere)
            project_sphere(frame, c);
        else
            project_cylinder(frame, c);
        if (mirrored) std::swap(c.uv[1], c.uv[2]);
        for (std::size_t k = 0; k < 3; ++k)
            indices[t + k] = coordinates.vertex(indices[t + k], {float(c.uv[k].x), float(c.uv[k].y)});
    }
    Mesh mesh = source;
    mesh.tangents = {};  // they belong to missing coordinates
    const std::vector<std::uint32_t>& split = coordinates.source_vertex();
    split_vertices(mesh, split.empty() ? std::vector<std::uint32_t>{} : std::move(indices), split, context);
    std::vector<Block<vec2>> sets = std::move(mesh.texcoords);
    if (sets.empty()) sets.emplace_back();
    sets[0] = coordinates.take_coordinates();
    mesh.texcoords = std::move(sets);
    charge_new_arrays(mesh, source, context);  // before the next instance allocates
    return mesh;
}

bool has_texcoords(const Mesh& mesh) {
    return std::any_of(mesh.texcoords.begin(), mesh.texcoords.end(),
                       [](const Block<vec2>& set) { return !set.empty(); });
}

/// The original meshes, before projection of their first instance.
class Originals {
public:
    Originals(const Scene& scene, const std::vector<Instance>& instances)
        : scene_(scene), uses_(scene.meshes.size(), 0) {
        for (const Instance& instance : instances) ++uses_[instance.mesh];
    }
    const Mesh& operator[](std::uint32_t number) {
        if (uses_[number] == 1) return scene_.meshes[number];
        return kept_.try_emplace(number, scene_.meshes[number]).first->second;
    }

private:
    const Scene& scene_;
    std::vector<std::uint32_t> uses_;
    std::map<std::uint32_t, Mesh> kept_;  ///< of meshes with several instances
};

}  // namespace

Scene project_texcoords(Scene scene, UvProjection projection, Context& context) {
    if (projection == UvProjection::none) return scene;
    const std::vector<dmat4> world = world_matrices(scene);
    const Frame frame = frame_of(world_bounds(scene));
    const std::vector<Instance> instances = drawn_instances(scene);
    Originals originals(scene, instances);
    MeshVariants variants(scene, context);
    std::uint64_t meshes = 0;
    for (const Instance& instance : instances) {
        context.throw_if_cancelled();
        const Mesh& mesh = originals[instance.mesh];
        if (has_texcoords(mesh)) continue;
        variants.place(instance, projected(mesh, world[instance.node], frame, projection, context));
        ++meshes;
    }
    if (meshes == 0) return scene;
    const char* name = projection == UvProjection::box      ? "box"
                       : projection == UvProjection::sphere ? "sphere"
                                                            : "cylinder";
    context.report().add(Remark::note, scene.source, {},
                         format_text("{} meshes without texture coordinates got them by {} projection", meshes, name));
    if (variants.copies() > 0)
        context.report().add(
            Remark::note, scene.source, {},
            format_text("{} instances got a mesh of their own: they lie elsewhere in the texture", variants.copies()));
    return scene;
}

}  // namespace rakelight
