// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/path_film.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

double luminance(const dvec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

}  // namespace

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
    const double bright = luminance(color);
    s.count += 1;
    s.color = s.color + color, s.direct = s.direct + cast<double>(sample.direct);
    s.alpha += double(sample.alpha), s.luminance += bright, s.luminance_squares += bright * bright;
    s.squares = s.squares + color * color;
    if (guides_.empty()) return;
    guides_[pixel].albedo = guides_[pixel].albedo + sample.albedo;
    guides_[pixel].normal = guides_[pixel].normal + sample.normal;
    if (sample.normal == vec3{}) return;
    guides_[pixel].position = guides_[pixel].position + sample.position;
    guides_[pixel].count += 1;
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
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const Sums& s = sums_[i];
        const Guides& g = guides_[i];
        const double n = s.count;
        vec3 variance{};
        for (std::size_t c = 0; c < 3 && n > 1; ++c)
            variance[c] = float(std::max(s.squares[c] - s.color[c] * s.color[c] / n, 0.0) / (n - 1) / n);
        out.color.push_back(mean(i, s.color)), out.variance.push_back(variance);
        out.albedo.push_back(albedo(i)), out.normal.push_back(g.normal * (1 / float(n)));
        out.position.push_back(g.count > 0 ? g.position * (1 / g.count) : vec3{});
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
