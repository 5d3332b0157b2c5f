// SPDX-License-Identifier: Apache-2.0
// Explained pixels of several samples: which triangle each sample shows, and their mean.
#include "tools/explain/explain.h"

#include <nlohmann/json.hpp>
#include "tools/shortest_digits.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

using raster::Fate;

std::string in_px(int sixteenths) { return digits(double(sixteenths) / 16); }

char letter_of(Fate fate) {
    switch (fate) {
        case Fate::visible:
            return 'V';
        case Fate::blended:
            return 'B';
        case Fate::masked_out:
            return 'M';
        case Fate::hidden:
            return 'H';
        case Fate::culled_back:
        case Fate::culled_front:
            return 'C';
    }
    return ' ';
}

}  // namespace

std::string letters_of_samples(const ExplainedPixel& e, const raster::CoveringTriangle& triangle) {
    std::string letters(e.pixel.samples.size(), '-');
    for (const raster::CoveredSample& s : triangle.samples) letters[std::size_t(s.sample)] = letter_of(s.fate);
    return letters;
}

std::string shaded_at_text(const raster::ShadedLayer& layer) {
    std::string text = "  shaded once for sample";
    if (layer.samples.size() > 1) text += "s";
    for (const raster::LaidSample& s : layer.samples) text += " " + digits(s.sample);
    if (layer.place.x == 0 && layer.place.y == 0) return text + ", at the pixel's center\n";
    return text + ", " + digits(layer.place.x) + ", " + digits(layer.place.y) + " px from the pixel's center\n";
}

std::string samples_text(const ExplainedPixel& e) {
    TextTable table({">sample", ">x [px]", ">y [px]", "shows", ">red", ">green", ">blue", ">alpha"});
    const auto add = [&table](std::vector<std::string> cells, vec4 c) {
        for (const float v : {c.x, c.y, c.z, c.w}) cells.push_back(digits(v));
        table.add(std::move(cells));
    };
    for (std::size_t k = 0; k < e.pixel.samples.size(); ++k) {
        const raster::SeenSample& s = e.pixel.samples[k];
        add({digits(k), in_px(s.at.x), in_px(s.at.y),
             s.triangle == SIZE_MAX ? "background" : "triangle " + digits(s.triangle)},
            s.color);
    }
    add({"mean", "", "", "= the pixel"}, e.pixel.sum);
    return "\nThe samples after all layers are blended, from the pixel's center, y down; their mean in linear light, "
           "each weighted by its alpha\n" +
           table.text("  ");
}

Json samples_json(const ExplainedPixel& e) {
    Json out = Json::array();
    for (const raster::SeenSample& s : e.pixel.samples)
        out.push_back({{"x", double(s.at.x) / 16},
                       {"y", double(s.at.y) / 16},
                       {"triangle", s.triangle == SIZE_MAX ? Json() : Json(s.triangle)},
                       {"color", {double(s.color.x), double(s.color.y), double(s.color.z), double(s.color.w)}}});
    return out;
}

}  // namespace rakelight
