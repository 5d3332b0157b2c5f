// SPDX-License-Identifier: Apache-2.0
// Files in which normals are missing: zeros and numbers that are none, parts without normals beside parts with, morph targets
// whose normals do not move. What smooth_file() writes, and what inspect() and check_limits() say before and after.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <rakelight/tools/convert_file.h>
#include <rakelight_internal/tools/inspection_report.h>

#include "base/format_text.h"
#include "io/gltf/write/glb_writer.h"
#include "math/linear.h"
#include "tools/shortest_digits.h"
#include "unit/prepare/meshes.h"
#include "unit/tools/smooth_file_support.h"

namespace rakelight {
namespace {

using namespace test;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

/// A roof of two strips that meet along x = 0, bent by `steps` edges of equal angles: a part of a tube about Y.
Mesh strip(double from, double to, int steps, bool has_normals) {
    Mesh mesh;
    std::vector<vec3> positions, normals;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i <= steps; ++i) {
        const double turn = from + (to - from) * i / steps;
        for (const float y : {0.0f, 1.0f}) {
            positions.push_back({float(std::sin(turn)), y, float(std::cos(turn))});
            normals.push_back({float(std::sin(turn)), 0, float(std::cos(turn))});
        }
    }
    for (std::uint32_t i = 0; i < std::uint32_t(steps); ++i)
        for (const std::uint32_t k : {0u, 2u, 3u, 0u, 3u, 1u}) indices.push_back(2 * i + k);
    mesh.positions = std::move(positions), mesh.indices = std::move(indices);
    if (has_normals) mesh.normals = std::move(normals);
    return mesh;
}

Scene roof(bool second_has_normals) {
    Scene scene = scene_of({strip(-0.8, 0, 4, true), strip(0, 0.8, 4, second_has_normals)});
    scene.nodes[0].name = "left", scene.nodes[1].name = "right";
    return scene;
}

class MissingNormalsFile : public testing::Test {
protected:
    std::string written(const Scene& scene) {
        const std::string file = (folder_.path() / "in.glb").string();
        io::write_glb(scene, file, context_);
        return file;
    }
    SmoothedFile smoothed(const std::string& file, const SmoothFileOptions& options = {}) {
        return smooth_file(file, (folder_.path() / "out.glb").string(), options, context_);
    }
    Scene out() { return load((folder_.path() / "out.glb").string(), {}, context_); }

