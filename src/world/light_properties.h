// SPDX-License-Identifier: Apache-2.0
// The properties of a light, by name.
#pragma once
#include <string>
#include <string_view>

#include <rakelight/scene.h>

namespace rakelight::values {

/// Sets a property that this kind of light has. @param value  as the command line has it
/// @throws Error usage: no such property, or a value out of its range
void set_light_property(const std::string& option, Light& light, std::string_view name, std::string_view value);

}  // namespace rakelight::values
