// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace rakelight::cli {

/// The text of --version. @throws Error usage when RAKELIGHT_ISA cannot be had
std::string version_text();

}  // namespace rakelight::cli
