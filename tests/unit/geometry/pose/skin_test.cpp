// SPDX-License-Identifier: Apache-2.0
// Linear blend skinning against the sum in double, vertex by vertex, with every instruction set.
#include "geometry/pose/skin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "geometry/pose/morph.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

struct Rig {
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
    std::vector<JointInfluence> influences, more;
    std::vector<JointColumns> joints;
    std::vector<dmat4> matrices;

    SkinInput input() const { return {positions, normals, tangents, influences, more, joints}; }
};

struct Skinned {
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
};

dmat4 random_matrix(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    dmat4 m =
        compose({number(random), number(random), number(random)}, {number(random), number(random), number(random), 1.5},
                {1 + 0.5 * number(random), 1 + 0.5 * number(random), 1 + 0.5 * number(random)});
    return m;
}

Rig random_rig(std::size_t vertices, bool has_more) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    Rig rig;
    for (int j = 0; j < 9; ++j) {
        rig.matrices.push_back(random_matrix(random));
        rig.joints.push_back(columns_of(rig.matrices.back()));
    }
    for (std::size_t v = 0; v < vertices; ++v) {
        rig.positions.push_back({number(random), number(random), number(random)});
        rig.normals.push_back(normalize_or(vec3{number(random), number(random), number(random)}, vec3{0, 0, 1}));
        const vec3 t = normalize_or(vec3{number(random), number(random), number(random)}, vec3{0, 0, 1});
        rig.tangents.push_back({t.x, t.y, t.z, v % 2 ? 1.0f : -1.0f});
        JointInfluence first, next;
        float sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            first.joints[k] = std::uint16_t(random() % 9), next.joints[k] = std::uint16_t(random() % 9);
            sum += first.weights[k] = std::fabs(number(random)) + 0.01f;
            if (has_more && v % 3 == 0) sum += next.weights[k] = 0.1f * std::fabs(number(random));
        }
        for (std::size_t k = 0; k < 4; ++k) first.weights[k] /= sum, next.weights[k] /= sum;
        rig.influences.push_back(first);
        if (has_more) rig.more.push_back(next);
    }
    return rig;
}

Skinned skinned(const Rig& rig, unsigned threads = 2) {
    Skinned out{std::vector<vec3>(rig.positions.size()), std::vector<vec3>(rig.normals.size()),
                std::vector<vec4>(rig.tangents.size())};
    Context context({.threads = int(threads)});
    skin_vertices(rig.input(), {out.positions, out.normals, out.tangents}, context);
    return out;
}

dmat4 blended(const Rig& rig, std::size_t v) {
    dmat4 sum{};
    for (std::size_t c = 0; c < 4; ++c) sum[c] = {};
    const auto add = [&](const JointInfluence& influence) {
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t c = 0; c < 4; ++c)
                sum[c] = sum[c] + rig.matrices[influence.joints[k]][c] * double(influence.weights[k]);
    };
    add(rig.influences[v]);
    if (!rig.more.empty()) add(rig.more[v]);
    return sum;
}

void expect_near(vec3 got, dvec3 wanted, double tolerance, std::size_t v) {
    EXPECT_LE(length(cast<double>(got) - wanted), tolerance) << "vertex " << v;
}

void expect_as_in_double(const Rig& rig) {
    const Skinned got = skinned(rig);
    for (std::size_t v = 0; v < rig.positions.size(); ++v) {
        const dmat4 m = blended(rig, v);
        const double side = determinant(upper_left(m)) < 0 ? -1 : 1;
        expect_near(got.positions[v], transform_point(m, cast<double>(rig.positions[v])), 2e-6, v);
        const dvec3 n = cofactor(upper_left(m)) * cast<double>(rig.normals[v]) * side;
        expect_near(got.normals[v], normalize_or(n, dvec3{}), 1e-4, v);  // blended matrices can be nearly flat
        const dvec3 t = transform_direction(m, cast<double>(rig.tangents[v].xyz()));
        expect_near(got.tangents[v].xyz(), normalize_or(t, dvec3{}), 1e-4, v);
        EXPECT_EQ(got.tangents[v].w, rig.tangents[v].w * float(side));
    }
}

TEST(Skin, IsTheWeightedSumOfFourJoints) { expect_as_in_double(random_rig(1000, false)); }

