// SPDX-License-Identifier: Apache-2.0
#include "io/import/texture_placement.h"

#include <cmath>

#include "math/functions.h"

namespace rakelight::io {
namespace {

/// outer after inner
TextureAffine after(const TextureAffine& o, const TextureAffine& i) {
    return {o.a * i.a + o.b * i.d, o.a * i.b + o.b * i.e, o.a * i.c + o.b * i.f + o.c,
            o.d * i.a + o.e * i.d, o.d * i.b + o.e * i.e, o.d * i.c + o.e * i.f + o.f};
}

TextureAffine moved(double u, double v) { return {1, 0, u, 0, 1, v}; }

TextureAffine turned(double rad) {  // counter-clockwise where v points up
    const double c = math::cos(rad), s = math::sin(rad);
    return {c, -s, 0, s, c, 0};
}

}  // namespace

TextureAffine placement_of(const import_stream::TextureLink& link) {
    const TextureAffine flip{1, 0, 0, 0, -1, 1};
    const TextureAffine scaled{link.scale[0], 0, 0, 0, link.scale[1], 0};
    TextureAffine map;
    if (link.placement == std::uint32_t(import_stream::Placement::max)) {
        // 3ds Max moves, tiles and turns the *picture* about (0.5, 0.5), so coordinates go the other way (tiling shrinks it).
        const TextureAffine centered = moved(-0.5 - link.offset[0], -0.5 - link.offset[1]);
        map = after(moved(0.5, 0.5), after(turned(-double(link.rotation_rad)), after(scaled, centered)));
    } else {
        const TextureAffine turn = after(moved(0.5, 0.5), after(turned(link.rotation_rad), moved(-0.5, -0.5)));
        map = after(moved(link.offset[0], link.offset[1]),
                    after(link.rotation_rad == 0 ? TextureAffine{} : turn, scaled));
    }
    return after(flip, after(map, flip));
}

std::optional<TextureTransform> as_transform(const TextureAffine& m) {
    const double sx = std::sqrt(m.a * m.a + m.d * m.d), sy_length = std::sqrt(m.b * m.b + m.e * m.e);
    if (!(std::fabs(m.a * m.b + m.d * m.e) <= 1e-6 * sx * sy_length) || !(sx > 0)) return std::nullopt;
    // KHR_texture_transform: columns (cos, -sin) * sx and (sin, cos) * sy.
    const double cosine = m.a / sx, sine = -m.d / sx;
    TextureTransform t;
    t.offset = {float(m.c), float(m.f)};
    t.scale = {float(sx), float(m.b * sine + m.e * cosine)};
    t.rotation_rad = float(math::atan2(sine, cosine));
    return t;
}

}  // namespace rakelight::io
