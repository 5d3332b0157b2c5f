// SPDX-License-Identifier: Apache-2.0
// Texture sampling: wrap modes, nearest / bilinear / trilinear filtering, level of detail from analytic derivatives.
// Where to read (Footprint) is apart from what stands there, so that textures of one shape at one place find their
// texels once. Texels are linear before they are filtered: 8-bit data and 15-bit colors two channels a lane, floats one
// by one. Two texels of a row are read at once. Per instruction set.
#pragma once
#include "cpu_shading/kernels/texcoords.h"

namespace rakelight::cpu_shading::RL_ISA {

inline constexpr int fraction_bits = 15;  ///< of a texel: its weight in a filter

/// The texels of one level: the nearest, or the four around the point and its place between them.
struct Taps {
    integer texel;             ///< upper left of the four, or the nearest
    integer stride;            ///< to the texel below
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
    integer origin, stride;
    real width, height;  ///< [2^-15 texels]
};

inline Level level_at(const TextureView& t, integer number) {
    const auto look_up_real = [number](const float* table) {
        return real_from_bits(look_up(reinterpret_cast<const int32_t*>(table), number));
    };
    const real width = look_up_real(t.fixed_width);
    return {look_up(t.origin, number), look_up(t.stride, number), width,
            t.width[0] == t.height[0] ? width : look_up_real(t.fixed_height)};
}
inline Level largest_level(const TextureView& t) {
    return {integer(t.origin[0]), integer(t.stride[0]), real(t.fixed_width[0]), real(t.fixed_height[0])};
}

/// Texture coordinate -> 0..1 by the wrap mode; not finite and huge values give something in range.
inline real wrap_coordinate(real u, int mode) {
    if (mode == wrap_repeat) return max(fract(u), real(0.0f));  // only NaN is not in 0..1
    if (mode == wrap_mirrored) {
        const real folded = abs(u - real(2.0f) * floor(u * real(0.5f) + real(0.5f)));  // triangle wave, period 2
        return clamp(folded, real(0.0f), real(1.0f));
    }
    return clamp(u, real(0.0f), real(1.0f));
}

/// The first of two neighbors on one axis, -1..size - 1 or by rounding `size`, and the second one's weight.
struct Neighbors {
    integer first, weight;
};

inline Neighbors neighbors(real wrapped, real fixed_size) {
    const integer fixed = to_int(wrapped * fixed_size) - integer(1 << (fraction_bits - 1));
    static_assert(fraction_bits == 15);
    return {fixed >> fraction_bits, low_in_both_halves(fixed) & integer(0x7fff7fff)};
}

/// The texel that holds the point.
inline integer nearest(real wrapped, real fixed_size) {
    const integer fixed = min(to_int(wrapped * fixed_size), to_int(fixed_size) - integer(1));
    return fixed >> fraction_bits;
}

inline Taps taps_of(const Level& level, real u, real v, bool linear) {
    Taps taps;
    taps.stride = level.stride;
    if (!linear) {
        taps.texel = level.origin + nearest(v, level.height) * level.stride + nearest(u, level.width);
        taps.along_x = taps.along_y = integer(0);
        return taps;
    }
    const Neighbors x = neighbors(u, level.width), y = neighbors(v, level.height);
    taps.texel = level.origin + y.first * level.stride + x.first;
    taps.along_x = x.weight;
    taps.along_y = y.weight;
    return taps;
}

/// Level of detail: log2 of the longer side of the pixel's footprint in texels (OpenGL 3.3 core, eq. 3.17 and 3.18, with the
/// maximum of the two lengths).
inline real level_of_detail(const TextureView& t, const TexCoords& c) {
    const real w = real(float(t.width[0])), h = real(float(t.height[0]));
    if (t.width[0] == t.height[0]) {
        const real squared = max(dot(c.dx, c.dx), dot(c.dy, c.dy));
        return real(0.5f) * log2_coarse(squared * (w * w));
    }
    const real ux = c.dx.x * w, vx = c.dx.y * h, uy = c.dy.x * w, vy = c.dy.y * h;
    const real squared = max(ux * ux + vx * vx, uy * uy + vy * vy);
    return real(0.5f) * log2_coarse(squared);
}

/// The coordinates that a slot reads its texture at: `raw` itself, or `room` filled with what its matrix makes of them.
inline const TexCoords& transformed(const TextureSlot& slot, const TexCoords& raw, TexCoords& room) {
    if (slot.is_transformed == 0) return raw;
    const auto turn = [&slot](vec2 d) {
        return vec2(real(slot.uu) * d.x + real(slot.uv) * d.y, real(slot.vu) * d.x + real(slot.vv) * d.y);
    };
    room = {turn(raw.uv) + vec2(real(slot.u0), real(slot.v0)), turn(raw.dx), turn(raw.dy)};
    return room;
}

inline void find_footprint(const TextureView& t, const TexCoords& c, real lod, bool linear, Footprint& f) {
    const real u = wrap_coordinate(c.uv.x, t.wrap_u), v = wrap_coordinate(c.uv.y, t.wrap_v);
    f.linear = linear;
    f.has_two_levels = false;
    if (t.mip == mip_none || t.levels == 1 || no_lane(lod > real(0.0f))) {
        f.taps[0] = taps_of(largest_level(t), u, v, linear);
        return;
    }
    const real level = clamp(lod, real(0.0f), real(float(t.levels - 1)));
    const integer lower = to_int(t.mip == mip_nearest ? level + real(0.5f) : level);
    f.taps[0] = taps_of(level_at(t, lower), u, v, linear);
    if (t.mip == mip_nearest) return;
    f.has_two_levels = true;
    f.between = low_in_both_halves(to_int((level - to_real(lower)) * real(float(1 << fraction_bits))));
    f.taps[1] = taps_of(level_at(t, min(lower + integer(1), integer(t.levels - 1))), u, v, linear);
}

inline Footprint footprint_of(const TextureView& t, const TexCoords& c, real lod, bool linear) {
    Footprint f;
    find_footprint(t, c, lod, linear, f);
    return f;
}

/// Two 15-bit channels a lane.
struct Texels {
    integer red_blue, green_alpha;
};

inline integer mix16(integer a, integer b, integer weight) { return add16(a, scale16(sub16(b, a), weight)); }
inline Texels mix(const Texels& a, const Texels& b, integer weight) {
    return {mix16(a.red_blue, b.red_blue, weight), mix16(a.green_alpha, b.green_alpha, weight)};
}
inline real fraction(integer weight) {
    return to_real(weight & integer(0xffff)) * real(1.0f / float(1 << fraction_bits));
}
inline real mix(real a, real b, integer weight) { return a + (b - a) * fraction(weight); }
inline vec4 mix(const vec4& a, const vec4& b, integer weight) { return a + (b - a) * fraction(weight); }

/// Reads linear 15-bit colors; `mixed` reads a texel and its right neighbor.
struct ColorTexels {
    const uint32_t* base;
    [[gnu::always_inline]] Texels at(integer texel) const {
        integer words[4];
        gather_quads(base, texel, words);
        return {words[0], words[1]};
    }
    [[gnu::always_inline]] Texels mixed(integer texel, integer weight) const {
        integer words[4];
        gather_quads(base, texel, words);
        return mix(Texels{words[0], words[1]}, Texels{words[2], words[3]}, weight);
    }
};

/// Reads linear 8-bit codes, as 128 times them.
struct DataTexels {
    const uint32_t* base;
    static Texels unpack(integer rgba) {
        const integer codes(0x7f807f80);
        return {(rgba << 7) & codes, shift_right_logical(rgba, 1) & codes};
    }
    [[gnu::always_inline]] Texels at(integer texel) const { return unpack(gather_i(base, texel)); }
    [[gnu::always_inline]] Texels mixed(integer texel, integer weight) const {
        integer left, right;
        gather_pairs(base, texel, left, right);
        return mix(unpack(left), unpack(right), weight);
    }
};

struct FloatTexels {
    const float* base;
    [[gnu::always_inline]] vec4 at(integer texel) const {
        integer words[4];
        gather_quads(reinterpret_cast<const uint32_t*>(base), texel << 1, words);
        return vec4(real_from_bits(words[0]), real_from_bits(words[1]), real_from_bits(words[2]),
                    real_from_bits(words[3]));
    }
    [[gnu::always_inline]] vec4 mixed(integer texel, integer weight) const {
        return mix(at(texel), at(texel + integer(1)), weight);
    }
};

/// The first channel alone.
struct FloatHeights {
    const float* base;
    real at(integer texel) const { return gather(base, texel << 2); }
    real mixed(integer texel, integer weight) const { return mix(at(texel), at(texel + integer(1)), weight); }
};

/// A level, of any kind of texel. A call: code that many steps share stays in the processor's cache.
template <class Reader>
[[gnu::noinline]] inline auto filtered_level(const Reader& read, const Taps& taps, bool linear) {
    if (!linear) return read.at(taps.texel);
    const auto upper = read.mixed(taps.texel, taps.along_x);
    const auto lower = read.mixed(taps.texel + taps.stride, taps.along_x);
    return mix(upper, lower, taps.along_y);
}
template <class Reader>
inline auto filtered(const Reader& read, const Footprint& f) {
    const auto first = filtered_level(read, f.taps[0], f.linear);
    return f.has_two_levels ? mix(first, filtered_level(read, f.taps[1], f.linear), f.between) : first;
}

inline Texels filtered_codes(const TextureView& t, const Footprint& f) {
    return t.rgba16 != nullptr ? filtered(ColorTexels{t.rgba16}, f) : filtered(DataTexels{t.rgba8}, f);
}

/// Formats of texels that a kernel reads: 8 and 15 bits per channel, or floats too.
enum class TexelFormats { codes, every };

/// 0..1 except for floats, times a power of two. Inline, so that channels which nobody reads cost nothing.
template <TexelFormats formats = TexelFormats::every>
[[gnu::always_inline]] inline vec4 sample(const TextureView& t, const Footprint& f, float times = 1.0f) {
    if (formats == TexelFormats::every && t.rgba32f != nullptr)
        return filtered(FloatTexels{t.rgba32f}, f) * real(times);
    const Texels texels = filtered_codes(t, f);
    const real scale(times * (t.rgba16 != nullptr ? 1.0f / 32767.0f : 1.0f / (255.0f * 128.0f)));
    const integer low(0xffff);
    return vec4(to_real(texels.red_blue & low) * scale, to_real(texels.green_alpha & low) * scale,
                to_real(shift_right_logical(texels.red_blue, 16)) * scale,
                to_real(shift_right_logical(texels.green_alpha, 16)) * scale);
}

/// A slot's texture.
template <TexelFormats formats>
inline vec4 sample(const TextureSlot& slot, const TexCoords& raw) {
    const TextureView& t = *slot.view;
    TexCoords room;
    const TexCoords& c = transformed(slot, raw, room);
    const real lod = level_of_detail(t, c);
    const vec4 result = sample<formats>(t, footprint_of(t, c, lod, t.minify_linear != 0));
    const mask is_minified = lod > real(0.0f);
    if (t.magnify_linear == t.minify_linear || all_lanes(is_minified)) return result;
    return select(is_minified, result, sample<formats>(t, footprint_of(t, c, real(0.0f), t.magnify_linear != 0)));
}

inline lit::Probes probes_of(const TextureView& t, const TexCoords& c, int32_t most) {
    return lit::probes_of(c.dx, c.dy, vec2(real(float(t.width[0])), real(float(t.height[0]))), most);
}

/// A slot's texture by up to `most` probes.
template <TexelFormats formats>
inline vec4 sample_anisotropic(const TextureSlot& slot, const TexCoords& raw, int32_t most) {
    const TextureView& t = *slot.view;
    TexCoords room;
    const TexCoords& c = transformed(slot, raw, room);
    if (t.mip == mip_none || t.levels == 1) return sample<formats>(slot, raw);
    const lit::Probes p = probes_of(t, c, most);
    if (no_lane(p.is_stretched)) return sample<formats>(slot, raw);
    vec4 sum = vec4(real(0.0f));
    for (int32_t i = 0; any_lane(real(float(i)) < p.count); ++i) {
        TexCoords at = c;
        at.uv = lit::probe_place(p, c.uv, i);
        const vec4 probe = sample<formats>(t, footprint_of(t, at, p.lod, t.minify_linear != 0));
        sum = sum + select(real(float(i)) < p.count, probe, vec4(real(0.0f)));
    }
    return select(p.is_stretched, sum * p.inverse, sample<formats>(slot, raw));
}

}  // namespace rakelight::cpu_shading::RL_ISA
