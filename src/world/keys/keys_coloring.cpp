// SPDX-License-Identifier: Apache-2.0
// Keys of coloring by vertex attributes.
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

constexpr Word<ColorMap> map_words[] = {{"viridis", ColorMap::viridis}, {"magma", ColorMap::magma},
                                        {"inferno", ColorMap::inferno}, {"plasma", ColorMap::plasma},
                                        {"turbo", ColorMap::turbo},     {"coolwarm", ColorMap::coolwarm},
                                        {"gray", ColorMap::gray}};
constexpr int length = -1;  ///< magnitude instead of a component

void read_scalars(PictureRequest& r, Words w) {
    if (w[0].empty()) throw values::wrong("scalars", "needs the name of an array");
    r.coloring.is_on = true;
    r.coloring.array = w[0];
}

Written write_scalars(const PictureRequest& r) {
    return r.coloring.is_on && !r.coloring.array.empty() ? Written{r.coloring.array} : Written{};
}

void read_component(PictureRequest& r, Words w) {
    const int number = values::integer("coloring-component", w[0], length, 15);
    r.coloring.component = number == length ? std::nullopt : std::optional(number);
}

void read_range(PictureRequest& r, Words w) {
    const std::vector<double> ends = values::numbers("coloring-range", w[0], 2);
    if (!(ends[0] < ends[1])) throw values::wrong("coloring-range", "must go from the smaller to the larger number");
    r.coloring.range = dvec2{ends[0], ends[1]};
}

constexpr RenderKey table_of_coloring[] = {
    {"scalar-coloring", Kind::flag,
     [](PictureRequest& r, Words w) { r.coloring.is_on = r.coloring.is_on || w[0] == "on"; },
     [](const PictureRequest& r) -> Written {
         return r.coloring.is_on && r.coloring.array.empty() ? Written{"on"} : Written{};
     }},
    {"scalars", Kind::value, read_scalars, write_scalars},
    {"coloring-component", Kind::value, read_component,
     RL_WRITE(r.coloring.component, {std::to_string(*r.coloring.component)})},
    {"coloring-range", Kind::value, read_range,
     RL_WRITE(r.coloring.range, {text_of(r.coloring.range->x) + "," + text_of(r.coloring.range->y)})},
    RL_WORD_KEY("colormap", r.coloring.map, map_words),
    RL_KEY("bar", flag, r.coloring.has_bar, w[0] == "on", {"on"}),
};

}  // namespace

constinit const KeyTable coloring_keys = table_of_coloring;

}  // namespace rakelight::keys