TEST(Skin, IsTheWeightedSumOfEightJoints) { expect_as_in_double(random_rig(1000, true)); }

TEST(Skin, GivesTheSameBitsForAnyInstructionSetThreadsAndPlaceInTheArray) {
    const char* const before = std::getenv("RAKELIGHT_ISA");
    const std::string kept = before ? before : "";
    for (const std::size_t vertices : {1u, 15u, 16u, 17u, 4095u, 4097u, 9000u}) {
        const Rig rig = random_rig(vertices, true);
        setenv("RAKELIGHT_ISA", "scalar", 1);
        const Skinned wanted = skinned(rig, 1);
        for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            setenv("RAKELIGHT_ISA", name(isa), 1);
            const Skinned got = skinned(rig, 2);
            EXPECT_EQ(got.positions, wanted.positions) << name(isa) << " " << vertices;
            EXPECT_EQ(got.normals, wanted.normals) << name(isa) << " " << vertices;
            EXPECT_EQ(got.tangents, wanted.tangents) << name(isa) << " " << vertices;
        }
    }
    before ? setenv("RAKELIGHT_ISA", kept.c_str(), 1) : unsetenv("RAKELIGHT_ISA");
}

TEST(Skin, VerticesWithoutWeightsFollowTheFirstJoint) {
    Rig rig = random_rig(20, false);
    for (JointInfluence& influence : rig.influences) influence = {};
    const Skinned got = skinned(rig);
    for (std::size_t v = 0; v < 20; ++v)
        expect_near(got.positions[v], transform_point(rig.matrices[0], cast<double>(rig.positions[v])), 1e-6, v);
}

TEST(Skin, TinyAndHugeMatricesKeepDirectionsUnit) {
    for (const double size : {1e-18, 1e-12, 1e15}) {
        Rig rig = random_rig(40, false);
        for (std::size_t j = 0; j < rig.joints.size(); ++j) {
            rig.matrices[j] = scaling(dvec3{size, size, size});
            rig.joints[j] = columns_of(rig.matrices[j]);
        }
        const Skinned got = skinned(rig);
        for (std::size_t v = 0; v < 40; ++v) {
            expect_near(got.normals[v], cast<double>(rig.normals[v]), 1e-5, v);
            expect_near(got.tangents[v].xyz(), cast<double>(rig.tangents[v].xyz()), 1e-5, v);
        }
    }
}

TEST(Skin, FlatMatricesLeaveDirectionsThatVanish) {
    Rig rig = random_rig(20, false);
    for (JointColumns& joint : rig.joints) joint = columns_of(scaling(dvec3{0, 0, 0}));
    const Skinned got = skinned(rig);
    EXPECT_EQ(got.normals, rig.normals);
    for (const vec4& t : got.tangents) EXPECT_TRUE(is_finite(t.xyz()));
}

TEST(Skin, MirroredTangentsChangeTheirSign) {
    Rig rig = random_rig(20, false);
    for (JointColumns& joint : rig.joints) joint = columns_of(scaling(dvec3{-1, 1, 1}));
    const Skinned got = skinned(rig);
    for (std::size_t v = 0; v < 20; ++v) {
        const vec3 n = rig.normals[v];
        expect_near(got.normals[v], {-n.x, n.y, n.z}, 1e-6, v);  // the outside stays out
        EXPECT_EQ(got.tangents[v].w, -rig.tangents[v].w);
    }
}

TEST(Morph, AddsWeightedOffsets) {
    const std::vector<vec3> base = {{0, 0, 1}, {0, 1, 0}}, a = {{1, 0, 0}, {0, 0, 0}}, b = {{0, 2, 0}, {0, -1, 0}};
    const std::vector<WeightedTarget> targets = {{0.5f, a}, {1, b}};
    std::vector<vec3> out(2);
    Context context;
    morph_positions(base, targets, out, context);
    EXPECT_EQ(out[0], (vec3{0.5f, 2, 1}));
    EXPECT_EQ(out[1], (vec3{0, 0, 0}));
    morph_normals(base, targets, out, context);
    EXPECT_NEAR(length(out[0]), 1, 1e-6);
    EXPECT_EQ(out[1], base[1]) << "what vanishes stays";
}

}  // namespace
}  // namespace rakelight::geometry
