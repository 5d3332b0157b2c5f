// SPDX-License-Identifier: Apache-2.0
// Makes the components of two pictures comparable.
#pragma once
#include <rakelight/image/image.h>

namespace rakelight {

/// Gives both the same channels and the same meaning of numbers: see ComparedPictures. Pictures that agree stay as they are.
/// @throws Error bad_file: beyond the memory budget
void make_comparable(Pixels& a, Pixels& b, Context& context);

}  // namespace rakelight
