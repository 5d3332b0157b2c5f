// SPDX-License-Identifier: Apache-2.0
// What is wrong with a command line, in one line each.
#pragma once
#include <rakelight/error.h>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace rakelight::cli {

/// CLI11's message as one line that says where help is. An option that is not known is said with the nearest that is.
/// @param app  that was parsed
Error usage_error(const CLI::ParseError& fault, const CLI::App& app);

/// @throws Error usage: a flag is given a value, such as --edges=5
/// @param app  that is to be parsed
void refuse_values_of_flags(const CLI::App& app, int argc, const char* const* argv);

}  // namespace rakelight::cli
