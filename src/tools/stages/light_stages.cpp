// SPDX-License-Identifier: Apache-2.0
// What the sum of a pixel is made of: the relief that textures are read in, the terms of lights, surroundings and fog.
#include <algorithm>
#include <cmath>

#include "tools/material_names.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

/// Mean and largest value of a term over the pixels that show something.
Cell::List totals(const Sources& of, const std::vector<vec3>& term) {
    dvec3 sum{}, most{};
    std::uint64_t n = 0;
    for (std::size_t p = 0; p < term.size(); ++p) {
        if (!of.pixels.shows(p)) continue;
        const dvec3 v = {double(term[p].x), double(term[p].y), double(term[p].z)};
        sum = sum + v;
        most = {std::max(most.x, v.x), std::max(most.y, v.y), std::max(most.z, v.z)};
        ++n;
    }
    const double scale = n > 0 ? 1.0 / double(n) : 0;
    return {sum.x * scale, sum.y * scale, sum.z * scale, most.x, most.y, most.z};
}

bool is_black(const std::vector<vec3>& term) {
    return std::all_of(term.begin(), term.end(), [](vec3 v) { return v.x == 0 && v.y == 0 && v.z == 0; });
}

/// A row, and a picture where there is something to see.
void add_term(Stage& s, const Sources& of, const std::string& name, const std::string& file,
              const std::vector<vec3>& term) {
    Cell::List row = {name};
    for (const Cell& v : totals(of, term)) row.push_back(v);
    s.rows.push_back(std::move(row));
    if (is_black(term)) return;
    s.pictures.push_back(
        {file, name, paint(of, [&](std::size_t p) { return of.pixels.shows(p) ? exposed(of, term[p]) : backdrop; })});
}

void add_lights(Stage& s, const Sources& of) {
    for (std::size_t i = 0; i < of.pixels.lights.size(); ++i) {
        const raster::TermPictures& t = of.pixels.lights[i];
        const Light& light = of.engine.list().scene.lights[i];
        const std::string number = std::to_string(i), name = "Light " + number_and_name(light, i) + ": ";
        add_term(s, of, name + "ambient", "light-" + number + "-ambient", t.ambient);
        add_term(s, of, name + "diffuse", "light-" + number + "-diffuse", t.diffuse);
        add_term(s, of, name + "specular", "light-" + number + "-specular", t.specular);
    }
    if (of.pixels.other_lights.empty()) return;
    const std::string first = std::to_string(of.pixels.lights.size()),
                      last = std::to_string(of.engine.lights().size() - 1);
    add_term(s, of, "Lights " + first + " to " + last + ", all terms", "other-lights", of.pixels.other_lights);
}

std::string lighting_text(const Sources& of) {
    std::string text =
        "Each light adds an ambient term (k ambient times its color), a diffuse one (k diffuse, its color, the "
        "cosine n.l) and a specular one (k specular, its color, the lobe). ";
    if (!of.pixels.seen.empty())
        text += "In shadow the last two are multiplied by the fraction of the light that arrives. ";
    if (!of.pixels.around_diffuse.empty()) text += "The environment adds its diffuse and its glossy reflection. ";
    if (!of.pixels.transmitted.empty())
        text += "Transmissive surfaces add the opaque surfaces that are seen through them. ";
    if (!of.pixels.fog.empty())
        text +=
            "Fog lies between all surfaces and the eye: each term is what is seen of it through the fog, and the fog's "
            "own light fills the rest. ";
    text +=
        "The pixel is their sum, with the emission and the own color of unlit surfaces. Where blended surfaces are "
        "laid over, a term is its contribution to the picture: a layer's own counts by its alpha, those behind by what "
        "the layer transmits. Terms that are black everywhere have no picture.";
    if (of.tone.exposure_ev != 0 || of.tone.mapping != ToneMapping::none)
        text += " The pictures have the exposure and no tone curve, so that they add up; the numbers have neither.";
    if (of.engine.settings().shading == Shading::flat || of.engine.settings().shading == Shading::gouraud)
        text +=
            " Here lighting is evaluated once a face or vertex: what is interpolated from there is multiplied by the "
            "pixel's own k.";
    return text;
}

