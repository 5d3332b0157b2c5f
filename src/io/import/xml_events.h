// SPDX-License-Identifier: Apache-2.0
// XML as a run of events, by expat.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace rakelight::io {

/// What an element says of itself.
class XmlAttributes {
public:
    explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}
    /// Empty when it is not there.
    std::string_view operator[](std::string_view name) const;

private:
    const char* const* pairs_;
};

/// May throw; lines count from 1.
class XmlHandler {
public:
    virtual ~XmlHandler() = default;
    virtual void start(std::string_view /*element*/, const XmlAttributes&) {}
    virtual void end(std::string_view /*element*/) {}
    /// A part of a text, in UTF-8; parts may end anywhere.
    virtual void text(std::string_view /*part*/, std::uint64_t /*line*/) {}
};

/// A whole document. Encodings that are neither Unicode nor Latin 1 are read byte by byte as Latin 1.
/// @throws Error bad_file "line N: ...": not well-formed, a document type (whose entities could name files or grow without bound),
///         more than 512 elements deep; and what the handler throws
void read_xml(std::span<const std::byte> bytes, XmlHandler& handler);

}  // namespace rakelight::io
