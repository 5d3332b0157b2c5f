// SPDX-License-Identifier: Apache-2.0
// In place of bake_texels.cpp where no engine follows rays: bake_maps() refuses before.
#include "bake/bake_texels.h"

namespace rakelight::bake {

std::vector<std::uint8_t> bake_texels(const Scene&, const Scene&, const BakeOptions&, BakeResult&, Context&) {
    throw Error(ErrorCode::failed, "this build follows no rays");
}

}  // namespace rakelight::bake
