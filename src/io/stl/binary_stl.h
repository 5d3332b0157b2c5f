// SPDX-License-Identifier: Apache-2.0
// Binary STL: a header of 80 bytes, the number of facets, and 50 bytes for each: normal, three corners, an attribute.
// Two programs store colors in the attribute: bit 15 and five bits a channel.
// - VisCAM and SolidView (A. van der Geest): bit 15 says that the facet has a color; blue stands in the lowest bits.
// - Materialise Magics: the header has the color of the object behind "COLOR=". Bit 15 says that the facet has that one; else
//   the facet has its own, and red stands in the lowest bits.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "io/stl/join_corners.h"

namespace rakelight::io::stl {

class BinaryStl {
public:
    /// The file whose size is that of the facets which it declares. nullopt: it is not binary, or damaged.
    static std::optional<BinaryStl> of(std::string_view file);

    std::size_t facet_count() const { return facets_.size() / facet_bytes; }
    /// Corners of the file from `first`, a multiple of 3.
    void read_corners(std::size_t first, std::span<Corner> out) const;
    /// Linear, of the whole object, by its header.
    std::optional<vec4> object_color() const { return object_color_; }
    /// Linear, of Corner::color.
    vec4 color(std::uint32_t corner_color) const;

private:
    static constexpr std::size_t facet_bytes = 50;
    void read_header(std::string_view header);
    bool has_attributes() const;
    std::uint32_t facet_color(std::uint32_t attribute) const;

    std::string_view facets_;
    std::optional<vec4> object_color_;
    vec3 object_display_;              ///< color of the object, display values
    bool ignores_attributes_ = false;  ///< of Magics: none is set
};

/// @throws Error bad_file, always: what is wrong with a file that is neither text nor whole
[[noreturn]] void refuse_binary(std::string_view file);

}  // namespace rakelight::io::stl
