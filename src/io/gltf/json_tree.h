// SPDX-License-Identifier: Apache-2.0
// The JSON text of a glTF file as a tree, built without recursion and with a limit on its depth.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <rakelight/base/context.h>

namespace rakelight::io::gltf {

using Json = nlohmann::json;

/// Arrays and objects inside one another. glTF itself needs 8; the rest is for `extras`. What walks or frees the tree
/// recurses, so the limit keeps the stack safe.
inline constexpr std::size_t max_json_depth = 256;

/// Parses UTF-8 JSON. A byte order mark is skipped and a name that an object holds twice keeps its last value; both are
/// reported.
/// @param charge  grows by the tree's memory
/// @throws Error bad_file: not JSON (NaN tokens, UTF-16 and text after the end too), a number beyond double, too deep.
Json parse_json(std::span<const std::byte> text, const std::string& file, MemoryCharge& charge, Context& context);

}  // namespace rakelight::io::gltf
