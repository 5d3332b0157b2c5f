// SPDX-License-Identifier: Apache-2.0
#include "io/color_columns.h"

#include <rakelight/scene/words.h>

#include "base/format_text.h"

namespace rakelight::io {
namespace {

constexpr std::string_view names[][3] = {
    {"red", "diffuse_red", "r"},
    {"green", "diffuse_green", "g"},
    {"blue", "diffuse_blue", "b"},
    {"alpha", "diffuse_alpha", "a"},
};

ColorScale range_of(float most) {
    return most > 255 ? ColorScale::words : most > 1 ? ColorScale::bytes : ColorScale::unit;
}

}  // namespace

std::optional<std::size_t> color_component(std::string_view name) {
    for (std::size_t c = 0; c < 4; ++c)
        for (const std::string_view known : names[c])
            if (same_word(known, name)) return c;
    return {};
}

bool ColorColumns::take(std::size_t component, ColorScale scale) {
    if (has_[component]) return false;
    has_[component] = true;
    (component == 3 ? alpha_scale_ : scale_) = scale;
    return true;
}

void ColorColumns::take_all(ColorScale scale) {
    scale_ = alpha_scale_ = scale;
    for (bool& has : has_) has = true;
}

void ColorColumns::settle(const char* of_what, const std::string& path, Report& report) {
    if (alpha_scale_ == ColorScale::by_value) alpha_scale_ = has_[3] ? range_of(most_[1]) : ColorScale::unit;
    if (scale_ != ColorScale::by_value) return;
    scale_ = range_of(most_[0]);
    if (scale_ != ColorScale::unit)
        report.add(Remark::guessed, path, "",
                   format_text("{} colors over 1 were read as 0..{}", of_what, int(largest_of(scale_))));
}

}  // namespace rakelight::io
