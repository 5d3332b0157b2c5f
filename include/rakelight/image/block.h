// SPDX-License-Identifier: Apache-2.0
// Immutable shared arrays, which make a Scene cheap to copy.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include <rakelight/base/memory_budget.h>

namespace rakelight {

/// An immutable array shared by any number of scenes. Copies share the storage. Two blocks are equal only if they share
/// their storage. So engines can reuse data that they derived from an equal block. The default is empty.
template <class T>
class Block {
public:
    Block() = default;
    /// Takes the vector over.
    /// @param charge memory charge of the array; it ends with the last owner
    Block(std::vector<T> values, MemoryCharge charge = {})  // NOLINT(google-explicit-constructor)
    {
        // As an if: GCC 12 warns of freed memory in users' code where this is a conditional expression.
        if (!values.empty()) storage_ = new Storage(std::move(values), std::move(charge));
    }
    /// A block of these values, without a charge.
    Block(std::initializer_list<T> values) : Block(std::vector<T>(values)) {}
    Block(const Block& other) noexcept : storage_(other.storage_) {
        if (storage_) storage_->owners.fetch_add(1, std::memory_order_relaxed);
    }
    Block(Block&& other) noexcept : storage_(std::exchange(other.storage_, nullptr)) {}
    Block& operator=(Block other) noexcept {
        std::swap(storage_, other.storage_);
        return *this;
    }
    ~Block() {
        if (storage_ && storage_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete storage_;
    }

    std::size_t size() const { return storage_ ? storage_->values.size() : 0; }
    bool empty() const { return !storage_; }
    const T* data() const { return storage_ ? storage_->values.data() : nullptr; }
    const T& operator[](std::size_t i) const { return storage_->values[i]; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size(); }
    /// The whole array.
    std::span<const T> span() const { return {data(), size()}; }
    /// The whole array.
    operator std::span<const T>() const { return span(); }
    /// An address that is equal for blocks that share an array. Null: the block is empty.
    const void* identity() const { return storage_; }
    /// Whether the array has a memory charge; an empty block needs none.
    bool is_charged() const { return !storage_ || storage_->charge.bytes() > 0; }
    /// Adds a memory charge to an array created without one. Only for its creator, before the block is shared.
    void attach_charge(MemoryCharge charge) const {
        if (storage_) storage_->charge = std::move(charge);
    }
    bool operator==(const Block& other) const { return storage_ == other.storage_; }

private:
    /// Not a std::shared_ptr: a scene of a million meshes holds ten million blocks, most of them empty.
    struct Storage {
        Storage(std::vector<T>&& v, MemoryCharge&& c) : values(std::move(v)), charge(std::move(c)) {}
        const std::vector<T> values;
        mutable MemoryCharge charge;
        mutable std::atomic<std::uint32_t> owners{1};
    };
    const Storage* storage_ = nullptr;
};

}  // namespace rakelight
