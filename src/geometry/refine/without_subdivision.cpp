// SPDX-License-Identifier: Apache-2.0
// Replacements for builds without OpenSubdiv (RAKELIGHT_SUBDIVISION=OFF).
#include "base/left_out.h"
#include "geometry/refine/subdivide.h"

namespace rakelight::geometry {
namespace {

[[noreturn]] void refuse() {
    throw left_out("subdivision", "OpenSubdiv", "RAKELIGHT_SUBDIVISION", ErrorCode::usage).about("subdivide");
}

}  // namespace

std::uint64_t fine_face_count(Scheme, int, const Polygons&) { refuse(); }
std::uint64_t subdivision_bytes(Scheme, std::uint64_t) { refuse(); }
LimitSurface subdivide(const ControlSurface&, Context&) { refuse(); }
LimitValues subdivide_values(const ControlSurface&, const ControlValues&, Context&) { refuse(); }

}  // namespace rakelight::geometry
