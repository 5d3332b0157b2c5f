// SPDX-License-Identifier: Apache-2.0
#include "base/name_table.h"

#include <algorithm>
#include <cstring>

namespace rakelight {

std::uint64_t hash_of_text(std::string_view text, const HashKey& key) noexcept {
    std::uint64_t state = folded_product(key.a ^ text.size(), key.b);
    do {  // the last step is padded with zeros; the number of bytes distinguishes "a" from "a\0"
        std::uint64_t words[2] = {0, 0};
        const std::size_t count = std::min(text.size(), sizeof words);
        if (count != 0) std::memcpy(words, text.data(), count);
        state = folded_product(words[0] ^ key.a, words[1] ^ state);
        text.remove_prefix(count);
    } while (!text.empty());
    return folded_product(state ^ key.b, key.a);
}

}  // namespace rakelight
