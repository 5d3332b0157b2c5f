// SPDX-License-Identifier: Apache-2.0
// The numbers of a PLY file one after another, text or binary.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "io/ply/ply_header.h"

namespace rakelight::io::ply {

class Cursor {
public:
    /// @param file  the whole file, whose data begin at header.bytes
    Cursor(std::string_view file, const Header& header);

    /// The element whose numbers follow: for messages.
    void begin(const Element& element) { element_ = &element; }
    /// The next number. A word that is none is NaN and counted. @throws Error bad_file: the data end here
    double number(Type type);
    /// The number of values of a list. @throws Error bad_file: it is negative, or more than can follow
    std::uint64_t list(const Property& property);
    /// Passes over the values of one row, or of one property in it.
    void skip_row(const Element& element);
    void skip(const Property& property);
    /// Binary data of all rows of an element without lists, which are passed over. @throws Error bad_file: they end before
    std::string_view rows(const Element& element);
    bool is_at_end();
    std::uint64_t bad_words() const { return bad_words_; }

private:
    double word();
    double binary(Type type);
    void skip_blanks();
    [[noreturn]] void ends_here() const;
    std::string line_of(std::size_t at) const;  ///< "line 12"

    std::string_view file_;
    Format format_;
    std::size_t at_;
    const Element* element_ = nullptr;
    std::uint64_t bad_words_ = 0;
};

/// A number of binary data. @param at  size_of(type) bytes
double binary_number(const char* at, Type type, bool is_big_endian);

}  // namespace rakelight::io::ply
