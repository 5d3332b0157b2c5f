// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/pictures/new_pixels.h"

#include <span>

namespace rakelight::io::codec {

/// Refuses an EXR file whose headers would make the library ask for more memory than the file explains.
/// @param bytes  the file, or its beginning with all of its headers
void check_exr(std::span<const std::byte> bytes, Context& context, std::uint64_t most_a_side = max_side);

}  // namespace rakelight::io::codec
