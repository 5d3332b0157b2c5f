// SPDX-License-Identifier: Apache-2.0
// Hash tables with keys from files: names, paths, lines. std::hash is equal in every run, so a hostile file could put
// all names into one slot. The order of entries changes from run to run; nothing may depend on it.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "base/hash_key.h"

namespace rakelight {

/// Hash of all bytes and their number. Collisions cannot be found without the key. Source: Wang Yi 2019, "wyhash": 16
/// bytes per step, each step a folded product with a secret in both factors.
std::uint64_t hash_of_text(std::string_view text, const HashKey& key) noexcept;

struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const noexcept {
        return std::size_t(hash_of_text(text, hash_key_of_this_run()));
    }
};

template <class Value>
using NameMap = std::unordered_map<std::string, Value, NameHash, std::equal_to<>>;
using NameSet = std::unordered_set<std::string, NameHash, std::equal_to<>>;

}  // namespace rakelight
