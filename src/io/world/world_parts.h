// SPDX-License-Identifier: Apache-2.0
// The other sections of a world file, from their values.
#pragma once
#include "io/world/section_values.h"

namespace rakelight::io::world {

WorldModel read_model(const SectionValues& values);
WorldPrimitive read_primitive(const SectionValues& values);
WorldMaterial read_material(const SectionValues& values);
Fog read_fog(const SectionValues& values);
WorldEnvironment read_environment(const SectionValues& values);

/// Materials and models that are named must be there. @throws Error bad_file
void check_names(const WorldFile& world);

}  // namespace rakelight::io::world
