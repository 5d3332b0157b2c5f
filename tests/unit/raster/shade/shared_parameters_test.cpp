// SPDX-License-Identifier: Apache-2.0
// Equal parameters mean the same reflectance under every lighting model: each parameter that models share is set alone
// and with others, the lobe's peak is divided out of the light that comes back, and what is left is held to the
// formulas of KHR_materials_ior, KHR_materials_specular and docs/lighting-models.md in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engines/raster/inspect/inspection.h"
#include "math/color.h"
#include "scene/materials/material_conversion.h"
#include "unit/raster/facing_square.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr Lighting all_models[] = {Lighting::lambert,    Lighting::phong,           Lighting::blinn_phong,
                                   Lighting::oren_nayar, Lighting::oren_nayar_full, Lighting::ward,
                                   Lighting::pbr};

bool has_highlight(Lighting model) {
    return model != Lighting::lambert && model != Lighting::oren_nayar && model != Lighting::oren_nayar_full;
}
bool is_power(Lighting model) { return model == Lighting::phong || model == Lighting::blinn_phong; }

struct Case {
    std::string name;
    std::function<void(Scene&, Material&)> set;
    bool is_uniform = true;  ///< no textures: flat, Gouraud and the conversions know all of it
};

/// A texture of one color, codes 0..255.
TextureUse even(Scene& scene, int r, int g, int b, int a = 255) {
    Pixels p;
    p.width = p.height = 4;
    p.channels = 4;
    for (int i = 0; i < 16; ++i)
        for (const int c : {r, g, b, a}) p.bytes.push_back(std::byte(c));
    return add_texture(scene, picture(p));
}

/// What an even texture multiplies by, linear: its texel's color where it is one, data else. White where there is none.
dvec4 texel_of(const Scene& scene, const TextureUse& use, bool is_color) {
    if (!use) return {1, 1, 1, 1};
    Context context;
    const EncodedImage& image = *scene.textures[use.texture].image;
    const Pixels p = image.decode(image, context);
    const auto part = [&](std::size_t c) {
        return is_color && c < 3 ? double(linear_from_srgb8(std::uint8_t(p.bytes[c]))) : double(p.bytes[c]) / 255;
    };
    return {part(0), part(1), part(2), part(3)};
}

dvec3 times(dvec3 a, dvec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
dvec3 at_most_1(dvec3 v) { return {std::min(v.x, 1.0), std::min(v.y, 1.0), std::min(v.z, 1.0)}; }
double greatest(dvec3 v) { return std::max({v.x, v.y, v.z}); }

/// What a surface reflects by its parameters.
struct Meaning {
    dvec3 ambient, diffuse, specular, emission;
    double dielectric_f0 = 0;  ///< what pbr takes from the diffuse term where light and viewer face the surface
    double exponent = 1, alpha = 1;
};

Meaning meaning_of_metallic_roughness(const Scene& scene, const Material& m, dvec3 base) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    const dvec4 map = texel_of(scene, p.texture, false);
    const double metallic = double(p.metallic) * map.z, roughness = double(p.roughness) * map.y;
    const double strength = double(p.specular) * texel_of(scene, p.specular_texture, false).w;
    const double ior = double(p.ior), from_ior = std::pow((ior - 1) / (ior + 1), 2);
    const dvec3 color = times(cast<double>(p.specular_color), texel_of(scene, p.specular_color_texture, true).xyz());
    const dvec3 f0 = at_most_1(color * from_ior) * strength;
    Meaning out;
    out.ambient = base;
    out.diffuse = base * (1 - metallic);
    out.specular = f0 * (1 - metallic) + base * metallic;
    out.dielectric_f0 = greatest(f0);
    out.alpha = roughness * roughness;
    out.exponent = std::clamp(2 / (out.alpha * out.alpha) - 2, 1.0, 10000.0);
    return out;
}

Meaning meaning_of_classical(const Scene& scene, const Material& m, dvec3 base, dvec3 paint, Lighting model) {
    Meaning out;
    out.ambient = times(cast<double>(m.classical.ambient), paint);
    out.diffuse = base;
    out.specular = times(cast<double>(m.classical.specular), texel_of(scene, m.classical.specular_texture, true).xyz());
    out.exponent = double(m.classical.shininess);
    out.alpha = std::sqrt(2 / (out.exponent + 2));
    if (is_power(model)) return out;
    const bool is_textbook = m.specular_form != SpecularForm::normalized;
    out.specular = at_most_1(out.specular * (is_textbook ? std::min(1.0, 4 * out.alpha * out.alpha) : 1.0));
    out.dielectric_f0 = greatest(out.specular);
    return out;
}

