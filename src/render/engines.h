// SPDX-License-Identifier: Apache-2.0
// The engines of this build.
#pragma once
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight {

/// Names for make_engine(), the default first.
std::vector<std::string> engine_names();

/// The instruction set that an engine uses; empty for engines that do not choose one.
/// @throws Error usage: RAKELIGHT_ISA names an unknown set or one that this processor lacks
std::string engine_isa(const std::string& name);

/// @throws Error usage: the name is not one of engine_names()
void check_engine_name(const std::string& name);

/// Whether an engine has all that the settings ask for.
bool can_draw(const EngineCapabilities& can, const RenderSettings& settings);
/// @throws Error usage: the settings ask for what the engine of that name cannot do
void check_abilities(const std::string& name, const EngineCapabilities& can, const RenderSettings& settings);

}  // namespace rakelight
