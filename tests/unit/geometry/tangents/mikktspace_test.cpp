// SPDX-License-Identifier: Apache-2.0
// Tangents of mode mikktspace against those of the reference implementation (tests/support/mikktspace_vectors.mjs made
// the files), and what the mode promises beyond it.
#include "geometry/tangents/mikktspace.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>

#include "support/shared.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

struct Vectors {
    Shape shape;                 // three vertices of its own for each triangle
    std::vector<vec4> tangents;  // [corners] of the reference
};

Vectors read_vectors(const std::string& name) {
    std::ifstream file(source_dir() / "tests/unit/geometry/data" / ("mikktspace_" + name + ".txt"));
    EXPECT_TRUE(file) << name;
    Vectors v;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream in(line);
        std::array<double, 12> x{};
        for (double& number : x) in >> number;
        EXPECT_TRUE(in) << name << ": " << line;
        const auto f = [&](std::size_t i) { return float(x[i]); };
        v.shape.indices.push_back(std::uint32_t(v.shape.positions.size()));
        v.shape.positions.push_back({f(0), f(1), f(2)});
        v.shape.normals.push_back({f(3), f(4), f(5)});
        v.shape.texcoords.push_back({f(6), f(7)});
        v.tangents.push_back({f(8), f(9), f(10), f(11)});
    }
    return v;
}

// One vertex for all corners that are equal in position, normal and texture coordinate.
Shape indexed(const Shape& soup) {
    Shape s;
    std::map<std::array<float, 8>, std::uint32_t> number;
    for (std::size_t i = 0; i < soup.positions.size(); ++i) {
        const vec3 p = soup.positions[i], n = soup.normals[i];
        const vec2 q = soup.texcoords[i];
        const auto [at, is_new] =
            number.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z, q.x, q.y}, std::uint32_t(s.positions.size()));
        if (is_new) {
            s.positions.push_back(p);
            s.normals.push_back(n);
            s.texcoords.push_back(q);
        }
        s.indices.push_back(at->second);
    }
    return s;
}

AttributeOptions mikktspace() {
    AttributeOptions options;
    options.normals = false;
    options.tangent_mode = TangentMode::mikktspace;
    return options;
}

// What the standard gives where it found nothing, its default, or nothing at all. Ours is perpendicular to the normal
// there.
bool is_default(vec4 t) { return t == vec4{1, 0, 0, 1} || t.xyz() == vec3{}; }

void expect_equal(const std::string& name, const Vectors& reference, const Shape& shape, const MeshAttributes& out) {
    ASSERT_EQ(out.tangents.size(), out.normals.size());
    std::size_t differ = 0, defaults = 0;
    for (std::size_t i = 0; i < reference.tangents.size(); ++i) {
        const std::uint32_t v = output_vertex(shape, out, i);
        const vec4 t = out.tangents[v], r = reference.tangents[i];
        EXPECT_NEAR(length(cast<double>(t.xyz())), 1, 1e-5) << name << " corner " << i;
        EXPECT_NEAR(dot(cast<double>(t.xyz()), cast<double>(out.normals[v])), 0, 1e-5) << name << " corner " << i;
        if (is_default(r) && (r.xyz() == vec3{} || std::fabs(dot(r.xyz(), out.normals[v])) > 1e-5f)) {
            EXPECT_EQ(t.w, r.w);
            ++defaults;
            continue;
        }
        const double off = length(cast<double>(t.xyz()) - cast<double>(r.xyz()));
        if (off > 1e-4 || t.w != r.w) ++differ;
        EXPECT_LE(off, 1e-4) << name << " corner " << i;
        EXPECT_EQ(t.w, r.w) << name << " corner " << i;
    }
    EXPECT_EQ(differ, 0u) << name << ": of " << reference.tangents.size();
    EXPECT_LT(defaults, reference.tangents.size() / 4) << name;
}

class MikktspaceVectors : public testing::TestWithParam<const char*> {};

TEST_P(MikktspaceVectors, AreThoseOfTheReferenceOnCornersOfTheirOwn) {
    const Vectors reference = read_vectors(GetParam());
    expect_equal(GetParam(), reference, reference.shape, compute({reference.shape}, mikktspace()).front());
}

