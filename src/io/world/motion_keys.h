// SPDX-License-Identifier: Apache-2.0
// What `keys` of cameras and lights move in a world file.
#pragma once
#include <span>

#include "io/world/section_values.h"

#include <rakelight/scene/animated_properties.h>

namespace rakelight::io::world {

/// A key of [[camera]] or [[light]] that may stand in `keys`, too.
struct MovingKey {
    enum class Unit { same, degrees, twice };  ///< of the file: degrees for radians, a height for half of it
    const char* key;
    const char* property;  ///< of animated_properties()
    Unit unit = Unit::same;
};
std::span<const MovingKey> moving_camera_keys();
std::span<const MovingKey> moving_light_keys();

/// What keys move of the camera or light that was read last. @throws Error bad_file: times that do not ascend, keys of nothing
void add_camera_tracks(const SectionValues& values, WorldFile& world);
void add_light_tracks(const SectionValues& values, WorldFile& world);

}  // namespace rakelight::io::world
