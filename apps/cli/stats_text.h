// SPDX-License-Identifier: Apache-2.0
// What `rakelight render --stats` says.
#pragma once
#include <string>

#include <rakelight/render/picture.h>

namespace rakelight::cli {

/// "PICTURE: what  count" a line.
std::string stats_text(const PictureResult& result);

}  // namespace rakelight::cli
