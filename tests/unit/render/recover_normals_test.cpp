// SPDX-License-Identifier: Apache-2.0
// Models whose authors made their parts meet smoothly: with their normals thrown away and computed again over the whole model,
// the authors' own come back where the parts meet.
#include <gtest/gtest.h>

#include <rakelight/render/render.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "math/linear.h"
#include "scene/placement.h"
#include "support/shared.h"

namespace rakelight::test {
namespace {

struct Corner {
    std::uint32_t object, mesh;
    dvec3 authored, made;  // world
};

double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

/// All corners of both scenes by their place in the world, to a hundredth of a millimeter.
std::map<std::tuple<double, double, double>, std::vector<Corner>> corners_by_place(const Scene& authored,
                                                                                   const Scene& made) {
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

/// Where two parts or more meet and all authored normals agree.
bool is_smooth_border(const std::vector<Corner>& corners, double agree_deg) {
    bool meet = false, agree = true;
    for (const Corner& c : corners) {
        meet |= c.object != corners[0].object || c.mesh != corners[0].mesh;
        agree &= degrees_between(c.authored, corners[0].authored) < agree_deg;
    }
    return meet && agree;
}

/// A model of the set whose authored normals go on across borders of its parts (INDEX.md: cont), how its normals were made, and how
/// far the recomputed ones may be from them at these borders; measured values beside.
struct Model {
    const char* file;
    CornerWeight weight;
    double crease_deg;
    double agree_deg;  ///< authored normals that differ by less count as one: files round them
    std::size_t places;
    double most_deg, most_median_deg;
};

const Model models[] = {
    {"gltf/GlamVelvetSofa/GlamVelvetSofa.glb", CornerWeight::angle, 60, 0.5, 108, 0.2, 0.05},  // 0.098, 0.028
    {"gltf/kaykit/Knight.glb", CornerWeight::angle, 60, 0.5, 22, 0.2,
     0.01},  // 0.127, 0.000; parts meet at up to 45 degrees
    {"gltf/kenney/cakeBirthday.glb", CornerWeight::angle, 60, 0.5, 144, 0.01,
     0.001},  // 0.000: flat ones, which stay so
    {"gltf/babylon/frostAxe_noMorph.glb", CornerWeight::angle_area, 60, 0.5, 7, 0.5,
     0.02},  // 0.284, 0.006; by angle 9.789
    {"gltf/godot/mushroom.glb", CornerWeight::angle, 60, 2, 8, 1.5,
     1.4},  // 1.370, 1.346; the authored differ by 0.5 to 2
    {"gltf/SimpleMeshes/SimpleMeshes.gltf", CornerWeight::angle, 60, 0.5, 1, 0.01, 0.001},
    {"generator/Mesh_PrimitivesUV/Mesh_PrimitivesUV_03.gltf", CornerWeight::angle, 60, 0.5, 2, 0.01, 0.001},
    {"generator/Mesh_PrimitivesUV/Mesh_PrimitivesUV_06.gltf", CornerWeight::angle, 60, 0.5, 2, 0.01, 0.001},
    {"generator/Mesh_PrimitivesUV/Mesh_PrimitivesUV_07.gltf", CornerWeight::angle, 60, 0.5, 2, 0.01, 0.001},
    {"generator/Mesh_PrimitivesUV/Mesh_PrimitivesUV_08.gltf", CornerWeight::angle, 60, 0.5, 2, 0.01, 0.001},
    {"obj/trimesh/groups.obj", CornerWeight::area, 100, 0.5, 9, 0.01, 0.001},  // 0.000: by area, over right angles
};

class RecoverNormals : public testing::TestWithParam<Model> {};

// Strips the normals, makes them again over the whole model, and compares.
TEST_P(RecoverNormals, AreTheAuthoredOnesWherePartsMeetSmoothly) {
    const Model& model = GetParam();
    RL_NEEDS_SHARED("assets");
    Context context({.threads = 2});
    const Scene scene = load((shared_dir() / "assets" / model.file).string(), {}, context);
    Scene bare = scene;
    for (Mesh& mesh : bare.meshes) {
        mesh.normals = {};
        mesh.tangents = {};
    }
    const Scene made = smooth(
        bare, {.weight = model.weight, .crease_angle_rad = radians(model.crease_deg), .tangents = false}, context);
    std::vector<double> off;
    for (const auto& [place, corners] : corners_by_place(scene, made)) {
        if (!is_smooth_border(corners, model.agree_deg)) continue;
        double worst = 0;
        for (const Corner& c : corners) {
            worst = std::max(worst, degrees_between(c.authored, c.made));
            EXPECT_LT(degrees_between(c.made, corners[0].made), 1e-3) << "a seam";
        }
        off.push_back(worst);
    }
    EXPECT_EQ(off.size(), model.places);
    ASSERT_FALSE(off.empty());
    std::sort(off.begin(), off.end());
    const double median = off[off.size() / 2];
    RecordProperty("places", int(off.size()));
    RecordProperty("worst_deg", std::to_string(off.back()));
    RecordProperty("median_deg", std::to_string(median));
    EXPECT_LT(off.back(), model.most_deg);
    EXPECT_LT(median, model.most_median_deg);
}

std::string name_of(const testing::TestParamInfo<Model>& model) {
    const std::string stem = std::filesystem::path(model.param.file).stem().string();
    std::string name;
    for (const char c : stem)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
    return name;
}
INSTANTIATE_TEST_SUITE_P(Model, RecoverNormals, testing::ValuesIn(models), name_of);

}  // namespace
}  // namespace rakelight::test
