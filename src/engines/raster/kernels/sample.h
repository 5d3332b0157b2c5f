// SPDX-License-Identifier: Apache-2.0
// Texture sampling: wrap modes, nearest / bilinear / trilinear filtering, level of detail from analytic derivatives.
// Where to read (Footprint) is apart from what stands there, so that textures of one shape at one place find their
// texels once. Texels are linear before they are filtered: 8-bit data and 15-bit colors two channels a lane, floats one
// by one. Per instruction set.
#pragma once
#include "engines/raster/kernels/interpolate.h"

namespace rakelight::raster::RL_ISA {

inline constexpr int fraction_bits = 15;  ///< of a texel: its weight in a filter

/// The texels of one level: the nearest, or the four around the point and its place between them.
struct Taps {
    integer texel[4];          ///< left and right of the upper row, then of the lower one
    integer along_x, along_y;  ///< 0..32767: right's and lower's weight, in both halves of a lane
};

/// What a sample reads.
struct Footprint {
    Taps taps[2];
    integer between;  ///< weight of taps[1], as in Taps
    bool linear, has_two_levels;
};

/// One level of a texture, which may differ from lane to lane.
struct Level {
    integer offset, width, height;
};

inline Level level_at(const TextureView& t, integer number) {
    const int32_t first = lane(number, 0);  // lanes are mostly of one level
    if (all_lanes(number == integer(first))) return {integer(t.offset[first]), integer(t.width[first]), integer(t.height[first])};
    return {gather_i(t.offset, number), gather_i(t.width, number), gather_i(t.height, number)};
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

/// Two neighbors on one axis, and the second one's weight.
struct Neighbors {
    integer first, second, weight;
};

inline integer in_both_halves(integer weight) { return weight | (weight << 16); }

inline Neighbors neighbors(real wrapped, integer size, int mode) {
    const integer fixed = to_int(wrapped * to_real(size << fraction_bits)) - integer(1 << (fraction_bits - 1));
    const integer at = fixed >> fraction_bits, next = at + integer(1), last = size - integer(1);
    const bool repeats = mode == 0;
    return {select(at < integer(0), repeats ? last : integer(0), at),
            select(next > last, repeats ? integer(0) : last, next),
            in_both_halves(fixed & integer((1 << fraction_bits) - 1))};
}

inline Taps taps_of(const TextureView& t, const Level& level, real u, real v, bool linear) {
    Taps taps;
    if (!linear) {
        const integer x = min(to_int(u * to_real(level.width)), level.width - integer(1));
        const integer y = min(to_int(v * to_real(level.height)), level.height - integer(1));
        taps.texel[0] = level.offset + y * level.width + x;
        return taps;
    }
    const Neighbors x = neighbors(u, level.width, t.wrap_u), y = neighbors(v, level.height, t.wrap_v);
    const integer upper = level.offset + y.first * level.width, lower = level.offset + y.second * level.width;
    taps.texel[0] = upper + x.first;
    taps.texel[1] = upper + x.second;
    taps.texel[2] = lower + x.first;
    taps.texel[3] = lower + x.second;
    taps.along_x = x.weight;
    taps.along_y = y.weight;
    return taps;
}

/// Level of detail: log2 of the longer side of the pixel's footprint in texels (OpenGL 3.3 core, eq. 3.17 and 3.18, with the
/// maximum of the two lengths).
inline real level_of_detail(const TextureView& t, const TexCoords& c) {
    const real w = real(float(t.width[0])), h = real(float(t.height[0]));
    const real ux = c.dx.x * w, vx = c.dx.y * h, uy = c.dy.x * w, vy = c.dy.y * h;
    const real squared = max(ux * ux + vx * vx, uy * uy + vy * vy);
    return real(0.5f) * log2_coarse(squared);
}

/// The coordinates that a slot reads its texture at.
inline TexCoords transformed(const TextureSlot& slot, const TexCoords& raw) {
    const auto turn = [&slot](vec2 d) {
        return vec2(real(slot.uu) * d.x + real(slot.uv) * d.y, real(slot.vu) * d.x + real(slot.vv) * d.y);
    };
    return {turn(raw.uv) + vec2(real(slot.u0), real(slot.v0)), turn(raw.dx), turn(raw.dy)};
}

inline Footprint footprint_of(const TextureView& t, const TexCoords& c, real lod, bool linear) {
    Footprint f;
    const real u = wrap_coordinate(c.uv.x, t.wrap_u), v = wrap_coordinate(c.uv.y, t.wrap_v);
    f.linear = linear;
    f.has_two_levels = false;
    if (t.mip == 0 || t.levels == 1 || no_lane(lod > real(0.0f))) {
        f.taps[0] = taps_of(t, level_at(t, integer(0)), u, v, linear);
        return f;
    }
    const real level = clamp(lod, real(0.0f), real(float(t.levels - 1)));
    const integer lower = to_int(t.mip == 1 ? level + real(0.5f) : level);
    f.taps[0] = taps_of(t, level_at(t, lower), u, v, linear);
    if (t.mip == 1) return f;
    f.has_two_levels = true;
    f.between = in_both_halves(to_int((level - to_real(lower)) * real(float(1 << fraction_bits))));
    f.taps[1] = taps_of(t, level_at(t, min(lower + integer(1), integer(t.levels - 1))), u, v, linear);
    return f;
}

/// Two 15-bit channels a lane.
struct Texels {
    integer red_blue, green_alpha;
};

inline Texels fetch(const TextureView& t, integer texel) {
    Texels out;
    if (t.rgba16 != nullptr) {
        gather_pairs(t.rgba16, texel, out.red_blue, out.green_alpha);
    } else {
        const integer rgba = gather_i(t.rgba8, texel), codes(0x7f807f80);  // times 128
        out.red_blue = (rgba << 7) & codes;
        out.green_alpha = shift_right_logical(rgba, 1) & codes;
    }
    return out;
}
inline integer mix16(integer a, integer b, integer weight) { return add16(a, scale16(sub16(b, a), weight)); }
inline Texels mix(const Texels& a, const Texels& b, integer weight) {
    return {mix16(a.red_blue, b.red_blue, weight), mix16(a.green_alpha, b.green_alpha, weight)};
}

inline vec4 fetch_float(const TextureView& t, integer texel) {
    const integer i = texel << 2;
    return vec4(gather(t.rgba32f, i), gather(t.rgba32f + 1, i), gather(t.rgba32f + 2, i), gather(t.rgba32f + 3, i));
}
inline vec4 mix(const vec4& a, const vec4& b, integer weight) {
    return a + (b - a) * (to_real(weight & integer(0xffff)) * real(1.0f / float(1 << fraction_bits)));
}

/// A level, by either kind of texel.
template <class Fetch>
inline auto filtered_level(const Taps& taps, bool linear, const Fetch& fetch) {
    if (!linear) return fetch(taps.texel[0]);
    const auto upper = mix(fetch(taps.texel[0]), fetch(taps.texel[1]), taps.along_x);
    const auto lower = mix(fetch(taps.texel[2]), fetch(taps.texel[3]), taps.along_x);
    return mix(upper, lower, taps.along_y);
}
template <class Fetch>
inline auto filtered(const Footprint& f, const Fetch& fetch) {
    const auto first = filtered_level(f.taps[0], f.linear, fetch);
    return f.has_two_levels ? mix(first, filtered_level(f.taps[1], f.linear, fetch), f.between) : first;
}

inline vec4 sample(const TextureView& t, const Footprint& f) {
    if (t.rgba32f != nullptr) return filtered(f, [&t](integer texel) { return fetch_float(t, texel); });
    const Texels texels = filtered(f, [&t](integer texel) { return fetch(t, texel); });
    const real scale(t.rgba16 != nullptr ? 1.0f / 32767.0f : 1.0f / (255.0f * 128.0f));
    const integer low(0xffff);
    return vec4(to_real(texels.red_blue & low) * scale, to_real(texels.green_alpha & low) * scale,
                to_real(shift_right_logical(texels.red_blue, 16)) * scale,
                to_real(shift_right_logical(texels.green_alpha, 16)) * scale);
}

/// A slot's texture.
inline vec4 sample(const TextureSlot& slot, const TexCoords& raw) {
    const TextureView& t = *slot.view;
    const TexCoords c = transformed(slot, raw);
    const real lod = level_of_detail(t, c);
    const vec4 result = sample(t, footprint_of(t, c, lod, t.minify_linear != 0));
    const mask is_minified = lod > real(0.0f);
    if (t.magnify_linear == t.minify_linear || all_lanes(is_minified)) return result;
    return select(is_minified, result, sample(t, footprint_of(t, c, real(0.0f), t.magnify_linear != 0)));
}

/// Samples along the longer side of a footprint, each as wide as the shorter one:
/// GL_EXT_texture_filter_anisotropic, its section 3.8.8, with the footprint's axes as they are.
struct Probes {
    mask is_stretched;  ///< else one sample as of square footprints
    real count, inverse, lod;
    vec2 axis;

    vec2 place(vec2 middle, int32_t i) const {
        return middle + axis * ((real(float(i)) + real(0.5f)) * inverse - real(0.5f));
    }
};

inline Probes probes_of(const TextureView& t, const TexCoords& c, int32_t most) {
    const real w = real(float(t.width[0])), h = real(float(t.height[0]));
    const real ux = c.dx.x * w, vx = c.dx.y * h, uy = c.dy.x * w, vy = c.dy.y * h;
    const real along_x = ux * ux + vx * vx, along_y = uy * uy + vy * vy;
    const real longer = max(along_x, along_y), shorter = max(min(along_x, along_y), real(1e-20f));
    const real count = ceil(clamp(sqrt(longer / shorter), real(1.0f), real(float(most))));
    Probes p;
    p.is_stretched = count > real(1.0f) && longer > real(1.0f);  // what is magnified needs one sample
    p.count = select(p.is_stretched, count, real(1.0f));
    p.inverse = reciprocal(p.count);
    p.lod = real(0.5f) * log2_coarse(longer * p.inverse * p.inverse);
    p.axis = select(along_x >= along_y, c.dx, c.dy);
    return p;
}

/// A slot's texture by up to `most` probes.
inline vec4 sample_anisotropic(const TextureSlot& slot, const TexCoords& raw, int32_t most) {
    const TextureView& t = *slot.view;
    const TexCoords c = transformed(slot, raw);
    if (t.mip == 0 || t.levels == 1) return sample(slot, raw);
    const Probes p = probes_of(t, c, most);
    if (no_lane(p.is_stretched)) return sample(slot, raw);
    vec4 sum = vec4(real(0.0f));
    for (int32_t i = 0; any_lane(real(float(i)) < p.count); ++i) {
        TexCoords at = c;
        at.uv = p.place(c.uv, i);
        const vec4 probe = sample(t, footprint_of(t, at, p.lod, t.minify_linear != 0));
        sum = sum + select(real(float(i)) < p.count, probe, vec4(real(0.0f)));
    }
    return select(p.is_stretched, sum * p.inverse, sample(slot, raw));
}

}  // namespace rakelight::raster::RL_ISA
