// SPDX-License-Identifier: Apache-2.0
// One pixel explained: the numbers are those of the picture, and what lies behind is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "engines/raster/inspect/inspection.h"
#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;
using raster::Fate;

namespace {

constexpr int width = 96, height = 64;

RenderSettings settings() { return {.width = width, .height = height, .background = {0.1f, 0.2f, 0.3f, 0.5f}}; }

bool same_bits(vec4 a, vec4 b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Every `step`th pixel of the picture is explained to the bit.
void expect_all_explained(const Scene& scene, const RenderSettings& s, const Camera& camera, int step = 3) {
    const Frame frame = draw(scene, camera, s);
    Context context({.threads = 1});
    const raster::Inspection inspection(scene, camera, s, context);
    int layers = 0;
    for (int y = 0; y < height; y += step)
        for (int x = 0; x < width; x += step) {
            const raster::PixelExplanation e = inspection.explain(x, y, context);
            const vec4 drawn = frame.color[std::size_t(y * width + x)];
            ASSERT_TRUE(same_bits(e.sum, drawn)) << x << "," << y << ": " << e.sum.x << " is not " << drawn.x;
            ASSERT_TRUE(same_bits(e.color, drawn)) << x << "," << y;
            layers += int(e.layers.size());
        }
    EXPECT_GT(layers, 100);
}

/// The soft engine with another instruction set for this scope.
class UseIsa {
public:
    explicit UseIsa(const char* name) { setenv("RAKELIGHT_ISA", name, 1); }
    ~UseIsa() { unsetenv("RAKELIGHT_ISA"); }
};

}  // namespace

TEST(ExplainPixel, SumsAreThePicturesBitsInEveryInstructionSet) {
    const Scene scene = busy_scene();
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const UseIsa use(name(isa));
        SCOPED_TRACE(name(isa));
        expect_all_explained(scene, settings(), busy_view());
    }
}

TEST(ExplainPixel, SumsAreThePicturesBitsUnderEverySetting) {
    const Scene scene = busy_scene();
    for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong})
        for (const SpecularForm form : {SpecularForm::textbook, SpecularForm::normalized}) {
            RenderSettings s = settings();
            s.lighting = lighting;
            s.specular_form = form;
            s.specular_horizon = form == SpecularForm::normalized;
            s.orthogonalize = lighting != Lighting::phong;
            s.cull = lighting == Lighting::phong     ? Cull::back
                     : lighting == Lighting::lambert ? Cull::front
                                                     : Cull::automatic;
            expect_all_explained(scene, s, busy_view(), 5);
        }
    RenderSettings s = settings();
    s.shading = Shading::unlit;
    expect_all_explained(scene, s, busy_view(), 5);
    s = settings();
    s.bump = Bump::none;
    expect_all_explained(scene, s, flat_camera(), 5);
}

TEST(ExplainPixel, SumsAreThePicturesBitsWithSeveralSamplesAPixelAndAnisotropicFilters) {
    const Scene scene = busy_scene();
    for (const int samples : {1, 4, 8})
        for (const int anisotropy : {1, 8}) {
            RenderSettings s = settings();
            s.samples = samples;
            s.anisotropy = anisotropy;
            SCOPED_TRACE(std::to_string(samples) + " samples, anisotropy " + std::to_string(anisotropy));
            expect_all_explained(scene, s, busy_view(), 5);
            s.shading = Shading::gouraud;
            expect_all_explained(scene, s, flat_camera(), 9);
        }
}

TEST(ExplainPixel, SumsAreThePicturesBitsUnderAllThatTheFullKernelHas) {
    const Scene scene = rich_scene();
    for (const Lighting lighting : {Lighting::automatic, Lighting::blinn_phong, Lighting::oren_nayar,
                                    Lighting::oren_nayar_full, Lighting::ward, Lighting::pbr})
        for (const Bump bump : {Bump::normal, Bump::height, Bump::occlusion}) {
            RenderSettings s = settings();
            s.lighting = lighting;
            s.bump = bump;
            s.shadows = bump != Bump::height;
            s.shadow_size = 64;
            s.multiple_scattering = lighting == Lighting::pbr;
            s.relief.self_shadow = true;
            s.bump_terms = bump == Bump::height ? BumpTerms::diffuse : BumpTerms::both;
            s.viewer_at_infinity = lighting == Lighting::ward;
            SCOPED_TRACE(std::to_string(int(lighting)) + ", bump " + std::to_string(int(bump)));
            expect_all_explained(scene, s, busy_view(), 7);
            if (bump != Bump::height) continue;
            s.shading = Shading::gouraud;
            expect_all_explained(scene, s, busy_view(), 9);
        }
}

