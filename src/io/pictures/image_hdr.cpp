// SPDX-License-Identifier: Apache-2.0
// Radiance HDR (Ward 1991, "Real Pixels"; file format: Radiance reference, "Picture File Format"). Three 8-bit mantissas
// share one exponent. Own code: stb_image 2.27 takes a file that was cut short for a whole one and may never return from it.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/format_text.h"
#include "io/files/output_file.h"
#include "io/pictures/image_formats.h"
#include "io/pictures/image_hdr_lines.h"
#include "io/pictures/image_place.h"

namespace rakelight::io::codec {
namespace {

constexpr std::size_t most_header_bytes = 1 << 16;  // of files read by rows

/// Negative and NaN give 0, what is too large the largest number there is.
void rgbe_of(const float* rgb, std::uint8_t* rgbe) {
    constexpr float largest_value = 255.0f * 0x1p119f;
    float v[3], largest = 0;
    for (int c = 0; c < 3; ++c) {
        v[c] = rgb[c] > 0 ? std::fmin(rgb[c], largest_value) : 0.0f;
        largest = std::fmax(largest, v[c]);
    }
    if (largest < 0x1p-127f) {  // too small for the exponent's byte: black
        std::memset(rgbe, 0, 4);
        return;
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    if (std::ldexp(largest, 8 - exponent) >= 255.5f) ++exponent;  // the mantissa would be rounded up to 256
    const double scale = std::ldexp(1.0, 8 - exponent);           // up to 2^135, more than a float holds
    for (int c = 0; c < 3; ++c) rgbe[c] = std::uint8_t(double(v[c]) * scale + 0.5);
    rgbe[3] = std::uint8_t(exponent + 128);
}

class HdrWriter final : public ImageWriter {
public:
    HdrWriter(const OutputTarget& target, int width, int height, int channels)
        : path_(target.path),
          width_(std::size_t(width)),
          channels_(std::size_t(channels)),
          rows_left_(height),
          file_(target),
          rgbe_(width_ * 4) {
        const std::string window = window_text(target.place, width, height);
        put(format_text("#?RADIANCE\n{}{}FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
                        target.comment.empty() ? "" : "# " + target.comment + "\n",
                        window.empty() ? "" : hdr::window_key + window + "\n", height, width));
    }

    void write_row(const void* row) override {
        const auto* from = static_cast<const float*>(row);
        for (std::size_t x = 0; x < width_; ++x, from += channels_) {
            const float rgb[3] = {from[0], channels_ < 3 ? from[0] : from[1], channels_ < 3 ? from[0] : from[2]};
            rgbe_of(rgb, rgbe_.data() + 4 * x);
        }
        --rows_left_;
        if (!hdr::can_pack(width_)) return file_.write(std::as_bytes(std::span(rgbe_)));
        packed_.assign({2, 2, std::uint8_t(width_ >> 8), std::uint8_t(width_ & 255)});
        for (std::size_t c = 0; c < 4; ++c) pack(c);
        file_.write(std::as_bytes(std::span(packed_)));
    }

    void finish(Sync sync) override {
        if (rows_left_ != 0) throw Error(ErrorCode::failed, "the picture is not complete").with_file(path_);
        file_.commit(sync);
    }

private:
    std::uint8_t value(std::size_t x, std::size_t c) const { return rgbe_[4 * x + c]; }
    std::size_t run_at(std::size_t x, std::size_t c) const {
        std::size_t end = x + 1;
        while (end < width_ && end - x < 127 && value(end, c) == value(x, c)) ++end;
        return end - x;
    }

    void pack(std::size_t c) {
        constexpr std::size_t worthwhile = 4;  // a shorter run costs more bytes than it saves
        for (std::size_t x = 0; x < width_;) {
            std::size_t plain = x;
            while (plain < width_ && plain - x < 128 && run_at(plain, c) < worthwhile) ++plain;
            if (plain > x) {
                packed_.push_back(std::uint8_t(plain - x));
                for (; x < plain; ++x) packed_.push_back(value(x, c));
            } else {
                const std::size_t run = run_at(x, c);
                packed_.insert(packed_.end(), {std::uint8_t(128 + run), value(x, c)});
                x += run;
            }
        }
    }

    void put(const std::string& text) { file_.write(std::as_bytes(std::span(text.data(), text.size()))); }

    std::string path_;
    std::size_t width_, channels_;
    int rows_left_;
    OutputFile file_;
    std::vector<std::uint8_t> rgbe_, packed_;
};

/// Floats of the mantissas and exponents of a file are written back as the same.
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

Pixels read_hdr(std::span<const std::byte> bytes, Want want, Context& context) {
    hdr::Source source(bytes);
    const hdr::Header size = hdr::read_header(source);
    if (size.height > source.left() / 4)
        bad_picture("broken HDR: it ends too early");  // every line has at least four bytes
    Pixels pixels = make_pixels(size.width, size.height, 3, Component::f32, want, context);
    if (want == Want::header) return pixels;
    pixels.is_linear = true;
    const std::size_t width = std::size_t(size.width);
    std::vector<std::uint8_t> rgbe(width * 4);
    std::vector<float> rgb(width * 3);
    for (int y = 0; y < pixels.height; ++y) {
        context.throw_if_cancelled();
        hdr::read_line(source, width, rgbe.data());
        hdr::floats_of(rgbe.data(), width, rgb.data());
        std::memcpy(pixels.row(size.bottom_up ? pixels.height - 1 - y : y), rgb.data(), pixels.row_bytes());
    }
    return pixels;
}

std::unique_ptr<ImageWriter> write_hdr(const OutputTarget& target, int width, int height, int channels, Component) {
    return std::make_unique<HdrWriter>(target, width, height, channels);
}

std::uint64_t work_of_hdr(const Pixels& header, std::span<const std::byte>, int, Context&) {
    return std::uint64_t(header.width) * std::uint64_t(header.height) * std::uint64_t(header.channels) / 2;
}

std::unique_ptr<RowReader> read_hdr_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<HdrRows>(std::move(file), context);
}

}  // namespace

constinit const ReadableFormat readable_hdr = {.read = read_hdr, .work = work_of_hdr, .read_rows = read_hdr_rows};
constinit const WritableFormat writable_hdr = {.component = Component::f32, .write = write_hdr};

}  // namespace rakelight::io::codec
