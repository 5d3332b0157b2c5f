// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_factors.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace rakelight {
namespace {

using raster::TracedFactor;
using raster::TracedLayer;
using raster::TracedPart;
using raster::TracedQuantity;
using raster::TracedTerm;

struct Words {
    TracedQuantity quantity;
    const char *json, *text, *note;
};

using enum raster::TracedQuantity;
constexpr Words all_words[] = {
    {k_ambient, "k_ambient", "k ambient", ""},
    {k_diffuse, "k_diffuse", "k diffuse", ""},
    {k_specular, "k_specular", "k specular", ""},
    {light_color, "light_color", "light that arrives", ""},
    {n_dot_l, "n_dot_l", "n.l", ""},
    {n_dot_l_diffuse, "n_dot_l_diffuse", "n.l", "with the normal for diffuse light"},
    {n_dot_l_coat, "n_dot_l_coat", "n.l", "with the normal of the coat"},
    {pi, "pi", "pi", "a light's color is irradiance / pi"},
    {oren_nayar, "oren_nayar", "A + B ...", "Oren & Nayar 1994, eq. 30"},
    {oren_nayar_full, "oren_nayar_full", "C1 + ...", "Oren & Nayar 1994, eq. 27 to 29"},
    {power, "power", "cosine to the exponent", "r.v or n.h; 0 below 0"},
    {energy_factor, "energy_factor", "energy factor", "pi times the lobe's normalization"},
    {ward_peak, "ward_peak", "peak [1/sr]", "1 / (4 pi alpha_x alpha_y)"},
    {ward_exponential, "ward_exponential", "exp(-tan^2 ...)", "Ward 1992, eq. 5a"},
    {ward_divided, "ward_divided", "1 / cosines", "of the form of Ward's model"},
    {fresnel, "fresnel", "Fresnel's term (F)", "f0 + (f90 - f0) (1 - v.h)^5"},
    {fresnel_rest, "fresnel_rest", "1 - F", "of the non-metallic part"},
    {distribution, "distribution", "D [1/sr]", "GGX"},
    {visibility, "visibility", "V", "Smith: G / (4 n.l n.v)"},
    {scattering_color, "scattering_color", "color of it", "of all further bounces"},
    {scattering_lost_l, "scattering_lost_l", "1 - E(l)", "energy lost by one bounce"},
    {scattering_lost_v, "scattering_lost_v", "1 - E(v)", ""},
    {scattering_mean, "scattering_mean", "1 / (pi (1 - E mean))", "Kulla & Conty 2017"},
    {sheen_color, "sheen_color", "color of the sheen", ""},
    {sheen_lobe, "sheen_lobe", "D V [1/sr]", "Estevez & Kulla 2017"},
    {sheen_rest, "sheen_rest", "light that the sheen leaves", ""},
    {coat_reflectance, "coat_reflectance", "clearcoat", "its reflectance towards the viewer"},
    {coat_rest, "coat_rest", "light that the coat transmits", "1 - its reflectance"},
    {above, "above", "below the surface", "light or viewer: nothing is reflected"},
    {seen, "seen", "not in shadow", "fraction of the light"},
    {around_diffuse, "around_diffuse", "diffuse reflectance", "of environment light, with occlusion"},
    {around_specular, "around_specular", "specular reflectance", "of environment light, with occlusion"},
    {around_sheen, "around_sheen", "reflectance of the sheen", ""},
    {around_coat, "around_coat", "reflectance of the coat", ""},
    {mean_light, "mean_light", "environment light around the normal", "irradiance / pi"},
    {mean_light_sheen, "mean_light", "environment light around the normal", "irradiance / pi"},
    {mirrored, "mirrored", "reflected environment light", "around the mirror direction, as wide as the lobe"},
    {mirrored_coat, "mirrored", "reflected environment light", "around the mirror direction, as wide as the lobe"},
    {own_emission, "own_emission", "emission of the material", ""},
    {through, "through", "transmission color", "of the transmission"},
    {behind, "behind", "light from behind", "refracted, blurred, absorbed by the body"},
};

constexpr bool are_in_order() {
    std::size_t i = 0;
    for (const Words& w : all_words)
        if (std::size_t(w.quantity) != i++) return false;
    return i == std::size_t(TracedQuantity::count);
}
static_assert(are_in_order(), "one row per quantity");

const Words& words_of(const TracedFactor& f) { return all_words[std::size_t(f.quantity)]; }

constexpr const char* terms[] = {"ambient", "diffuse", "specular", "emission"};
constexpr const char* layers[] = {"base", "scattering", "sheen", "clearcoat"};
constexpr const char* layers_text[] = {"", ", interreflection between facets", ", sheen", ", clearcoat"};

bool arrives(const TracedPart& part) {
    return std::none_of(part.factor, part.factor + part.count, [](const TracedFactor& f) {
        return f.quantity == TracedQuantity::light_color && is_black(f.value);
    });
}

void add_factor(Values& values, const TracedFactor& f, bool is_first) {
    const Words& words = words_of(f);
    const std::string name = std::string(is_first ? "    " : "  x ") + words.text;
    if (f.is_color)
        values.add(name, f.value, words.note);
    else
        values.add(name, f.value[0], words.note);
}

}  // namespace

Rgb product_of(const TracedPart& part) {
    double product[3] = {1, 1, 1};
    for (int i = 0; i < part.count; ++i)
        for (std::size_t c = 0; c < 3; ++c) product[c] *= double(part.factor[i].value[c]);
    return {float(product[0]), float(product[1]), float(product[2])};
}

std::optional<Rgb> term_of(const raster::TracedParts& parts, int part, const raster::TracedLight& light) {
    const TracedTerm term = parts.part[part].term;
    if (std::count_if(parts.part, parts.part + parts.count, [&](const TracedPart& p) { return p.term == term; }) > 1)
        return std::nullopt;
    const float(&v)[3] = term == TracedTerm::ambient   ? light.ambient
                         : term == TracedTerm::diffuse ? light.diffuse
                                                       : light.specular;
    return Rgb{v[0], v[1], v[2]};
}

void add_factors(Values& values, const TracedPart& part, const std::optional<Rgb>& term) {
    const std::string name = terms[std::size_t(part.term)] + std::string(layers_text[std::size_t(part.layer)]);
    const Rgb sum = term.value_or(product_of(part));
    const float(&shown)[3] = *reinterpret_cast<const float(*)[3]>(sum.data());
    if (!arrives(part)) return values.add(name, shown, "no such light arrives");
    values.title(name);
    for (int i = 0; i < part.count; ++i) add_factor(values, part.factor[i], i == 0);
    values.add("  =", shown);
}

Json parts_json(const raster::TracedParts& parts) {
    Json out = Json::array();
    for (int k = 0; k < parts.count; ++k) {
        const TracedPart& part = parts.part[k];
        Json factors = Json::array();
        for (int i = 0; i < part.count; ++i) {
            const TracedFactor& f = part.factor[i];
            Json value = f.is_color ? Json{double(f.value[0]), double(f.value[1]), double(f.value[2])}
                                    : Json(double(f.value[0]));
            factors.push_back({{"factor", words_of(f).json}, {"value", std::move(value)}});
        }
        const Rgb product = product_of(part);
        out.push_back({{"term", terms[std::size_t(part.term)]},
                       {"layer", layers[std::size_t(part.layer)]},
                       {"factors", std::move(factors)},
                       {"value", {double(product[0]), double(product[1]), double(product[2])}}});
    }
    return out;
}

}  // namespace rakelight
