// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/image_hdr_lines.h"

#include <cmath>
#include <cstring>

#include "io/pictures/new_pixels.h"

namespace rakelight::io::codec::hdr {

const std::uint8_t* Source::take(std::size_t count) {
    if (left() < count) bad_picture("broken HDR: it ends too early");
    at_ += count;
    return reinterpret_cast<const std::uint8_t*>(bytes_.data()) + at_ - count;
}

std::string_view Source::line() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, left());
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos || end > 1000) bad_picture("broken HDR: its header does not end");
    at_ += end + 1;
    return rest.substr(0, end);
}

namespace {

constexpr int exponent_bias = 128 + 8;  // the mantissas are integers 0..255

std::uint64_t number(std::string_view& text) {
    std::uint64_t value = 0;
    std::size_t i = 0;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9' && value <= max_side; ++i)
        value = value * 10 + std::uint64_t(text[i] - '0');
    text.remove_prefix(i);
    return value;
}

}  // namespace

Header read_header(Source& source) {
    Header size;
    source.line();  // "#?RADIANCE" or the name of another program
    for (std::string_view line = source.line(); !line.empty(); line = source.line()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            bad_picture("HDR pictures in XYZ are not supported");
        if (line.starts_with(window_key)) size.window = line.substr(std::string_view(window_key).size());
        if (line.starts_with("# ") && size.comment.empty()) size.comment = line.substr(2);
    }
    std::string_view line = source.line();
    size.bottom_up = line.starts_with("+Y ");
    if (!size.bottom_up && !line.starts_with("-Y ")) bad_picture("rotated HDR pictures are not supported");
    line.remove_prefix(3);
    size.height = number(line);
    if (!line.starts_with(" +X ")) bad_picture("mirrored HDR pictures are not supported");
    line.remove_prefix(4);
    size.width = number(line);
    return size;
}

namespace {

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
    return can_pack(width) && source.left() >= 4 && source.peek(0) == 2 && source.peek(1) == 2 && source.peek(2) < 128;
}

}  // namespace

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

}  // namespace rakelight::io::codec::hdr
