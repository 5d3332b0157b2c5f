// SPDX-License-Identifier: Apache-2.0
// An optional value that few have.
#pragma once
#include <memory>
#include <utility>

namespace rakelight {

/// As std::optional, but where there is no value it takes the room of a pointer only: for large members that most of
/// many objects lack. Copying copies the value.
template <class T>
class Rare {
public:
    Rare() = default;
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

}  // namespace rakelight