Stage make_lighting_stage(const Sources& of) {
    Stage s{.id = "lighting", .title = "Lighting, term by term", .text = lighting_text(of)};
    s.columns = {"term", "mean red", "mean green", "mean blue", "largest red", "largest green", "largest blue"};
    if (!is_black(of.pixels.own_color))
        add_term(s, of, "Own color of unlit surfaces, and of the background behind layers", "own-color",
                 of.pixels.own_color);
    add_term(s, of, "Emission", "emission", of.pixels.emission);
    add_lights(s, of);
    if (!of.pixels.around_diffuse.empty()) {
        add_term(s, of, "Surroundings: diffuse", "surroundings-diffuse", of.pixels.around_diffuse);
        add_term(s, of, "Surroundings: specular", "surroundings-specular", of.pixels.around_specular);
    }
    if (!of.pixels.transmitted.empty())
        add_term(s, of, "Transmitted from behind", "transmitted", of.pixels.transmitted);
    const std::size_t all = of.engine.lights().size();
    s.numbers["lights"] = all;
    if (all > of.pixels.lights.size()) s.numbers["lights shown"] = of.pixels.lights.size();
    s.rows_note = "Linear values over the pixels that show a surface";
    if (of.pixels.fog.empty()) return s;
    add_term(s, of, "Fog", "fog", of.pixels.fog);
    double sum = 0;
    std::uint64_t n = 0;
    for (std::size_t p = 0; p < of.pixels.fog_share.size(); ++p)
        if (of.pixels.draw[p] != no_index) sum += double(of.pixels.fog_share[p]), ++n;
    s.numbers["fraction seen through the fog, mean of opaque pixels"] = n > 0 ? sum / double(n) : 1.0;
    s.pictures.push_back({"fog-share",
                          "How much of the visible surface is seen through the fog: black nothing, white all.",
                          paint(of, [&](std::size_t p) {
                              return of.pixels.draw[p] == no_index ? backdrop : gray(double(of.pixels.fog_share[p]));
                          })});
    return s;
}

Stage make_relief_stage(const Sources& of) {
    Stage s{.id = "relief", .title = "Relief: where textures are read"};
    s.text =
        "Parallax techniques treat the surface as a relief of its height map: the view ray is followed to where it "
        "hits the relief, and all textures are read there instead of at the point of the polygon. Only the texture "
        "coordinates move: outlines and depth stay those of the polygon.";
    const std::vector<vec2>& shift = of.pixels.relief_shift;
    const auto length_of = [&](std::size_t p) {
        const double x = double(shift[p].x), y = double(shift[p].y);
        return std::sqrt(x * x + y * y);
    };
    double most = 0, sum = 0;
    std::uint64_t n = 0;
    for (std::size_t p = 0; p < shift.size(); ++p) {
        if (of.pixels.relief_height[p] < 0) continue;
        most = std::max(most, length_of(p)), sum += length_of(p), ++n;
    }
    s.numbers = {{"pixels in a relief", n},
                 {"mean shift [widths of the texture]", n > 0 ? sum / double(n) : 0.0},
                 {"largest shift [widths of the texture]", most}};
    s.pictures.push_back({"relief-shift",
                          "How far the coordinates move: blue little, over green and yellow to white " + digits(most) +
                              " widths of the texture.",
                          paint(of, [&](std::size_t p) {
                              return of.pixels.relief_height[p] < 0 ? backdrop
                                                                    : heat(most > 0 ? length_of(p) / most : 0);
                          })});
    s.pictures.push_back({"relief-height", "The height that the ray hits, as in the map: black 0, white 1.",
                          paint(of, [&](std::size_t p) {
                              const float height = of.pixels.relief_height[p];
                              return height < 0 ? backdrop : gray(double(height));
                          })});
    return s;
}

bool has_relief(const Sources& of) { return !of.pixels.relief_shift.empty(); }

}  // namespace

constinit const StageKind relief_stage{make_relief_stage, has_relief}, lighting_stage{make_lighting_stage};

}  // namespace rakelight::stages
