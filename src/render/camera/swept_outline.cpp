// SPDX-License-Identifier: Apache-2.0
#include "render/camera/swept_outline.h"

#include <array>
#include <cmath>

#include <rakelight/math/linear.h>
#include <rakelight/scene/scene_queries.h>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr std::size_t directions = 32, corners = 64;  ///< of the profile; of a ring

bool is_inside(const Bounds& box, dvec3 p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z &&
           p.z <= box.high.z;
}

/// The half plane beside the axis: x is the distance from it, y the height along it, from its middle [m].
class Profile {
public:
    Profile() {
        for (std::size_t k = 0; k < directions; ++k) {
            const double angle = pi * (double(k) / (directions - 1) - 0.5);  // straight down to straight up
            ways_[k] = {math::cos(angle), math::sin(angle)};
        }
        reach_.fill(-HUGE_VAL);
    }
    void add(dvec2 p) {
        for (std::size_t k = 0; k < directions; ++k) {
            const double reach = p.x * ways_[k].x + p.y * ways_[k].y;
            if (reach > reach_[k]) reach_[k] = reach, farthest_[k] = p;
        }
    }
    const std::array<dvec2, directions>& farthest() const { return farthest_; }

private:
    std::array<dvec2, directions> ways_{}, farthest_{};
    std::array<double, directions> reach_{};
};

void add(Profile& profile, const Scene& scene, const Bounds& box, dvec3 axis) {
    const dvec3 center = box.center();
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const dmat4 place = world[n] * translation(scene.meshes[m].origin);
            for (const vec3& position : scene.meshes[m].positions) {
                const dvec3 p = transform_point(place, cast<double>(position));
                if (!is_inside(box, p)) continue;  // nor is what is not finite
                const double height = dot(p - center, axis);
                profile.add({length(p - center - axis * height), height});
            }
        }
}

}  // namespace

Scene swept_outline(std::span<const Scene> outlines, const Bounds& box, dvec3 axis) {
    Profile profile;
    for (const Scene& outline : outlines) add(profile, outline, box, axis);
    const dvec3 other = std::fabs(axis.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0};
    const dvec3 u = normalize_or(cross(axis, other), dvec3{1, 0, 0}), v = cross(axis, u);
    Mesh rings;
    rings.topology = Topology::points;
    rings.origin = box.center();
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::size_t c = 0; c < corners; ++c) {
        const double angle = 2 * pi * double(c) / corners;
        const dvec3 outward = u * math::cos(angle) + v * math::sin(angle);
        for (const dvec2& p : profile.farthest()) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(cast<float>(outward * p.x + axis * p.y));
        }
    }
    rings.positions = std::move(positions), rings.indices = std::move(indices);
    Scene scene;
    scene.meshes.push_back(std::move(rings));
    Node node;
    node.meshes = {0};
    scene.nodes.push_back(std::move(node));
    return scene;
}

}  // namespace rakelight
