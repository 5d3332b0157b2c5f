// SPDX-License-Identifier: Apache-2.0
// Picture files read row by row, with the numbers that they hold: a picture need not fit into memory. PNG, EXR and HDR as
// image_io.h writes them.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/files/file.h"
#include "io/pictures/image_io.h"

namespace rakelight::io {

enum class RowFormat : std::uint8_t { png, exr, hdr };

/// What the rows of a file hold.
struct RowKind {
    RowFormat format = RowFormat::png;
    int channels = 0;                        ///< 1..4 components a pixel; of EXR as many as exr_channels
    Component component = Component::u8;     ///< u8, u16: PNG; f32: HDR, EXR
    std::vector<ExrChannel> exr_channels{};  ///< in the order of a row, by name; values of four bytes
    std::string comment{};
    bool operator==(const RowKind&) const = default;
    std::size_t pixel_bytes() const { return std::size_t(channels) * size_of(component); }
};

struct RowHeader {
    RowKind kind{};
    int width = 0, height = 0;  ///< [px] 1..65536
    ImagePlace place{};         ///< width 0: the file does not say
    bool operator==(const RowHeader&) const = default;
};

class RowReader {
public:
    virtual ~RowReader() = default;
    const RowHeader& header() const { return header_; }
    /// The next row from the top. PNG and HDR: as ImageWriter takes it. EXR: as the writer of make_exr_writer() does,
    /// halves as floats. At most header().height times. @throws Error bad_file
    virtual void read_row(void* row) = 0;

protected:
    RowHeader header_;
};

/// By its content. Room for a few rows is charged to the memory budget.
/// @throws Error not_found; bad_file: not such a picture, broken, interlaced, in tiles; with the file's name
std::unique_ptr<RowReader> read_rows(const std::string& path, Context& context);

/// A file of such rows, the whole picture. @throws Error usage: the ending of its name is another format's
std::unique_ptr<ImageWriter> write_rows(const std::string& path, int width, int height, const RowKind& kind);

namespace codec {

inline constexpr std::uint64_t max_row_side = 65536;  ///< [px] the largest side that is written

/// @throws Error bad_file
void check_row_size(std::uint64_t width, std::uint64_t height);

}  // namespace codec
}  // namespace rakelight::io