    const TemporaryFolder folder_;
    Context context_;
};

/// The vertex of `before` at the same position: OBJ files number by first use.
std::size_t vertex_before(const Mesh& before, vec3 position) {
    return std::size_t(std::ranges::find(before.positions, position) - before.positions.begin());
}

double degrees_from_exact(const Mesh& mesh, std::size_t v) {
    const vec3 p = mesh.positions[v];
    const dvec3 exact{double(p.x), 0, double(p.z)}, n = cast<double>(mesh.normals[v]);
    return degrees(std::atan2(length(cross(exact, n)), dot(exact, n)));
}

TEST_F(MissingNormalsFile, BordersGetTheAuthorsNormals) {
    const SmoothedFile result = smoothed(written(roof(false)));
    EXPECT_EQ(result.seams->turned, 0u);
    const Scene scene = out();
    const Mesh &left = scene.meshes[0], &right = scene.meshes[1];
    const Scene before = roof(true);
    for (std::size_t v = 0; v < left.normals.size(); ++v) EXPECT_EQ(left.normals[v], before.meshes[0].normals[v]);
    for (std::size_t v = 0; v < 8; ++v) EXPECT_LT(degrees_from_exact(right, v), 1e-3) << v;  // the open end leans
    SmoothFileOptions again;
    EXPECT_EQ(result.missing_made, 10u);
    const SmoothedFile second = smooth_file(result.output, (folder_.path() / "again.glb").string(), again, context_);
    EXPECT_FALSE(second.changed);
    EXPECT_EQ(second.missing_made, 0u);
}

TEST_F(MissingNormalsFile, ZerosAreMadeSaidAndAFault) {
    for (const vec3 none : {vec3{0, 0, 0}, vec3{nan_f, 0, 0}}) {
        Scene scene = roof(true);
        scene.meshes[1].normals = std::vector<vec3>(10, none);
        const Inspection i = inspect(scene, {}, context_);
        EXPECT_EQ(i.seams.missing_normals, 10u);
        EXPECT_EQ(i.surfaces[1].zero_normals + i.surfaces[1].non_finite_normals, 10u);
        EXPECT_EQ(i.objects[1].normals, ObjectSummary::Has::no);
        EXPECT_NE(to_text(i).find("10 normals missing in the file"), std::string::npos) << to_text(i);
        const std::vector<CheckFailure> failures = check_limits(i, {});
        ASSERT_EQ(failures.size(), 1u);
        EXPECT_NE(failures[0].message.find("10 zero or non-finite normals in 'right'"), std::string::npos)
            << failures[0].message;
        Context bare;
        const Inspection without = inspect(scene, {.surfaces = false}, bare);
        EXPECT_EQ(check_limits(without, {}).size(), 1u) << "whether surfaces are examined or not";
        std::vector<InspectionRow> rows(1);
        rows[0].inspection = i;
        const auto json = nlohmann::json::parse(to_json(rows))["rows"][0];
        EXPECT_EQ(json["seams"]["missing_normals"], 10);
    }
    Scene scene = roof(true);
    std::vector<vec3> normals(scene.meshes[1].normals.begin(), scene.meshes[1].normals.end());
    scene.meshes[1].normals = std::vector<vec3>(10);
    const SmoothedFile all = smoothed(written(scene));
    EXPECT_EQ(all.meshes[1].normals, SmoothedMesh::Change::made);
    EXPECT_EQ(all.seams->unusable, 0u);
    EXPECT_EQ(all.missing_made, 10u);
    EXPECT_NE(summary(all).find(", 10 missing normals made"), std::string::npos) << summary(all);
    EXPECT_TRUE(is_said(context_, Remark::warning, "all zero or not finite"));
    Scene after = out();
    EXPECT_EQ(inspect(after, {}, context_).seams.missing_normals, 0u);
    EXPECT_TRUE(check_limits(inspect(after, {}, context_), {}).empty());
    for (std::size_t v = 0; v < 8; ++v) EXPECT_LT(degrees_from_exact(after.meshes[1], v), 1e-3);

    const std::vector<vec3> exact = normals;
    normals[4] = normals[5] = {};
    scene.meshes[1].normals = normals;
    EXPECT_EQ(check_limits(inspect(scene, {}, context_), {}).size(), 1u);
    const SmoothedFile some = smoothed(written(scene));
    EXPECT_TRUE(some.changed);
    EXPECT_EQ(some.missing_made, 2u);
    EXPECT_NE(summary(some).find("0 of 20 normals turn, 2 missing normals made"), std::string::npos) << summary(some);
    after = out();
    for (std::size_t v = 0; v < 10; ++v) {
        EXPECT_LT(degrees_from_exact(after.meshes[1], v), 1e-3);
        if (v != 4 && v != 5) {
            EXPECT_EQ(after.meshes[1].normals[v], exact[v]);
        }
    }
    EXPECT_TRUE(check_limits(inspect(after, {}, context_), {}).empty());
}

/// The scene as an OBJ file; at some vertices of the parts after the first, `none` is written for the normal.
std::string obj_text(const Scene& scene, std::initializer_list<std::size_t> without, const char* none) {
    std::string text;
    std::size_t before = 1;
    for (const Node& node : scene.nodes) {
        const Mesh& mesh = scene.meshes[node.meshes[0]];
        text += "o " + node.name + "\n";
        for (const vec3 p : mesh.positions) text += format_text("v {} {} {}\n", digits(p.x), digits(p.y), digits(p.z));
        for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
            const vec3 n = mesh.normals[v];
            const bool is_none = before > 1 && std::ranges::find(without, v) != without.end();
            text += is_none ? format_text("vn {}\n", none)
                            : format_text("vn {} {} {}\n", digits(n.x), digits(n.y), digits(n.z));
        }
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            const std::size_t corner = before + mesh.indices[c];
            text += format_text("{}{}//{}", c % 3 == 0 ? "f " : " ", corner, corner) + (c % 3 == 2 ? "\n" : "");
        }
        before += mesh.positions.size();
    }
    return text;
}

/// The rule of ZerosAreMadeSaidAndAFault, and the normals beside the missing ones keep their bits.
TEST_F(MissingNormalsFile, ZerosInObjFilesAreMadeSaidAndAFault) {
    const Scene exact = roof(true);
    for (const char* none : {"0 0 0", "nan 0 0"}) {
        const std::string file = (folder_.path() / "in.obj").string();
        write(file, obj_text(exact, {4, 5}, none));
        const Inspection i = inspect(load(file, {}, context_), {}, context_);
        EXPECT_EQ(i.seams.missing_normals, 2u) << none;
        const std::vector<CheckFailure> failures = check_limits(i, {});
        ASSERT_EQ(failures.size(), 1u) << none;
        EXPECT_NE(failures[0].message.find("2 zero or non-finite normals in 'right'"), std::string::npos);

        EXPECT_TRUE(smooth_file(file, file, {}, context_).changed);
        const Scene after = load(file, {}, context_);
        EXPECT_TRUE(check_limits(inspect(after, {}, context_), {}).empty()) << none;
        for (std::size_t m = 0; m < 2; ++m)
            for (std::size_t v = 0; v < after.meshes[m].normals.size(); ++v) {
                EXPECT_LT(degrees_from_exact(after.meshes[m], v), 1e-3) << none << ' ' << v;
                const std::size_t was = vertex_before(exact.meshes[m], after.meshes[m].positions[v]);
                if (m == 0 || (was != 4 && was != 5)) {
                    EXPECT_EQ(after.meshes[m].normals[v], exact.meshes[m].normals[was]);
                }
            }
        const std::string once = bytes_of(file);
        EXPECT_FALSE(smooth_file(file, file, {}, context_).changed) << none;
        EXPECT_EQ(bytes_of(file), once);
    }
}

