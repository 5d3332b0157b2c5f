// SPDX-License-Identifier: Apache-2.0
// What a key did, in words: its effect may be too small to be seen.
#pragma once
#include <string>

#include "document.h"
#include "keys.h"

namespace rakelight::viewer {

/// "shading: flat", after the command; empty: what it did is seen.
std::string effect_of(Command command, const Look& look, const Model& model);

}  // namespace rakelight::viewer
