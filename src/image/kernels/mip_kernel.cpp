// SPDX-License-Identifier: Apache-2.0
// One row of a smaller mip level: averages of rows first, then of columns, in the order of mip_chain.h; each lane is a
// texel.
#include "image/maps/mip_rows.h"
#include "image/srgb_table.h"
#include "math/wide.h"

namespace rakelight::mip::RL_ISA {
RL_USE_WIDE;

namespace {

enum Columns { one, even, odd };

struct Texel {
    real c[4];
};

template <bool srgb>
inline Texel decoded(integer codes, const Tables& tables) {
    Texel t{};
    for (int c = 0; c < 3; ++c) {
        const integer code = shift_right_logical(codes, 8 * c) & integer(255);
        if constexpr (srgb)
            t.c[c] = gather(tables.linear, code);
        else
            t.c[c] = to_real(code);
    }
    t.c[3] = to_real(shift_right_logical(codes, 24));
    return t;
}

inline void add(Texel& sum, const Texel& t, float weight, bool is_first) {
    for (int c = 0; c < 4; ++c) {
        const real part = t.c[c] * real(weight);
        sum.c[c] = is_first ? part : sum.c[c] + part;
    }
}

/// Texels at, at + 1 and at + 2 of a row, as many as `columns` needs.
struct Three {
    Texel t[3];
};

template <Columns columns, bool srgb>
inline Three read(const uint32_t* codes, integer at, const Tables& tables) {
    Three out{};
    integer first, second;
    if constexpr (columns == one) {
        out.t[0] = decoded<srgb>(gather_i(codes, at), tables);
    } else {
        gather_pairs(codes, at, first, second);
        out.t[0] = decoded<srgb>(first, tables);
        out.t[1] = decoded<srgb>(second, tables);
    }
    if constexpr (columns == odd) out.t[2] = decoded<srgb>(gather_i(codes, at + integer(2)), tables);
    return out;
}

template <Columns columns>
inline Three read(const float* row, int32_t width, integer at) {
    Three out{};
    for (int c = 0; c < 4; ++c) {
        const float* const plane = row + int64_t(c) * width;
        out.t[0].c[c] = gather(plane, at);
        if constexpr (columns != one) out.t[1].c[c] = gather(plane, at + integer(1));
        if constexpr (columns == odd) out.t[2].c[c] = gather(plane, at + integer(2));
    }
    return out;
}

template <bool srgb>
inline integer encoded(const Texel& t, const Tables& tables) {
    integer codes = to_int(t.c[3] + real(0.5f)) << 24;
    for (int c = 0; c < 3; ++c) {
        if constexpr (srgb) {
            const integer bits = bits_of(min(max(t.c[c], real(0.0f)), real(srgb_highest)));
            const integer entry = gather_i(tables.encode_srgb, shift_right_logical(bits, srgb_bucket_bits));
            codes = codes | shift_right_logical(entry + (bits & integer(0xffff)), srgb_bucket_bits) << 8 * c;
        } else {
            codes = codes | to_int(t.c[c] + real(0.5f)) << 8 * c;
        }
    }
    return codes;
}

template <bool from_codes, Columns columns, bool srgb>
void halve(const Row& row, const Tables& tables) {
    constexpr int used = columns == one ? 1 : columns == even ? 2 : 3;
    for (int32_t x = 0; x < row.smaller; x += lanes) {
        const integer i = lane_indices() + integer(x);
        const mask live = i < integer(row.smaller);
        const integer at = select(live, i + i, integer(0));
        Three sum{};
        for (int32_t r = 0; r < row.rows; ++r) {
            Three three{};
            if constexpr (from_codes)
                three = read<columns, srgb>(row.codes[r], at, tables);
            else
                three = read<columns>(row.averages[r], row.larger, at);
            for (int k = 0; k < used; ++k) add(sum.t[k], three.t[k], row.row_weight[r], r == 0);
        }
        Texel mean = sum.t[0];
        if constexpr (columns == even)
            for (int c = 0; c < 4; ++c) mean.c[c] = (sum.t[0].c[c] + sum.t[1].c[c]) * real(0.5f);
        if constexpr (columns == odd) {
            const real first = load_masked(row.first_weight + x, live), last = load_masked(row.last_weight + x, live);
            for (int c = 0; c < 4; ++c)
                mean.c[c] = sum.t[0].c[c] * first + sum.t[1].c[c] * real(row.middle_weight) + sum.t[2].c[c] * last;
        }
        for (int c = 0; c < 4; ++c) store_masked(row.to_averages + int64_t(c) * row.smaller + x, mean.c[c], live);
        store_masked(reinterpret_cast<int32_t*>(row.to_codes) + x, encoded<srgb>(mean, tables), live);
    }
}

template <bool from_codes, bool srgb>
void halve(const Row& row, const Tables& tables) {
    if (row.larger == 1)
        halve<from_codes, one, srgb>(row, tables);
    else if (row.larger % 2 == 0)
        halve<from_codes, even, srgb>(row, tables);
    else
        halve<from_codes, odd, srgb>(row, tables);
}

}  // namespace

void halve_row(const Row& row, const Tables& tables) {
    const bool from_codes = row.codes[0] != nullptr;
    if (row.is_srgb)
        from_codes ? halve<true, true>(row, tables) : halve<false, true>(row, tables);
    else
        from_codes ? halve<true, false>(row, tables) : halve<false, false>(row, tables);
}

}  // namespace rakelight::mip::RL_ISA
