// SPDX-License-Identifier: Apache-2.0
// Unpacking of EXT_meshopt_compression (and KHR_meshopt_compression with the same codecs) by meshoptimizer.
#pragma once
#include <span>

#include "io/files/file.h"
#include "io/gltf/value.h"

namespace rakelight::io::gltf {

/// @param packed  the extension's object: count, byteStride, mode, filter
/// @param data    the compressed bytes that it points to
/// @return [count * byteStride] bytes, filtered
/// @throws Error bad_file at the view: impossible sizes for the mode or filter, more elements than the data can hold,
/// broken data.
Bytes decode_meshopt(const Value& packed, std::span<const std::byte> data, Context& context);

}  // namespace rakelight::io::gltf
