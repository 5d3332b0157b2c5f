// SPDX-License-Identifier: Apache-2.0
#include "image/compare/ssim.h"

#include <array>

#include "base/assert.h"
#include "image/compare/picture_windows.h"
#include "math/functions.h"

namespace rakelight {
namespace {

constexpr int side = 11;  ///< [px] of the window
using Kernel = std::array<double, side>;

Kernel gaussian_kernel() {
    constexpr double sigma = 1.5;
    Kernel kernel{};
    double sum = 0;
    for (int i = 0; i < side; ++i) {
        const double x = i - side / 2;
        sum += kernel[std::size_t(i)] = math::exp(-x * x / (2 * sigma * sigma));
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

/// 0..1
double luma(std::uint32_t code) {
    return (0.299 * (code & 255) + 0.587 * (code >> 8 & 255) + 0.114 * (code >> 16 & 255)) / 255.0;
}

Plane<double> luma_of(const DisplayPicture& picture, const PictureWindow& w) {
    Plane<double> plane(w.width + side - 1, w.height + side - 1);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) plane.row(y)[x] = luma(picture.row(w.y + y)[w.x + x]);
    return plane;
}

Plane<double> product(const Plane<double>& a, const Plane<double>& b) {
    Plane<double> out(a.width, a.height);
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = a.values[i] * b.values[i];
    return out;
}

/// The sum of SSIM over the windows whose upper left pixels are those of `w`.
double ssim_sum(const DisplayPicture& a, const DisplayPicture& b, const PictureWindow& w, const Kernel& kernel) {
    if (equal_within(a, b, w.x, w.y, w.x + w.width + side - 1, w.y + w.height + side - 1))
        return double(w.width) * double(w.height);        // ones, the result of the following for equal pictures
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;  // (K1 L)^2, (K2 L)^2 with L = 1
    const auto mean = [&](const Plane<double>& plane) {
        return filter_columns<double>(filter_rows<double>(plane, kernel), kernel);
    };
    const Plane<double> x = luma_of(a, w), y = luma_of(b, w);
    const Plane<double> mean_x = mean(x), mean_y = mean(y);
    const Plane<double> mean_xx = mean(product(x, x)), mean_yy = mean(product(y, y)), mean_xy = mean(product(x, y));
    double sum = 0;
    for (std::size_t i = 0; i < mean_x.values.size(); ++i) {
        const double mx = mean_x.values[i], my = mean_y.values[i];
        const double xx = mean_xx.values[i] - mx * mx, yy = mean_yy.values[i] - my * my;
        const double xy = mean_xy.values[i] - mx * my;
        sum += (2 * mx * my + c1) * (2 * xy + c2) / ((mx * mx + my * my + c1) * (xx + yy + c2));
    }
    return sum;
}

}  // namespace

std::optional<double> mean_ssim(const DisplayPicture& a, const DisplayPicture& b, Context& context) {
    RL_ASSERT(a.width == b.width && a.height == b.height, "pictures of different size");
    if (a.width < side || a.height < side) return std::nullopt;
    const Kernel kernel = gaussian_kernel();
    const int width = a.width - side + 1, height = a.height - side + 1;
    const double sum =
        sum_over_windows(width, height, context, [&](const PictureWindow& w) { return ssim_sum(a, b, w, kernel); });
    return sum / (double(width) * double(height));
}

}  // namespace rakelight
