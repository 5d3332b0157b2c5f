// SPDX-License-Identifier: Apache-2.0
// Meshes that the engine gl poses by transform feedback beside those that the processor poses: vertices that are read back. On
// llvmpipe where there is no GPU; skipped where there is no OpenGL.
#include <gtest/gtest.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <set>

#include <nlohmann/json.hpp>

#include "engines/opengl/context/headless.h"
#include "engines/opengl/renderer.h"
#include "parity/arm.h"
#include "render/prepared_scene.h"
#include "support/environment_variable.h"
#include "support/shared.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;
using geometry::MeshPose, test::arm, test::bent, test::oblique, test::small, test::EnvironmentVariable;

/// Largest differences of vertices that were read back: positions in sizes of the model, directions in lengths.
struct Differences {
    double positions = 0, directions = 0;
    std::size_t meshes = 0, vertices = 0;
};

template <class T>
std::vector<T> read_back(const opengl::GlBuffer& buffer, std::size_t count) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
    const auto bytes = GLsizeiptr(count * sizeof(T));
    const auto* const at = static_cast<const T*>(glMapBufferRange(GL_COPY_READ_BUFFER, 0, bytes, GL_MAP_READ_BIT));
    std::vector<T> out(at, at + count);
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    return out;
}

/// Whether the blended matrix of a vertex is flat but for rounding, as halfway between a mirrored joint and one that is not:
/// which side its directions are on is chance.
bool is_flat(const MeshPose& pose, std::size_t v) {
    if (pose.joints.empty()) return false;
    dmat3 m{{dvec3{}, dvec3{}, dvec3{}}};
    for (const Block<JointInfluence>* const block : {&pose.influences, &pose.more_influences})
        for (std::size_t k = 0; k < 4 && !block->empty(); ++k) {
            const double weight = (*block)[v].weights[k];
            if (weight == 0) continue;
            const geometry::JointColumns& joint = pose.joints[(*block)[v].joints[k]];
            for (std::size_t c = 0; c < 3; ++c)
                m[c] += dvec3{joint.columns[c][0], joint.columns[c][1], joint.columns[c][2]} * weight;
        }
    const double volume = length(m[0]) * length(m[1]) * length(m[2]);
    return volume > 0 ? std::fabs(determinant(m)) < 1e-5 * volume
                      : dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]) > 0;
}

/// OpenGL 3.3 core, or ES 3.0 where the name says "es".
class GpuPoses : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        try {
            gl.emplace();
            renderer.emplace();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }
    void TearDown() override { renderer.reset(), gl.reset(); }

    void take(const PreparedScene& prepared) { renderer->prepare({prepared.scene, prepared.poses}, context); }
    void begin(const RenderSettings& settings) {
        RenderStats stats;
        renderer->begin_picture(oblique(), settings, stats, context);
    }

    /// By the store alone, whatever draws the meshes.
    void compare(UnposedScene unposed, Differences& to) {
        opengl::MeshStore meshes(renderer->driver());
        opengl::PoseStore store(renderer->driver());
        store.pose(unposed.scene, unposed.poses, meshes);
        for (const auto& [number, pose] : unposed.poses) {
            const opengl::PosedBuffers* const got = store.of(number);
            ASSERT_NE(got, nullptr);
            compare(pose, *got, to);
        }
    }
    void compare(const MeshPose& pose, const opengl::PosedBuffers& got, Differences& to) {
        const geometry::PosedArrays wanted = geometry::posed_arrays(pose, context);
        const geometry::Box box = geometry::posed_box(pose, context);
        const double size = length(cast<double>(box.high - box.low));
        const auto positions = read_back<vec3>(got.positions, pose.positions.size());
        ++to.meshes;
        for (std::size_t v = 0; v < positions.size(); ++v, ++to.vertices)
            to.positions = std::fmax(to.positions, double(length(positions[v] - wanted.positions[v])) / size);
        if (!pose.normals.empty()) {
            const auto normals = read_back<vec3>(got.normals, positions.size());
            for (std::size_t v = 0; v < normals.size(); ++v) {
                if (is_flat(pose, v)) {
                    EXPECT_NEAR(length(normals[v]), 1, 1e-5);
                } else {
                    to.directions = std::fmax(to.directions, double(length(normals[v] - wanted.normals[v])));
                }
            }
        }
        if (pose.tangents.empty()) return;
        const auto tangents = read_back<vec4>(got.tangents, positions.size());
        for (std::size_t v = 0; v < tangents.size(); ++v) {
            if (is_flat(pose, v)) continue;
            EXPECT_EQ(tangents[v].w, wanted.tangents[v].w);
            to.directions = std::fmax(to.directions, double(length(tangents[v].xyz() - wanted.tangents[v].xyz())));
        }
    }

    EnvironmentVariable flavour{"RAKELIGHT_GL", GetParam().c_str()}, no_cache{"RAKELIGHT_GL_CACHE", "off"},
        by_gpu{"RAKELIGHT_GL_POSES", "gpu"};
    Context context{{.threads = 1}};
    std::optional<opengl::HeadlessContext> gl;
    std::optional<opengl::Renderer> renderer;
};

