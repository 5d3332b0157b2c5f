// SPDX-License-Identifier: Apache-2.0
#include "render/remarks/too_dark_or_bright.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include "render/engines.h"
#include "render/remarks/why_black.h"
#include "unit/render/picture_fixture.h"

namespace rakelight {
namespace {

Light point(dvec3 position, float range = std::numeric_limits<float>::infinity()) {
    Light light;
    light.position = position;
    light.range = range;
    return light;
}

class TooDarkOrBright : public test::PictureFiles {
protected:
    /// The remark on a picture of the built-in sphere, of radius 1 about the origin.
    std::string said(std::vector<Light> lights, const std::function<void(PictureRequest&)>& change = {}) {
        PictureRequest request{.input = "builtin:sphere", .output = file("a.png")};
        request.settings.width = request.settings.height = 60;
        request.lights = std::move(lights);
        if (change) change(request);
        Context context({.threads = 2});
        Session session;
        result_ = test::draw_picture(request, session, context);
        std::string all;
        for (const ReportEntry& e : context.report().entries())
            if (e.remark == Remark::warning) all += e.message + "\n";
        return all;
    }
    PictureResult result_;
};

const std::string black = "all of the model is black: ";
const std::string highlights_alone =
    "its materials have only highlights, and its visible surfaces are not lit or reflect the lights elsewhere\n";

TEST_F(TooDarkOrBright, AModelThatNoLightReachesIsSaidToBeBlackWithTheReason) {
    EXPECT_EQ(said({point({0, 0, 9}, 7.5f)}), black + "it is outside the range of the light\n");
    EXPECT_EQ(said({point({0, 0, 9}, 8.5f)}), "");  // it is 8 m to the sphere
    EXPECT_EQ(said({point({0, 0, 9}, 2), point({0, 9, 0}, 3)}), black + "it is outside the range of all 2 lights\n");
    Light off = point({0, 0, 9});
    off.diffuse = off.specular = {0, 0, 0};
    EXPECT_EQ(said({off}), black + "no light is brighter than 0\n");
    Light faint = point({0, 0, 9});
    faint.units = LightUnits::photometric, faint.intensity = 0.01f;
    EXPECT_EQ(said({faint}), black +
                                 "too little of the light reaches it; see intensity and attenuation of lights, "
                                 "'light-intensity', 'exposure'\n");
    EXPECT_EQ(said({faint}, [](PictureRequest& r) { r.tone.exposure_ev = 12; }), "");
    EXPECT_EQ(said({point({0, 0, 0})}),
              black + "no light reaches its visible surfaces: they face away from the light\n");
    Light spot = point({0, 0, 9});
    spot.type = LightType::spot, spot.direction = {0, 0, 1}, spot.cutoff_rad = 0.5f;
    EXPECT_EQ(
        said({spot}, [](PictureRequest& r) { r.settings.shadows = true; }),
        black +
            "no light reaches its visible surfaces: they face away from the light, outside its cone or in shadow\n");
}

TEST_F(TooDarkOrBright, LightsThatTheCutoffEndedAreSaidToBeSo) {
    Light lamp = point({0, 0, 9});
    lamp.diffuse = lamp.specular = {0.5f, 0.5f, 0.5f}, lamp.constant = 0, lamp.quadratic = 1;  // 0.5 / d^2
    const auto cut_at = [](double cutoff) { return [=](PictureRequest& r) { r.light_cutoff = cutoff; }; };
    EXPECT_EQ(said({lamp}), "");
    EXPECT_EQ(said({lamp}, cut_at(0.5 / 100)), "") << "10 m; it is 8 m to the sphere";
    EXPECT_EQ(said({lamp}, cut_at(0.5 / 49)),
              black + "'light-cutoff' ends the light before it; a smaller value reaches farther\n")
        << "7 m";
    EXPECT_EQ(said({lamp, lamp}, cut_at(0.5 / 49)),
              black + "'light-cutoff' ends all 2 lights before it; a smaller value reaches farther\n");
    EXPECT_EQ(said({lamp, point({0, 9, 0}, 3)}, cut_at(0.5 / 49)),
              black +
                  "it is outside the range of all 2 lights; of 1 the range is set by 'light-cutoff': a smaller value "
                  "reaches farther\n");
    EXPECT_EQ(said({point({0, 9, 0}, 3)}, cut_at(0.5 / 49)), black + "it is outside the range of the light\n")
        << "its own";
    EXPECT_EQ(said({lamp}, cut_at(0.5 / 64.0001)),
              black +
                  "too little of the light reaches it; see intensity and attenuation of lights, 'light-intensity', "
                  "'light-cutoff', 'exposure'\n")
        << "8 m, where next to nothing is left of it";
}

TEST_F(TooDarkOrBright, ABlackMaterialIsTheReasonWhateverTheLight) {
    const auto none = [](const char* key) { return WorldValue{key, {"#000000"}, {0, 0, 0}, {}}; };
    const auto soot = [&](PictureRequest& r) {
        r.materials.values = {none("color"), none("specular"), none("ambient")};
    };
    EXPECT_EQ(said({point({0, 0, 9})}, soot), black + "its materials are black\n");
    EXPECT_EQ(said({point({0, 0, 9}, 1)}, soot), black + "its materials are black\n");
    EXPECT_EQ(said({point({0, 0, 9})}, [&](PictureRequest& r) { soot(r), r.settings.shading = Shading::unlit; }),
              black + "it is shown in its own colors, and they are black\n");
}

TEST_F(TooDarkOrBright, WhetherAMaterialIsBlackDependsOnTheLightingModelInForce) {
    const Light behind_it = point({0, 0, 0});
    const auto colored = [&](const char* color, Lighting lighting) {
        return said({behind_it}, [&](PictureRequest& r) {
            r.materials.color = std::string(color) == "black" ? vec3{0, 0, 0} : vec3{1, 1, 1};
            r.materials.metallic = 0, r.settings.lighting = lighting;
        });
    };
    for (const Lighting diffuse : {Lighting::lambert, Lighting::oren_nayar}) {
        EXPECT_EQ(colored("black", diffuse), black + "its materials are black\n");
        EXPECT_EQ(colored("white", diffuse),
                  black + "no light reaches its visible surfaces: they face away from the light\n");
    }
    for (const Lighting glossy : {Lighting::phong, Lighting::blinn_phong, Lighting::ward, Lighting::pbr})
        EXPECT_EQ(colored("black", glossy), black + highlights_alone);
}

TEST_F(TooDarkOrBright, AMetalHasNoDiffuseReflectionToBeTurnedAway) {
    const auto metal = [&](Lighting lighting) {
        return said({point({0, 0, 0})},
                    [&](PictureRequest& r) { r.materials.metallic = 1, r.settings.lighting = lighting; });
    };
    EXPECT_EQ(metal(Lighting::pbr), black + highlights_alone);
    EXPECT_EQ(metal(Lighting::lambert),  // which shows metals in their base color
              black + "no light reaches its visible surfaces: they face away from the light\n");
}

TEST_F(TooDarkOrBright, FogOfThatColorIsNamedAndOtherFogIsNot) {
    const Light front = point({0, 0, 9}), inside = point({0, 0, 0});
    const auto in_fog = [&](const Light& light, vec3 color, float density, Shading shading = Shading::phong) {
        return said({light}, [&](PictureRequest& r) {
            r.fog = Fog{.kind = FogKind::exponential, .color = color, .density = density};
            r.settings.shading = shading, r.view.side = "front";
        });
    };
    EXPECT_EQ(in_fog(front, {0, 0, 0}, 80),
              black + "the fog, which is black, hides it, or too little light reaches its visible surfaces\n");
    EXPECT_EQ(in_fog(front, {0, 0, 0}, 80, Shading::unlit),
              black + "the fog, which is black, hides it, or its own colors are black\n");
    EXPECT_EQ(in_fog(front, {0, 0, 0}, 0.01f), "");
    EXPECT_EQ(in_fog(inside, {0.5f, 0.5f, 0.5f}, 1e-9f),
              black + "no light reaches its visible surfaces: they face away from the light\n");
    const std::string white = " are white, 1 or more in red, green and blue";
    EXPECT_EQ(in_fog(front, {1, 1, 1}, 80), "100 % of the pixels that the model covers" + white +
                                                ", and so is the fog: see 'fog', 'exposure', 'tone-mapping', "
                                                "'light-intensity'\n");
    Light sun = front;
    sun.type = LightType::directional, sun.units = LightUnits::photometric, sun.intensity = 100000;
    EXPECT_NE(in_fog(sun, {0.5f, 0.5f, 0.5f}, 1e-9f).find(white + ": see 'exposure'"), std::string::npos);
}

TEST_F(TooDarkOrBright, BlackTexturesAndVertexColorsAreLeftPossible) {
    Scene scene;
    scene.materials.resize(1);
    scene.materials[0].base_color_texture.texture = 0, scene.materials[0].metallic_roughness.metallic = 0;
    scene.meshes.resize(1), scene.nodes.resize(1);
    scene.nodes[0].meshes = {0}, scene.meshes[0].material = 0;
    scene.meshes[0].positions = std::vector<vec3>{{-1, -1, -1}, {1, 1, 1}};
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 0};
    scene.lights = {point({0, 0, 0})};
    const std::string away = "no light reaches its visible surfaces: they face away from the light",
                      or_paint = "; or its textures or vertex colors are black";
    EXPECT_EQ(why_black(scene, {}), away + or_paint);
    scene.materials[0].base_color_texture = {};
    EXPECT_EQ(why_black(scene, {}), away);
    scene.meshes[0].colors = std::vector<vec4>(2, vec4{0, 0, 0, 1});
    EXPECT_EQ(why_black(scene, {}), away + or_paint);
}

/// A wall 6 m wide in a color of its own, behind a sphere of radius 0.5.
class BeforeAWall : public TooDarkOrBright {
protected:
    std::string before_wall(const std::string& color, const std::string& alpha, int samples,
                            std::vector<Light> lights) {
        std::ofstream(file("wall.scene.toml"))
            << "[[primitive]]\ntype = 'plane'\nsize = [6, 6]\nrotation_deg = [90, 0, 0]\nposition = [0, 0, -1]\n"
               "material = 'wall'\n[[primitive]]\ntype = 'sphere'\nradius = 0.5\n[[material]]\nname = 'wall'\n"
               "shading = 'unlit'\ndouble_sided = true\ncolor = "
            << color << "\nalpha = '" << alpha << "'\n";
        return said(std::move(lights), [&](PictureRequest& r) {
            r.input = file("wall.scene.toml"), r.view.side = "front", r.settings.samples = samples;
        });
    }
};

TEST_F(BeforeAWall, PicturesWithBlendedSurfacesAreNotJudged) {
    const Light dark = point({0, 0, 9}, 1), lit = point({0, 0, 9});
    for (const int samples : {1, 4}) {
        EXPECT_EQ(before_wall("[0, 0, 0]", "blend", samples, {lit}), "") << samples;
        EXPECT_EQ(before_wall("[1, 1, 1]", "blend", samples, {lit}), "") << samples;
        EXPECT_EQ(before_wall("[0, 0, 0]", "opaque", samples, {dark}),
                  black + "it is outside the range of the light\n");
    }
}

TEST_F(TooDarkOrBright, BlackBackgroundsAndEdgesOfSeveralSamplesChangeNothing) {
    for (const int samples : {1, 4, 8})
        for (const float gray : {0.0f, 0.18f, 1.0f}) {
            const auto change = [&](PictureRequest& r) {
                r.settings.samples = samples;
                r.settings.background = {gray, gray, gray, 1};
                r.settings.width = r.settings.height = 200;
            };
            EXPECT_EQ(said({point({0, 0, 9}, 7.5f)}, change), black + "it is outside the range of the light\n")
                << samples << gray;
            EXPECT_EQ(said({point({0, 0, 9}, 8.5f)}, change), "") << samples << gray;
        }
}

TEST_F(TooDarkOrBright, MoreThanTwoThirdsOfTheModelInWhiteAreSaidUnlessItIsNotLit) {
    Light lux = point({0, 0, 9});
    lux.type = LightType::directional, lux.units = LightUnits::photometric, lux.intensity = 100000;
    const auto front = [](PictureRequest& r) { r.view.side = "front"; };
    const std::string remark = said({lux}, front);
    EXPECT_NE(
        remark.find(
            " % of the pixels that the model covers are white, 1 or more in red, green and blue: see 'exposure', "),
        remark.npos);
    EXPECT_GE(std::stoi(remark), 97) << "all but a rim of the half that faces the light";
    const auto on_white = [&](PictureRequest& r) { front(r), r.settings.background = {1, 1, 1, 1}; };
    EXPECT_EQ(said({lux}, on_white), remark);
    EXPECT_EQ(said({point({0, 0, 9})}, on_white), "") << "the white is the background";
    EXPECT_EQ(said({lux}, [&](PictureRequest& r) { front(r), r.tone.exposure_ev = -17; }), "");
    EXPECT_EQ(said({lux}, [&](PictureRequest& r) { front(r), r.settings.shading = Shading::unlit; }), "");
    EXPECT_EQ(said({lux}, [&](PictureRequest& r) { front(r), r.output = file("a.exr"); }), "") << "holds it all";
}

TEST_F(TooDarkOrBright, BlackAndWhitePixelsAreCountedTheSameInCodesAndInRows) {
    std::mt19937 random(7);
    for (const std::size_t count : {1u, 15u, 16u, 17u, 1000u}) {
        std::vector<std::uint32_t> codes;
        std::vector<std::byte> rgb, rgba;
        std::uint64_t black = 0, white = 0;
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t code = random();
            if (random() % 3 == 0)
                code &= 0xFF000000u, ++black;
            else if (random() % 3 == 0)
                code |= 0x00FFFFFFu, ++white;
            else
                code = (code & 0xFF0000FFu) | 0x00007F00u;  // neither
            codes.push_back(code);
            for (int k = 0; k < 4; ++k) {
                rgba.push_back(std::byte(code >> 8 * k));
                if (k < 3) rgb.push_back(rgba.back());
            }
        }
        ExtremePixels by_codes, by_rgb, by_rgba;
        by_codes.add(codes), by_rgb.add_row(rgb.data(), count, 3), by_rgba.add_row(rgba.data(), count, 4);
        for (const ExtremePixels* p : {&by_codes, &by_rgb, &by_rgba}) {
            EXPECT_EQ(p->black(), black);
            EXPECT_EQ(p->white(), white);
        }
    }
}

}  // namespace
}  // namespace rakelight
