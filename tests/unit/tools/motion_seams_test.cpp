// SPDX-License-Identifier: Apache-2.0
// Characters cut into parts have no seam in motion: where parts meet and follow the same joints, places and normals are
// equal to the bit in every frame.
#include <gtest/gtest.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/motion.h>

#include <array>
#include <cstring>
#include <map>

#include "math/linear.h"
#include "prepare/prepare_scene.h"
#include "tools/bench/bench_rig.h"

namespace rakelight {
namespace {

using Bits = std::array<std::uint32_t, 3>;

Bits bits(vec3 v) {
    v = v + vec3{0, 0, 0};  // -0 is +0
    Bits b;
    std::memcpy(b.data(), &v, sizeof v);
    return b;
}

/// Vertices of the bind pose that stand at one place and follow the same joints with the same weights.
struct Twins {
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> places;  ///< mesh, vertex
};

/// @param meshes  numbers in the prepared scene, in the order of the file's
Twins twins_of(const Scene& rest) {
    using Key = std::tuple<Bits, std::array<std::uint16_t, 4>, std::array<float, 4>>;
    std::map<Key, std::vector<std::pair<std::uint32_t, std::uint32_t>>> found;
    for (std::uint32_t m = 0; m < rest.meshes.size(); ++m) {
        const Mesh& mesh = rest.meshes[m];
        for (std::uint32_t v = 0; v < mesh.influences.size(); ++v)
            found[{bits(mesh.positions[v]), mesh.influences[v].joints, mesh.influences[v].weights}].emplace_back(m, v);
    }
    Twins twins;
    for (auto& [key, vertices] : found) {
        const bool crosses = std::ranges::any_of(vertices, [&](auto v) { return v.first != vertices[0].first; });
        if (crosses) twins.places.push_back(std::move(vertices));
    }
    return twins;
}

Scene at(const Scene& scene, double time_s) {
    const ClipTime clip{0, time_s};
    return scene_at(scene, std::span(&clip, 1));
}

struct Seams {
    std::size_t places = 0, open = 0, seams = 0;
};

/// @param has_one_normal  of a place: creases and hard edges have several in one part
Seams seams_of(const Scene& posed, const Twins& twins) {
    Seams s;
    for (const auto& place : twins.places) {
        std::map<std::uint32_t, std::vector<Bits>> normals;  // by mesh
        const auto [m0, v0] = place[0];
        for (const auto& [m, v] : place) {
            s.open += bits(posed.meshes[m].positions[v]) != bits(posed.meshes[m0].positions[v0]);
            normals[m].push_back(bits(posed.meshes[m].normals[v]));
        }
        ++s.places;
        for (auto& [m, own] : normals) {
            std::sort(own.begin(), own.end());
            own.erase(std::unique(own.begin(), own.end()), own.end());
        }
        s.seams += std::ranges::any_of(normals, [&](const auto& of) { return of.second != normals.begin()->second; });
    }
    return s;
}

TEST(MotionSeams, MadeNormalsOfACharacterInPartsAreEqualToTheBitInEveryFrame) {
    const Scene rig = make_bench_rig(6000, 8, 12);
    const Twins twins = twins_of(rig);
    ASSERT_GT(twins.places.size(), 200u);
    Context context;
    const BoundScene bound = bind_scene(rig, {.normals = NormalSource::model, .crease_angle_rad = pi}, context);
    ASSERT_EQ(bound.made.size(), 1u);
    for (int frame = 0; frame <= 12; ++frame) {
        const Scene posed = finish_scene(bound, at(rig, frame / 12.0).pose, {.normals = NormalSource::model}, context);
        const Seams seams = seams_of(posed, twins);
        EXPECT_EQ(seams.open, 0u) << "frame " << frame;
        EXPECT_EQ(seams.seams, 0u) << "frame " << frame << " of " << seams.places;
    }
}

TEST(MotionSeams, NormalsAreThoseOfTheMovedSurface) {
    const Scene rig = make_bench_rig(6000, 8, 12);
    Context context;
    const PrepareOptions options{.normals = NormalSource::model, .crease_angle_rad = pi};
    const Scene moved = prepare_scene(at(rig, 0.5), options, context);
    Scene still = moved;  // the same surface, smoothed where it stands
    for (Mesh& mesh : still.meshes) mesh.normals = {}, mesh.tangents = {};
    const Scene anew = prepare_scene(still, options, context);
    float largest = 0;
    for (std::size_t m = 0; m < moved.meshes.size(); ++m) {
        ASSERT_EQ(moved.meshes[m].normals.size(), anew.meshes[m].normals.size());
        for (std::size_t v = 0; v < moved.meshes[m].normals.size(); ++v)
            largest = std::max(largest, length(moved.meshes[m].normals[v] - anew.meshes[m].normals[v]));
    }
    EXPECT_LT(largest, 1e-5f);
}

TEST(MotionSeams, ASessionPosesWhatItHasPrepared) {
    const Scene rig = make_bench_rig(3000, 4, 8);
    Context context;
    Session session("soft");
    RenderSettings settings;
    settings.width = 64, settings.height = 48;
    session.set(rig, {.normals = NormalSource::model});
    session.prepared(settings, context);
    for (const double time : {0.2, 0.5, 0.0}) {
        session.set(at(rig, time), {.normals = NormalSource::model});
        const Scene& posed = scene_of(*session.prepared(settings, context));
        const Scene alone = prepare_scene(at(rig, time), {.normals = NormalSource::model}, context);
        ASSERT_EQ(posed.meshes.size(), alone.meshes.size());
        for (std::size_t m = 0; m < posed.meshes.size(); ++m) {
            const auto same = [](const auto& a, const auto& b) {
                return std::equal(a.begin(), a.end(), b.begin(), b.end());
            };
            EXPECT_TRUE(same(posed.meshes[m].positions, alone.meshes[m].positions)) << time;
            EXPECT_TRUE(same(posed.meshes[m].normals, alone.meshes[m].normals)) << time;
            EXPECT_TRUE(same(posed.meshes[m].tangents, alone.meshes[m].tangents)) << time;
        }
    }
}

/// The character with normals that a file would have: smooth inside each part, with seams between them.
Scene with_file_normals(Scene rig) {
    Context context;
    BoundScene bound = bind_scene(std::move(rig), {.normals = NormalSource::object, .crease_angle_rad = pi}, context);
    return std::move(bound.scene);
}

TEST(MotionSeams, JoinedSeamsOfTheFilesNormalsStayClosedInEveryFrame) {
    const Scene rig = with_file_normals(make_bench_rig(6000, 8, 12));
    const Twins twins = twins_of(rig);
    Context context;
    const PrepareOptions file{.normals = NormalSource::file}, joined{.normals = NormalSource::seams};
    const Scene open = prepare_scene(at(rig, 0.5), file, context);
    EXPECT_GT(seams_of(open, twins).seams, 100u) << "else there is nothing to join";
    const BoundScene bound = bind_scene(rig, joined, context);
    EXPECT_TRUE(bound.made.empty()) << "the file's normals are turned, not made again";
    for (int frame = 0; frame <= 12; ++frame) {
        const Scene posed = finish_scene(bound, at(rig, frame / 12.0).pose, joined, context);
        const Seams seams = seams_of(posed, twins);
        EXPECT_EQ(seams.open, 0u) << "frame " << frame;
        EXPECT_EQ(seams.seams, 0u) << "frame " << frame << " of " << seams.places;
    }
}

TEST(MotionSeams, WhatPartsInMotionIsReported) {
    Scene rig = make_bench_rig(3000, 4, 8);
    std::vector<JointInfluence> other(rig.meshes[0].influences.begin(), rig.meshes[0].influences.end());
    for (JointInfluence& influence : other) influence = {{7, 0, 0, 0}, {1, 0, 0, 0}};
    rig.meshes[0].influences = std::move(other);
    Context context;
    prepare_scene(rig, {.normals = NormalSource::model}, context);
    const auto& remarks = context.report().entries();
    EXPECT_TRUE(std::ranges::any_of(
        remarks, [](const auto& r) { return r.message.find("will part in motion") != std::string::npos; }));
}

}  // namespace
}  // namespace rakelight
