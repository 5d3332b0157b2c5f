// SPDX-License-Identifier: Apache-2.0
// Immutable shared arrays: what makes a scene a cheap value.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <rakelight/memory_budget.h>

namespace rakelight {

/// An immutable array that any number of scenes share. Copying shares; equality is identity of the storage (so engines
/// can keep what they made of a block while a new scene still holds it). The empty block is the default.
template <class T>
class Block {
public:
    Block() = default;
    /// A vector becomes a block by being moved in.
    /// @param charge  what pays for it; it ends with the last owner of the array
    Block(std::vector<T> values, MemoryCharge charge = {})  // NOLINT(google-explicit-constructor)
    {
        // As an if: GCC 12 warns of freed memory in users' code where this is a conditional expression.
        if (!values.empty()) storage_ = new Storage(std::move(values), std::move(charge));
    }
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
    /// All of it.
    std::span<const T> span() const { return {data(), size()}; }
    /// All of it.
    operator std::span<const T>() const { return span(); }
    /// Equal for blocks that share one array; null: empty.
    const void* identity() const { return storage_; }
    /// Whether a charge pays for the array; the empty block needs none.
    bool is_paid() const { return !storage_ || storage_->charge.bytes() > 0; }
    /// Gives an array the charge that it was made without. Only by who made it, before others share it.
    void pay(MemoryCharge charge) const {
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