TEST(ExplainPixel, TransformedTexturesOfEveryRoleAreReadWhereThePictureReadsThem) {
    Scene scene = rich_scene();
    const TextureTransform turned{.offset = {0.3f, -0.2f}, .scale = {3, 0.5f}, .rotation_rad = 0.7f};
    for (Material& m : scene.materials)
        for (TextureUse* use : {&m.base_color_texture,
                                &m.normal_texture,
                                &m.emission_texture,
                                &m.occlusion_texture,
                                &m.opacity_texture,
                                &m.classical.specular_texture,
                                &m.metallic_roughness.texture,
                                &m.height_texture,
                                &m.metallic_roughness.specular_texture,
                                &m.metallic_roughness.specular_color_texture,
                                &m.metallic_roughness.anisotropy_texture,
                                &m.metallic_roughness.clearcoat_texture,
                                &m.metallic_roughness.clearcoat_roughness_texture,
                                &m.metallic_roughness.clearcoat_normal_texture,
                                &m.metallic_roughness.sheen_color_texture,
                                &m.metallic_roughness.sheen_roughness_texture,
                                &m.metallic_roughness.transmission_texture,
                                &m.metallic_roughness.thickness_texture,
                                &m.metallic_roughness.iridescence_texture,
                                &m.metallic_roughness.iridescence_thickness_texture})
            use->transform = turned;
    for (const int anisotropy : {1, 8}) {
        RenderSettings s = settings();
        s.bump = Bump::height;  // the normal map is followed beside it
        s.anisotropy = anisotropy;
        expect_all_explained(scene, s, busy_view(), 5);
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, busy_view(), s, context);
        int used[texture_role_count] = {};
        for (int pixel = 0; pixel < width * height; pixel += 7)
            for (const raster::ShadedLayer& layer : inspection.explain(pixel % width, pixel / width, context).layers)
                for (int i = 0; i < texture_role_count; ++i) {
                    const raster::TracedTexture& map = layer.trace.map[i];
                    if (!map.is_used) continue;
                    ++used[i];
                    const float u = 3 * layer.trace.texcoord[0][0], v = 0.5f * layer.trace.texcoord[0][1];
                    const float c = std::cos(0.7f), sine = std::sin(0.7f);  // KHR_texture_transform: T R S
                    EXPECT_NEAR(map.u, 0.3f + c * u + sine * v, 1e-4f * (1 + std::fabs(map.u)));
                    EXPECT_NEAR(map.v, -0.2f - sine * u + c * v, 1e-4f * (1 + std::fabs(map.v)));
                }
        for (int i = 0; i < texture_role_count; ++i) EXPECT_GT(used[i], 0) << i;
    }
}

TEST(ExplainPixel, SamplesShowTheNearestTriangleAndLayersAreLaidOverThoseThatTheyAreBefore) {
    Scene scene;
    Material solid, glass;
    solid.model = glass.model = MaterialModel::unlit;
    glass.base_color = {0, 0, 1, 0.25f};
    glass.alpha_mode = AlphaMode::blend;
    scene.materials = {solid, glass};
    add_object(scene, square_mesh(0, 0.5f));                                // pixels 16 to 48 of 64
    add_object(scene, square_mesh(1), translation(dvec3{1.0 / 64, 0, 1}));  // glass from the middle of column 0 on
    RenderSettings s = settings();
    s.width = s.height = 64;
    s.samples = 4;
    s.background = {0, 0, 0, 1};
    Context context({.threads = 1});
    const raster::Inspection inspection(scene, flat_camera(), s, context);
    const raster::PixelExplanation edge = inspection.explain(0, 20, context);
    ASSERT_EQ(edge.layers.size(), 1u);
    ASSERT_EQ(edge.layers[0].samples.size(), 2u) << "half of them";
    EXPECT_EQ(edge.layers[0].place, (vec2{0.25f, 0.125f})) << "the middle of the two on the right";
    EXPECT_EQ(edge.sum, (vec4{0, 0, 0.125f, 1}));
    for (const raster::SeenSample& sample : edge.samples) {
        EXPECT_EQ(sample.triangle, SIZE_MAX) << "glass is laid over the background";
        EXPECT_EQ(sample.color.z, sample.at.x > 0 ? 0.25f : 0.0f);
    }
    const raster::PixelExplanation inside = inspection.explain(30, 20, context);
    ASSERT_EQ(inside.layers.size(), 2u);
    EXPECT_EQ(inside.layers[0].place, (vec2{0, 0}));
    for (const raster::ShadedLayer& layer : inside.layers) EXPECT_EQ(layer.samples.size(), 4u);
    for (const raster::CoveringTriangle& t : inside.triangles) {
        EXPECT_EQ(t.fate, t.draw == 0 ? Fate::visible : Fate::blended);
        EXPECT_EQ(t.samples.size(), 4u);
    }
}

