// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/light_table.h"

#include <algorithm>

#include "engines/opengl/programs/programs.h"
#include "shading/lights/light_reach.h"

namespace rakelight::opengl {
namespace {

constexpr std::size_t most_exact = 1 << 24;  ///< whole numbers up to it are exact as floats

vec4 with(const float (&v)[3], float w) { return {v[0], v[1], v[2], w}; }

/// light_kind() of the text.
std::uint32_t kind_bits(const lighting::LightParameters& p) {
    return std::uint32_t(p.kind) | (p.is_photometric ? 4u : 0u) | (p.inverse_range > 0 ? 8u : 0u);
}

bool has_ambient(const lighting::LightParameters& p) {
    return !p.is_photometric && (p.ambient[0] != 0 || p.ambient[1] != 0 || p.ambient[2] != 0);
}

/// light_texels of one light, in the order of light_sample() and shadow_of().
void add_light(const lighting::LightParameters& p, const LightShadow* shadow, std::vector<vec4>& to) {
    to.push_back(with(p.position, float(kind_bits(p))));
    to.push_back(with(p.direction, 0));
    if (p.is_photometric)
        to.push_back({p.cone_scale, p.cone_offset, 0, p.inverse_range});
    else
        to.push_back({p.constant_term, p.linear_term, p.quadratic_term, p.inverse_range});
    to.push_back(with(p.is_photometric ? p.intensity : p.diffuse, 0));
    to.push_back(with(p.ambient, p.cos_cutoff));
    to.push_back(with(p.specular, p.exponent));
    const shading::ShadowFactors s = shadow ? shadow->factors : shading::ShadowFactors{};
    to.push_back({p.casts_shadow ? 1.0f : 0.0f, s.bias, shadow ? float(shadow->y) : 0.0f, 0});
    to.push_back({shadow ? float(shadow->x) : -1.0f, float(s.faces), float(s.is_orthographic), s.texels});
    for (const auto& row : s.to_light) to.push_back({row[0], row[1], row[2], row[3]});
}

}  // namespace

void LightTable::set(const std::vector<lighting::LightParameters>& lights, const std::vector<LightShadow>& shadows,
                     const shading::PictureCamera& view, Window pixels) {
    count_ = int(lights.size());
    texels_.clear();
    for (const lighting::LightParameters& p : lights)
        add_light(p, p.shadow >= 0 ? &shadows[std::size_t(p.shadow)] : nullptr, texels_);
    has_lists_ = false;
    std::fill(std::begin(counts_), std::end(counts_), 0);
    counts_[0] = count_;
    kinds_ = without_ambient_ = 0;
    if (are_near()) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            kinds_ |= kind_bits(lights[i]) << 4 * i;
            without_ambient_ |= (has_ambient(lights[i]) ? 0u : 1u) << i;
        }
        texels_.resize(std::size_t(most_near) * light_texels);
        return;
    }
    add_lists(lights, view, pixels);
    texels_.resize((texels_.size() + fetch_width - 1) / fetch_width * fetch_width);
    glActiveTexture(GL_TEXTURE0 + unit_lights);
    set_texels(texture_, GL_RGBA32F, GL_RGBA, GL_FLOAT, fetch_width, int(texels_.size() / fetch_width), texels_.data());
}

/// Texels (first, end) of each square, numbers of lights counted in quarters of texels; then the numbers, four a texel.
void LightTable::add_lists(const std::vector<lighting::LightParameters>& lights, const shading::PictureCamera& view,
                           Window pixels) {
    const shading::LightReach reach(lights);
    if (!reach.is_worth_it()) return;
    const int columns = (pixels.width + square - 1) / square, rows = (pixels.height + square - 1) / square;
    const std::size_t ranges = texels_.size(), first = ranges + std::size_t(columns) * std::size_t(rows);
    texels_.resize(first);
    std::vector<float> numbers;
    std::vector<std::uint32_t> list;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            reach.in_square(view, pixels.x + c * square, pixels.y + r * square, square, list);
            const float begin = float(4 * first + numbers.size());
            numbers.insert(numbers.end(), list.begin(), list.end());
            texels_[ranges + std::size_t(r * columns + c)] = {begin, float(4 * first + numbers.size()), 0, 0};
        }
    if (4 * first + numbers.size() > most_exact) return texels_.resize(ranges);
    has_lists_ = true;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        const auto at = [&](std::size_t k) { return i + k < numbers.size() ? numbers[i + k] : 0.0f; };
        texels_.push_back({at(0), at(1), at(2), at(3)});
    }
    counts_[1] = columns, counts_[2] = square, counts_[3] = std::int32_t(ranges);
}

void LightTable::bind() const {
    glActiveTexture(GL_TEXTURE0 + unit_lights);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace rakelight::opengl
