// SPDX-License-Identifier: Apache-2.0
#include "render/too_dark_or_bright.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "render/engines.h"
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
        const auto engine = make_engine("soft");
        result_ = draw_picture(request, *engine, context);
        std::string all;
        for (const ReportEntry& e : context.report().entries())
            if (e.remark == Remark::warning) all += e.message + "\n";
        return all;
    }
    PictureResult result_;
};

const std::string black = "all of the model came out black: ";

TEST_F(TooDarkOrBright, AModelThatNoLightReachesIsSaidToBeBlackWithTheReason) {
    EXPECT_EQ(said({point({0, 0, 9}, 7.5f)}), black + "it is out of the range of the light\n");
    EXPECT_EQ(said({point({0, 0, 9}, 8.5f)}), "");  // it is 8 m to the sphere
    EXPECT_EQ(said({point({0, 0, 9}, 2), point({0, 9, 0}, 3)}), black + "it is out of the range of all 2 lights\n");
    Light off = point({0, 0, 9});
    off.diffuse = off.specular = {0, 0, 0};
    EXPECT_EQ(said({off}), black + "no light has any brightness\n");
    Light faint = point({0, 0, 9});
    faint.units = LightUnits::photometric, faint.intensity = 0.01f;
    EXPECT_EQ(said({faint}), black +
                                 "too little of the light reaches it; see intensity and attenuation of lights, "
                                 "--light-intensity, --exposure\n");
    EXPECT_EQ(said({faint}, [](PictureRequest& r) { r.tone.exposure_ev = 12; }), "");
    EXPECT_EQ(said({point({0, 0, 0})}),
              black + "no light falls on what is seen of it: that is turned away from the light\n");
    Light spot = point({0, 0, 9});
    spot.type = LightType::spot, spot.direction = {0, 0, 1}, spot.cutoff_rad = 0.5f;
    EXPECT_EQ(said({spot}, [](PictureRequest& r) { r.settings.shadows = true; }),
              black +
                  "no light falls on what is seen of it: that is turned away from the light, outside of its cone or "
                  "in shadow\n");
}

TEST_F(TooDarkOrBright, ABlackMaterialIsTheReasonWhateverTheLight) {
    const auto none = [](const char* key) { return WorldValue{key, {"#000000"}, {0, 0, 0}, {}}; };
    const auto soot = [&](PictureRequest& r) {
        r.materials.values = {none("color"), none("specular"), none("ambient")};
    };
    EXPECT_EQ(said({point({0, 0, 9})}, soot), black + "its materials are black\n");
    EXPECT_EQ(said({point({0, 0, 9}, 1)}, soot), black + "its materials are black\n");
    EXPECT_EQ(said({point({0, 0, 9})}, [&](PictureRequest& r) { soot(r), r.settings.shading = Shading::unlit; }),
              black + "it is shown in its own colors, and those are\n");
}

TEST_F(TooDarkOrBright, BlackBackgroundsAndEdgesOfSeveralSamplesChangeNothing) {
    for (const int samples : {1, 4, 8})
        for (const float gray : {0.0f, 0.18f, 1.0f}) {
            const auto change = [&](PictureRequest& r) {
                r.settings.samples = samples;
                r.settings.background = {gray, gray, gray, 1};
                r.settings.width = r.settings.height = 200;
            };
            EXPECT_EQ(said({point({0, 0, 9}, 7.5f)}, change), black + "it is out of the range of the light\n")
                << samples << gray;
            EXPECT_EQ(said({point({0, 0, 9}, 8.5f)}, change), "") << samples << gray;
        }
}

TEST_F(TooDarkOrBright, MoreThanTwoThirdsOfTheModelInWhiteAreSaidUnlessItIsNotLit) {
    Light lux = point({0, 0, 9});
    lux.type = LightType::directional, lux.units = LightUnits::photometric, lux.intensity = 100000;
    const auto front = [](PictureRequest& r) { r.view.side = "front"; };
    const std::string remark = said({lux}, front);
    EXPECT_NE(remark.find(" % of what the model covers is white, 1 or more in red, green and blue: see --exposure, "),
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
