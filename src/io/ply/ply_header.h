// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file (Turk 1994, "The PLY Polygon File Format").
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rakelight::io::ply {

enum class Format : std::uint8_t { ascii, little_endian, big_endian };
enum class Type : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
std::size_t size_of(Type type);
constexpr bool is_real(Type type) { return type == Type::f32 || type == Type::f64; }

struct Property {
    std::string name{};
    Type type = Type::f32;
    std::optional<Type> count_type{};  ///< of a list: the number before its values
};

struct Element {
    std::string name{};
    std::uint64_t count = 0;
    std::vector<Property> properties{};  ///< at most 1000
    bool has_lists() const;
    /// Least size of one in the file: in text a digit and a blank for each number.
    std::uint64_t least_bytes(Format format) const;
};

struct Header {
    Format format = Format::ascii;
    std::size_t bytes = 0;                ///< where the data begin
    std::vector<Element> elements{};      ///< at most 100
    std::vector<std::string> textures{};  ///< names after "comment TextureFile"
};

/// Every count is checked against the size of the file. @throws Error bad_file
Header read_header(std::string_view file);

}  // namespace rakelight::io::ply
