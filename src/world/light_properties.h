// SPDX-License-Identifier: Apache-2.0
// The properties of a light, by name.
#pragma once
#include <string>
#include <string_view>

#include <rakelight/scene/scene.h>

namespace rakelight::values {

/// Sets a property of a light.
/// @param value as on the command line
/// @throws Error usage: no such property, or a value out of range
void set_light_property(const std::string& option, Light& light, std::string_view name, std::string_view value);

}  // namespace rakelight::values
