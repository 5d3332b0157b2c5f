// SPDX-License-Identifier: Apache-2.0
// The options of commands as types of TypeScript, for the npm package.
#pragma once
#include <string>

#include "command_line.h"

namespace rakelight::apps {

/// An interface for each command: "export interface InspectOptions". Names are in camel case: maxSeam is --max-seam.
std::string typescript_options(const Program& program);

}  // namespace rakelight::apps
