// SPDX-License-Identifier: Apache-2.0
// Second pass over an OBJ file: its v, vt and vn lines. It takes all chunks at once.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

#include "io/obj/obj_contents.h"
#include "io/obj/obj_remarks.h"

namespace rakelight::io::obj {

/// Numbers of the file as written, in its order.
struct VertexData {
    std::vector<dvec3> positions;         ///< a coordinate that is unreadable, not finite or too large for float is NaN
    std::vector<vec4> colors;             ///< [positions] or empty; linear RGBA, white where a vertex has none
    std::vector<std::uint8_t> has_color;  ///< [colors] 1 or 0
    std::vector<vec2> texcoords;          ///< v down, finite
    std::vector<vec3> normals;            ///< unit; (0, 0, 0), which is none, where the file's is zero or not finite
    MemoryCharge charge;
};

/// Charges the memory first, by the counts. @throws Error bad_file: over the memory limit; failed: cancelled
VertexData read_vertices(std::string_view file, const Contents& contents, Remarks& remarks, Context& context);

}  // namespace rakelight::io::obj
