// SPDX-License-Identifier: Apache-2.0
// From light to codes: exposure, tone curve, clamping and sRGB; and the picture that comes out.
#include <algorithm>
#include <cmath>

#include <rakelight/scene/words.h>

#include "math/functions.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

constexpr int width = 640, height = 400, left = 64, right = 616, top = 16, bottom = 370;
constexpr double low_ev = -10, high_ev = 8, gray_card = 0.18;
constexpr Code grid{48, 54, 68}, words{190, 195, 205}, curve_color{90, 160, 250}, plain_color{120, 120, 120};

const char* name_of(ToneMapping mapping) {
    const auto has = [&](const Word<ToneMapping>& word) { return word.value == mapping; };
    return std::ranges::find_if(tone_mapping_words, has)->name;
}

float light_at(double ev) { return float(gray_card * math::exp2(ev)); }
vec3 gray_light(float light) { return {light, light, light}; }

double x_of(double ev) { return left + (ev - low_ev) / (high_ev - low_ev) * (right - left); }
double y_of(int code) { return bottom - code / 255.0 * (bottom - top); }

void draw_curve(Canvas& canvas, const ToneCurve& curve, Code color) {
    dvec2 last;
    for (int x = left; x <= right; ++x) {
        const double ev = low_ev + (high_ev - low_ev) * (x - left) / (right - left);
        const dvec2 p = {double(x), y_of(code_of_light(curve(gray_light(light_at(ev)))).g)};
        if (x > left) canvas.line(last, p, color);
        last = p;
    }
}

Picture curve_picture(const Sources& of) {
    Canvas canvas(width, height, backdrop);
    for (int ev = int(low_ev); ev <= int(high_ev); ev += 2) {
        const std::string text = (ev > 0 ? "+" : "") + std::to_string(ev);
        canvas.line({x_of(ev), top}, {x_of(ev), bottom}, grid);
        canvas.write(int(x_of(ev)), bottom + 8, text, words, Align::center);
    }
    for (const int code : {0, 64, 128, 192, 255}) {
        const std::string text = std::to_string(code);
        canvas.line({left, y_of(code)}, {right, y_of(code)}, grid);
        canvas.write(left - 6, int(y_of(code)) - letter_height / 2, text, words, Align::right);
    }
    draw_curve(canvas, ToneCurve(), plain_color);
    draw_curve(canvas, of.curve, curve_color);
    return {"tone-curve",
            "The code of gray light over its brightness in powers of two about 0.18. Blue: this picture's; gray: light "
            "clamped to 1 without exposure or curve.",
            std::move(canvas)};
}

bool is_over_one(vec3 c) { return c.x > 1 || c.y > 1 || c.z > 1; }

std::uint64_t count_over_one(const Sources& of, const ToneCurve& curve) {
    return std::uint64_t(std::count_if(of.pixels.color.begin(), of.pixels.color.end(),
                                       [&](const vec4& c) { return is_over_one(curve(c.xyz())); }));
}

Stage make_tone_stage(const Sources& of) {
    Stage s{.id = "tone", .title = "Exposure, tone curve and codes"};
    s.text =
        "The sums of the terms are light of any brightness. It is multiplied by 2 to the power of the exposure, passes "
        "through the tone curve, which compresses bright values to the range of a display, is clamped to 0..1 and "
        "encoded as sRGB with 8 bits. Without a curve (none, the default) everything over 1 is clamped: brighter "
        "differences are lost, and bright colors turn towards white. EXR and HDR files keep the light as it is.";
    const ToneCurve plain;
    s.numbers = {{"exposure [EV]", of.tone.exposure_ev},
                 {"tone curve", name_of(of.tone.mapping)},
                 {"pixels brighter than 1 before", count_over_one(of, plain)},
                 {"pixels brighter than 1 with the exposure", count_over_one(of, of.exposure)},
                 {"pixels brighter than 1 after the curve, clamped", count_over_one(of, of.curve)}};
    s.pictures.push_back({"tone-light", "Before: the light clamped to 1, no exposure, no curve.",
                          paint(of, [&](std::size_t p) { return code_of_light(of.pixels.color[p].xyz()); })});
    s.pictures.push_back(
        {"tone-over-1", "Red: with the exposure brighter than 1 before the curve.", paint(of, [&](std::size_t p) {
             const vec3 light = of.exposure(of.pixels.color[p].xyz());
             if (is_over_one(light)) return Code{240, 70, 60};
             const Code c = code_of_light(light);
             return gray((c.r + 2 * c.g + c.b) / (4 * 255.0) * 0.6);
         })});
    s.pictures.push_back(curve_picture(of));
    s.columns = {"EV about 0.18", "light", "with the exposure", "after the curve", "code"};
    for (int ev = int(low_ev); ev <= int(high_ev); ++ev) {
        const vec3 light = gray_light(light_at(ev)), after = of.curve(light);
        s.rows.push_back(
            {ev, double(light.y), double(of.exposure(light).y), double(after.y), int(code_of_light(after).g)});
    }
    s.rows_note = "The result for gray light";
    return s;
}

Stage make_picture_stage(const Sources& of) {
    Stage s{.id = "picture", .title = "The picture"};
    s.text =
        "The sums of the terms, blended surfaces laid over them far to near, then exposure, tone curve and sRGB codes "
        "of 8 bits. It is the picture that rakelight render writes with these options, to the bit.";
    s.numbers["pixels brighter than 1, clamped"] = count_over_one(of, of.curve);
    s.pictures.push_back(
        {"picture", "The picture.", paint(of, [&](std::size_t p) { return displayed_code(of, of.pixels.color[p]); })});
    return s;
}

}  // namespace

constinit const StageKind tone_stage{make_tone_stage}, picture_stage{make_picture_stage};

}  // namespace rakelight::stages