Meaning meaning_of(const Scene& scene, Lighting model) {
    const Material& m = scene.materials[0];
    const vec4 vertex = scene.meshes[0].colors.empty() ? vec4{1, 1, 1, 1} : scene.meshes[0].colors[0];
    const dvec3 paint = times(texel_of(scene, m.base_color_texture, true).xyz(), cast<double>(vertex.xyz()));
    const dvec3 base = times(cast<double>(m.base_color.xyz()), paint);
    Meaning out = m.model == MaterialModel::classical ? meaning_of_classical(scene, m, base, paint, model)
                                                      : meaning_of_metallic_roughness(scene, m, base);
    if (!has_highlight(model) && m.model == MaterialModel::metallic_roughness) out.diffuse = base;
    const double occluded = 1 - texel_of(scene, m.occlusion_texture, false).x;
    out.ambient = out.ambient * (1 - double(m.occlusion_strength) * occluded);
    out.emission = times(cast<double>(m.emission), texel_of(scene, m.emission_texture, true).xyz());
    return out;
}

/// The lobe where light and viewer face the surface, times pi for a BRDF [1/sr].
double peak(const Material& m, const Meaning& by, Lighting model) {
    const double n = by.exponent;
    const bool is_normalized =
        m.model == MaterialModel::metallic_roughness || m.specular_form == SpecularForm::normalized;
    if (!is_power(model)) return 1 / (4 * by.alpha * by.alpha);
    if (!is_normalized) return 1;
    return model == Lighting::phong ? (n + 2) / 2 : (n + 2) * (n + 4) / (8 * (std::pow(2, -n / 2) + n));
}

void expect_near(vec3 seen, dvec3 expected, const std::string& what) {
    for (std::size_t c = 0; c < 3; ++c)  // n.h is 1 to 3e-7, and the exponent's power of that
        EXPECT_NEAR(double(seen[c]), expected[c], 1e-5 + 5e-4 * expected[c]) << what << ", channel " << c;
}

struct Seen {
    vec3 ambient, diffuse, specular, emission, normal;
};

Seen look(const Scene& scene, Lighting model, Shading shading = Shading::phong) {
    RenderSettings s{.width = 32, .height = 32, .shading = shading, .lighting = model};
    s.channels = channels_lighting | channel_normal;
    const Frame f = draw(scene, flat_camera(), s);
    constexpr std::size_t i = 16 * 32 + 16;
    return {f.ambient[i], f.diffuse[i], f.specular[i], f.emission[i], f.normal[i]};
}

void expect_meaning(const Scene& scene, Lighting model, Shading shading, const std::string& what) {
    const Material& m = scene.materials[0];
    const Meaning by = meaning_of(scene, model);
    const Seen seen = look(scene, model, shading);
    const double kept = model == Lighting::pbr ? 1 - by.dielectric_f0 : 1;
    expect_near(seen.diffuse, by.diffuse * kept, what + ": diffuse");
    expect_near(seen.specular, has_highlight(model) ? by.specular * peak(m, by, model) : dvec3{0, 0, 0},
                what + ": specular");
    expect_near(seen.emission, by.emission, what + ": emission");
    if (model != Lighting::pbr) expect_near(seen.ambient, by.ambient, what + ": ambient");  // pbr: of tables
}

Scene scene_of(const Case& c, Material m) {
    m.sigma_rad = 0.0f;  // Oren-Nayar is Lambert then
    Scene scene = facing_square({}, {1, 1, 1});
    c.set(scene, m);
    scene.materials = {m};
    return scene;
}

void expect_meaning_everywhere(const std::vector<Case>& cases, const Material& from) {
    for (const Case& c : cases) {
        const Scene scene = scene_of(c, from);
        for (const Lighting model : all_models) {
            const std::string what = c.name + ", model " + std::to_string(int(model));
            expect_meaning(scene, model, Shading::phong, what);
            if (!c.is_uniform) continue;
            expect_meaning(scene, model, Shading::gouraud, what + ", Gouraud");
            expect_meaning(scene, model, Shading::flat, what + ", flat");
        }
    }
}

using P = MetallicRoughnessParameters;

Case of(const char* name, void (*set)(P&)) {
    return {name, [set](Scene&, Material& m) { set(m.metallic_roughness); }};
}

void set_vertex_colors(Scene& scene) { scene.meshes[0].colors = std::vector<vec4>(4, vec4{0.5f, 0.75f, 0.25f, 1}); }

