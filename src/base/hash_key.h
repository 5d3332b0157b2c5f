// SPDX-License-Identifier: Apache-2.0
// A random key for hash tables with content from files. With a known hash, a hostile file could put all entries into
// one slot and cause quadratic time. Results must not depend on the key.
#pragma once
#include <cstdint>

namespace rakelight {

struct HashKey {
    std::uint64_t a = 0, b = 0;
};

/// The key of this process: random bytes from the system, else from the clock.
HashKey hash_key_of_this_run();

/// The 128-bit product, folded: each bit of the result depends on all bits of both factors. Source: Wang Yi 2019,
/// "wyhash" (mum).
inline std::uint64_t folded_product(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide(a) * b;
    return std::uint64_t(product) ^ std::uint64_t(product >> 64);
}

}  // namespace rakelight
