// SPDX-License-Identifier: Apache-2.0
// The pictures of picture_metric_values.py, and what it found of their pairs.
#pragma once
#include <string>

#include "image/compare/display_picture.h"
#include "image_support.h"

namespace rakelight::test {

using PictureFormula = int (*)(int x, int y, int c);

inline int black(int, int, int) { return 0; }
inline int white(int, int, int) { return 255; }
inline int gray(int, int, int) { return 128; }
inline int gray_130(int, int, int) { return 130; }
inline int green(int, int, int c) { return c == 1 ? 255 : 0; }
inline int blue(int, int, int c) { return c == 2 ? 255 : 0; }
inline int noise_code(int x, int y, int c) { return int(noise(x, y, c) & 255); }
inline int other_noise(int x, int y, int c) { return int(noise(x + 100, y, c) & 255); }
inline int ramp(int x, int y, int c) { return 10 + 7 * x + 3 * y + 10 * c; }
inline int noisy_ramp(int x, int y, int c) { return ramp(x, y, c) + int(noise(x, y, c) % 9); }
inline int step(int x, int, int) { return x < 12 ? 60 : 190; }
inline int step_beside(int x, int, int) { return x < 13 ? 60 : 190; }
inline int dot(int x, int y, int) { return x == 11 && y == 9 ? 255 : 128; }
inline int checks(int x, int y, int) { return 255 * ((x ^ y) & 1); }

struct MetricValues {
    PictureFormula a, b;
    double pixels_per_degree, ssim, flip, flip_of_pixel;  ///< the last: at (12, 9)
    const char* name;
};

inline const std::vector<MetricValues>& metric_values() {
    static const std::vector<MetricValues> table = [] {
        constexpr PictureFormula noise = noise_code;
        return std::vector<MetricValues>{
#include "picture_metric_values.inc"
        };
    }();
    return table;
}

inline constexpr int metric_width = 24, metric_height = 19;

inline DisplayPicture display(PictureFormula formula, int width, int height, Context& context) {
    return to_display(picture_of<std::uint8_t>(width, height, 3, formula), context);
}

}  // namespace rakelight::test
