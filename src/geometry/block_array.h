// SPDX-License-Identifier: Apache-2.0
// A large array over a block of memory that can be handed on to an array of another type, stage after stage.
#pragma once
#include <utility>

#include "geometry/fast_memory.h"

namespace rakelight::geometry {

/// Raw memory, of any contents.
using Block = LargeArray<char>;

/// T is copied by its bytes (plain structs and numbers); what is read was written before by the same owner.
template <class T>
class BlockArray {
public:
    BlockArray() = default;
    explicit BlockArray(Block block) : block_(std::move(block)) {}

    /// Room for `count` items. What it held is lost when it must grow.
    void reserve(std::size_t count) { block_.reserve(count * sizeof(T)); }
    T* data() { return reinterpret_cast<T*>(block_.data()); }
    const T* data() const { return reinterpret_cast<const T*>(block_.data()); }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    /// Gives the memory away.
    Block take() { return std::move(block_); }

private:
    Block block_;
};

}  // namespace rakelight::geometry
