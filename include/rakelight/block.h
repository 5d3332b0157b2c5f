// SPDX-License-Identifier: Apache-2.0
// Immutable shared arrays: what makes a scene a cheap value.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace rakelight {

/// An immutable array that any number of scenes share. Copying shares; equality is identity of the storage (so engines can
/// keep what they made of a block while a new scene still holds it). The empty block is the default.
template <class T>
class Block {
public:
    Block() = default;
    Block(std::vector<T> values)  // NOLINT(google-explicit-constructor): a vector becomes a block by being moved in
        : storage_(values.empty() ? nullptr : std::make_shared<const std::vector<T>>(std::move(values))) {}

    std::size_t size() const { return storage_ ? storage_->size() : 0; }
    bool empty() const { return !storage_; }
    const T* data() const { return storage_ ? storage_->data() : nullptr; }
    const T& operator[](std::size_t i) const { return (*storage_)[i]; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size(); }
    std::span<const T> span() const { return {data(), size()}; }
    operator std::span<const T>() const { return span(); }
    const void* identity() const { return storage_.get(); }
    bool operator==(const Block& other) const { return storage_ == other.storage_; }

private:
    std::shared_ptr<const std::vector<T>> storage_;
};

}  // namespace rakelight