TEST(ExplainPixel, LightOfTheCornersTimesWhatThePixelReflectsIsItsColor) {
    const Scene scene = busy_scene();
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
        RenderSettings s = settings();
        s.shading = shading;
        expect_all_explained(scene, s, busy_view(), 5);
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, busy_view(), s, context);
        int lit = 0;
        for (int x = 0; x < width; x += 3)
            for (const raster::ShadedLayer& layer : inspection.explain(x, height / 2, context).layers) {
                const raster::PixelTrace& t = layer.trace;
                EXPECT_TRUE(layer.lights.empty());
                EXPECT_EQ(t.is_lit_at_corners != 0, !layer.is_unlit);
                if (layer.is_unlit) continue;
                for (int c = 0; c < 3; ++c)
                    EXPECT_EQ(t.emission[c] + (t.k_ambient[c] * t.received[0][c] + t.k_diffuse[c] * t.received[1][c] +
                                               t.k_specular[c] * t.received[2][c]),
                              t.color[c]);
                ++lit;
            }
        EXPECT_GT(lit, 20);
    }
}

TEST(ExplainPixel, AFilteredValueIsItsTexelsTimesTheirWeights) {
    const Scene scene = busy_scene();
    for (const int anisotropy : {1, 8, 16}) {
        RenderSettings s = settings();
        s.anisotropy = anisotropy;
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, busy_view(), s, context);
        int used = 0, most = 0, most_probes = 0;
        for (int y = 0; y < height; y += 3)
            for (int x = 0; x < width; x += 3)
                for (const raster::ShadedLayer& layer : inspection.explain(x, y, context).layers)
                    for (std::size_t i = 0; i < texture_role_count; ++i) {
                        const raster::TracedTexture& map = layer.trace.map[i];
                        const raster::TracedTexels& texels = layer.texels[i];
                        if (map.is_used == 0) continue;
                        ++used;
                        most = std::max(most, texels.count);
                        most_probes = std::max(most_probes, map.probes);
                        std::vector<float> of_probe(std::size_t(map.probes), 0);
                        float weight = 0, sum[4] = {};
                        ASSERT_GT(texels.count, 0);
                        for (int k = 0; k < texels.count; ++k) {
                            const raster::TracedTexel& texel = texels.texel[k];
                            weight += texel.weight;
                            of_probe.at(std::size_t(texel.probe)) += texel.weight;
                            for (int c = 0; c < 4; ++c) sum[c] += texel.weight * texel.value[c];
                            EXPECT_GE(texel.level, int(map.level));
                            EXPECT_LE(texel.level, int(map.level) + 1);
                            EXPECT_TRUE(texel.x >= 0 && texel.x < 32 && texel.y >= 0 && texel.y < 64)
                                << texel.x << ", " << texel.y;
                        }
                        EXPECT_NEAR(weight, 1, 1e-5f) << x << ", " << y;
                        for (const float w : of_probe) EXPECT_NEAR(w, 1 / float(map.probes), 1e-6f);
                        EXPECT_EQ(map.probes > 1, map.axis_u != 0 || map.axis_v != 0);
                        for (int c = 0; c < 4; ++c)
                            EXPECT_NEAR(sum[c], map.value[c], 3e-4f) << x << ", " << y << ": fixed-point filters round";
                    }
        EXPECT_GT(used, 500);
        EXPECT_LE(most_probes, anisotropy);
        EXPECT_GE(most_probes, std::min(anisotropy, 5));
        if (anisotropy == 1) {
            EXPECT_EQ(most, 8) << "2 x 2 of two levels";
        } else {
            EXPECT_GT(most, 16);
        }
    }
}

