// SPDX-License-Identifier: Apache-2.0
#include "base/hash_key.h"

#include <unistd.h>

#include <chrono>

namespace rakelight {

HashKey hash_key_of_this_run() {
    static const HashKey key = [] {
        HashKey made;
        if (getentropy(&made, sizeof made) != 0) {
            made.a = std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count()) * 0x9e3779b97f4a7c15ull;
            made.b = folded_product(made.a, 0xbf58476d1ce4e5b9ull);
        }
        return made;
    }();
    return key;
}

}  // namespace rakelight
