// SPDX-License-Identifier: Apache-2.0
#include "base/hash_key.h"

#include <sys/auxv.h>

#include <chrono>
#include <cstring>

namespace rakelight {

HashKey hash_key_of_this_run() {
    static const HashKey key = [] {
        HashKey made;
        if (const auto random = reinterpret_cast<const void*>(getauxval(AT_RANDOM))) {  // 16 bytes
            std::memcpy(&made.a, random, sizeof made.a);
            std::memcpy(&made.b, static_cast<const char*>(random) + sizeof made.a, sizeof made.b);
        } else {
            made.a = std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count()) * 0x9e3779b97f4a7c15ull;
            made.b = folded_product(made.a, 0xbf58476d1ce4e5b9ull);
        }
        // Not the bytes themselves, by which the C library guards its stack.
        return HashKey{folded_product(made.a, 0x94d049bb133111ebull) ^ made.b,
                       folded_product(made.b, 0xd6e8feb86659fd93ull) ^ made.a};
    }();
    return key;
}

}  // namespace rakelight
