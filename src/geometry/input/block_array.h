// SPDX-License-Identifier: Apache-2.0
// A large array on a memory block that can be reused for an array of another type.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/input/fast_memory.h"

namespace rakelight::geometry {

/// Raw memory with unspecified contents.
using Block = LargeArray<char>;

/// T is trivially copyable; elements are written before they are read.
template <class T>
class BlockArray {
public:
    BlockArray() = default;
    explicit BlockArray(Block block) : block_(std::move(block)) {}

    /// Reserves `count` items. Growing loses the contents.
    void reserve(std::size_t count) { block_.reserve(count * sizeof(T)); }
    T* data() { return reinterpret_cast<T*>(block_.data()); }
    const T* data() const { return reinterpret_cast<const T*>(block_.data()); }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    /// Releases the memory to the caller.
    Block take() { return std::exchange(block_, {}); }
    bool empty() const { return block_.data() == nullptr; }

private:
    Block block_;
};

/// Memory of the general path that a workspace keeps for the next call. A stage takes a block and returns it; contents are not preserved.
struct GeneralScratch {
    Block faces;    ///< face normals while grouping, then rows of normals
    Block corners;  ///< corners by place, then rows of tangents
    Block keys;     ///< of CornerSort
    std::vector<Block> spare;
    std::vector<std::vector<std::uint32_t>> spare_words;
    bool is_kept = false;  ///< by a workspace, for the next call

    /// Where nothing of it is needed again in this call.
    void free_spare() {
        if (!is_kept) spare.clear(), spare_words.clear();
    }

    std::size_t bytes() const {
        std::size_t sum = faces.bytes() + corners.bytes() + keys.bytes();
        for (const Block& block : spare) sum += block.bytes();
        for (const auto& words : spare_words) sum += words.capacity() * sizeof(std::uint32_t);
        return sum;
    }

    /// Room for `count` items: the smallest spare block that has it, else the largest one grows.
    template <class T>
    BlockArray<T> take(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        auto best = spare.end();
        for (auto it = spare.begin(); it != spare.end(); ++it)
            if (best == spare.end() || (best->bytes() < bytes ? it->bytes() > best->bytes()
                                                              : it->bytes() >= bytes && it->bytes() < best->bytes()))
                best = it;
        BlockArray<T> array;
        if (best != spare.end()) {
            array = BlockArray<T>(std::move(*best));
            spare.erase(best);
        }
        array.reserve(count);
        return array;
    }
    template <class T>
    void give(BlockArray<T>& array) {
        if (!array.empty()) spare.push_back(array.take());
    }

    /// An empty vector, with the largest capacity.
    std::vector<std::uint32_t> take_words() {
        const auto best = std::max_element(spare_words.begin(), spare_words.end(),
                                           [](const auto& a, const auto& b) { return a.capacity() < b.capacity(); });
        if (best == spare_words.end()) return {};
        std::vector<std::uint32_t> words = std::move(*best);
        spare_words.erase(best);
        words.clear();
        return words;
    }
    void give(std::vector<std::uint32_t>& words) {
        if (words.capacity() > 0) spare_words.push_back(std::exchange(words, {}));
    }
};

}  // namespace rakelight::geometry
