// SPDX-License-Identifier: Apache-2.0
#include "scene/drawn_vertices.h"

#include <rakelight/scene/scene_queries.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.h"
#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr std::size_t run_length = 64;
constexpr std::size_t no_runs = ~std::size_t{0};

std::size_t run_count(const Mesh& mesh) { return (mesh.positions.size() + run_length - 1) / run_length; }

/// Calls f(position) for the used vertices of run `r`.
template <class Run, class F>
void for_each_used(const Mesh& mesh, const Run& run, std::size_t r, const F& f) {
    for (std::uint64_t left = run.used; left != 0; left &= left - 1)
        f(mesh.positions[r * run_length + std::size_t(std::countr_zero(left))]);
}

/// At least dot(p, direction) + shift, as it is computed, for every p in the box. NaN if that may not hold.
template <class Run>
double at_most(const Run& run, dvec3 direction, double shift) {
    const dvec3 corner{direction.x < 0 ? run.low.x : run.high.x, direction.y < 0 ? run.low.y : run.high.y,
                       direction.z < 0 ? run.low.z : run.high.z};
    return dot(corner, direction) + shift;
}

}  // namespace

DrawnVertices::DrawnVertices(const Scene& scene)
    : scene_(scene), world_(world_matrices(scene)), first_run_(scene.meshes.size(), no_runs) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t mesh : scene.nodes[i].meshes) {
            if (first_run_[mesh] == no_runs) add(mesh);
            extend_bounds(mesh, world_[i]);
        }
}

void DrawnVertices::add(std::uint32_t number) {
    const Mesh& mesh = scene_.meshes[number];
    first_run_[number] = runs_.size();
    runs_.resize(runs_.size() + run_count(mesh),
                 Run{{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}});
    const std::span<Run> runs = std::span(runs_).subspan(first_run_[number]);
    for (const std::uint32_t v : mesh.indices) runs[v / run_length].used |= std::uint64_t{1} << (v % run_length);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        Run& run = runs[r];
        for (std::uint64_t left = run.used; left != 0; left &= left - 1) {
            const vec3 p = mesh.positions[r * run_length + std::size_t(std::countr_zero(left))];
            if (is_finite(p))
                run.low = min(run.low, p), run.high = max(run.high, p);
            else
                run.used &= ~(left & (~left + 1));
        }
    }
}

std::span<const DrawnVertices::Run> DrawnVertices::runs_of(std::uint32_t mesh) const {
    return std::span(runs_).subspan(first_run_[mesh], run_count(scene_.meshes[mesh]));
}

void DrawnVertices::extend_bounds(std::uint32_t number, const dmat4& to_world) {
    const Mesh& mesh = scene_.meshes[number];
    const dmat4 m = to_world * translation(mesh.origin);
    const dvec3 x{m[0].x, m[1].x, m[2].x}, y{m[0].y, m[1].y, m[2].y}, z{m[0].z, m[1].z, m[2].z};
    const dvec3 shift = m[3].xyz();
    const auto is_inside = [&](const Run& run) {
        const dvec3 high{at_most(run, x, shift.x), at_most(run, y, shift.y), at_most(run, z, shift.z)};
        const dvec3 low{-at_most(run, -x, -shift.x), -at_most(run, -y, -shift.y), -at_most(run, -z, -shift.z)};
        return low.x >= bounds_.low.x && low.y >= bounds_.low.y && low.z >= bounds_.low.z && high.x <= bounds_.high.x &&
               high.y <= bounds_.high.y && high.z <= bounds_.high.z;
    };
    const std::span<const Run> runs = runs_of(number);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs[r].used == 0 || is_inside(runs[r])) continue;
        for_each_used(mesh, runs[r], r, [&](vec3 position) {
            const dvec3 p = transform_point(m, cast<double>(position));
            if (!is_finite(p)) return;
            bounds_.low = min(bounds_.low, p);
            bounds_.high = max(bounds_.high, p);
        });
    }
}

/// A query over one object after the other.
class DrawnVertices::Search {
public:
    Search(dvec3 about, std::span<const dvec3> directions, std::span<double> reach)
        : about_(about), directions_(directions), reach_(reach), own_(directions.size()), shift_(directions.size()) {}

    void look_at(const Mesh& mesh, std::span<const Run> runs, const dmat4& to_world) {
        const dmat4 m = to_world * translation(mesh.origin);
        for (std::size_t k = 0; k < own_.size(); ++k) {
            const dvec3 d = directions_[k];
            own_[k] = {dot(m[0].xyz(), d), dot(m[1].xyz(), d), dot(m[2].xyz(), d)};
            shift_[k] = dot(m[3].xyz() - about_, d);
        }
        look_at_best(mesh, runs);
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (runs[r].used != 0 && promises(runs[r])) look_at_run(mesh, runs[r], r);
    }

private:
    /// Whether the run may have a vertex that lies farther along some direction than those so far.
    bool promises(const Run& run) const {
        for (std::size_t k = 0; k < own_.size(); ++k)
            if (!(at_most(run, own_[k], shift_[k]) <= reach_[k])) return true;
        return false;
    }

    /// The run that promises most in each direction comes first: few others promise more than it holds.
    void look_at_best(const Mesh& mesh, std::span<const Run> runs) {
        for (std::size_t k = 0; k < own_.size(); ++k) {
            std::size_t best = runs.size();
            double most = reach_[k];
            for (std::size_t r = 0; r < runs.size(); ++r) {
                if (runs[r].used == 0) continue;
                const double bound = at_most(runs[r], own_[k], shift_[k]);
                if (bound > most) most = bound, best = r;
            }
            if (best < runs.size()) look_at_run(mesh, runs[best], best);
        }
    }

    void look_at_run(const Mesh& mesh, const Run& run, std::size_t r) {
        for_each_used(mesh, run, r, [&](vec3 position) {
            const dvec3 p = cast<double>(position);
            for (std::size_t k = 0; k < own_.size(); ++k) {
                const double along = dot(p, own_[k]) + shift_[k];
                if (along > reach_[k] && std::isfinite(along)) reach_[k] = along;
            }
        });
    }

    dvec3 about_;
    std::span<const dvec3> directions_;
    std::span<double> reach_;
    std::vector<dvec3> own_;     ///< the directions in the object's space
    std::vector<double> shift_;  ///< [m] of its origin along them
};

void DrawnVertices::farthest_along(dvec3 about, std::span<const dvec3> directions, std::span<double> reach) const {
    RL_ASSERT(directions.size() == reach.size(), "a result for each direction");
    std::fill(reach.begin(), reach.end(), -HUGE_VAL);
    Search search(about, directions, reach);
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i)
        for (const std::uint32_t mesh : scene_.nodes[i].meshes)
            search.look_at(scene_.meshes[mesh], runs_of(mesh), world_[i]);
    for (double& r : reach)
        if (r == -HUGE_VAL) r = 0;
}

Bounds world_bounds(const Scene& scene) { return DrawnVertices(scene).bounds(); }

}  // namespace rakelight
