// SPDX-License-Identifier: Apache-2.0
// Tangents of coordinates behind a texture's transform are those of coordinates into which it was baked.
#include "prepare/normals/tangent_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/prepare/prepared.h"

namespace rakelight {
namespace {

using namespace test;

const TextureTransform transforms[] = {{},
                                       {.scale = {-1, 1}},
                                       {.scale = {1, -1}},
                                       {.rotation_rad = float(pi / 2)},
                                       {.offset = {7, -3}, .scale = {2, 0.25f}, .rotation_rad = 1.2f},
                                       {.scale = {-3, -0.5f}, .rotation_rad = -0.4f}};

/// A ball with coordinates around and along.
Scene textured_ball(TextureUse Material::*role, std::uint32_t set) {
    Mesh mesh = ball_mesh(12, 8);
    std::vector<vec2> uv;
    for (const vec3 p : mesh.positions) uv.push_back({0.3f * p.x + 0.9f * p.z, 0.8f * p.y - 0.2f * p.x});
    for (std::uint32_t s = 0; s <= set; ++s) mesh.texcoords.emplace_back(std::vector<vec2>(uv.size(), {0.5f, 0.5f}));
    mesh.texcoords[set] = std::move(uv);
    Scene scene = scene_of({mesh});
    give_texture(scene, role, set);
    return scene;
}

/// By the extension's own formula, in double.
void bake(Scene& scene, TextureUse Material::*role, const TextureTransform& t) {
    const std::uint32_t set = (scene.materials[0].*role).texcoord_set;
    std::vector<vec2> uv;
    const double c = std::cos(double(t.rotation_rad)), s = std::sin(double(t.rotation_rad));
    for (const vec2 q : scene.meshes[0].texcoords[set]) {
        const double x = double(t.scale.x) * double(q.x), y = double(t.scale.y) * double(q.y);
        uv.push_back({float(c * x + s * y), float(-s * x + c * y)});
    }
    scene.meshes[0].texcoords[set] = std::move(uv);
}

TEST(TangentCoordinates, TransformedIsAsBaked) {
    for (TextureUse Material::*role : {&Material::normal_texture, &Material::height_texture})
        for (const std::uint32_t set : {0u, 1u})
            for (const TextureTransform& t : transforms)
                for (const TangentMode mode :
                     {TangentMode::averaged, TangentMode::mikktspace, TangentMode::published}) {
                    Scene extension = textured_ball(role, set), baked = extension;
                    (extension.materials[0].*role).transform = t;
                    bake(baked, role, t);
                    PrepareOptions options = by(NormalSource::model);
                    options.tangents = mode;
                    const Mesh a = prepared(extension, options).meshes[0], b = prepared(baked, options).meshes[0];
                    ASSERT_EQ(a.tangents.size(), b.tangents.size());
                    for (std::size_t v = 0; v < a.tangents.size(); ++v) {
                        EXPECT_LE(length(a.tangents[v].xyz() - b.tangents[v].xyz()), 2e-5f);
                        EXPECT_EQ(a.tangents[v].w, b.tangents[v].w);
                    }
                }
}

TEST(TangentCoordinates, WithoutATransformTheyAreTheMeshsOwn) {
    const Scene scene = textured_ball(&Material::normal_texture, 1);
    const TangentCoordinates c = tangent_coordinates(scene, scene.meshes[0], TangentNeed::where_needed);
    EXPECT_EQ(c.set, 1u);
    EXPECT_TRUE(tangent_texcoords(scene.meshes[0], c) == scene.meshes[0].texcoords[1]);
}

TEST(TangentCoordinates, TheNormalMapComesBeforeTheHeightMap) {
    Scene scene = textured_ball(&Material::normal_texture, 0);
    scene.materials[0].height_texture = scene.materials[0].normal_texture;
    scene.materials[0].height_texture.transform.scale = {5, 5};
    scene.materials[0].normal_texture.transform.scale = {1, -1};
    const UvMatrix flipped{1, 0, 0, -1};
    EXPECT_EQ(tangent_coordinates(scene, scene.meshes[0], TangentNeed::where_needed).matrix, flipped);
    scene.materials[0].normal_texture = {};
    const UvMatrix scaled{5, 0, 0, 5};
    EXPECT_EQ(tangent_coordinates(scene, scene.meshes[0], TangentNeed::where_needed).matrix, scaled);
}

/// What has no inverse has no direction: a fixed one, never a number that is none.
TEST(TangentCoordinates, ZeroScalesGiveAFixedDirection) {
    for (const vec2 scale : {vec2{0, 0}, vec2{0, 1}, vec2{2, 0}}) {
        Scene scene = textured_ball(&Material::normal_texture, 0);
        scene.materials[0].normal_texture.transform.scale = scale;
        Context context;
        const Mesh mesh = prepare_scene(scene, by(NormalSource::model), context).meshes[0];
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        for (const vec4 t : mesh.tangents) {
            EXPECT_NEAR(length(t.xyz()), 1, 1e-5);
            EXPECT_EQ(std::fabs(t.w), 1);
        }
        EXPECT_EQ(remarks(context, Remark::warning, "tangents have no direction"), 1u);
    }
}

TEST(TangentCoordinates, TheFilesTangentsAreTheAuthors) {
    Scene scene = textured_ball(&Material::normal_texture, 0);
    scene.materials[0].normal_texture.transform.scale = {-1, 1};
    Mesh& mesh = scene.meshes[0];
    std::vector<vec3> normals;
    std::vector<vec4> tangents;
    for (const vec3 p : mesh.positions) {
        normals.push_back(p);
        const dvec3 t = normalize_or(cross(dvec3{0.3, 0.2, 1}, cast<double>(p)), dvec3{1, 0, 0});
        tangents.push_back({float(t.x), float(t.y), float(t.z), 1});
    }
    mesh.normals = std::move(normals), mesh.tangents = std::move(tangents);
    Context context;
    EXPECT_TRUE(prepare_scene(scene, {}, context).meshes[0].tangents == mesh.tangents);
}

}  // namespace
}  // namespace rakelight
