// SPDX-License-Identifier: Apache-2.0
// Reads the records of stream_format.h from an untrusted sender: the helper runs on hostile files and may be made to say anything.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <rakelight/base/context.h>

#include "io/import/stream_format.h"

namespace rakelight::io::import_stream {

/// Where the bytes come from: a pipe with a deadline, or memory.
class Source {
public:
    virtual ~Source() = default;
    /// Fills `to` wholly. @throws Error bad_file: the stream ends early, takes too long.
    virtual void read(std::span<std::byte> to) = 0;
};

class MemorySource final : public Source {
public:
    explicit MemorySource(std::span<const std::byte> bytes) : rest_(bytes) {}
    void read(std::span<std::byte> to) override;

private:
    std::span<const std::byte> rest_;
};

/// Counts are charged to the memory budget and memory is taken in steps as bytes arrive, so a lying count costs nothing.
class Reader {
public:
    Reader(Source& source, Context& context) : source_(source), charge_(context.memory()) {}
    /// Pays for all that was read.
    MemoryCharge& charge() { return charge_; }

    template <class T>
    void value(T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        source_.read(std::as_writable_bytes(std::span(&v, 1)));
    }
    void text(std::string& s);
    template <class T>
    void array(std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::uint64_t count = checked_count(sizeof(T));
        constexpr std::uint64_t step = (std::uint64_t(4) << 20) / sizeof(T);
        while (v.size() < count) {
            const std::size_t have = v.size(), more = std::size_t(count - have < step ? count - have : step);
            if (v.capacity() < have + more)
                v.reserve(std::size_t(have * 2 < count ? std::max<std::uint64_t>(have * 2, have + more) : count));
            v.resize(have + more);
            source_.read(std::as_writable_bytes(std::span(v).subspan(have, more)));
        }
    }
    template <class T>
    void arrays(std::vector<std::vector<T>>& v) {
        const std::uint64_t count = checked_count(sizeof(std::vector<T>));
        for (std::uint64_t i = 0; i < count; ++i) array(v.emplace_back());
    }
    template <class T>
    void records(std::vector<T>& v) {
        const std::uint64_t count = checked_count(sizeof(T));
        for (std::uint64_t i = 0; i < count; ++i) transfer(*this, v.emplace_back());
    }

private:
    /// Reads a count and charges count * element_bytes.
    std::uint64_t checked_count(std::size_t element_bytes);
    Source& source_;
    MemoryCharge charge_;
};

struct Import {
    MemoryCharge charge;  ///< pays for all of it
    Document document;
    std::vector<Part> parts;
};

/// The whole stream, with every size, index and enumeration checked: what comes out may be used without a further look
/// (numbers may still be NaN or infinite).
/// @throws Error bad_file: broken or short stream, over the memory budget; or the refusal that the helper sent.
Import read_import(Source& source, Context& context);

}  // namespace rakelight::io::import_stream
