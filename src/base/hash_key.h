// SPDX-License-Identifier: Apache-2.0
// Keys for hash tables whose content a file decides: for a hash that everybody can compute a file can be made all of
// whose entries meet in one slot, and then takes quadratic time. What is found in a table must not depend on the key.
#pragma once
#include <cstdint>

namespace rakelight {

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

}  // namespace rakelight
