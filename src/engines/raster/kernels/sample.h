// SPDX-License-Identifier: Apache-2.0
// Texture sampling: wrap modes, nearest / bilinear / trilinear filtering, level of detail from analytic derivatives.
// Texels are decoded to linear before they are filtered. Per instruction set.
#pragma once
#include "engines/raster/kernels/interpolate.h"

namespace rakelight::raster::RL_ISA {

/// One level of a texture, which may differ from lane to lane.
struct Level {
    integer offset, width, height;
};

inline Level level_at(const TextureView& t, integer number) {
    const int32_t first = lane(number, 0);  // lanes are mostly of one level
    if (all_lanes(number == integer(first))) return {integer(t.offset[first]), integer(t.width[first]), integer(t.height[first])};
    return {gather_i(t.offset, number), gather_i(t.width, number), gather_i(t.height, number)};
}

/// A texel before the scale of the texture: filters are linear, so it is applied once, after them.
inline vec4 fetch(const TextureView& t, integer texel) {
    if (t.rgba32f != nullptr) {
        const integer i = texel << 2;
        return vec4(gather(t.rgba32f, i), gather(t.rgba32f + 1, i), gather(t.rgba32f + 2, i), gather(t.rgba32f + 3, i));
    }
    const integer rgba = gather_i(t.rgba8, texel), byte = integer(255);
    const integer r = rgba & byte, g = (rgba >> 8) & byte, b = (rgba >> 16) & byte;
    const real alpha = to_real((rgba >> 24) & byte);
    if (t.decode == nullptr) return vec4(to_real(r), to_real(g), to_real(b), alpha);
    return vec4(gather(t.decode, r), gather(t.decode, g), gather(t.decode, b), alpha);
}
inline vec4 scaled(const TextureView& t, vec4 v) {
    if (t.rgba32f != nullptr) return v;
    const real by_code(1.0f / 255.0f), rgb = t.decode == nullptr ? by_code : real(1.0f);
    return vec4(v.x * rgb, v.y * rgb, v.z * rgb, v.w * by_code);
}

/// Texture coordinate -> 0..1 by the wrap mode; not finite and huge values give something in range.
inline real wrap_coordinate(real u, int mode) {
    if (mode == 0) return clamp(fract(u), real(0.0f), real(1.0f));
    if (mode == 1) {
        const real folded = abs(u - real(2.0f) * floor(u * real(0.5f) + real(0.5f)));  // triangle wave, period 2
        return clamp(folded, real(0.0f), real(1.0f));
    }
    return clamp(u, real(0.0f), real(1.0f));
}

/// Texel number -> 0..size-1, for numbers at most one out of range.
inline integer wrap_texel(integer i, integer size, int mode) {
    if (mode != 0) return clamp(i, integer(0), size - integer(1));
    const integer up = select(i < integer(0), i + size, i);
    return max(select(up >= size, up - size, up), integer(0));
}

inline vec4 sample_nearest(const TextureView& t, const Level& level, vec2 uv) {
    const real u = wrap_coordinate(uv.x, t.wrap_u), v = wrap_coordinate(uv.y, t.wrap_v);
    const integer x = clamp(to_int(u * to_real(level.width)), integer(0), level.width - integer(1));
    const integer y = clamp(to_int(v * to_real(level.height)), integer(0), level.height - integer(1));
    return fetch(t, level.offset + y * level.width + x);
}

inline vec4 sample_bilinear(const TextureView& t, const Level& level, vec2 uv) {
    const real x = wrap_coordinate(uv.x, t.wrap_u) * to_real(level.width) - real(0.5f);
    const real y = wrap_coordinate(uv.y, t.wrap_v) * to_real(level.height) - real(0.5f);
    const real x_floor = floor(x), y_floor = floor(y);
    const integer xi = to_int(x_floor), yi = to_int(y_floor);
    const integer x0 = wrap_texel(xi, level.width, t.wrap_u), x1 = wrap_texel(xi + integer(1), level.width, t.wrap_u);
    const integer row0 = level.offset + wrap_texel(yi, level.height, t.wrap_v) * level.width;
    const integer row1 = level.offset + wrap_texel(yi + integer(1), level.height, t.wrap_v) * level.width;
    const vec4 top = mix(fetch(t, row0 + x0), fetch(t, row0 + x1), x - x_floor);
    const vec4 bottom = mix(fetch(t, row1 + x0), fetch(t, row1 + x1), x - x_floor);
    return mix(top, bottom, y - y_floor);
}

inline vec4 sample_level(const TextureView& t, integer number, vec2 uv, bool linear) {
    const Level level = level_at(t, number);
    return linear ? sample_bilinear(t, level, uv) : sample_nearest(t, level, uv);
}

/// Level of detail: log2 of the longer side of the pixel's footprint in texels (OpenGL 3.3 core, eq. 3.17 and 3.18, with the
/// maximum of the two lengths).
inline real level_of_detail(const TextureView& t, const TexCoords& c) {
    const real w = real(float(t.width[0])), h = real(float(t.height[0]));
    const real ux = c.dx.x * w, vx = c.dx.y * h, uy = c.dy.x * w, vy = c.dy.y * h;
    const real squared = max(ux * ux + vx * vx, uy * uy + vy * vy);
    return real(0.5f) * log2(squared);
}

/// A slot's texture at transformed coordinates.
inline vec4 sample(const TextureSlot& slot, const TexCoords& raw) {
    const TextureView& t = *slot.view;
    const auto turn = [&slot](vec2 d) {
        return vec2(real(slot.uu) * d.x + real(slot.uv) * d.y, real(slot.vu) * d.x + real(slot.vv) * d.y);
    };
    const TexCoords c = {turn(raw.uv) + vec2(real(slot.u0), real(slot.v0)), turn(raw.dx), turn(raw.dy)};
    const real lod = level_of_detail(t, c);
    const mask is_minified = lod > real(0.0f);
    const bool one_filter = t.magnify_linear == t.minify_linear;
    vec4 result;
    if (t.mip == 0 || t.levels == 1 || no_lane(is_minified)) {
        result = sample_level(t, integer(0), c.uv, t.minify_linear != 0);
    } else {
        const real level = clamp(lod, real(0.0f), real(float(t.levels - 1)));
        const integer lower = to_int(t.mip == 1 ? level + real(0.5f) : level);
        result = sample_level(t, lower, c.uv, t.minify_linear != 0);
        if (t.mip == 2) {
            const integer upper = min(lower + integer(1), integer(t.levels - 1));
            result = mix(result, sample_level(t, upper, c.uv, t.minify_linear != 0), level - to_real(lower));
        }
    }
    if (one_filter || all_lanes(is_minified)) return scaled(t, result);
    return scaled(t, select(is_minified, result, sample_level(t, integer(0), c.uv, t.magnify_linear != 0)));
}

}  // namespace rakelight::raster::RL_ISA
