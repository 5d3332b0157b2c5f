// SPDX-License-Identifier: Apache-2.0
// Pictures of meshes that the engine gl poses on the GPU, and of those that it has to get posed. On llvmpipe where there is no GPU;
// skipped where there is no OpenGL.
#include <gtest/gtest.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>

#include <algorithm>
#include <cmath>

#include "engines/opengl/opengl_engine.h"
#include "engines/raster/raster_engine.h"
#include "parity/arm.h"
#include "render/auto_engine.h"
#include "render/prepared_scene.h"
#include "support/environment_variable.h"
#include "support/shared.h"

namespace rakelight {
namespace {

using test::arm, test::bent, test::oblique, test::small, test::EnvironmentVariable;

/// The picture of a session whose scenes come one after another; the last one.
Frame drawn(std::unique_ptr<Engine> engine, const std::vector<Scene>& moments, const RenderSettings& settings,
            const PrepareOptions& options, Context& context) {
    Session session(std::move(engine));
    Frame frame;
    for (const Scene& moment : moments) {
        session.set(moment, options);
        session.render(oblique(), settings, frame, context);
    }
    return frame;
}

/// [1/255] of linear colors, root of the mean square.
double rmse(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        const vec3 d = a.color[i].xyz() - b.color[i].xyz();
        sum += double(dot(d, d)) / 3;
    }
    return 255 * std::sqrt(sum / double(a.color.size()));
}

class PosedPictures : public testing::Test {
protected:
    void SetUp() override {
        try {
            opengl::make_engine();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }
    Frame by(const char* who, const std::vector<Scene>& moments, const RenderSettings& settings,
             const PrepareOptions& options = {}) {
        const EnvironmentVariable poses("RAKELIGHT_GL_POSES", who);
        return drawn(opengl::make_engine(), moments, settings, options, context);
    }
    /// Of a driver that poses, beside one that gets posed arrays, and beside the soft engine.
    void expect_alike(const std::vector<Scene>& moments, const RenderSettings& settings, double most_beside_arrays,
                      double most_beside_soft, const PrepareOptions& options = {}) {
        const Frame gpu = by("gpu", moments, settings, options), cpu = by("cpu", moments, settings, options),
                    soft = drawn(raster::make_engine(), moments, settings, options, context);
        EXPECT_LE(rmse(gpu, cpu), most_beside_arrays);
        EXPECT_LE(rmse(gpu, soft), most_beside_soft);
        EXPECT_GT(rmse(gpu, by("gpu", {moments[0]}, settings, options)), 5) << "it moves";
    }
    EnvironmentVariable no_cache{"RAKELIGHT_GL_CACHE", "off"};
    Context context{{.threads = 1}};
};

std::vector<Scene> three_moments() { return {bent(arm(), 0), bent(arm(), 0.5, 0.5f), bent(arm(), 1.1, 1)}; }

TEST_F(PosedPictures, AMomentIsDrawnAsWithArraysAndAsTheSoftEngineDrawsIt) {
    expect_alike(three_moments(), small(), 0.2, 1.5);
}

TEST_F(PosedPictures, ShadowsAreThoseOfThePose) {
    std::vector<Scene> moments = three_moments();
    for (Scene& moment : moments) moment.lights[0].casts_shadow = true;
    RenderSettings settings = small();
    settings.shadows = true;
    expect_alike(moments, settings, 0.2, 3);
}

TEST_F(PosedPictures, FlatShadingEdgesPointsAndTrianglesAreDrawnOfPosedArrays) {
    RenderSettings flat = small(), edges = small(), points = small(), triangles = small();
    flat.shading = Shading::flat;
    edges.edges = true;
    points.points = PointShape::disc;
    triangles.channels = channel_triangle | channel_object | channel_barycentric;
    for (const RenderSettings& settings : {flat, edges, points, triangles}) {
        const Frame gpu = by("gpu", three_moments(), settings), cpu = by("cpu", three_moments(), settings);
        EXPECT_EQ(gpu.color, cpu.color);
        EXPECT_EQ(gpu.triangle, cpu.triangle);
        EXPECT_EQ(gpu.object, cpu.object);
    }
}

TEST_F(PosedPictures, BlendedSurfacesAreSortedAsTheyStand) {
    std::vector<Scene> moments = three_moments();
    for (Scene& moment : moments)
        moment.materials[0].base_color.w = 0.5f, moment.materials[0].alpha_mode = AlphaMode::blend;
    const Frame gpu = by("gpu", moments, small()), cpu = by("cpu", moments, small());
    EXPECT_EQ(gpu.color, cpu.color);
    EXPECT_GT(rmse(gpu, by("gpu", {moments[0]}, small())), 5);
}

TEST_F(PosedPictures, NormalsThatAreMadeAreMadeAgain) {
    const PrepareOptions made{.normals = NormalSource::model};
    const auto prepared = make_prepared(bent(arm(), 1), made, small(), context);
    EXPECT_FALSE(prepared->poses) << "prepare needs the vertices";
    const Frame gpu = by("gpu", three_moments(), small(), made), cpu = by("cpu", three_moments(), small(), made);
    EXPECT_EQ(gpu.color, cpu.color);
}

TEST_F(PosedPictures, WhatTheGpuCannotDoTheSoftEngineDrawsOfThePose) {
    const EnvironmentVariable poses("RAKELIGHT_GL_POSES", "gpu");
    RenderSettings settings = small();
    settings.visibility = Visibility::z24;
    const Frame got = drawn(make_auto_engine(opengl::make_engine(), ""), three_moments(), settings, {}, context);
    EXPECT_EQ(got.color, drawn(raster::make_engine(), three_moments(), settings, {}, context).color);
}

TEST_F(PosedPictures, AFileIsDrawnInTheMiddleOfItsClip) {
    RL_NEEDS_SHARED("assets/gltf/RiggedFigure/RiggedFigure.glb");
    const Scene scene = load((test::shared_dir() / "assets/gltf/RiggedFigure/RiggedFigure.glb").string(), {}, context);
    std::vector<Scene> moments;
    for (const double time : {0.0, 0.3, 0.6}) {
        const ClipTime clip{0, time};
        moments.push_back(scene_at(scene, std::span(&clip, 1)));
        moments.back().lights = {test::directional({-1, -1, -2})};
    }
    ASSERT_TRUE(make_prepared(moments[1], {}, small(), context)->poses);
    expect_alike(moments, small(), 0.2, 1.5);
}

TEST_F(PosedPictures, TheSceneOfASessionHasItsVerticesPosed) {
    Session session;
    const Scene scene = bent(arm(), 0.7);
    session.set(scene);
    const auto prepared = session.prepared(small(), context);
    const Scene wanted = posed_scene(scene, context);
    EXPECT_TRUE(std::ranges::equal(scene_of(*prepared).meshes[0].positions.span(), wanted.meshes[0].positions.span()));
    Scene lit = scene;
    lit.lights.pop_back();
    session.set(lit);
    const auto other = session.prepared(small(), context);
    EXPECT_EQ(scene_of(*other).lights.size(), 1u);
    EXPECT_EQ(scene_of(*other).meshes, scene_of(*prepared).meshes) << "other lights pose nothing anew";
}

}  // namespace
}  // namespace rakelight
