// SPDX-License-Identifier: Apache-2.0
#include "scene/near_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr std::size_t run_length = 64;    ///< primitives
constexpr std::size_t most_corners = 48;  ///< of a clipped polygon: each of the four planes at most doubles three

std::size_t corners_of(Topology topology) {
    return topology == Topology::triangles ? 3 : topology == Topology::lines ? 2 : 1;
}

/// A line, a triangle or what clipping leaves of them, in camera space.
struct Polygon {
    dvec3 at[most_corners];
    std::size_t count = 0;
};

/// The part where dot(plane, p) >= 0 (Sutherland & Hodgman 1974).
void clip(const Polygon& in, dvec3 plane, Polygon& out) {
    out.count = 0;
    for (std::size_t i = 0; i < in.count; ++i) {
        const dvec3 &a = in.at[i], &b = in.at[(i + 1) % in.count];
        const double a_by = dot(a, plane), b_by = dot(b, plane);
        if (a_by >= 0) out.at[out.count++] = a;
        if ((a_by >= 0) != (b_by >= 0) && a_by != b_by) out.at[out.count++] = a + (b - a) * (a_by / (a_by - b_by));
    }
}

}  // namespace

void NearSurfaces::read() const {
    world_ = world_matrices(scene_);
    runs_.resize(scene_.meshes.size());
    for (const Node& node : scene_.nodes)
        for (const std::uint32_t number : node.meshes) {
            const Mesh& mesh = scene_.meshes[number];
            std::vector<Run>& runs = runs_[number];
            if (!runs.empty()) continue;
            const Run nothing{{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
            const std::size_t indices = run_length * corners_of(mesh.topology);
            runs.assign(1 + (mesh.indices.size() + indices - 1) / indices, nothing);
            for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
                const vec3 p = mesh.positions[mesh.indices[i]];
                Run& run = runs[1 + i / indices];
                if (is_finite(p)) run.low = min(run.low, p), run.high = max(run.high, p);
            }
            for (const Run& run : runs)
                runs[0].low = min(runs[0].low, run.low), runs[0].high = max(runs[0].high, run.high);
        }
}

/// A query over one object after the other.
class NearSurfaces::Search {
public:
    Search(dvec2 half, double limit) : half_(half), nearest_(limit) {}

    void look_at(const Mesh& mesh, std::span<const Run> runs, const dmat4& to_camera) {
        if (runs.empty() || !promises(runs[0], to_camera)) return;
        const std::size_t corners = corners_of(mesh.topology), indices = run_length * corners;
        for (std::size_t r = 1; r < runs.size(); ++r) {
            if (!promises(runs[r], to_camera)) continue;
            const std::size_t first = (r - 1) * indices, end = std::min(first + indices, mesh.indices.size());
            for (std::size_t i = first; i + corners <= end; i += corners)
                look_at_primitive(mesh, i, corners, to_camera);
        }
    }
    double nearest() const { return nearest_; }

private:
    /// Whether the box may reach into the pyramid before what is the nearest so far.
    bool promises(const Run& run, const dmat4& m) const {
        if (run.empty()) return false;
        const dvec3 low = cast<double>(run.low), high = cast<double>(run.high);
        const dvec3 center = transform_point(m, (low + high) * 0.5), h = (high - low) * 0.5;
        const auto reach = [&](std::size_t axis) {
            return std::fabs(m[0][axis]) * h.x + std::fabs(m[1][axis]) * h.y + std::fabs(m[2][axis]) * h.z;
        };
        const double distance = -center.z, depth = reach(2);
        return distance + depth > 0 && distance - depth < nearest_ &&
               std::fabs(center.x) - reach(0) <= nearest_ * half_.x &&
               std::fabs(center.y) - reach(1) <= nearest_ * half_.y;
    }

    void look_at_primitive(const Mesh& mesh, std::size_t first, std::size_t corners, const dmat4& m) {
        Polygon both[2];
        Polygon *polygon = both, *clipped = both + 1;
        bool is_nearer = false;
        for (std::size_t k = 0; k < corners; ++k) {
            const dvec3 p = transform_point(m, cast<double>(mesh.positions[mesh.indices[first + k]]));
            if (!is_finite(p)) return;
            is_nearer |= -p.z < nearest_;
            polygon->at[polygon->count++] = p;
        }
        if (!is_nearer) return;
        for (const dvec3& plane :
             {dvec3{1, 0, -half_.x}, dvec3{-1, 0, -half_.x}, dvec3{0, 1, -half_.y}, dvec3{0, -1, -half_.y}}) {
            clip(*polygon, plane, *clipped);
            std::swap(polygon, clipped);
        }
        for (std::size_t i = 0; i < polygon->count; ++i)
            nearest_ = std::min(nearest_, std::max(0.0, -polygon->at[i].z));
    }

    dvec2 half_;
    double nearest_;
};

double NearSurfaces::nearest(const dmat4& world_to_camera, dvec2 half, double limit) const {
    std::call_once(is_read_, [this] { read(); });
    Search search(half, limit);
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i)
        for (const std::uint32_t number : scene_.nodes[i].meshes) {
            const Mesh& mesh = scene_.meshes[number];
            search.look_at(mesh, runs_[number], world_to_camera * (world_[i] * translation(mesh.origin)));
        }
    return search.nearest();
}

}  // namespace rakelight
