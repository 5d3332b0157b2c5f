// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/vector.h>

namespace rakelight::bake {

/// [V] the first vertex at exactly the same position.
/// @param places finite
std::vector<std::uint32_t> place_numbers(std::span<const dvec3> places);

}  // namespace rakelight::bake