/// Parameters of every kind of material.
std::vector<Case> common_cases() {
    return {
        {"nothing", [](Scene&, Material&) {}},
        {"color",
         [](Scene&, Material& m) {
             m.base_color = {0.9f, 0.1f, 0.4f, 1};
         }},
        {"emission",
         [](Scene&, Material& m) {
             m.emission = {0.25f, 3, 0.5f};
         }},
        {"vertex colors", [](Scene& s, Material&) { set_vertex_colors(s); }},
        {"color texture", [](Scene& s, Material& m) { m.base_color_texture = even(s, 188, 60, 240); }, false},
        {"vertex colors and texture",
         [](Scene& s, Material& m) { set_vertex_colors(s), m.base_color_texture = even(s, 188, 60, 240); }, false},
        {"occlusion",
         [](Scene& s, Material& m) { m.occlusion_texture = even(s, 64, 0, 0), m.occlusion_strength = 0.5f; }, false},
        {"emission texture",
         [](Scene& s, Material& m) {
             m.emission = {1, 2, 3}, m.emission_texture = even(s, 188, 60, 240);
         },
         false},
    };
}

std::vector<Case> metallic_roughness_cases() {
    std::vector<Case> cases = common_cases();
    for (const Case& c : {
             of("metallic 0.3", [](P& p) { p.metallic = 0.3f; }),
             of("metallic 1", [](P& p) { p.metallic = 1; }),
             of("roughness 0.3", [](P& p) { p.roughness = 0.3f; }),
             of("roughness 0.9", [](P& p) { p.roughness = 0.9f; }),
             of("ior 0", [](P& p) { p.ior = 0; }),
             of("ior 1", [](P& p) { p.ior = 1; }),
             of("ior 2.4", [](P& p) { p.ior = 2.4f; }),
             of("specular_factor 0", [](P& p) { p.specular = 0; }),
             of("specular_factor 0.5", [](P& p) { p.specular = 0.5f; }),
             of("specular_color",
                [](P& p) {
                    p.specular_color = {1, 0.5f, 0.25f};
                }),
             of("specular_color beyond all light",
                [](P& p) {
                    p.specular_color = {30, 20, 1};
                }),
             of("half of that",
                [](P& p) {
                    p.specular = 0.5f, p.specular_color = {30, 30, 1};
                }),
             of("a quarter, of a half metal of index 2",
                [](P& p) {
                    p.specular = 0.25f, p.specular_color = {30, 7, 1}, p.ior = 2, p.metallic = 0.5f;
                }),
         })
        cases.push_back(c);
    const auto textured = [&](const char* name, void (*set)(Scene&, P&)) {
        cases.push_back({name, [set](Scene& s, Material& m) { set(s, m.metallic_roughness); }, false});
    };
    textured("metallic-roughness texture",
             [](Scene& s, P& p) { p.metallic = 0.8f, p.roughness = 1, p.texture = even(s, 0, 153, 102); });
    textured("specular texture", [](Scene& s, P& p) {
        p.specular_texture = even(s, 255, 255, 255, 102), p.specular_color = {30, 2, 1};
    });
    textured("specular color texture", [](Scene& s, P& p) {
        p.specular_color_texture = even(s, 188, 60, 240), p.specular_color = {60, 60, 1}, p.specular = 0.5f;
    });
    return cases;
}

Material classical_material() {
    Material m = matte({0.5f, 0.25f, 1});
    m.classical.ambient = {0.2f, 0.4f, 0.6f};
    m.classical.specular = {0.4f, 0.2f, 0.1f};
    m.classical.shininess = 20;
    return m;
}

std::vector<Case> classical_cases() {
    std::vector<Case> cases = common_cases();
    using K = ClassicalParameters;
    const auto of_classical = [&](const char* name, void (*set)(K&)) {
        cases.push_back({name, [set](Scene&, Material& m) { set(m.classical); }});
    };
    of_classical("ambient", [](K& k) { k.ambient = {0.9f, 0, 0.3f}; });
    of_classical("specular", [](K& k) { k.specular = {1, 0, 0.7f}; });
    of_classical("no specular", [](K& k) { k.specular = {0, 0, 0}; });
    of_classical("specular beyond all light", [](K& k) { k.specular = {3, 1, 1.5f}; });
    of_classical("shininess 1", [](K& k) { k.shininess = 1; });
    of_classical("shininess 8", [](K& k) { k.shininess = 8; });
    of_classical("shininess 150.5", [](K& k) { k.shininess = 150.5f; });
    cases.push_back({"specular texture",
                     [](Scene& s, Material& m) { m.classical.specular_texture = even(s, 188, 60, 240); }, false});
    return cases;
}

TEST(SharedParameters, OfMetallicRoughnessMaterialsMeanTheSameUnderEveryModel) {
    expect_meaning_everywhere(metallic_roughness_cases(), metallic(0, 0.5f));
}

TEST(SharedParameters, OfClassicalMaterialsMeanTheSameUnderEveryModel) {
    expect_meaning_everywhere(classical_cases(), classical_material());
}

