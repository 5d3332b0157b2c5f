// SPDX-License-Identifier: Apache-2.0
// Radiance HDR row by row. Floats of the file's mantissas and exponents are written back as the same.
#include <algorithm>
#include <cstring>

#include "io/pictures/image_codecs.h"
#include "io/pictures/image_hdr_lines.h"
#include "io/pictures/image_place.h"
#include "io/pictures/image_rows.h"

namespace rakelight::io::codec {
namespace {

constexpr std::size_t most_header_bytes = 1 << 16;

class HdrRows final : public RowReader {
public:
    HdrRows(std::unique_ptr<InputFile> file, Context& context) : file_(std::move(file)), bytes_(most_header_bytes) {
        fill();
        hdr::Source source(unread());
        const hdr::Header read = hdr::read_header(source);
        begin_ = source.taken();
        check_row_size(read.width, read.height);
        if (read.bottom_up) bad_picture("is an HDR picture whose rows begin at the bottom");
        header_.width = int(read.width), header_.height = int(read.height);
        header_.kind = {RowFormat::hdr, 3, Component::f32, {}, read.comment};
        if (!read.window.empty()) header_.place = place_of(read.window, header_.width, header_.height);
        const std::size_t width = std::size_t(header_.width), room = hdr::most_line_bytes(width);
        charge_ = MemoryCharge(context.memory(), room + 4 * width, "rows of the picture");
        bytes_.resize(std::max(bytes_.size(), room));
        rgbe_.resize(4 * width);
    }

    void read_row(void* row) override {
        const std::size_t width = std::size_t(header_.width);
        if (end_ - begin_ < hdr::most_line_bytes(width)) fill();
        hdr::Source source(unread());
        hdr::read_line(source, width, rgbe_.data());
        begin_ += source.taken();
        hdr::floats_of(rgbe_.data(), width, static_cast<float*>(row));
    }

private:
    std::span<const std::byte> unread() const { return std::span(bytes_).subspan(begin_, end_ - begin_); }
    void fill() {
        std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
        end_ -= begin_, begin_ = 0;
        end_ += file_->read(std::span(bytes_).subspan(end_));
    }

    std::unique_ptr<InputFile> file_;
    MemoryCharge charge_;
    std::vector<std::byte> bytes_;  ///< begin_..end_ are read from the file, and not yet taken
    std::size_t begin_ = 0, end_ = 0;
    std::vector<std::uint8_t> rgbe_;
};

}  // namespace

std::unique_ptr<RowReader> read_hdr_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<HdrRows>(std::move(file), context);
}

}  // namespace rakelight::io::codec