/// What is no normal becomes none in any format.
TEST_F(MissingNormalsFile, ConvertedZerosStayMissing) {
    Scene scene = roof(true);
    std::vector<vec3> normals(scene.meshes[1].normals.begin(), scene.meshes[1].normals.end());
    normals[4] = normals[5] = {};
    scene.meshes[1].normals = normals;
    const std::string file = written(scene);
    for (const char* name : {"a.obj", "a.ply", "a.gltf"}) {
        const std::string to = (folder_.path() / name).string();
        convert_file(file, to, {}, context_);
        EXPECT_EQ(inspect(load(to, {}, context_), {}, context_).seams.missing_normals, 2u) << name;
    }
}

TEST_F(MissingNormalsFile, ObjFilesOfZerosAloneGetNormals) {
    const std::string file = (folder_.path() / "in.obj").string();
    write(file, obj_text(roof(true), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, "0 0 0"));
    EXPECT_EQ(inspect(load(file, {}, context_), {}, context_).seams.missing_normals, 10u);
    EXPECT_EQ(smooth_file(file, file, {}, context_).meshes[1].normals, SmoothedMesh::Change::made);
    const Mesh right = load(file, {}, context_).meshes[1];
    for (std::size_t v = 0; v < right.positions.size(); ++v)
        if (right.positions[v].x < 0.71f) {  // the open end leans
            EXPECT_LT(degrees_from_exact(right, v), 1e-3) << v;
        }
    EXPECT_FALSE(smooth_file(file, file, {}, context_).changed);
}

TEST_F(MissingNormalsFile, NormalsThatAreNotKeptAreNotMissed) {
    Scene scene = roof(true);
    scene.meshes[1].normals = std::vector<vec3>(10);
    InspectOptions options;
    options.prepare.normals = NormalSource::model;
    EXPECT_EQ(inspect(scene, options, context_).seams.missing_normals, 0u);
}

TEST_F(MissingNormalsFile, PlyAndObjAreWrittenWithMadeNormals) {
    Scene scene = roof(true);
    scene.meshes[1].normals = std::vector<vec3>(10);
    const std::string file = written(scene);
    for (const char* name : {"out.ply", "out.obj"}) {
        const std::string to = (folder_.path() / name).string();
        smooth_file(file, to, {}, context_);
        for (const Mesh& mesh : load(to, {}, context_).meshes)
            for (std::size_t v = 0; v < mesh.normals.size(); ++v)
                if (std::fabs(mesh.positions[v].x) < 0.71f) {
                    EXPECT_LT(degrees_from_exact(mesh, v), 0.05) << name;
                }
    }
}

/// Two quads that a target folds about their common edge, with right base normals and offsets of zero, or none that fit.
Scene folding(bool has_right_offsets) {
    Mesh a = quad_mesh(), b = quad_mesh();
    a.normals = b.normals = std::vector<vec3>(4, {0, 0, 1});
    b.positions = std::vector<vec3>{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    const float half = float(std::sqrt(0.5));
    const vec3 edge{float(std::sin(pi / 8)), 0, float(std::cos(pi / 8))}, end{half, 0, half}, up{0, 0, 1};
    const vec3 down{half - 1, 0, -half};  // by 45 degrees about the edge x = 1
    const auto offsets = [&](vec3 first, vec3 second, vec3 third, vec3 fourth) {
        return has_right_offsets ? std::vector<vec3>{first - up, second - up, third - up, fourth - up}
                                 : std::vector<vec3>(4);
    };
    a.targets = {{"fold", std::vector<vec3>(4), offsets(up, edge, edge, up), {}}};
    b.targets = {{"fold", std::vector<vec3>{{}, down, down, {}}, offsets(edge, end, end, edge), {}}};
    Scene scene = scene_of({a, b});
    for (Node& node : scene.nodes) node.morph_weights = {0};
    return scene;
}

TEST_F(MissingNormalsFile, OffsetsOfTargetsAreMadeToo) {
    const SmoothedFile result = smoothed(written(folding(false)), anew);
    EXPECT_TRUE(result.changed);
    const Scene made = out(), right = folding(true);
    for (std::size_t m = 0; m < 2; ++m) {
        ASSERT_EQ(made.meshes[m].targets[0].normals.size(), 4u);
        for (std::size_t v = 0; v < 4; ++v) {
            EXPECT_EQ(made.meshes[m].normals[v], (vec3{0, 0, 1}));
            EXPECT_LE(length(made.meshes[m].targets[0].normals[v] - right.meshes[m].targets[0].normals[v]), 1e-6f);
        }
    }
    const std::string again = (folder_.path() / "again.glb").string();
    EXPECT_FALSE(smooth_file(result.output, again, anew, context_).changed);
    EXPECT_FALSE(smooth_file(written(folding(true)), again, anew, context_).changed) << "they are right already";
}

}  // namespace
}  // namespace rakelight