TEST_P(MikktspaceVectors, AreThoseOfTheReferenceOnSharedVerticesThatSplit) {
    const Vectors reference = read_vectors(GetParam());
    const Shape shape = indexed(reference.shape);
    ASSERT_LT(shape.positions.size(), reference.tangents.size());
    const MeshAttributes out = compute({shape}, mikktspace()).front();
    expect_equal(GetParam(), reference, shape, out);
    ASSERT_EQ(out.normals.size(), shape.positions.size() + out.source_vertex.size());
    EXPECT_TRUE(std::is_sorted(out.source_vertex.begin(), out.source_vertex.end()));
    for (std::size_t i = 0; i < shape.indices.size(); ++i) {
        const std::uint32_t v = output_vertex(shape, out, i), fixed = std::uint32_t(shape.positions.size());
        EXPECT_EQ(v < fixed ? v : out.source_vertex[v - fixed], shape.indices[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, MikktspaceVectors,
                         testing::Values("cube", "round_cube", "sphere", "mirrored", "degenerate", "turned", "soup",
                                         "charts", "crowd"),
                         [](const auto& made) { return std::string(made.param); });

TEST(Mikktspace, QuadHasTheSignOfTheGltfReference) {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    s.indices = {0, 1, 2, 0, 2, 3};
    s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    AttributeOptions options;
    options.tangent_mode = TangentMode::mikktspace;
    EXPECT_EQ(compute({s}, options).front().tangents, std::vector<vec4>(4, {1, 0, 0, 1}));
    for (vec2& q : s.texcoords) q.x = 1 - q.x;
    EXPECT_EQ(compute({s}, options).front().tangents, std::vector<vec4>(4, {-1, 0, 0, -1}));
}

TEST(Mikktspace, StandsOnComputedNormalsAndTheirSplits) {
    // A cube of eight vertices splits into 24 by its creases; each side then has its own tangents.
    Shape cube = make_cube();
    for (const vec3 p : cube.positions) cube.texcoords.push_back({p.x + 0.25f * p.z, p.y + 0.5f * p.z});
    AttributeOptions options;
    options.tangent_mode = TangentMode::mikktspace;
    const MeshAttributes out = compute({cube}, options).front();
    ASSERT_EQ(out.normals.size(), 24u);
    ASSERT_EQ(out.tangents.size(), 24u);
    for (std::size_t v = 0; v < 24; ++v) {
        EXPECT_NEAR(length(cast<double>(out.tangents[v].xyz())), 1, 1e-6);
        EXPECT_NEAR(dot(out.tangents[v].xyz(), out.normals[v]), 0, 1e-6);
    }
    options.tangent_mode = TangentMode::averaged;
    EXPECT_EQ(out.normals.size(), compute({cube}, options).front().normals.size());
}

TEST(Mikktspace, IsFiniteForWhateverTheCornersHold) {
    const float bad[] = {0, -0.0f, 1, 1e-30f, 1e30f, INFINITY, std::nanf("")};
    std::mt19937 random(5);
    for (int round = 0; round < 50; ++round) {
        Shape s;
        const auto number = [&] { return random() % 4 == 0 ? bad[random() % 7] : float(random() % 5); };
        for (int v = 0; v < 12; ++v) {
            s.positions.push_back({number(), number(), number()});
            s.normals.push_back({number(), number(), number()});
            s.texcoords.push_back({number(), number()});
        }
        for (int i = 0; i < 60; ++i) s.indices.push_back(random() % 12);
        for (const bool makes_normals : {false, true}) {
            AttributeOptions options = mikktspace();
            options.normals = makes_normals;
            const MeshAttributes out = compute({s}, options).front();
            ASSERT_EQ(out.tangents.size(), out.normals.size());
            for (const vec4 t : out.tangents) {
                EXPECT_NEAR(length(cast<double>(t.xyz())), 1, 1e-5);
                EXPECT_EQ(std::fabs(t.w), 1.0f);
            }
        }
    }
}

TEST(Mikktspace, TinyAndHugeMeshesHaveTheTangentsOfPlainOnes) {
    const Vectors reference = read_vectors("sphere");
    const MeshAttributes plain = compute({reference.shape}, mikktspace()).front();
    for (const float size : {1e-20f, 1e15f}) {
        Shape s = reference.shape;
        for (vec3& p : s.positions) p = p * size;
        const MeshAttributes out = compute({s}, mikktspace()).front();
        for (std::size_t v = 0; v < s.positions.size(); ++v) {
            EXPECT_LT(length(out.tangents[v].xyz() - plain.tangents[v].xyz()), 1e-4f) << size;
            EXPECT_EQ(out.tangents[v].w, plain.tangents[v].w) << size;
        }
    }
}

TEST(Mikktspace, ManyFacesOfOwnGroupsAtOneVertexAreSplitInOrderlyTime) {
    // 20,000 triangles that share one vertex and nothing else: each is a group of its own.
    Shape s;
    s.positions.push_back({0, 0, 0});
    s.texcoords.push_back({0, 0});
    s.normals.push_back({0, 0, 1});
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-1, 1);
    for (std::uint32_t t = 0; t < 20000; ++t) {
        s.indices.push_back(0);
        for (int k = 0; k < 2; ++k) {
            s.indices.push_back(std::uint32_t(s.positions.size()));
            s.positions.push_back({value(random), value(random), value(random)});
            s.texcoords.push_back({value(random), value(random)});
            s.normals.push_back({0, 0, 1});
        }
    }
    const MeshAttributes out = compute({s}, mikktspace()).front();
    EXPECT_GT(out.source_vertex.size(), 19000u);
    EXPECT_EQ(out.tangents.size(), out.normals.size());
}

TEST(Mikktspace, BitsDoNotDependOnThreadsAndTheTwoStepsEqualTheOne) {
    std::vector<Shape> parts = cut_at_random(make_sphere(24, 12), 5, 3);
    AttributeOptions options;
    options.tangent_mode = TangentMode::mikktspace;
    const auto one = compute(parts, options, 1);
    for (const int threads : {2, 4}) {
        Context context({.threads = threads});
        const auto meshes = views(parts);
        const auto many = accumulate(group(meshes, options, context), meshes, context);
        for (std::size_t m = 0; m < parts.size(); ++m) {
            EXPECT_EQ(one[m].tangents, many[m].tangents);
            EXPECT_EQ(one[m].indices, many[m].indices);
        }
    }
}

}  // namespace
}  // namespace rakelight::test
