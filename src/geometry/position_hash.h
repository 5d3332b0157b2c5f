// SPDX-License-Identifier: Apache-2.0
// Hashes of positions for tables whose content a file decides. Keyed, since for a hash that everybody can compute a
// file can be made all of whose positions meet in one slot. What is found in a table does not depend on the key.
#pragma once
#include <cstdint>

namespace rakelight::geometry {

struct HashKey {
    std::uint64_t a = 0, b = 0;
};

/// Of this run of the program: random bytes that the system gave it when it started, else the clock's.
HashKey hash_key_of_this_run();

/// All 128 bits of the product, folded: each bit of the result depends on all bits of both.
/// Source: Wang Yi 2019, "wyhash" (mum).
inline std::uint64_t folded_product(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide(a) * b;
    return std::uint64_t(product) ^ std::uint64_t(product >> 64);
}

/// @param bits  [3] of the coordinates in double
inline std::uint64_t hash_of_bits(const std::uint64_t (&bits)[3], std::uint64_t also, HashKey key) {
    const std::uint64_t xy = folded_product(bits[0] ^ key.a, bits[1] ^ key.b);
    return folded_product(xy ^ bits[2], (also * 2 + 1) * 0x9e3779b97f4a7c15ull ^ key.a);
}

}  // namespace rakelight::geometry
