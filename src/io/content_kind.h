// SPDX-License-Identifier: Apache-2.0
// The kind of a file's content, by its first bytes.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace rakelight::io {

struct ContentKind {
    std::string_view name;    ///< for people: "JPEG picture", "FBX"; empty: not recognized
    std::string_view ending;  ///< the model format's usual ending, without the dot; empty: no model format
    bool is_certain = false;  ///< a signature that no file of another format begins with
};

/// @param head  the first bytes of the file, 64 are enough
ContentKind content_kind(std::span<const std::byte> head);

}  // namespace rakelight::io
