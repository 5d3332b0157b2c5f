// SPDX-License-Identifier: Apache-2.0
// For the last handler of a program: what is said of an exception, whatever it is.
#pragma once
#include <string>

#include <rakelight/error.h>
#include <rakelight/export.h>

namespace rakelight {

/// The exception that is being handled, as an Error in words for people: an Error as it is, a lack of memory, what the
/// system or a library says. What the standard library says of itself is left out. Only to be called from a handler.
/// @param out_of_memory  what is said when memory ran out; such an error has the code `failed`
RL_API Error current_error(const std::string& out_of_memory = "out of memory");

}  // namespace rakelight
