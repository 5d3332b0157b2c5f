// SPDX-License-Identifier: Apache-2.0
// Keys of three words, each once, numbered in order of first use: corners of faces, or the bits of vectors.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/hash_key.h"

namespace rakelight::io::obj {

/// Open addressing with a random key per run, so no file can make all its keys collide. Expected O(1) per lookup.
/// @tparam Key  with == and hash_of(key, HashKey)
template <class Key>
class UniqueTable {
public:
    static constexpr std::uint32_t most = 0xfffffffe;

    /// What reserve() takes at most. [bytes]
    static std::uint64_t bytes_for(std::size_t count) {
        return count * sizeof(Key) + slots_for(count) * sizeof(std::uint32_t);
    }

    /// Room for as many keys.
    void reserve(std::size_t count) {
        keys_.reserve(count);
        if (slots_for(count) > slots_.size()) make_slots(slots_for(count));
    }

    /// The key's number; the caller sees to it that there are at most `most` of them.
    std::uint32_t number_of(const Key& key) {
        if (2 * (keys_.size() + 1) > slots_.size()) make_slots(slots_for(keys_.size() + 1));
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash_of(key, hash_key_) & mask;; slot = (slot + 1) & mask) {
            const std::uint32_t number = slots_[slot];
            if (number == empty) {
                slots_[slot] = std::uint32_t(keys_.size());
                keys_.push_back(key);
                return slots_[slot];
            }
            if (keys_[number] == key) return number;
        }
    }

    /// Forgets all keys, in a time that their number decides.
    void clear() {
        if (keys_.size() * 8 > slots_.size()) {
            slots_.assign(slots_.size(), empty);
        } else {
            const std::size_t mask = slots_.size() - 1;
            for (std::uint32_t i = 0; i < keys_.size(); ++i) {
                std::size_t slot = hash_of(keys_[i], hash_key_) & mask;
                while (slots_[slot] != i) slot = (slot + 1) & mask;
                slots_[slot] = empty;
            }
        }
        keys_.clear();
    }

    const std::vector<Key>& keys() const { return keys_; }
    std::vector<Key> take_keys() { return std::move(keys_); }
    /// Full slots in a row: as far as a look for a key can go.
    std::size_t longest_run() const {
        std::size_t longest = 0, run = 0;
        for (const std::uint32_t slot : slots_) longest = std::max(longest, run = slot == empty ? 0 : run + 1);
        return longest;
    }

private:
    static constexpr std::uint32_t empty = 0xffffffff;
    static std::size_t slots_for(std::size_t count) { return std::bit_ceil(std::max<std::size_t>(8, 2 * count)); }

    void make_slots(std::size_t size) {
        slots_.assign(size, empty);
        for (std::uint32_t i = 0; i < keys_.size(); ++i) {
            std::size_t slot = hash_of(keys_[i], hash_key_) & (size - 1);
            while (slots_[slot] != empty) slot = (slot + 1) & (size - 1);
            slots_[slot] = i;
        }
    }

    HashKey hash_key_ = hash_key_of_this_run();
    std::vector<Key> keys_;
    std::vector<std::uint32_t> slots_;  ///< a power of two, at most half full
};

/// Keys that were made unique by themselves, and where their numbers go.
template <class Key>
struct UniquePart {
    const Key* keys = nullptr;
    std::size_t count = 0;
    std::uint32_t* numbers = nullptr;
};

/// The keys of all parts, each once, in order of first use. One part has each once by itself.
/// @return [keys] the parts' numbers count these
template <class Key>
std::vector<Key> merged(const std::vector<UniquePart<Key>>& parts, std::size_t total) {
    if (parts.size() == 1) {
        for (std::size_t i = 0; i < parts[0].count; ++i) parts[0].numbers[i] = std::uint32_t(i);
        return {parts[0].keys, parts[0].keys + parts[0].count};
    }
    UniqueTable<Key> table;
    table.reserve(total);
    for (const UniquePart<Key>& part : parts)
        for (std::size_t i = 0; i < part.count; ++i) part.numbers[i] = table.number_of(part.keys[i]);
    std::vector<Key> keys = table.take_keys();
    keys.shrink_to_fit();
    return keys;
}

}  // namespace rakelight::io::obj
