// SPDX-License-Identifier: Apache-2.0
// Colors as columns of numbers have them, of vertices and of faces: which column is which component, and the range they are written in.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rakelight/base/report.h>
#include <rakelight/math/vector.h>

#include "math/color.h"

namespace rakelight::io {

/// The range that numbers of a color are written in: as the column's type has it, or by what they are.
enum class ColorScale : std::uint8_t { unit, bytes, words, by_value };

/// 1, 255 or 65535; of by_value 1.
constexpr float largest_of(ColorScale scale) {
    return scale == ColorScale::bytes ? 255.0f : scale == ColorScale::words ? 65535.0f : 1.0f;
}

/// 0 red to 3 alpha, of "red", "diffuse_red", "r" and so on; case does not matter.
std::optional<std::size_t> color_component(std::string_view name);

class ColorColumns {
public:
    /// Takes the column of a component. @return false: there is one already
    bool take(std::size_t component, ColorScale scale);
    /// Colors that come from elsewhere, all of one range.
    void take_all(ColorScale scale);
    bool any() const { return has_[0] || has_[1] || has_[2] || has_[3]; }
    /// Reads colors whose range only their values tell: over 1 they are 0..255, over 255 0..65535.
    void look_at(const vec4& color) {
        for (std::size_t k = 0; k < 4; ++k)
            if (std::isfinite(color[k])) most_[k == 3] = std::max(most_[k == 3], color[k]);
    }
    bool is_by_value() const { return scale_ == ColorScale::by_value || alpha_scale_ == ColorScale::by_value; }
    /// Decides by what look_at() has seen, and reports it. @param of_what "vertex"
    void settle(const char* of_what, const std::string& path, Report& report);
    /// Linear, after settle(). What is not finite or out of range is clamped; without a column of a color it is white, and alpha 1.
    vec4 linear(const vec4& c) const {
        const float alpha = has_[3] ? c.w * (1 / largest_of(alpha_scale_)) : 1;
        const bool is_colored = has_[0] || has_[1] || has_[2];
        const vec3 color = is_colored ? vec3{linear(c.x), linear(c.y), linear(c.z)} : vec3{1, 1, 1};
        return {color.x, color.y, color.z, alpha >= 0 && alpha <= 1 ? alpha : 1.0f};
    }

private:
    float linear(float v) const {
        if (!(v > 0)) return 0.0f;
        return scale_ == ColorScale::bytes && v <= 255 && v == std::floor(v)
                   ? linear_from_srgb8(std::uint8_t(v))
                   : linear_from_srgb(std::min(v * (1 / largest_of(scale_)), 1.0f));
    }

    bool has_[4] = {false, false, false, false};
    ColorScale scale_ = ColorScale::by_value, alpha_scale_ = ColorScale::by_value;
    float most_[2] = {0, 0};  ///< of the colors, of alpha
};

}  // namespace rakelight::io
