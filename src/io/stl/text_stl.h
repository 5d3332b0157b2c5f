// SPDX-License-Identifier: Apache-2.0
// STL text: solids of facets with three vertices each. Keywords may be written in capitals.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::io::stl {

struct TextSolid {
    std::string name;              ///< the first word behind "solid", or empty
    std::size_t first_corner = 0;  ///< its corners end where the next solid's begin
};

struct TextStl {
    std::vector<TextSolid> solids;
    std::vector<dvec3> corners;  ///< [3 facets]; what is no finite float is NaN
    MemoryCharge charge;         ///< of both, and of the nodes and meshes that the solids become
};

/// The first word is "solid", and nothing in the first 512 bytes looks binary.
bool begins_as_text(std::string_view text);

/// @param text  begins_as_text()
/// @param path  for remarks: words that are none of STL, decimal commas, a missing "endsolid"
/// @throws Error bad_file, with the line: a facet without three vertices, a vertex without three numbers; no facet
TextStl read_text_stl(std::string_view text, const std::string& path, Context& context);

}  // namespace rakelight::io::stl
