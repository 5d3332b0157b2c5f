// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_look.h"

#include <rakelight/scene/words.h>

#include <algorithm>
#include <cmath>

#include "image/tone_curves.h"
#include "math/color.h"
#include "render/rows.h"
#include "tools/explain/explain_values.h"

namespace rakelight {
namespace {

bool is_lit_from_around(const raster::Inspection& engine) {
    const std::optional<Environment>& around = engine.list().scene.environment;
    return around && around->is_light;
}

std::string intensity_text(const raster::Inspection& engine) {
    return is_lit_from_around(engine) ? ", intensity " + digits(engine.list().scene.environment->intensity) : "";
}

std::string light_choice(const PictureRequest& asked, const PictureRequest& looked, const raster::Inspection& engine) {
    if (looked.studio_lights && !asked.studio_lights) {
        std::string text = "the built-in studio as environment" + intensity_text(engine);
        for (const Light& light : engine.list().scene.lights)
            text += ", and '" + one_line(light.name, 40) + "' of " + digits(light.diffuse.x);
        return text;
    }
    if (looked.hdri_ambient.value_or(false) && !asked.hdri_ambient)
        return "the built-in studio as environment" + intensity_text(engine) + ", beside the file's lights";
    if (looked.default_lights && !asked.default_lights) return "the default lights instead of the file's";
    return {};
}

std::string background_text(const vec4& c) {
    const auto component = [](float linear) { return digits(std::round(1000 * srgb_from_linear(linear)) / 1000); };
    return "sRGB " + component(c.x) + " " + component(c.y) + " " + component(c.z) +
           ": the model's outline stands out from it";
}

std::string exposure_text(float ev) { return (ev > 0 ? "+" : "") + digits(ev) + " EV"; }

}  // namespace

std::vector<LookChoice> look_choices(const PictureRequest& asked, const PictureRequest& looked,
                                     const raster::Inspection& engine) {
    std::vector<LookChoice> choices;
    const auto add = [&](const char* topic, std::string value) {
        if (!value.empty()) choices.push_back({topic, std::move(value)});
    };
    const RenderSettings &before = asked.settings, &after = looked.settings;
    if (after.samples != before.samples) add("samples", digits(after.samples) + " a pixel");
    add("light", light_choice(asked, looked, engine));
    if (after.shadows && !before.shadows)
        add("shadows", "of the lights, filtered over " + digits(after.shadow_filter) + " texels");
    if (!(after.background == before.background)) add("background", background_text(after.background));
    if (looked.tone.exposure_ev != asked.tone.exposure_ev)
        add("exposure", exposure_text(looked.tone.exposure_ev) + ", for the file's lights in physical units");
    if (looked.view.side != asked.view.side) add("camera", "the fitted view instead of the file's");
    return choices;
}

std::string look_text(const ExplainedPixel& e) {
    if (e.look.empty()) return {};
    TextTable table({"", ""});
    for (const LookChoice& choice : e.look) table.add({choice.topic, choice.value});
    const std::string rows = table.text("    ");
    return "  the default look, unless another is given ('look' plain turns it off)\n" +
           rows.substr(rows.find('\n') + 1);
}

std::string code_text(const ExplainedPixel& e) {
    if (e.displayed == e.pixel.color) return {};
    Values values(4);
    const vec4 light = e.pixel.color;
    const auto add = [&](const std::string& name, vec3 v, const std::string& note) {
        values.add(name, vec4{v.x, v.y, v.z, light.w}, note);
    };
    values.add("linear color, alpha", light);
    if (e.tone.exposure_ev != 0)
        add("x 2^exposure", ToneCurve({ToneMapping::none, e.tone.exposure_ev})(light.xyz()),
            exposure_text(e.tone.exposure_ev));
    const auto is_used = [&](const Word<ToneMapping>& word) { return word.value == e.tone.mapping; };
    if (e.tone.mapping != ToneMapping::none)
        add("tone curve", ToneCurve(e.tone)(light.xyz()), std::ranges::find_if(tone_mapping_words, is_used)->name);
    if (light.w < 1)
        values.add("over the background", e.displayed, "by its alpha; exposure and tone curve do not change it");
    return "\nFrom light to codes: these are clamped to 0..1 and encoded as sRGB\n" + values.text("  ");
}

}  // namespace rakelight
