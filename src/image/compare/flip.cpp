// SPDX-License-Identifier: Apache-2.0
#include "image/compare/flip.h"

#include <cmath>

#include "base/assert.h"
#include "image/compare/flip_color.h"
#include "image/compare/flip_kernels.h"
#include "image/compare/picture_windows.h"
#include "math/color.h"
#include "math/functions.h"

namespace rakelight {
namespace {

using flip::ContrastKernels;
using flip::FeatureKernels;
using Values =
    Plane<double>;  ///< double, because the square root of a feature difference amplifies noise of 1e-7 to 3e-4

/// A window of a picture with a margin, in the opponent color space of the filters.
struct Opponent {
    Values y, cx, cz;
};

Opponent opponent_of(const DisplayPicture& picture, const PictureWindow& w, int margin) {
    const int width = w.width + 2 * margin, height = w.height + 2 * margin;
    Opponent out{{width, height}, {width, height}, {width, height}};
    for (int y = 0; y < height; ++y) {
        const std::uint32_t* const row = picture.row(std::clamp(w.y + y - margin, 0, picture.height - 1));
        for (int x = 0; x < width; ++x) {
            const std::uint32_t code = row[std::clamp(w.x + x - margin, 0, picture.width - 1)];
            const auto light = [&](int shift) { return double(linear_from_srgb8(std::uint8_t(code >> shift))); };
            const dvec3 o = flip::opponent_from_linear({light(0), light(8), light(16)});
            out.y.row(y)[x] = o.x, out.cx.row(y)[x] = o.y, out.cz.row(y)[x] = o.z;
        }
    }
    return out;
}

/// The same plane without the outermost pixels.
Values inner(const Values& plane, int margin) {
    Values out(plane.width - 2 * margin, plane.height - 2 * margin);
    for (int y = 0; y < out.height; ++y) std::copy_n(plane.row(y + margin) + margin, out.width, out.row(y));
    return out;
}

Values filtered(const Values& in, std::span<const double> along_row, std::span<const double> along_column) {
    return filter_columns<double>(filter_rows<double>(in, along_row), along_column);
}

/// The colors filtered by the contrast sensitivity of the eye, in CIELab.
struct SeenColors {
    Values y, cx, cz;
    dvec3 lab(std::size_t i) const { return flip::lab_of_opponent({y.values[i], cx.values[i], cz.values[i]}); }
};

SeenColors seen_colors(const Opponent& o, int margin, const ContrastKernels& k) {
    const int rest = margin - k.radius;
    const auto seen = [&](const Values& plane, const flip::Kernel& kernel) {
        return filtered(inner(plane, rest), kernel, kernel);
    };
    SeenColors out{seen(o.y, k.achromatic), seen(o.cx, k.red_green), seen(o.cz, k.blue_yellow[0])};
    const Values second = seen(o.cz, k.blue_yellow[1]);
    for (std::size_t i = 0; i < second.values.size(); ++i)
        out.cz.values[i] = k.blue_yellow_share[0] * out.cz.values[i] + k.blue_yellow_share[1] * second.values[i];
    return out;
}

/// Edge and point features of every pixel.
struct Features {
    Values edge, point;
};

Values length_of(Values x, const Values& y) {
    for (std::size_t i = 0; i < x.values.size(); ++i)
        x.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    return x;
}

Features features_of(const Values& y, int margin, const FeatureKernels& k) {
    const Values plane = inner(y, margin - k.radius);
    const Values across = filter_rows<double>(plane, k.gaussian);
    const auto down = [&](const Values& rows, const flip::Kernel& kernel) {
        return filter_columns<double>(rows, kernel);
    };
    return {length_of(down(filter_rows<double>(plane, k.edge), k.gaussian), down(across, k.edge)),
            length_of(down(filter_rows<double>(plane, k.point), k.gaussian), down(across, k.point))};
}

/// 0..1
double feature_error(const Features& a, const Features& b, std::size_t i) {
    const double edge = std::fabs(a.edge.values[i] - b.edge.values[i]);
    const double point = std::fabs(a.point.values[i] - b.point.values[i]);
    constexpr double root_half = 0.70710678118654752;
    return std::min(1.0, std::sqrt(root_half * std::max(edge, point)));
}

/// Feature differences amplify color differences.
double pixel_error(double color, double feature) {
    if (color == 0 || feature == 0) return color;
    return math::pow(color, 1 - feature);
}

/// The errors of one window.
Values errors(const DisplayPicture& a, const DisplayPicture& b, const PictureWindow& w, const ContrastKernels& contrast,
              const FeatureKernels& feature) {
    const int margin = std::max(contrast.radius, feature.radius);
    if (equal_within(a, b, w.x - margin, w.y - margin, w.x + w.width + margin, w.y + w.height + margin))
        return {w.width, w.height};  // the result of the following for equal pictures
    const Opponent in_a = opponent_of(a, w, margin), in_b = opponent_of(b, w, margin);
    const SeenColors seen_a = seen_colors(in_a, margin, contrast), seen_b = seen_colors(in_b, margin, contrast);
    const Features features_a = features_of(in_a.y, margin, feature), features_b = features_of(in_b.y, margin, feature);
    Values out(w.width, w.height);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] =
            pixel_error(flip::color_error(seen_a.lab(i), seen_b.lab(i)), feature_error(features_a, features_b, i));
    return out;
}

}  // namespace

double mean_flip(const DisplayPicture& a, const DisplayPicture& b, double pixels_per_degree, Context& context,
                 std::vector<float>* map) {
    RL_ASSERT(a.width == b.width && a.height == b.height, "pictures of different size");
    RL_ASSERT(pixels_per_degree >= flip_least_ppd && pixels_per_degree <= flip_most_ppd,
              "pixels per degree out of range");
    const std::size_t width = std::size_t(a.width), count = width * std::size_t(a.height);
    if (map) map->assign(count, 0);
    if (count == 0) return 0;
    const ContrastKernels contrast = flip::contrast_kernels(pixels_per_degree);
    const FeatureKernels feature = flip::feature_kernels(pixels_per_degree);
    const double sum = sum_over_windows(a.width, a.height, context, [&](const PictureWindow& w) {
        const Values part = errors(a, b, w, contrast, feature);
        double of_part = 0;
        for (const double e : part.values) of_part += e;
        for (int y = 0; map && y < part.height; ++y)
            std::transform(part.row(y), part.row(y) + part.width,
                           map->data() + std::size_t(w.y + y) * width + std::size_t(w.x),
                           [](double e) { return float(e); });
        return of_part;
    });
    return sum / double(count);
}

}  // namespace rakelight
