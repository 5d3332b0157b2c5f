// SPDX-License-Identifier: Apache-2.0
// Data of the mip kernel: one row of a smaller level of an 8-bit picture. Plain types, because it is compiled per
// instruction set.
#pragma once
#include <stdint.h>

namespace rakelight::mip {

/// Values of codes: linear light for sRGB colors, the code itself for data.
struct Tables {
    float linear[256];            ///< of sRGB codes
    const uint32_t* encode_srgb;  ///< SrgbEncoder::table()
};

/// A row of unrounded averages holds four planes of `width` floats: R, G, B, A.
struct Row {
    const uint32_t* codes[3];  ///< input rows if they are codes (full size)
    const float* averages[3];  ///< input rows else
    float row_weight[3];
    int32_t rows;             ///< 1..3 of them
    int32_t larger, smaller;  ///< widths: smaller = max(1, larger / 2)
    const float*
        first_weight;  ///< [smaller] where `larger` is odd and more than 1: of texels 2i, 2i + 2; and of all 2i + 1
    const float* last_weight;
    float middle_weight;
    int32_t is_srgb;
    float* to_averages;  ///< [4 * smaller]
    uint32_t* to_codes;  ///< [smaller]
};

// Each: fills to_averages and to_codes.
namespace scalar {
void halve_row(const Row& row, const Tables& tables);
}
namespace sse2 {
void halve_row(const Row& row, const Tables& tables);
}
namespace avx2 {
void halve_row(const Row& row, const Tables& tables);
}
namespace avx512 {
void halve_row(const Row& row, const Tables& tables);
}

}  // namespace rakelight::mip
