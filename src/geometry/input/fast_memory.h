// SPDX-License-Identifier: Apache-2.0
// Large arrays that are used again and again: never initialized, grown only when too small, in huge pages where the system
// grants them (which halves the time of random access to them).
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

#include "base/huge_pages.h"

namespace rakelight::geometry {

template <class T>
class LargeArray {
public:
    LargeArray() = default;
    LargeArray(LargeArray&& other) noexcept { swap(other); }
    LargeArray& operator=(LargeArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~LargeArray() { std::free(data_); }

    /// Room for `count` items. What it held is lost when it must grow.
    void reserve(std::size_t count) {
        if (count <= capacity_) return;
        std::free(std::exchange(data_, nullptr));
        capacity_ = 0;
        const std::size_t step = count * sizeof(T) < huge_page ? 4096 : huge_page;
        const std::size_t bytes = (count * sizeof(T) + step - 1) / step * step;
        data_ = static_cast<T*>(std::aligned_alloc(step, bytes));
        if (data_ == nullptr) throw std::bad_alloc();
        advise_huge_pages(data_, bytes);
        capacity_ = bytes / sizeof(T);
    }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    std::size_t bytes() const { return capacity_ * sizeof(T); }

private:
    void swap(LargeArray& other) {
        std::swap(data_, other.data_);
        std::swap(capacity_, other.capacity_);
    }
    T* data_ = nullptr;
    std::size_t capacity_ = 0;
};

}  // namespace rakelight::geometry
