// SPDX-License-Identifier: Apache-2.0
// The GLB container: a header, a JSON chunk, and perhaps a binary chunk (glTF 2.0 specification, section 4).
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <rakelight/base/context.h>

namespace rakelight::io::gltf {

struct Container {
    std::span<const std::byte> json;
    std::span<const std::byte> binary;  ///< the BIN chunk with its padding
    bool has_binary = false;
};

/// Finds the parts of a file: a GLB container by its magic, else the whole file is JSON.
/// Bytes after the stated length, unknown chunks and second BIN chunks are left out and reported.
/// @throws Error bad_file: neither kind; a wrong version; a length or chunk that reaches past the end; JSON not first.
Container open_container(std::span<const std::byte> file, const std::string& path, Context& context);

}  // namespace rakelight::io::gltf
