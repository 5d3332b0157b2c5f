// SPDX-License-Identifier: Apache-2.0
// The door of the glTF reader for bytes that are already in memory.
#pragma once
#include "io/files/file.h"
#include "io/reader.h"

namespace rakelight::io::gltf {

/// What gltf_reader (io/model_readers.h) does with a file whose bytes are `file`; `path` is for messages and for resolving references.
/// @throws Error that carries `path`
Scene read_gltf_bytes(const std::string& path, Bytes file, const ReadOptions& options, Context& context);

}  // namespace rakelight::io::gltf
