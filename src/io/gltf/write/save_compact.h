// SPDX-License-Identifier: Apache-2.0
// Bytes of buffer views that nothing refers to, taken out of the binary chunk of a GLB.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// Takes the bytes of dead views out of buffer 0, except for those that lie in a live view too; offsets of the others
/// move by multiples of 4. Views and accessors keep their numbers. A dead view keeps one byte at the start of the
/// buffer; a dead accessor keeps no view, so its elements are zeros (glTF 2.0, section 3.6.2). Where the file has an
/// extension of which is not known whether it refers to views or accessors, nothing is done.
/// @param binary  all of buffer 0
/// @return [bytes] taken out
std::uint64_t drop_dead_views(OrderedJson& tree, std::vector<std::byte>& binary);

}  // namespace rakelight::io::gltf
