// SPDX-License-Identifier: Apache-2.0
// Changed materials as sections [[material]] of a world that has sections of its own.
#pragma once
#include <vector>

#include <rakelight/io/world.h>

namespace rakelight::viewer {

/// Changes the sections so that the values go over all that the world says of the target's materials, and all else stays.
/// Sections for all objects act in the order of the file, later ones over earlier ones, then those for single objects likewise;
/// there is at most one for each name, model and object.
/// @param target  its name ("*": all), model and object
void set_values(WorldFile& world, const WorldMaterial& target, const std::vector<WorldValue>& values);

}  // namespace rakelight::viewer