/// Directions for meshes that have none: the cases are about positions.
void add_directions(Scene& scene) {
    std::mt19937 random{3};
    std::uniform_real_distribution<float> number(-1, 1);
    const auto direction = [&] {
        return normalize_or(vec3{number(random), number(random), number(random)}, vec3{0, 0, 1});
    };
    for (Mesh& mesh : scene.meshes) {
        std::vector<vec3> normals;
        std::vector<vec4> tangents;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const vec3 t = direction();
            normals.push_back(direction()), tangents.push_back({t.x, t.y, t.z, v % 2 ? 1.0f : -1.0f});
        }
        if (mesh.normals.empty()) mesh.normals = std::move(normals);
        if (mesh.tangents.empty()) mesh.tangents = std::move(tangents);
    }
}

std::vector<fs::path> references() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "tests/poses/positions"))
        files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

TEST_P(GpuPoses, VerticesStandWhereTheProcessorPutsThem) {
    Differences all;
    std::size_t models = 0, moments = 0;
    for (const fs::path& file : references()) {
        std::ifstream in(file);
        const nlohmann::json reference = nlohmann::json::parse(in);
        const std::string name = reference["model"];
        const fs::path model = name.starts_with("cases/") ? test::source_dir() / "tests/poses" / name
                                                          : test::shared_dir() / "assets" / name;
        if (!fs::exists(model)) continue;
        Scene scene = load(model.string(), {}, context);
        add_directions(scene);
        Differences here;
        for (const auto& pose : reference["poses"]) {
            Scene at = scene;
            if (!pose["clip"].is_null()) {
                const ClipTime clip{pose["clip"], pose["time"]};
                at = scene_at(scene, std::span(&clip, 1));
            }
            compare(valid::unposed_scene(std::move(at), context), here);
            moments += here.meshes > 0;
        }
        EXPECT_LE(here.positions, 1e-4) << name;
        EXPECT_LE(here.directions, 1e-3) << name;
        all.positions = std::fmax(all.positions, here.positions);
        all.directions = std::fmax(all.directions, here.directions);
        all.meshes += here.meshes, all.vertices += here.vertices, models += here.meshes > 0;
    }
    EXPECT_GE(models, 30u);
    RecordProperty("models", std::to_string(models));
    RecordProperty("moments", std::to_string(moments));
    RecordProperty("vertices", std::to_string(all.vertices));
    RecordProperty("largest_of_positions", std::to_string(1e9 * all.positions) + "e-9 of the size");
    RecordProperty("largest_of_directions", std::to_string(1e9 * all.directions) + "e-9");
}

