// SPDX-License-Identifier: Apache-2.0
// Converts any exception to an Error, for the outermost handler of a program.
#pragma once
#include <string>

#include <rakelight/base/error.h>
#include <rakelight/base/export.h>

namespace rakelight {

/// The currently handled exception as an Error with a readable message. An Error is returned as it is. std::bad_alloc
/// gives `out_of_memory`. Other exceptions give the message of the system or of a library; texts of the standard
/// library are dropped. Call it only in exception handlers.
/// @param out_of_memory  message for std::bad_alloc, with the code `failed`
RL_API Error current_error(const std::string& out_of_memory = "out of memory");

}  // namespace rakelight
