// SPDX-License-Identifier: Apache-2.0
// A texture line of an MTL file.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rakelight/math/vector.h>

#include "io/obj/obj_remarks.h"

namespace rakelight::io::obj {

/// Its options and file name, as written.
struct MtlMap {
    std::string file;                       ///< as written, quotes taken off; not empty
    std::optional<double> bump_multiplier;  ///< -bm
    std::optional<double> gain;             ///< second number of -mm
    vec2 offset{0, 0}, scale{1, 1};         ///< -o, -s: uv' = offset + scale * uv, v up as in the file
    bool is_clamped = false;                ///< -clamp on
    std::uint64_t line = 0;
};

/// The part of a texture line after its keyword. Options stand before the file name; -bm also after it, as some
/// exporters write it. Words that are not options begin the file name, which may hold blanks.
/// @return nullopt when there is no file name
std::optional<MtlMap> parse_map(std::string_view file, std::size_t begin, std::size_t end, std::uint64_t line,
                                Remarks& remarks);

}  // namespace rakelight::io::obj