TEST_P(GpuPoses, FlatTinyAndMirroredMatricesKeepDirectionsUnit) {
    for (const dvec3 size : {dvec3{1e-15, 1e-15, 1e-15}, dvec3{1e12, 1e12, 1e12}, dvec3{-1, 1, 1}, dvec3{1, 0, 1},
                             dvec3{0, 0, 0}, dvec3{-2, -3, 0.1}}) {
        UnposedScene unposed = valid::unposed_scene(bent(arm(), 0.3, 0.5f), context);
        std::vector<geometry::JointColumns> joints(2, geometry::columns_of(scaling(size)));
        unposed.poses.at(0).joints = joints;
        opengl::MeshStore meshes(renderer->driver());
        opengl::PoseStore store(renderer->driver());
        store.pose(unposed.scene, unposed.poses, meshes);
        const geometry::PosedArrays wanted = geometry::posed_arrays(unposed.poses.at(0), context);
        const auto normals = read_back<vec3>(store.of(0)->normals, wanted.normals.size());
        const auto tangents = read_back<vec4>(store.of(0)->tangents, wanted.normals.size());
        for (std::size_t v = 0; v < normals.size(); ++v) {
            EXPECT_LE(length(normals[v] - wanted.normals[v]), 1e-5f) << size.x << " " << v;
            EXPECT_LE(length(tangents[v].xyz() - wanted.tangents[v].xyz()), 1e-5f) << size.x << " " << v;
            EXPECT_EQ(tangents[v].w, wanted.tangents[v].w);
        }
    }
}

TEST_P(GpuPoses, BoxesOfDrawsAreThoseOfPosedArrays) {
    const auto prepared = make_prepared(bent(arm(), 1.1, 0.7f), {}, small(), context);
    ASSERT_TRUE(prepared->poses);
    const auto list_of = [&](bool by_processor) {
        return opengl::take_scene({prepared->scene, prepared->poses}, by_processor, {}, {}, context).list;
    };
    const shading::DrawList gpu = list_of(false), cpu = list_of(true);
    ASSERT_EQ(gpu.draws.size(), 2u);
    for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_EQ(gpu.draws[d].low, cpu.draws[d].low);
        EXPECT_EQ(gpu.draws[d].high, cpu.draws[d].high);
    }
    EXPECT_EQ(gpu.bounds.low, cpu.bounds.low);
    EXPECT_EQ(gpu.bounds.high, cpu.bounds.high);
}

TEST_P(GpuPoses, BuffersAreUsedAgainFromMomentToMoment) {
    auto prepared = make_prepared(bent(arm(), 0), {}, small(), context);
    std::set<std::uint64_t> bytes;
    std::set<GLuint> names;
    for (int moment = 0; moment < 6; ++moment) {
        prepared = make_posed(*prepared, bent(arm(), 0.2 * moment, 0.1f * float(moment)).pose, context);
        take(*prepared);
        begin(small());
        renderer->draw_part({0, 0, 120, 90}, context);
        ASSERT_NE(renderer->poses().of(0), nullptr);
        Differences found;
        compare(prepared->poses->at(0), *renderer->poses().of(0), found);
        EXPECT_LE(found.positions, 1e-4) << moment;
        bytes.insert(renderer->mesh_bytes());
        names.insert(renderer->poses().of(0)->positions.name());
    }
    EXPECT_EQ(bytes.size(), 1u) << "nothing grows";
    EXPECT_EQ(names.size(), 1u);
}

TEST_P(GpuPoses, WhatReadsVerticesOnTheProcessorHasThemPosedThere) {
    const auto prepared = make_prepared(bent(arm(), 0.8), {}, small(), context);
    take(*prepared);
    begin(small());
    EXPECT_NE(renderer->poses().of(0), nullptr);
    RenderSettings flat = small();
    flat.shading = Shading::flat;
    begin(flat);
    EXPECT_EQ(renderer->poses().of(0), nullptr);
    EXPECT_EQ(renderer->scene().meshes[0].positions.span()[100], scene_of(*prepared).meshes[0].positions.span()[100]);
    begin(small());
    EXPECT_EQ(renderer->poses().of(0), nullptr) << "for this moment";
    take(*make_posed(*prepared, bent(arm(), 0.9).pose, context));
    begin(small());
    EXPECT_NE(renderer->poses().of(0), nullptr) << "the next one is the GPU's again";
}

INSTANTIATE_TEST_SUITE_P(OpenGl, GpuPoses, testing::Values("core", "es"), [](const auto& of) { return of.param; });

}  // namespace
}  // namespace rakelight
