// SPDX-License-Identifier: Apache-2.0
// Checked reading of values from the JSON tree: every reader either returns a value of the right kind or throws an
// Error with its place. Only value.cpp includes the full JSON header.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/gltf/json_tree.h"

namespace rakelight::io::gltf {

/// A value of the tree, or an absent one. Cheap enough to pass by value; the tree must outlive it.
class Value {
public:
    Value() = default;
    /// @param place  for messages: "mesh 3 'body'"; the parts of an element keep the element's place
    Value(const Json* json, std::string place, std::string name = {})
        : json_(json), place_(std::move(place)), name_(std::move(name)) {}

    explicit operator bool() const { return json_ != nullptr; }  ///< present
    const std::string& place() const { return place_; }
    [[noreturn]] void fail(const std::string& reason) const;  ///< @throws Error bad_file at this place

    /// Parts; absent when the name is. @throws Error bad_file when present but not of that kind.
    Value object(const char* name) const;
    Value list(const char* name) const;
    Value extension(const char* name) const { return object("extensions").object(name); }
    Value part(const char* name) const { return {find(name), place_, name}; }  ///< of any kind
    bool has(const char* name) const { return find(name) != nullptr; }
    bool is_object() const;
    bool is_list() const;
    std::vector<std::string> names() const;  ///< of an object's members, sorted

    std::size_t size() const;            ///< of a list; 0 when absent
    Value element(std::size_t i) const;  ///< i < size(); must be an object, place becomes "PLACE, NAME i"
    Value element(std::size_t i, std::string place) const;  ///< the same with a place of its own
    std::uint32_t index_at(std::size_t i) const;            ///< a list element that is an index
    std::string text_at(std::size_t i) const;               ///< a list element that is a string
    bool is_text_at(std::size_t i) const;

    bool boolean(const char* name, bool fallback) const;
    double number(const char* name, double fallback) const;  ///< finite
    float real(const char* name, double fallback) const;     ///< finite and in float's range
    std::optional<double> optional_number(const char* name) const;
    std::uint64_t count(const char* name, std::uint64_t fallback) const;  ///< an integer of 0 .. 2^53
    std::uint64_t required_count(const char* name) const;
    std::uint32_t index(const char* name) const;  ///< `none` when absent
    std::uint32_t required_index(const char* name) const;
    std::string text(const char* name, const std::string& fallback = {}) const;
    const std::string* text_pointer(const char* name) const;  ///< without a copy; null when absent

    template <std::size_t N>
    std::optional<std::array<double, N>> numbers(const char* name) const {
        std::array<double, N> values{};
        if (!read_numbers(name, values.data(), N)) return std::nullopt;
        return values;
    }
    std::vector<float> reals(const char* name) const;  ///< a list of any length

private:
    const Json* find(const char* name) const;
    bool read_numbers(const char* name, double* out, std::size_t n) const;
    const Json* json_ = nullptr;
    std::string place_, name_;
};

}  // namespace rakelight::io::gltf
