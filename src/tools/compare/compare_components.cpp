// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare_components.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/convert.h"

namespace rakelight {
namespace {

bool has_alpha(const Pixels& p) { return p.channels == 2 || p.channels == 4; }

Pixels empty_like(const Pixels& from, int channels, Component component, Context& context) {
    Pixels to{from.width, from.height, channels, component, component == Component::f32, {}};
    const std::size_t bytes = to.row_bytes() * std::size_t(to.height);
    to.charge = share(MemoryCharge(context.memory(), bytes, "the picture with more channels"));
    to.bytes.resize(bytes);
    return to;
}

/// All of alpha: the largest code, or 1.
template <class T>
T opaque() {
    return std::is_integral_v<T> ? std::numeric_limits<T>::max() : T(1);
}

template <class T>
void expand(const std::byte* from, const Pixels& in, int channels, std::byte* to) {
    T source[4], out[4];
    std::memcpy(source, from, std::size_t(in.channels) * sizeof(T));
    const bool is_gray = in.channels < 3;
    for (int c = 0; c < 3; ++c) out[c] = source[is_gray ? 0 : c];
    out[3] = has_alpha(in) ? source[in.channels - 1] : opaque<T>();
    std::memcpy(to, out, std::size_t(channels) * sizeof(T));
}

/// As RGB or RGBA, components as they are.
Pixels with_channels(const Pixels& in, int channels, Context& context) {
    Pixels out = empty_like(in, channels, in.component, context);
    const std::size_t in_stride = std::size_t(in.channels) * size_of(in.component),
                      out_stride = std::size_t(channels) * size_of(in.component);
    context.parallel_for(std::size_t(in.height), [&](std::size_t y) {
        const std::byte* from = in.row(int(y));
        std::byte* to = out.row(int(y));
        for (int x = 0; x < in.width; ++x, from += in_stride, to += out_stride) switch (in.component) {
                case Component::u8:
                    expand<std::uint8_t>(from, in, channels, to);
                    break;
                case Component::u16:
                    expand<std::uint16_t>(from, in, channels, to);
                    break;
                case Component::f32:
                    expand<float>(from, in, channels, to);
                    break;
            }
    });
    return out;
}

/// sRGB codes as linear RGBA.
Pixels decoded_light(const Pixels& in, Context& context) {
    Pixels out = empty_like(in, 4, Component::f32, context);
    const MemoryCharge passing(context.memory(), out.bytes.size(), "the picture as linear light");
    const std::vector<vec4> light = to_rgba32f(in, ColorSpace::srgb, context);
    std::memcpy(out.bytes.data(), light.data(), out.bytes.size());
    return out;
}

}  // namespace

void make_comparable(Pixels& a, Pixels& b, Context& context) {
    if ((a.component == Component::f32) != (b.component == Component::f32)) {
        Pixels& codes = a.component == Component::f32 ? b : a;
        codes = decoded_light(codes, context);
    }
    if (a.channels == b.channels) return;
    const int channels = has_alpha(a) || has_alpha(b) ? 4 : 3;
    for (Pixels* p : {&a, &b})
        if (p->channels != channels) *p = with_channels(*p, channels, context);
}

}  // namespace rakelight
