// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_conclusion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "shading/lights/luminance.h"
#include "tools/explain/explain_values.h"
#include "tools/material_names.h"

namespace rakelight {
namespace {

using raster::PixelTrace;
using raster::ShadedLayer;
using raster::TracedLight;

constexpr int dark_code = 50;    ///< no component of a dark pixel is above
constexpr float little = 0.04f;  ///< of what arrives is reflected
constexpr float grazing_n_dot_l = 0.1f;
constexpr std::size_t most_reasons = 3;

struct Term {
    std::string name;
    double luminance;
};

/// [layers] How much of the pixel each is, by the opacities of those over it. They come to 1, or with background to less.
std::vector<double> shares_of_layers(const raster::PixelExplanation& p) {
    std::vector<double> shares(p.layers.size());
    for (std::size_t s = 0; s < p.samples.size(); ++s) {
        std::vector<std::pair<int, std::size_t>> here;  // places and layers
        for (std::size_t i = 0; i < p.layers.size(); ++i)
            for (const raster::LaidSample& laid : p.layers[i].samples)
                if (laid.sample == int(s)) here.emplace_back(laid.place, i);
        std::ranges::sort(here, std::greater());
        double rest = 1 / double(p.samples.size());
        for (const auto& [place, i] : here) {
            const double opacity = p.layers[i].is_blended ? double(p.layers[i].trace.alpha) : 1;
            shares[i] += rest * opacity;
            rest *= 1 - opacity;
        }
    }
    return shares;
}

void add(std::vector<Term>& terms, std::string name, const float (&v)[3], double times = 1) {
    const double light = times * shading::luminance_of(dvec3{double(v[0]), double(v[1]), double(v[2])});
    if (light > 0) terms.push_back({std::move(name), light});
}

void add_received(std::vector<Term>& terms, const PixelTrace& t, double times) {
    static constexpr const char* names[] = {"ambient", "diffuse", "specular"};
    const float(*const k[])[3] = {&t.k_ambient, &t.k_diffuse, &t.k_specular};
    for (std::size_t i = 0; i < 3; ++i) {
        float term[3];
        for (std::size_t c = 0; c < 3; ++c) term[c] = (*k[i])[c] * t.received[i][c];
        add(terms, std::string("the ") + names[i] + " term of the lights", term, times);
    }
}

/// What is added to the layer's color.
std::vector<Term> terms_of(const ExplainedPixel& e, const ShadedLayer& layer) {
    const PixelTrace& t = layer.trace;
    const double times = t.has_fog ? double(t.fog_share) : 1;
    std::vector<Term> terms;
    add(terms, "its emission", t.emission, times);
    if (layer.is_unlit)
        add(terms, "its own color, which is unlit", {t.base_color[0], t.base_color[1], t.base_color[2]}, times);
    for (std::size_t i = 0; i < layer.lights.size(); ++i) {
        const TracedLight& l = layer.lights[i];
        add(terms, "the ambient term of light " + name_of_light(e, i), l.ambient, times);
        add(terms, "the diffuse term of light " + name_of_light(e, i), l.diffuse, times);
        add(terms, "the specular term of light " + name_of_light(e, i), l.specular, times);
    }
    if (t.is_lit_at_corners) add_received(terms, t, times);
    if (t.has_environment) {
        add(terms, "the ambient term of the environment", t.environment[0], times);
        add(terms, "the diffuse term of the environment", t.environment[1], times);
        add(terms, "the specular term of the environment", t.environment[2], times);
    }
    if (t.has_transmission) add(terms, "what is seen through it", t.transmitted, times);
    if (t.has_fog) add(terms, "fog", t.fog_color, 1 - times);
    return terms;
}

/// A light where it was evaluated: at the pixel, or at the corners.
std::vector<const TracedLight*> places_of(const ShadedLayer& layer, std::size_t light) {
    std::vector<const TracedLight*> places;
    if (light < layer.lights.size()) places.push_back(&layer.lights[light]);
    for (const raster::TracedCorner& corner : layer.corners) places.push_back(&corner.lights[light]);
    return places;
}

/// Why a light gives nothing, or little; empty: it does give.
std::string what_keeps_away(const Light& light, const std::vector<const TracedLight*>& places) {
    if (places.empty() || light.type == LightType::ambient) return {};
    const auto all = [&](const auto& holds) {
        return std::ranges::all_of(places, [&](const auto* l) { return holds(*l); });
    };
    const auto is_black = [](const float(&v)[3]) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
    if (all([&](const TracedLight& l) { return is_black(l.own_diffuse) && is_black(l.own_specular); }))
        return "is black";
    if (all([](const TracedLight& l) { return !(l.n_dot_l > 0); })) return "is below the surface (n.l <= 0)";
    if (all([](const TracedLight& l) { return l.spot == 0; })) return "shines past it";
    if (all([](const TracedLight& l) { return l.attenuation == 0; })) return "does not reach this far";
    if (all([](const TracedLight& l) { return l.seen < 0.5f; })) return "is in shadow";
    if (all([](const TracedLight& l) { return l.n_dot_l < grazing_n_dot_l; })) return "is at a grazing angle";
    return {};
}

/// Factors that make the layer dark; empty: none stands out.
std::string dark_because(const ExplainedPixel& e, const ShadedLayer& layer) {
    const std::vector<Light>& lights = e.engine->list().scene.lights;
    const PixelTrace& t = layer.trace;
    std::vector<std::string> reasons;
    std::size_t kept_away = 0;
    for (std::size_t i = 0; i < lights.size() && !layer.is_unlit; ++i) {
        const std::string why = what_keeps_away(lights[i], places_of(layer, i));
        if (why.empty()) continue;
        if (++kept_away <= most_reasons) reasons.push_back("light " + name_of_light(e, i) + " " + why);
    }
    if (kept_away > most_reasons)
        reasons.push_back(digits(kept_away - most_reasons) + " more contribute nothing or little");
    if (lights.empty() && !t.has_environment && !layer.is_unlit) reasons.emplace_back("the scene has no light");
    float most = 0;
    for (const auto* const k : {&t.k_ambient, &t.k_diffuse, &t.k_specular})
        for (const float component : *k) most = std::max(most, component);
    if (!layer.is_unlit && most < little)
        reasons.emplace_back("the surface reflects little (k ambient, diffuse, specular)");
    std::string text;
    for (const std::string& reason : reasons) text += (text.empty() ? "" : ", ") + reason;
    return text;
}

/// The strongest light, if something keeps it away from a pixel that others light; else empty.
std::string missing_light(const ExplainedPixel& e, const ShadedLayer& layer) {
    const std::vector<Light>& lights = e.engine->list().scene.lights;
    std::size_t strongest = lights.size();
    double most = 0;
    for (std::size_t i = 0; i < lights.size() && !layer.is_unlit; ++i) {
        const std::vector<const TracedLight*> places = places_of(layer, i);
        if (places.empty() || lights[i].type == LightType::ambient) continue;
        const float(&own)[3] = places[0]->own_diffuse;
        const double power = shading::luminance_of(dvec3{double(own[0]), double(own[1]), double(own[2])});
        if (power > most) strongest = i, most = power;
    }
    if (strongest == lights.size()) return {};
    const std::string why = what_keeps_away(lights[strongest], places_of(layer, strongest));
    return why.empty() ? std::string() : "the strongest light, " + name_of_light(e, strongest) + ", " + why;
}

std::string percent(double share) { return digits(int(std::lround(100 * share))) + " %"; }

}  // namespace

std::string name_of_light(const ExplainedPixel& e, std::size_t i) {
    const Light& light = e.engine->list().scene.lights[i];
    return digits(i) + " (" + name_of(light.type) + (light.name.empty() ? "" : ", " + one_line(light.name, 40)) + ")";
}

std::string conclusion_text(const ExplainedPixel& e) {
    const std::vector<double> shares = shares_of_layers(e.pixel);
    const auto heaviest = std::ranges::max_element(shares);
    if (heaviest == shares.end() || !(*heaviest > 0)) return "\nIn short: the background.\n";
    const auto number = std::size_t(heaviest - shares.begin());
    const ShadedLayer& layer = e.pixel.layers[number];
    const std::vector<Term> terms = terms_of(e, layer);
    double sum = 0;
    for (const Term& term : terms) sum += term.luminance;
    const auto largest = std::ranges::max_element(terms, {}, &Term::luminance);
    const bool is_dark = *std::max_element(e.codes.begin(), e.codes.begin() + 3) <= dark_code;
    std::string text = "\nIn short: ";
    if (shares.size() > 1) text += "layer " + digits(number) + " makes " + percent(*heaviest) + " of the pixel; ";
    const std::string because = is_dark ? dark_because(e, layer) : std::string();
    if (is_dark) text += (sum > 0 ? "dark" : "black") + (because.empty() ? "" : ", because " + because);
    if (is_dark && sum > 0) text += "; ";
    if (sum > 0) text += percent(largest->luminance / sum) + " of its light is " + largest->name;
    if (const std::string missing = is_dark ? std::string() : missing_light(e, layer); !missing.empty())
        text += "; " + missing;
    return text + ".\n";
}

}  // namespace rakelight