TEST(ExplainPixel, CornersAreThoseThatTheEngineLitAndTheirTermsAddUpToTheirLight) {
    const Scene scene = busy_scene();
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
        RenderSettings s = settings();
        s.shading = shading;
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, busy_view(), s, context);
        int corners = 0;
        for (int y = 0; y < height; y += 4)
            for (int x = 0; x < width; x += 4)
                for (const raster::ShadedLayer& layer : inspection.explain(x, y, context).layers) {
                    const raster::PixelTrace& t = layer.trace;
                    ASSERT_EQ(layer.corners.size(), t.is_lit_at_corners == 0 ? 0u : shading == Shading::flat ? 1u : 3u);
                    float between[3][3] = {};
                    for (std::size_t k = 0; k < layer.corners.size(); ++k) {
                        const raster::TracedCorner& corner = layer.corners[k];
                        EXPECT_EQ(corner.corner.vertex == no_index, shading == Shading::flat);
                        const float(*const light[])[3] = {&corner.corner.light.ambient, &corner.corner.light.diffuse,
                                                          &corner.corner.light.specular};
                        for (int c = 0; c < 3; ++c) {
                            float sum[3] = {};
                            for (const raster::TracedLight& l : corner.lights) {
                                sum[0] += l.ambient[c];
                                sum[1] += l.diffuse[c];
                                sum[2] += l.specular[c];
                            }
                            for (int term = 0; term < 3; ++term) {
                                EXPECT_EQ(sum[term], (*light[term])[c]) << x << ", " << y << " corner " << k;
                                between[term][c] +=
                                    (layer.corners.size() == 1 ? 1 : t.barycentric[k]) * (*light[term])[c];
                            }
                        }
                        ++corners;
                    }
                    for (int term = 0; term < 3 && t.is_lit_at_corners; ++term)
                        for (int c = 0; c < 3; ++c)
                            EXPECT_NEAR(between[term][c], t.received[term][c], 1e-4f * (1 + t.received[term][c]))
                                << x << ", " << y;
                }
        EXPECT_GT(corners, 300);
    }
}

TEST(ExplainPixel, TermsOfALightAddUpFromTheEmissionOn) {
    const Scene scene = busy_scene();
    Context context({.threads = 1});
    RenderSettings by_blinn_phong = settings();
    by_blinn_phong.lighting = Lighting::blinn_phong;  // under pbr the diffuse term loses what the facets reflect
    const raster::Inspection inspection(scene, busy_view(), by_blinn_phong, context);
    int lit = 0;
    for (int x = 0; x < width; ++x)
        for (const raster::ShadedLayer& layer : inspection.explain(x, height / 2, context).layers) {
            if (layer.is_unlit) continue;
            for (int c = 0; c < 3; ++c) {
                float sum = layer.trace.emission[c];
                for (const raster::TracedLight& l : layer.lights) {
                    sum = sum + (l.ambient[c] + l.diffuse[c] + l.specular[c]);
                    EXPECT_EQ(sum, l.sum[c]);
                    EXPECT_FLOAT_EQ(l.diffuse[c], layer.trace.k_diffuse[c] * l.diffuse_color[c] *
                                                      std::max(0.0f, std::min(1.0f, l.n_dot_l)));
                }
                EXPECT_EQ(sum, layer.trace.color[c]);
            }
            ++lit;
        }
    EXPECT_GT(lit, 50);
}

TEST(ExplainPixel, NothingIsBackground) {
    Scene scene;
    add_object(scene, square_mesh());
    Camera camera = flat_camera();
    camera.half_height = 4;
    Context context({.threads = 1});
    const raster::PixelExplanation e =
        raster::Inspection(scene, camera, settings(), context).explain(0, height - 1, context);
    EXPECT_TRUE(e.triangles.empty());
    EXPECT_TRUE(e.layers.empty());
    EXPECT_TRUE(same_bits(e.color, settings().background));
    EXPECT_TRUE(same_bits(e.sum, settings().background));
}

