// SPDX-License-Identifier: Apache-2.0
// Optional values and lists for members that are rarely set.
#pragma once
#include <algorithm>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace rakelight {

/// Like std::optional, but the value is on the heap, so an unset value needs only a pointer. For large members that
/// most objects do not have. Copies are deep.
template <class T>
class Rare {
public:
    Rare() = default;
    /// Holds a copy.
    Rare(const T& value)
        : value_(std::make_unique<T>(value)) {}  // NOLINT(google-explicit-constructor): as std::optional
    Rare(const Rare& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
    Rare(Rare&&) noexcept = default;
    Rare& operator=(Rare other) noexcept {
        value_ = std::move(other.value_);
        return *this;
    }
    ~Rare() = default;
    bool operator==(const Rare& other) const {
        return value_ && other.value_ ? *value_ == *other.value_ : !value_ && !other.value_;
    }

    explicit operator bool() const noexcept { return bool(value_); }
    T& operator*() { return *value_; }
    const T& operator*() const { return *value_; }
    T* operator->() { return value_.get(); }
    const T* operator->() const { return value_.get(); }

private:
    std::unique_ptr<T> value_;
};

/// A vector for lists that are nearly always empty. An empty list needs only a pointer.
template <class T>
class RareList {
public:
    RareList() = default;
    /// Holds copies.
    RareList(std::initializer_list<T> values) : list_(std::vector<T>(values)) {}
    bool empty() const noexcept { return size() == 0; }
    std::size_t size() const noexcept { return list_ ? list_->size() : 0; }
    T* begin() noexcept { return list_ ? list_->data() : nullptr; }
    T* end() noexcept { return begin() + size(); }
    const T* begin() const noexcept { return list_ ? list_->data() : nullptr; }
    const T* end() const noexcept { return begin() + size(); }
    T& operator[](std::size_t i) { return (*list_)[i]; }
    const T& operator[](std::size_t i) const { return (*list_)[i]; }
    void push_back(T value) {
        if (!list_) list_ = std::vector<T>();
        list_->push_back(std::move(value));
    }
    void clear() { list_ = {}; }
    bool operator==(const RareList& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

private:
    Rare<std::vector<T>> list_;
};

}  // namespace rakelight
