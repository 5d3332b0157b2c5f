// SPDX-License-Identifier: Apache-2.0
#include <rakelight/bake/bake.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "math/color.h"

namespace rakelight {
namespace {

/// A map's value scaled to 0..1 for integer pictures, or unchanged for float pictures.
class Coding {
public:
    Coding(const BakeResult& result, const BakedMap& map, const BakeOptions& options, bool is_float) {
        if (map.map == BakeMap::normal)
            scale_ = 0.5, offset_ = 0.5, turns_ = options.green_down && options.space == BakeSpace::tangent;
        if (is_float) return;
        is_color_ = map.map == BakeMap::light;
        if (map.map == BakeMap::height) scale_ = 0.5 / result.report.distance, offset_ = 0.5;
        if (map.map == BakeMap::curvature) scale_ = 0.5 * result.report.curvature_radius, offset_ = 0.5;
    }
    double operator()(float value, std::size_t channel) const {
        const double v = turns_ && channel == 1 ? -double(value) : double(value);
        return is_color_ ? double(srgb_from_linear(value)) : v * scale_ + offset_;
    }

private:
    double scale_ = 1, offset_ = 0;
    bool turns_ = false, is_color_ = false;
};

}  // namespace

Pixels picture_of(const BakeResult& result, const BakedMap& map, const BakeOptions& options, Component component,
                  Context& context) {
    Pixels pixels{.width = result.width, .height = result.height, .channels = map.channels, .component = component};
    pixels.is_linear = component == Component::f32 || map.map != BakeMap::light;
    pixels.charge = share(MemoryCharge(context.memory(), map.values.size() * size_of(component), "a baked map"));
    pixels.bytes.resize(map.values.size() * size_of(component));
    const Coding coding(result, map, options, component == Component::f32);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double value = coding(map.values[i], i % std::size_t(map.channels));
        std::byte* const to = &pixels.bytes[i * size_of(component)];
        const auto code = [&](double most) { return std::floor(std::clamp(value, 0.0, 1.0) * most + 0.5); };
        if (component == Component::f32) {
            const float v = float(value);
            std::memcpy(to, &v, sizeof v);
        } else if (component == Component::u16) {
            const auto v = std::uint16_t(code(65535));
            std::memcpy(to, &v, sizeof v);
        } else {
            *to = std::byte(std::uint8_t(code(255)));
        }
    }
    return pixels;
}

}  // namespace rakelight
