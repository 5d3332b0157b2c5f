// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression for new data: without loss, in the order given.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// Describes `data` as a view of a buffer that is not stored, as files with this extension have one.
/// @param view       gets buffer, byteOffset and byteLength there, and the extension with mode, count and byteStride
/// @param extension  its name
/// @return the compressed bytes, whose buffer and byteOffset are for the caller to add to the extension; empty, and
/// `view` is as
///         before, when the file has no such buffer or the elements have a size that the codec does not take
std::vector<std::byte> compress(std::span<const std::byte> data, std::size_t element_bytes, bool is_indices,
                                const std::string& extension, OrderedJson& tree, OrderedJson& view);

}  // namespace rakelight::io::gltf
