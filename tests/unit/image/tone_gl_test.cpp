// SPDX-License-Identifier: Apache-2.0
// The tone curves' text on a GPU, or on Mesa's llvmpipe: in GLSL 3.30 and in ES 3.00 it gives what ToneCurve gives. Skipped
// where there is no EGL.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "image/tone_curves.h"
#include "support/gl_context.h"
#include "support/shared.h"

namespace rakelight {
namespace {

using test::GlContext;
using test::GlFlavour;

constexpr int side = 64;

std::string read_source(const std::string& name) {
    std::ifstream file(test::source_dir() / "src" / name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str() + "\n";
}

/// Colors from 2^-16 to 2^8 in steps of a sixteenth of an octave, of several hues.
std::vector<float> lights() {
    std::vector<float> out;
    for (int i = 0; i < side * side; ++i) {
        const float bright = std::exp2(float(i % 384) / 16 - 16), tint = float(i % 7) / 7;
        out.insert(out.end(), {bright, bright * tint, bright * (1 - tint * tint), 1});
    }
    return out;
}

/// Negative, very bright and very dark ones.
std::vector<float> odd_lights() {
    const float odd[] = {-1, -1e-6f, 0, 1e-30f, 1e4f, 1e6f, 1e10f, 0.5f};
    std::vector<float> out;
    for (int i = 0; i < side * side; ++i) out.insert(out.end(), {odd[i % 8], odd[i / 8 % 8], odd[i / 64 % 8], 1});
    return out;
}

void expect_curves(GlContext& context, const std::vector<float>& items) {
    context.set_textures({{"items", side, side, items}});
    const std::string text = read_source("math/prelude.glsl") + "struct Maps { float unused; };\n" +
                             read_source("image/agx_curves.glsl") + read_source("image/tone.glsl");
    const ToneMapping mappings[] = {ToneMapping::none, ToneMapping::reinhard, ToneMapping::neutral, ToneMapping::aces,
                                    ToneMapping::agx};
    for (int k = 0; k < 5; ++k) {
        const std::vector<float> got =
            context.run(text +
                            "uniform sampler2D items;\nvoid main() {\n    Maps maps;\n"
                            "    maps.unused = 0.0;\n"
                            "    vec3 light = texelFetch(items, ivec2(gl_FragCoord.xy), 0).xyz;\n"
                            "    result = vec4(tone_curve(maps, " +
                            std::to_string(k) + ", light, 2.0), 1.0);\n}\n",
                        side, side);
        const ToneCurve curve({.mapping = mappings[k], .exposure_ev = 1});
        for (std::size_t i = 0; i < got.size(); i += 4) {
            const vec3 expected = curve({items[i], items[i + 1], items[i + 2]});
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(got[i + c], expected[c], 3e-5 + 3e-5 * std::abs(expected[c]))
                    << "curve " << k << " light " << items[i] << " " << items[i + 1] << " " << items[i + 2];
        }
    }
}

void expect_curves(GlFlavour flavour) {
    std::string why;
    const std::unique_ptr<GlContext> context = GlContext::make(flavour, why);
    if (!context) GTEST_SKIP() << why;
    expect_curves(*context, lights());
}

TEST(ToneCurvesOnGpu, WhatIsNoColorIsShownAsToneCurveShowsIt) {
    std::string why;
    const std::unique_ptr<GlContext> context = GlContext::make(GlFlavour::core_33, why);
    if (!context) GTEST_SKIP() << why;
    expect_curves(*context, odd_lights());
}

TEST(ToneCurvesOnGpu, GiveTheNumbersOfToneCurveInGlsl330) { expect_curves(GlFlavour::core_33); }
TEST(ToneCurvesOnGpu, GiveTheNumbersOfToneCurveInEs300) { expect_curves(GlFlavour::es_30); }

}  // namespace
}  // namespace rakelight
