// SPDX-License-Identifier: Apache-2.0
#include "image/tone_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <rakelight/base/error.h>

#include "math/linear.h"

namespace rakelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
constexpr ToneMapping curves[] = {ToneMapping::reinhard, ToneMapping::neutral, ToneMapping::aces, ToneMapping::agx};

struct Published {
    ToneMapping mapping;
    vec3 light, displayed;
};
const std::vector<Published> published = {
#include "tone_values.inc"
};

TEST(ToneCurve, GivesThePublishedFormulasFarFinerThanEightBitCodes) {
    for (const Published& p : published) {
        const vec3 got = ToneCurve({p.mapping, 0})(p.light);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], p.displayed[c], 1e-6 + 2e-5 * double(p.displayed[c]))
                << int(p.mapping) << " " << p.light[c];
    }
}

TEST(ToneCurve, NoCurveAndNoExposureChangeNothingNotEvenWhatIsNoNumber) {
    const ToneCurve none;
    EXPECT_TRUE(none.is_identity());
    const vec3 odd = none({-1, 7, infinity});
    EXPECT_EQ(odd.x, -1);
    EXPECT_EQ(odd.y, 7);
    EXPECT_EQ(odd.z, infinity);
    EXPECT_TRUE(std::isnan(none({nan, 0, 0}).x));
    EXPECT_FALSE(ToneCurve({ToneMapping::none, 0.5}).is_identity());
    EXPECT_FALSE(ToneCurve({ToneMapping::agx, 0}).is_identity());
}

TEST(ToneCurve, OneStopMoreIsTwiceTheLight) {
    for (const double ev : {-3.0, -1.0, 1.0, 4.0}) {
        const vec3 got = ToneCurve({ToneMapping::none, ev})({0.3f, 1, 5});
        const float times = float(std::ldexp(1.0, int(ev)));
        EXPECT_EQ(got.x, 0.3f * times);
        EXPECT_EQ(got.y, times);
        EXPECT_EQ(got.z, 5 * times);
        for (const ToneMapping curve : curves) {
            const vec3 a = ToneCurve({curve, ev})({0.3f, 1, 5}), b = ToneCurve({curve, 0})(vec3{0.3f, 1, 5} * times);
            EXPECT_EQ(a.x, b.x);
            EXPECT_EQ(a.z, b.z);
        }
    }
    EXPECT_NEAR(ToneCurve({ToneMapping::none, 0.5})({1, 1, 1}).x, std::sqrt(2.0), 1e-7);
}

TEST(ToneCurve, MoreGrayLightIsNeverDarkerAndNeverOverOne) {
    for (const ToneMapping mapping : curves) {
        const ToneCurve curve({mapping, 0});
        float before = 0;
        for (float light = 1e-6f; light < 1e7f; light *= 1.01f) {
            const vec3 got = curve({light, light, light});
            EXPECT_GE(got.x, before - 1e-7f) << int(mapping) << " at " << light;  // one rounding
            EXPECT_LE(got.x, 1.0f);
            before = got.x;
        }
        EXPECT_GT(before, 0.98f);
    }
}

TEST(ToneCurve, NeutralKeepsColorsUnderItsShoulderUpToTheFresnelOffset) {
    const ToneCurve neutral({ToneMapping::neutral, 0});
    const vec3 got = neutral({0.70f, 0.30f, 0.10f});  // 0.04 off each where the least is over 0.08
    EXPECT_FLOAT_EQ(got.x, 0.66f);
    EXPECT_FLOAT_EQ(got.y, 0.26f);
    EXPECT_FLOAT_EQ(got.z, 0.06f);
}

TEST(ToneCurve, ReinhardKeepsTheHue) {
    const vec3 got = ToneCurve({ToneMapping::reinhard, 0})({8, 2, 4});
    EXPECT_FLOAT_EQ(got.x, 4 * got.y);
    EXPECT_FLOAT_EQ(got.z, 2 * got.y);
}

TEST(ToneCurve, WhatIsNoLightIsBlackAndWhatIsEndlessIsBright) {
    for (const ToneMapping mapping : curves) {
        const ToneCurve curve({mapping, 0});
        const vec3 black = curve({0, 0, 0}), bad = curve({nan, -3, -infinity}),
                   bright = curve({infinity, infinity, infinity});
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(bad[c], black[c]) << int(mapping);
            EXPECT_LE(black[c], 1e-6f);
            EXPECT_GT(bright[c], 0.98f) << int(mapping);
            EXPECT_LE(bright[c], 1.0f);
        }
    }
}

