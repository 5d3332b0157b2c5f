// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/value.h"

#include <nlohmann/json.hpp>

#include <rakelight/scene/scene.h>

#include <cmath>
#include <limits>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

constexpr double max_exact_integer = 9007199254740992.0;  // 2^53

/// Integers may be written 4.0 or 4e0; anything else that is not 0 .. 2^53 gives nothing.
std::optional<std::uint64_t> as_count(const Json& value) {
    if (value.is_number_unsigned()) {
        const auto n = value.get<std::uint64_t>();
        return n <= std::uint64_t(max_exact_integer) ? std::optional(n) : std::nullopt;
    }
    if (!value.is_number_float()) return std::nullopt;  // a negative integer
    const double d = value.get<double>();
    if (!(d >= 0) || d > max_exact_integer || d != std::floor(d)) return std::nullopt;
    return std::uint64_t(d);
}

std::string described(const Json& value) {
    if (value.is_number()) return value.dump();
    return std::string("a JSON ") + value.type_name();
}

}  // namespace

void Value::fail(const std::string& reason) const { throw Error(ErrorCode::bad_file, reason, place_); }

const Json* Value::find(const char* name) const {
    if (!json_ || !json_->is_object()) return nullptr;
    const auto it = json_->find(name);
    return it == json_->end() ? nullptr : &*it;
}

Value Value::object(const char* name) const {
    const Json* part = find(name);
    if (part && !part->is_object()) fail(std::string(name) + " must be an object, not " + described(*part));
    return {part, place_, name};
}

Value Value::list(const char* name) const {
    const Json* part = find(name);
    if (part && !part->is_array()) fail(std::string(name) + " must be a list, not " + described(*part));
    return {part, place_, name};
}

bool Value::is_object() const { return json_ && json_->is_object(); }
bool Value::is_list() const { return json_ && json_->is_array(); }
bool Value::is_text_at(std::size_t i) const { return (*json_)[i].is_string(); }

std::vector<std::string> Value::names() const {
    std::vector<std::string> result;
    if (json_ && json_->is_object())
        for (const auto& item : json_->items()) result.push_back(item.key());
    return result;
}

std::size_t Value::size() const { return json_ && json_->is_array() ? json_->size() : 0; }

Value Value::element(std::size_t i) const {
    return element(i, format_text("{}{} {}", place_.empty() ? std::string() : place_ + ", ", name_, i));
}

Value Value::element(std::size_t i, std::string place) const {
    const Value part(&(*json_)[i], std::move(place));
    if (!part.json_->is_object()) part.fail("must be an object, not " + described(*part.json_));
    return part;
}

std::uint32_t Value::index_at(std::size_t i) const {
    const auto n = as_count((*json_)[i]);
    if (!n || *n >= no_index) fail(name_ + " must hold indices, not " + described((*json_)[i]));
    return std::uint32_t(*n);
}

std::string Value::text_at(std::size_t i) const {
    if (!(*json_)[i].is_string()) fail(name_ + " must hold strings, not " + described((*json_)[i]));
    return (*json_)[i].get<std::string>();
}

bool Value::boolean(const char* name, bool fallback) const {
    const Json* part = find(name);
    if (!part) return fallback;
    if (!part->is_boolean()) fail(std::string(name) + " must be true or false, not " + described(*part));
    return part->get<bool>();
}

std::optional<double> Value::optional_number(const char* name) const {
    const Json* part = find(name);
    if (!part) return std::nullopt;
    if (!part->is_number()) fail(std::string(name) + " must be a number, not " + described(*part));
    return part->get<double>();
}

double Value::number(const char* name, double fallback) const { return optional_number(name).value_or(fallback); }

float Value::real(const char* name, double fallback) const {
    const double value = number(name, fallback);
    if (!(std::fabs(value) <= double(std::numeric_limits<float>::max()))) fail(std::string(name) + " is too large");
    return float(value);
}

std::uint64_t Value::count(const char* name, std::uint64_t fallback) const {
    return find(name) ? required_count(name) : fallback;
}

std::uint64_t Value::required_count(const char* name) const {
    const Json* part = find(name);
    if (!part) fail(std::string(name) + " is missing");
    const auto n = as_count(*part);
    if (!n) fail(std::string(name) + " must be a non-negative whole number, not " + described(*part));
    return *n;
}

std::uint32_t Value::index(const char* name) const { return find(name) ? required_index(name) : no_index; }

std::uint32_t Value::required_index(const char* name) const {
    const std::uint64_t n = required_count(name);
    if (n >= no_index) fail(format_text("{} {} is not an index", name, n));
    return std::uint32_t(n);
}

const std::string* Value::text_pointer(const char* name) const {
    const Json* part = find(name);
    if (!part) return nullptr;
    if (!part->is_string()) fail(std::string(name) + " must be a string, not " + described(*part));
    return part->get_ptr<const std::string*>();
}

std::string Value::text(const char* name, const std::string& fallback) const {
    const std::string* value = text_pointer(name);
    return value ? *value : fallback;
}

bool Value::read_numbers(const char* name, double* out, std::size_t n) const {
    const Value values = list(name);
    if (!values) return false;
    if (values.size() != n) fail(format_text("{} must hold {} numbers, not {}", name, n, values.size()));
    for (std::size_t i = 0; i < n; ++i) {
        const Json& value = (*values.json_)[i];
        if (!value.is_number()) fail(std::string(name) + " must hold numbers, not " + described(value));
        out[i] = value.get<double>();
        if (!(std::fabs(out[i]) <= double(std::numeric_limits<float>::max())))
            fail(std::string(name) + " holds a number too large for use");
    }
    return true;
}

std::vector<float> Value::reals(const char* name) const {
    const Value values = list(name);
    std::vector<double> numbers(values.size());
    if (!numbers.empty()) read_numbers(name, numbers.data(), numbers.size());
    return {numbers.begin(), numbers.end()};
}

}  // namespace rakelight::io::gltf
