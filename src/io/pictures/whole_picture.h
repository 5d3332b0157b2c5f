// SPDX-License-Identifier: Apache-2.0
// Pictures that are there, decoded to their last row: only so is one noticed that was damaged in its middle.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

#include "io/movie/png_chunks.h"

namespace rakelight {
class Context;
}

namespace rakelight::io {

/// @throws Error not_found: it is no regular file; bad_file: it is not whole; both with its name
PngHeader header_of_whole_png(const std::string& path, Context& context);

struct PictureSize {
    int width = 0, height = 0;  ///< [px]
    bool operator==(const PictureSize&) const = default;
};
/// Of any format. What JPEG and PPM files have lost is noticed only where the decoder does: they have no checksums.
/// @throws Error as header_of_whole_png()
PictureSize size_of_whole_picture(const std::string& path, Context& context);

/// Calls check(i) for each picture, several at a time. What fails is checked again alone: memory for all at once may have
/// been lacking.
/// @return [pictures] what is wrong with them
/// @throws Error bad_file: there is not memory enough for one; failed: cancelled
std::vector<std::optional<Error>> faults_of_pictures(std::size_t count, const std::function<void(std::size_t)>& check,
                                                     Context& context);

}  // namespace rakelight::io
