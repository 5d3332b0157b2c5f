// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_film.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::raytrace {
PathFilm::PathFilm(const Window& window, bool guides, Context& context) : window_(window) {
    const std::size_t pixels = std::size_t(window.width) * std::size_t(window.height);
    charge_ = MemoryCharge(context.memory(), pixels * (sizeof(Sums) + (guides ? sizeof(Guides) : 0)), "paths");
    sums_.resize(pixels);
    if (guides) guides_.resize(pixels);
}

void PathFilm::add(int x, int y, const PathSample& sample) {
    const std::size_t pixel = pixel_at(x, y);
    Sums& s = sums_[pixel];
    const dvec3 color = cast<double>(sample.color);
    const double bright = shading::luminance_of(color);
    s.count += 1;
    s.color = s.color + color, s.direct = s.direct + cast<double>(sample.direct);
    s.alpha += double(sample.alpha), s.luminance += bright, s.luminance_squares += bright * bright;
    s.squares = s.squares + color * color;
    if (guides_.empty()) return;
    Guides& g = guides_[pixel];
    const auto go_towards = [](vec3& mean, vec3 value, float count) { mean = mean + (value - mean) * (1 / count); };
    go_towards(g.albedo, sample.albedo, float(s.count)), go_towards(g.normal, sample.normal, float(s.count));
    if (sample.normal == vec3{}) return;
    g.count += 1;
    go_towards(g.position, sample.position, g.count);
}

vec3 PathFilm::mean(std::size_t pixel, const dvec3& sum) const { return cast<float>(sum * (1 / sums_[pixel].count)); }

float PathFilm::per_alpha(std::size_t pixel) const {
    const double alpha = sums_[pixel].alpha;
    return alpha > 0 ? float(sums_[pixel].count / alpha) : 1.0f;
}

vec4 PathFilm::color(std::size_t pixel, vec4 background) const {
    const auto alpha = float(sums_[pixel].alpha / sums_[pixel].count);
    const vec3 sum = replaced_.empty() ? mean(pixel, sums_[pixel].color) : replaced_[pixel];
    const vec3 own = alpha > 0 ? sum * per_alpha(pixel) : background.xyz();
    return {own.x, own.y, own.z, alpha};
}

vec3 PathFilm::indirect(std::size_t pixel) const {
    return mean(pixel, sums_[pixel].color - sums_[pixel].direct) * per_alpha(pixel);
}

float PathFilm::variance(std::size_t pixel) const {
    const Sums& s = sums_[pixel];
    const double n = s.count;
    if (n < 2) return 0;
    const double spread = std::max(s.luminance_squares - s.luminance * s.luminance / n, 0.0) / (n - 1);
    return float(spread / n);
}

PathFilm::Guided PathFilm::guided() const {
    Guided out;
    for (auto* const numbers : {&out.color, &out.variance, &out.albedo, &out.normal, &out.position})
        numbers->reserve(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const Sums& s = sums_[i];
        const Guides& g = guides_[i];
        const double n = s.count;
        vec3 variance{};
        for (std::size_t c = 0; c < 3 && n > 1; ++c)
            variance[c] = float(std::max(s.squares[c] - s.color[c] * s.color[c] / n, 0.0) / (n - 1) / n);
        out.color.push_back(mean(i, s.color)), out.variance.push_back(variance);
        out.albedo.push_back(g.albedo), out.normal.push_back(g.normal), out.position.push_back(g.position);
    }
    return out;
}

double PathFilm::noise() const {
    double error = 0, bright = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        error += std::sqrt(double(variance(i)));
        bright += sums_[i].luminance / std::max(sums_[i].count, 1.0);
    }
    return bright > 0 ? error / bright : 0;
}

}  // namespace rakelight::raytrace