TEST(ExplainPixel, WhatLiesBehindIsListedNearestFirstWithItsFate) {
    Scene scene;
    Material solid, glass, holes;
    glass.alpha_mode = AlphaMode::blend;
    glass.base_color.w = 0.25f;
    holes.alpha_mode = AlphaMode::mask;
    holes.base_color.w = 0.25f;
    scene.materials = {solid, glass, holes};
    const dmat4 turned = scaling(dvec3{-1, 1, -1});                           // half round the y axis
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, -2}));          // hidden
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, -1}));          // seen
    add_object(scene, square_mesh(1), translation(dvec3{0, 0, -3}));          // glass behind
    add_object(scene, square_mesh(1), translation(dvec3{0, 0, 0}));           // glass before
    add_object(scene, square_mesh(2), translation(dvec3{0, 0, 1}));           // alpha below the cutoff
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, 2}) * turned);  // from behind
    scene.lights = {directional({0, 0, -1})};
    Context context({.threads = 1});
    const raster::PixelExplanation e =
        raster::Inspection(scene, flat_camera(), settings(), context).explain(50, 20, context);
    const std::pair<std::uint32_t, Fate> expected[] = {{5, Fate::culled_back}, {4, Fate::masked_out},
                                                       {3, Fate::blended},     {1, Fate::visible},
                                                       {0, Fate::hidden},      {2, Fate::hidden}};
    ASSERT_EQ(e.triangles.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(e.triangles[i].draw, expected[i].first) << i;
        EXPECT_EQ(e.triangles[i].fate, expected[i].second) << i;
        EXPECT_NEAR(e.triangles[i].distance, 3.0 + double(i), 1e-4) << i;
    }
    ASSERT_EQ(e.layers.size(), 2u);
    EXPECT_EQ(e.layers[0].triangle, 3u);
    EXPECT_FALSE(e.layers[0].is_blended);
    EXPECT_EQ(e.layers[1].triangle, 2u);
    EXPECT_TRUE(e.layers[1].is_blended);
    EXPECT_EQ(e.triangles[2].alpha, 0.25f);
    EXPECT_TRUE(same_bits(e.sum, e.color));
}

TEST(ExplainPixel, APixelOutsideOfThePictureIsAUsageError) {
    Scene scene;
    add_object(scene, square_mesh());
    Context context({.threads = 1});
    const raster::Inspection inspection(scene, flat_camera(), settings(), context);
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {width, 0}, {0, height}}) {
        try {
            inspection.explain(x, y, context);
            FAIL() << x << "," << y;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
        }
    }
    EXPECT_NO_THROW(inspection.explain(width - 1, height - 1, context));
}

/// A plane that leans away to the right and upward, before an eye at the origin that looks along -Z: z = -(3 + 0.5 x + 0.25 y). Along
/// the ray through x = X z, y = Y z it is at the distance 3 / (1 - 0.5 X - 0.25 Y), so that near / distance is a plane over the screen.
TEST(ExplainPixel, DepthSlopesAreThoseOfThePlane) {
    Scene scene;
    scene.materials = {matte()};
    Mesh mesh = square_mesh(0, 20);
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    for (vec3& p : positions) p = {p.x * 0.05f, p.y * 0.05f, -(3 + 0.025f * p.x + 0.0125f * p.y)};
    mesh.positions = positions;
    mesh.normals = {}, mesh.tangents = {};
    add_object(scene, mesh);
    scene.lights = {directional({0, 0, -1})};
    Camera camera;
    camera.vertical_fov_rad = 0.5;
    camera.z_near = 0.25, camera.z_far = 50;
    Context context({.threads = 1});
    RenderSettings s = settings();
    const raster::Inspection inspection(scene, camera, s, context);
    const double per_pixel = 2 * std::tan(0.25) / height;
    int seen = 0;
    for (const auto& [x, y] : {std::pair{48, 32}, {40, 20}, {60, 44}}) {
        const raster::PixelExplanation e = inspection.explain(x, y, context);
        ASSERT_FALSE(e.triangles.empty());
        const raster::CoveringTriangle& t = e.triangles[0];
        const double right = (x + 0.5 - width / 2.0) * per_pixel, up = (height / 2.0 - y - 0.5) * per_pixel;
        const double key = 0.25 / 3 * (1 - 0.5 * right - 0.25 * up);
        EXPECT_NEAR(t.plane.slope_x, -0.25 / 3 * 0.5 * per_pixel, 2e-7 * per_pixel);
        EXPECT_NEAR(t.plane.slope_y, 0.25 / 3 * 0.25 * per_pixel, 2e-7 * per_pixel);
        EXPECT_NEAR(t.plane.exact, key, 2e-8);
        EXPECT_NEAR(t.depth_key, key, 3e-8);
        EXPECT_EQ(t.plane.by_steps, t.depth_key) << "within the corners' keys";
        const int down = y - t.plane.y, along = x - t.plane.x;
        EXPECT_NEAR(double(t.plane.key) + double(t.plane.slope_x) * along + double(t.plane.slope_y) * down, t.depth_key,
                    2e-8);
        seen += along + down > 0;
    }
    EXPECT_EQ(seen, 3) << "steps were taken";
}
