// SPDX-License-Identifier: Apache-2.0
// Models whose authors made their parts meet smoothly: with their normals thrown away and computed again over the whole model,
// the authors' own come back where the parts meet.
#include <gtest/gtest.h>

#include <rakelight/render.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "math/linear.h"
#include "scene/scene_tools.h"
#include "support/shared.h"

namespace rakelight::test {
namespace {

struct Corner {
    std::uint32_t object, mesh;
    dvec3 authored, made;  // world
};

double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

/// All corners of both scenes by their place in the world, to a hundredth of a millimeter.
std::map<std::tuple<double, double, double>, std::vector<Corner>> corners_by_place(const Scene& authored, const Scene& made) {
    std::map<std::tuple<double, double, double>, std::vector<Corner>> places;
    const std::vector<dmat4> world = world_matrices(authored);
    for (std::uint32_t n = 0; n < authored.nodes.size(); ++n)
        for (std::size_t slot = 0; slot < authored.nodes[n].meshes.size(); ++slot) {
            const std::uint32_t number = authored.nodes[n].meshes[slot];
            const Mesh &a = authored.meshes[number], &b = made.meshes[made.nodes[n].meshes[slot]];
            const dmat4 place = world[n] * translation(a.origin);
            const dmat3 turn = cofactor(upper_left(place));
            const auto direction = [&](vec3 v) { return normalize_or(turn * cast<double>(v), dvec3{}); };
            for (std::size_t i = 0; i < a.indices.size(); ++i) {
                const dvec3 p = transform_point(place, cast<double>(a.positions[a.indices[i]])) * 1e5;
                places[{std::round(p.x) + 0.0, std::round(p.y) + 0.0, std::round(p.z) + 0.0}].push_back(
                    {n, number, direction(a.normals[a.indices[i]]), direction(b.normals[b.indices[i]])});
            }
        }
    return places;
}

/// Where two parts or more meet and all authored normals agree within half a degree.
bool is_smooth_border(const std::vector<Corner>& corners) {
    bool meet = false, agree = true;
    for (const Corner& c : corners) {
        meet |= c.object != corners[0].object || c.mesh != corners[0].mesh;
        agree &= degrees_between(c.authored, corners[0].authored) < 0.5;
    }
    return meet && agree;
}

/// Strips the normals, makes them again over the model with the default weight and crease angle, and compares.
void expect_recovered(const char* file, std::size_t least_places, double most_deg, double most_median_deg) {
    Context context({.threads = 2});
    const Scene scene = load((shared_dir() / "assets/gltf" / file).string(), {}, context);
    Scene bare = scene;
    for (Mesh& mesh : bare.meshes) {
        mesh.normals = {};
        mesh.tangents = {};
    }
    const Scene made = smooth(bare, {.tangents = false}, context);
    std::vector<double> off;
    for (const auto& [place, corners] : corners_by_place(scene, made)) {
        if (!is_smooth_border(corners)) continue;
        double worst = 0;
        for (const Corner& c : corners) {
            worst = std::max(worst, degrees_between(c.authored, c.made));
            EXPECT_LT(degrees_between(c.made, corners[0].made), 1e-3) << file << ": a seam";
        }
        off.push_back(worst);
    }
    ASSERT_GE(off.size(), least_places) << file;
    std::sort(off.begin(), off.end());
    EXPECT_LT(off.back(), most_deg) << file;
    EXPECT_LT(off[off.size() / 2], most_median_deg) << file;
}

TEST(RecoverNormals, SofaHasItsAuthoredOnesWhereItsPrimitivesMeetSmoothly) {
    RL_NEEDS_SHARED("assets/gltf/GlamVelvetSofa/GlamVelvetSofa.glb");
    expect_recovered("GlamVelvetSofa/GlamVelvetSofa.glb", 100, 1, 0.1);  // measured: 0.098 at most
}

TEST(RecoverNormals, KnightHasItsAuthoredOnesWhereItsObjectsMeetSmoothly) {
    RL_NEEDS_SHARED("assets/gltf/kaykit/Knight.glb");
    expect_recovered("kaykit/Knight.glb", 20, 3, 0.1);  // measured: 0.127 at most; parts meet at up to 45 degrees
}

}  // namespace
}  // namespace rakelight::test
