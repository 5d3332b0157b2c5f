// SPDX-License-Identifier: Apache-2.0
// The sections of a world file, from their values.
#pragma once
#include "io/world/section_values.h"

namespace rakelight::io::world {

WorldModel read_model(const SectionValues& values);
WorldPrimitive read_primitive(const SectionValues& values);
Light read_light(const SectionValues& values);
/// Keys that a light of this type has, beside `keys` and `interpolation`.
std::vector<const char*> keys_of(const Light& light);
Camera read_camera(const SectionValues& values, WorldFile& world);  ///< remarks of its up
WorldMaterial read_material(const SectionValues& values);
Fog read_fog(const SectionValues& values);
WorldEnvironment read_environment(const SectionValues& values);

/// Materials and models that are named must be there. @throws Error bad_file
void check_names(const WorldFile& world);

}  // namespace rakelight::io::world