TEST(SharedParameters, OfNormalizedClassicalMaterialsMeanTheSameUnderEveryModel) {
    Material m = classical_material();
    m.specular_form = SpecularForm::normalized;
    expect_meaning_everywhere(classical_cases(), m);
}

TEST(SharedParameters, TheScaleOfANormalMapTiltsAllModelsAlike) {
    for (const float scale : {0.0f, 0.5f, -1.0f, 2.0f})
        for (const Material& from : {metallic(0, 0.5f), classical_material()}) {
            const Case tilted = {"tilted", [scale](Scene& s, Material& m) {
                                     m.normal_texture = even(s, 191, 96, 231);
                                     m.normal_scale = scale;
                                 }};
            const Scene scene = scene_of(tilted, from);
            const dvec3 texel = {2 * 191 / 255.0 - 1, 2 * 96 / 255.0 - 1, 2 * 231 / 255.0 - 1};
            const dvec3 n = normalize_or(dvec3{texel.x * double(scale), texel.y * double(scale), texel.z}, dvec3{});
            for (const Lighting model : all_models)
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(double(look(scene, model).normal[c]), n[c], 1e-5) << int(model) << ", scale " << scale;
        }
}

TEST(SharedParameters, OpacityIsAlphaUnderEveryModel) {
    for (const Material& from : {metallic(0.5f, 0.5f), classical_material()}) {
        Material m = from;
        m.base_color.w = 0.5f;
        m.alpha_mode = AlphaMode::blend;
        for (const Lighting model : all_models) {
            Scene scene = facing_square(m);
            scene.materials[0].opacity_texture = even(scene, 128, 0, 0);
            RenderSettings s{.width = 32, .height = 32, .lighting = model};
            s.background = {0, 0, 0, 0};
            EXPECT_NEAR(pixel(draw(scene, flat_camera(), s), 16, 16).w, 0.5f * 128 / 255, 1e-5) << int(model);
        }
    }
}

TEST(SharedParameters, AreExplainedAsTheyAreDrawn) {
    for (const Case& c : metallic_roughness_cases())
        for (const Lighting model : all_models) {
            const Scene scene = scene_of(c, metallic(0, 0.5f));
            Context context({.threads = 1});
            const raster::Inspection inspection(scene, flat_camera(), {.width = 32, .height = 32, .lighting = model},
                                                context);
            const raster::PixelTrace trace = inspection.explain(16, 16, context).layers.at(0).trace;
            const std::string what = c.name + ", model " + std::to_string(int(model));
            const MetallicRoughnessParameters& p = scene.materials[0].metallic_roughness;
            const auto is_read = [&](int map) { return trace.map[map].is_used != 0; };
            EXPECT_EQ(is_read(role_specular_strength), has_highlight(model) && bool(p.specular_texture)) << what;
            EXPECT_EQ(is_read(role_specular_color), has_highlight(model) && bool(p.specular_color_texture)) << what;
            if (!has_highlight(model)) continue;
            const vec3 k_s = {trace.k_specular[0], trace.k_specular[1], trace.k_specular[2]};
            expect_near(k_s, meaning_of(scene, model).specular, what + ": explained");
        }
}

/// What is drawn of the one kind is what is drawn of the other that it is converted to.
TEST(SharedParameters, MeanTheSameOnceTheyAreConverted) {
    for (const Case& c : metallic_roughness_cases()) {
        if (!c.is_uniform) continue;
        const Scene scene = scene_of(c, metallic(0, 0.5f));
        Scene classical = scene;
        classical.materials[0] = classical_from_metallic_roughness(scene.materials[0]);
        for (const Lighting model : {Lighting::phong, Lighting::blinn_phong}) {
            const Seen a = look(scene, model), b = look(classical, model);
            const std::string what = c.name + ", model " + std::to_string(int(model)) + ", converted";
            expect_near(b.ambient, cast<double>(a.ambient), what + ": ambient");
            expect_near(b.diffuse, cast<double>(a.diffuse), what + ": diffuse");
            expect_near(b.specular, cast<double>(a.specular), what + ": specular");
        }
    }
    for (const SpecularForm form : {SpecularForm::automatic, SpecularForm::normalized})
        for (const Case& c : classical_cases()) {
            Material m = classical_material();
            m.specular_form = form;
            const Scene scene = scene_of(c, m);
            Scene converted = scene;
            converted.materials[0] = metallic_roughness_from_classical(scene.materials[0]);
            for (const Lighting model : {Lighting::ward, Lighting::pbr}) {
                const Seen a = look(scene, model), b = look(converted, model);
                const std::string what = c.name + ", model " + std::to_string(int(model)) + ", converted to pbr";
                expect_near(b.diffuse, cast<double>(a.diffuse), what + ": diffuse");
                expect_near(b.specular, cast<double>(a.specular), what + ": specular");
            }
        }
}

}  // namespace
