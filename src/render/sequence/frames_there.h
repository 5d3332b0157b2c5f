// SPDX-License-Identifier: Apache-2.0
// Files that have the names of a sequence's pictures before it is drawn.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/render/picture.h>

namespace rakelight {

/// A picture would wait for ever for who reads from a FIFO of its name.
/// @throws Error failed: something else than a file has the name of a picture
void check_frame_names(const PictureRequest& request, std::span<const std::int64_t> frames);

/// Which pictures are there: whole, and as large as they shall be. One that is damaged is named in the report.
std::vector<char> frames_there(const PictureRequest& request, std::span<const std::int64_t> frames, Context& context);

}  // namespace rakelight
