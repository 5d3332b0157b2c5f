// SPDX-License-Identifier: Apache-2.0
// What two compared pictures keep, for the outputs.
#pragma once
#include <vector>

#include <rakelight/tools/compare.h>

#include "image/compare/display_picture.h"

namespace rakelight {

struct ComparedPictures::State {
    CompareOptions options{};
    Pixels a{}, b{};  ///< of equal channels
    DisplayPicture display_a{}, display_b{};
    MemoryCharge map_charge{};
    std::vector<float> flip_map{};  ///< [height * width] 0..1
    PictureComparison comparison{};
};

}  // namespace rakelight
