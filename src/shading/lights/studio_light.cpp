// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/studio_light.h"

#include <bit>
#include <cstdint>
#include <iterator>
#include <span>

namespace rakelight::shading {
namespace {

#include "studio_light.inc"

static_assert(std::size(sizes) == environment_levels, "one map a level");

vec3 gray(std::uint32_t bits) {
    const float value = std::bit_cast<float>(bits);
    return {value, value, value};
}

}  // namespace

EnvironmentLight studio_light(Context& context) {
    EnvironmentLight light;
    for (std::size_t i = 0; i < light.irradiance.size(); ++i) light.irradiance[i] = gray(irradiance[i]);
    if (!has_sharpest)
        light.mirrored.push_back(sharp_map(make_mip_chain(studio_panorama(), ColorSpace::linear, context), context));
    const std::uint32_t* texel = texels;
    for (const int size : std::span(sizes).subspan(light.mirrored.size())) {
        OctahedralMap map{size, std::vector<vec3>(std::size_t(size) * std::size_t(size))};
        for (vec3& t : map.texels) t = gray(*texel++);
        light.mirrored.push_back(std::move(map));
    }
    return light;
}

}  // namespace rakelight::shading
