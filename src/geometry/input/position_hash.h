// SPDX-License-Identifier: Apache-2.0
// Hashes of positions for tables whose content a file decides. Keyed, since for a hash that everybody can compute a
// file could put all positions into one slot. Results do not depend on the key.
#pragma once
#include <cstdint>

#include "base/hash_key.h"

namespace rakelight::geometry {

/// @param bits  [3] of the coordinates in double
inline std::uint64_t hash_of_bits(const std::uint64_t (&bits)[3], std::uint64_t also, HashKey key) {
    const std::uint64_t xy = folded_product(bits[0] ^ key.a, bits[1] ^ key.b);
    return folded_product(xy ^ bits[2], (also * 2 + 1) * 0x9e3779b97f4a7c15ull ^ key.a);
}

}  // namespace rakelight::geometry
