// SPDX-License-Identifier: Apache-2.0
// The lights and cameras of a world file, from their values.
#pragma once
#include <vector>

#include "io/world/section_values.h"

namespace rakelight::io::world {

Light read_light(const SectionValues& values);
/// Keys that a light of this type has, beside `keys` and `interpolation`.
std::vector<const char*> keys_of(const Light& light);
Camera read_camera(const SectionValues& values, WorldFile& world);  ///< remarks of its up

}  // namespace rakelight::io::world
