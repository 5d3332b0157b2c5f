// SPDX-License-Identifier: Apache-2.0
// First two passes over an OBJ file: what is in it, and its v, vt and vn lines.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

#include "io/obj/obj_remarks.h"

namespace rakelight::io::obj {

/// What a file holds, counted before memory is asked for.
struct Contents {
    std::uint64_t positions = 0, texcoords = 0, normals = 0, elements = 0;  ///< v, vt, vn; f, l and p lines
    bool has_objects = false;                                               ///< any `o` line
    bool has_smoothing = false;                                             ///< any `s` line
    std::vector<std::string> libraries;  ///< arguments of the mtllib lines, in order, each text once
};

/// Numbers of the file as written, in its order.
struct VertexData {
    std::vector<dvec3> positions;  ///< a coordinate that is unreadable, not finite or too large for float is NaN
    std::vector<vec4> colors;      ///< [positions] or empty; linear RGBA, white where a vertex has none
    std::vector<bool> has_color;   ///< [colors]
    std::vector<vec2> texcoords;   ///< v down, finite
    std::vector<vec3> normals;     ///< unit; (0, 0, 0) where the file's is unusable
    MemoryCharge charge;
};

/// @throws Error bad_file: UTF-16 text, more than 2^32 - 2 vertices of a kind; failed: cancelled
Contents count_contents(std::string_view file, Remarks& remarks, Context& context);

/// Charges the memory first, by the counts. @throws Error bad_file: over the memory limit; failed: cancelled
VertexData read_vertices(std::string_view file, const Contents& contents, Remarks& remarks, Context& context);

}  // namespace rakelight::io::obj
