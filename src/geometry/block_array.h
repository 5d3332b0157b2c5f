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

/// Memory of the general path that a workspace keeps for the next call. A stage takes a block and returns it; contents are not preserved.
struct GeneralScratch {
    Block faces;    ///< face normals while grouping, then rows of normals
    Block corners;  ///< corners by place, then rows of tangents
    Block keys;     ///< of CornerSort
    std::size_t bytes() const { return faces.bytes() + corners.bytes() + keys.bytes(); }
};

}  // namespace rakelight::geometry
