// SPDX-License-Identifier: Apache-2.0
// Programs with texts of the user's go through the driver in a process of its own first (rakelight-shader-check, apps/shader_check):
// there they may take all memory and time that they like, within limits.
#pragma once
#include <cstdint>
#include <optional>

#include "engines/opengl/programs/compile.h"
#include "engines/opengl/programs/program_text.h"

namespace rakelight::opengl {

/// Of one program, beside what the driver itself takes.
inline constexpr std::uint64_t shader_check_bytes = std::uint64_t(1) << 30;
inline constexpr int shader_check_seconds = 10;  ///< of the processor; by the clock four times as long

/// Once for each text in a run of this program.
/// @return what the driver says is wrong; none: it compiles, links and draws
/// @throws Error bad_file: it takes more than the limits, or the driver crashes on it; failed: the program is not there or
///         has no OpenGL
std::optional<CompileFault> checked_apart(const ProgramText& text);

}  // namespace rakelight::opengl
