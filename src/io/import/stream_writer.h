// SPDX-License-Identifier: Apache-2.0
// Writes the records of stream_format.h to a file descriptor. Used by the helper (and by tests, to a buffer).
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "io/import/stream_format.h"

namespace rakelight::io::import_stream {

class Writer {
public:
    using Put = std::function<void(std::span<const std::byte>)>;
    explicit Writer(Put put) : put_(std::move(put)) {}

    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        put_(std::as_bytes(std::span(&v, 1)));
    }
    void text(const std::string& s) {
        value(std::uint32_t(s.size()));
        put_(std::as_bytes(std::span(s)));
    }
    template <class T>
    void array(const std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        value(std::uint64_t(v.size()));
        put_(std::as_bytes(std::span(v)));
    }
    template <class T>
    void arrays(const std::vector<std::vector<T>>& v) {
        value(std::uint64_t(v.size()));
        for (const auto& inner : v) array(inner);
    }
    template <class T>
    void records(std::vector<T>& v) {
        value(std::uint64_t(v.size()));
        for (T& r : v) transfer(*this, r);
    }

private:
    Put put_;
};

}  // namespace rakelight::io::import_stream
