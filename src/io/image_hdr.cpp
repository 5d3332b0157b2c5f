// SPDX-License-Identifier: Apache-2.0
// Radiance HDR (Ward 1991, "Real Pixels"; file format: Radiance reference, "Picture File Format"). Three 8-bit mantissas
// share one exponent. Own code: stb_image 2.27 takes a file that was cut short for a whole one and may never return from it.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "io/file.h"
#include "io/image_codecs.h"

namespace rakelight::io::codec {
namespace {

constexpr int exponent_bias = 128 + 8;                          // the mantissas are integers 0..255
constexpr int min_packed_width = 8, max_packed_width = 0x7fff;  // widths that scan lines in run lengths can say

class Source {
public:
    explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::size_t left() const { return bytes_.size() - at_; }
    std::uint8_t peek(std::size_t i) const { return std::uint8_t(bytes_[at_ + i]); }
    const std::uint8_t* take(std::size_t count) {
        if (left() < count) bad_picture("broken HDR: it ends too early");
        at_ += count;
        return reinterpret_cast<const std::uint8_t*>(bytes_.data()) + at_ - count;
    }
    std::string_view line() {
        const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, left());
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos || end > 1000) bad_picture("broken HDR: its header does not end");
        at_ += end + 1;
        return rest.substr(0, end);
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

struct Size {
    std::uint64_t width = 0, height = 0;
    bool bottom_up = false;
};

std::uint64_t number(std::string_view& text) {
    std::uint64_t value = 0;
    std::size_t i = 0;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9' && value <= max_side; ++i)
        value = value * 10 + std::uint64_t(text[i] - '0');
    text.remove_prefix(i);
    return value;
}

Size read_header(Source& source) {
    source.line();  // "#?RADIANCE" or the name of another program
    for (std::string_view line = source.line(); !line.empty(); line = source.line())
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            bad_picture("HDR pictures in XYZ are not supported");
    std::string_view line = source.line();
    Size size;
    size.bottom_up = line.starts_with("+Y ");
    if (!size.bottom_up && !line.starts_with("-Y ")) bad_picture("turned HDR pictures are not supported");
    line.remove_prefix(3);
    size.height = number(line);
    if (!line.starts_with(" +X ")) bad_picture("mirrored HDR pictures are not supported");
    line.remove_prefix(4);
    size.width = number(line);
    return size;
}

/// Each of the four components apart: a count over 128 is a run of one value, else that many values follow.
void read_packed(Source& source, std::size_t width, std::uint8_t* rgbe) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < width;) {
            std::size_t count = *source.take(1);
            const bool run = count > 128;
            if (run) count -= 128;
            if (count == 0 || count > width - x) bad_picture("broken HDR: a run leaves its line");
            const std::uint8_t* values = source.take(run ? 1 : count);
            for (std::size_t i = 0; i < count; ++i, ++x) rgbe[4 * x + c] = values[run ? 0 : i];
        }
}

/// Plain pixels; the old form says "repeat the last one n times" by mantissas of 1, 1, 1, and n in the exponent.
void read_plain(Source& source, std::size_t width, std::uint8_t* rgbe) {
    int shift = 0;
    for (std::size_t x = 0; x < width;) {
        const std::uint8_t* pixel = source.take(4);
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            std::memcpy(rgbe + 4 * x++, pixel, 4);
            shift = 0;
            continue;
        }
        const std::size_t count = shift < 32 ? std::size_t(pixel[3]) << shift : 0;
        if (x == 0 || count == 0 || count > width - x) bad_picture("broken HDR: a run leaves its line");
        for (std::size_t i = 0; i < count; ++i, ++x) std::memcpy(rgbe + 4 * x, rgbe + 4 * x - 4, 4);
        shift += 8;
    }
}

bool is_packed(const Source& source, std::size_t width) {
    return width >= min_packed_width && width <= max_packed_width && source.left() >= 4 && source.peek(0) == 2 &&
           source.peek(1) == 2 && source.peek(2) < 128;
}

void read_line(Source& source, std::size_t width, std::uint8_t* rgbe) {
    if (!is_packed(source, width)) return read_plain(source, width, rgbe);
    const std::uint8_t* start = source.take(4);
    if ((std::size_t(start[2]) << 8 | start[3]) != width) bad_picture("broken HDR: a line of another width");
    read_packed(source, width, rgbe);
}

void floats_of(const std::uint8_t* rgbe, std::size_t width, float* rgb) {
    for (std::size_t x = 0; x < width; ++x, rgbe += 4, rgb += 3) {
        const float scale = rgbe[3] == 0 ? 0.0f : std::ldexp(1.0f, int(rgbe[3]) - exponent_bias);
        for (int c = 0; c < 3; ++c) rgb[c] = float(rgbe[c]) * scale;
    }
}

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
        put("#?RADIANCE\n" + (target.comment.empty() ? "" : "# " + target.comment + "\n") +
            "FORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n");
    }

    void write_row(const void* row) override {
        const auto* from = static_cast<const float*>(row);
        for (std::size_t x = 0; x < width_; ++x, from += channels_) {
            const float rgb[3] = {from[0], channels_ < 3 ? from[0] : from[1], channels_ < 3 ? from[0] : from[2]};
            rgbe_of(rgb, rgbe_.data() + 4 * x);
        }
        --rows_left_;
        if (width_ < min_packed_width || width_ > max_packed_width) return file_.write(std::as_bytes(std::span(rgbe_)));
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

}  // namespace

Pixels read_hdr(std::span<const std::byte> bytes, Want want, Context& context) {
    Source source(bytes);
    const Size size = read_header(source);
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
        read_line(source, width, rgbe.data());
        floats_of(rgbe.data(), width, rgb.data());
        std::memcpy(pixels.row(size.bottom_up ? pixels.height - 1 - y : y), rgb.data(), pixels.row_bytes());
    }
    return pixels;
}

std::unique_ptr<ImageWriter> write_hdr(const OutputTarget& target, int width, int height, int channels, Component) {
    return std::make_unique<HdrWriter>(target, width, height, channels);
}

}  // namespace rakelight::io::codec