TEST(ToneCurve, RowsAreTheirPixelsAndKeepAlpha) {
    const std::vector<vec4> in{{1, 2, 3, 0.5f}, {1, 2, 3, 0.5f}, {0, 0, 0, nan}, {4, 4, 4, 1}};
    for (const ToneMapping mapping : curves) {
        const ToneCurve curve({mapping, 1});
        std::vector<vec4> out = in;
        curve.apply(out, out);
        for (std::size_t i = 0; i < in.size(); ++i) {
            const vec3 one = curve(in[i].xyz());
            EXPECT_EQ(out[i].x, one.x);
            EXPECT_EQ(out[i].y, one.y);
            EXPECT_EQ(out[i].z, one.z);
        }
        EXPECT_EQ(out[0].w, 0.5f);
        EXPECT_TRUE(std::isnan(out[2].w));
    }
}

TEST(ToneCurve, RefusesAnExposureThatCannotBe) {
    for (const double ev :
         {33.0, -1e9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(ToneCurve({ToneMapping::none, ev}), Error);
}

TEST(ToneCurve, WhatLiesBehindAPixelIsNotChanged) {
    const vec4 behind{0.2f, 0.6f, 1.0f, 1};
    for (const ToneMapping curve : {ToneMapping::none, ToneMapping::reinhard, ToneMapping::agx})
        for (const double ev : {-5.0, 0.0, 6.0}) {
            const ToneSettings settings{curve, ev};
            const ToneCurve over(settings, behind);
            EXPECT_FALSE(over.is_identity());
            EXPECT_TRUE(over.is_opaque_behind());
            EXPECT_EQ(over.displayed({9, 9, 9, 0}), behind);
            const vec3 light{0.5f, 2, 0.1f}, own = ToneCurve(settings)(light);
            EXPECT_EQ(over.displayed({light.x, light.y, light.z, 1}), (vec4{own.x, own.y, own.z, 1}));
            const vec4 half = over.displayed({light.x, light.y, light.z, 0.25f});
            EXPECT_NEAR(half.x, 0.25f * std::min(own.x, 1.0f) + 0.75f * behind.x, 1e-6f);
            EXPECT_NEAR(half.y, 0.25f * std::min(own.y, 1.0f) + 0.75f * behind.y, 1e-6f);
            EXPECT_EQ(half.w, 1);
        }
}

TEST(ToneCurve, WhatIsHalfTransparentBehindLeavesAlpha) {
    const ToneCurve over({ToneMapping::none, 1}, {1, 0, 0, 0.5f});
    EXPECT_EQ(over.displayed({0, 0, 0, 0}), (vec4{1, 0, 0, 0.5f}));
    const vec4 mixed = over.displayed({0, 0.25f, 0, 0.5f});  // doubled by the exposure
    EXPECT_NEAR(mixed.w, 0.75f, 1e-6f);
    EXPECT_NEAR(mixed.x, 0.25f / 0.75f, 1e-6f);
    EXPECT_NEAR(mixed.y, 0.25f / 0.75f, 1e-6f);
    EXPECT_EQ(over.laid({0, 0.25f, 0, 1}), (vec4{0, 0.25f, 0, 1}));
    EXPECT_NEAR(over.laid({0, 0.25f, 0, 0.5f}).y, 0.125f / 0.75f, 1e-6f);
    EXPECT_EQ(over.displayed({nan, nan, nan, 0}), (vec4{1, 0, 0, 0.5f}));
}

TEST(ToneCurve, FindsTheLightThatIsDisplayedAsAColor) {
    for (const ToneMapping mapping :
         {ToneMapping::none, ToneMapping::reinhard, ToneMapping::neutral, ToneMapping::aces, ToneMapping::agx})
        for (const double exposure : {-12.0, 0.0, 3.0})
            for (const vec3 wanted : {vec3{0.03f, 0.031f, 0.037f}, vec3{0.2f, 0.2f, 0.2f}, vec3{0.55f, 0.14f, 0.05f}}) {
                const ToneCurve curve({mapping, exposure});
                const vec3 found = curve(curve.light_for(wanted));
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(found[c], wanted[c], 0.02) << int(mapping) << " " << exposure << " " << c;
            }
    EXPECT_EQ(ToneCurve({ToneMapping::none, 3}).light_for({0.5f, 0.25f, 0}), (vec3{0.0625f, 0.03125f, 0}));
}

}  // namespace
}  // namespace rakelight
