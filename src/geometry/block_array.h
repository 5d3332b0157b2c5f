// SPDX-License-Identifier: Apache-2.0
// A large array on a memory block that can be reused for an array of another type.
#pragma once
#include <utility>

#include "geometry/fast_memory.h"

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
    Block take() { return std::move(block_); }

private:
    Block block_;
};

}  // namespace rakelight::geometry
