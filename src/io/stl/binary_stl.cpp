// SPDX-License-Identifier: Apache-2.0
#include "io/stl/binary_stl.h"

#include <cmath>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "math/color.h"
#include "math/linear.h"

namespace rakelight::io::stl {
namespace {

constexpr std::size_t header_bytes = 80, count_end = 84;
constexpr std::uint32_t has_color = 0x8000;  ///< set in Corner::color of facets with a color of their own

std::uint32_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::uint32_t word16(std::string_view bytes, std::size_t at) {
    return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8;
}

std::uint32_t word32(std::string_view bytes, std::size_t at) { return word16(bytes, at) | word16(bytes, at + 2) << 16; }

/// Of a file with a whole header.
std::uint64_t declared_bytes(std::string_view file) {
    return count_end + std::uint64_t(word32(file, header_bytes)) * 50;
}

/// Five bits a channel, the lowest first.
vec3 channels(std::uint32_t color) {
    constexpr float step = 1.0f / 31;
    return {float(color & 31) * step, float(color >> 5 & 31) * step, float(color >> 10 & 31) * step};
}

}  // namespace

std::optional<BinaryStl> BinaryStl::of(std::string_view file) {
    if (file.size() < count_end || declared_bytes(file) != file.size()) return {};
    BinaryStl out;
    out.facets_ = file.substr(count_end);
    out.read_header(file.substr(0, header_bytes));
    return out;
}

void BinaryStl::read_header(std::string_view header) {
    constexpr std::string_view key = "COLOR=";
    const std::size_t at = header.find(key);
    if (at == std::string_view::npos || header.size() - at < key.size() + 4) return;
    float rgba[4];
    for (std::size_t k = 0; k < 4; ++k) rgba[k] = float(byte_at(header, at + key.size() + k)) * (1.0f / 255);
    object_display_ = {rgba[0], rgba[1], rgba[2]};
    const vec3 linear = linear_from_srgb(object_display_);
    object_color_ = {linear.x, linear.y, linear.z, rgba[3]};
    ignores_attributes_ = !has_attributes();
}

bool BinaryStl::has_attributes() const {
    for (std::size_t at = facet_bytes - 2; at < facets_.size(); at += facet_bytes)
        if (word16(facets_, at) != 0) return true;
    return false;
}

/// Corner::color of a facet. A color of Magics that five bits cannot tell from the object's is the object's, which has eight.
std::uint32_t BinaryStl::facet_color(std::uint32_t attribute) const {
    if (!object_color_) return attribute & has_color ? attribute : 0;
    if (ignores_attributes_ || attribute & has_color) return 0;
    const vec3 off = channels(attribute) - object_display_;
    const bool is_objects = std::fabs(off.x) * 31 < 1 && std::fabs(off.y) * 31 < 1 && std::fabs(off.z) * 31 < 1;
    return is_objects ? 0 : attribute | has_color;
}

void BinaryStl::read_corners(std::size_t first, std::span<Corner> out) const {
    for (std::size_t i = 0; i < out.size(); i += 3) {
        const std::string_view facet = facets_.substr((first + i) / 3 * facet_bytes, facet_bytes);
        const std::uint32_t color = facet_color(word16(facet, facet_bytes - 2));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = 12 + 12 * k;
            Corner& corner = out[i + k];
            corner.x = word32(facet, at), corner.y = word32(facet, at + 4), corner.z = word32(facet, at + 8);
            corner.color = color;
        }
    }
}

vec4 BinaryStl::color(std::uint32_t corner_color) const {
    constexpr vec4 gray{0.3185468f, 0.3185468f, 0.3185468f, 1};  // as plain_material() of a model without colors
    if (corner_color == 0) return object_color_.value_or(gray);
    const vec3 c = channels(corner_color);
    const vec3 linear = linear_from_srgb(object_color_ ? c : vec3{c.z, c.y, c.x});
    return {linear.x, linear.y, linear.z, 1};
}

void refuse_binary(std::string_view file) {
    if (file.size() < count_end)
        throw Error(ErrorCode::bad_file,
                    "not an STL file (neither text beginning with 'solid' nor the size of a binary one)");
    const std::uint32_t count = word32(file, header_bytes);
    const std::uint64_t needs = declared_bytes(file);
    throw Error(ErrorCode::bad_file,
                needs > file.size()
                    ? format_text("it promises {} triangles (at least {} bytes), but {} bytes are there", count, needs,
                                  file.size())
                    : format_text("{} bytes follow the {} triangles that it declares", file.size() - needs, count),
                "byte 80");
}

}  // namespace rakelight::io::stl
