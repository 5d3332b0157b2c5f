// SPDX-License-Identifier: Apache-2.0
#include "pace.h"

#include <algorithm>
#include <cmath>

namespace rakelight::viewer {
namespace {

constexpr double coarsest = 1.0 / 16, unmeasured = 0.5;
constexpr double share_of_new = 0.5;  // of the running means: one slow picture among fast ones is no trend

double mean(double old, double now) { return old > 0 ? old + share_of_new * (now - old) : now; }

}  // namespace

void Pace::measured(double front_ms, double pixels_ms, double pixels) {
    if (!(pixels > 0)) return;
    front_ms_ = mean(front_ms_, std::max(front_ms, 1e-3));
    pixel_ms_ = mean(pixel_ms_, std::max(pixels_ms, 1e-3) / pixels);
}

double Pace::scale(double whole_pixels, double budget_ms) const {
    if (!(pixel_ms_ > 0) || !(whole_pixels > 0)) return unmeasured;
    const double left_ms = std::max(budget_ms - front_ms_, 0.5 * front_ms_);
    const double scale = std::sqrt(left_ms / (pixel_ms_ * whole_pixels));
    return std::clamp(scale, coarsest, 1.0);
}

bool Pace::allows(double whole_pixels, int samples, double budget_ms) const {
    return pixel_ms_ > 0 && front_ms_ + samples * pixel_ms_ * whole_pixels <= budget_ms;
}

}  // namespace rakelight::viewer
