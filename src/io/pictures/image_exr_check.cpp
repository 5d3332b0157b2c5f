// SPDX-License-Identifier: Apache-2.0
// Checks the headers of an OpenEXR file before the library reads them. The library allocates tables and buffers from
// sizes that it has not compared with the file. It also reads values of known types without checking the size stored
// with them, so a wrong size would lead it into other data. Layout: "OpenEXR File Layout", openexr.com.
#include "io/pictures/image_exr_check.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/format_text.h"

namespace rakelight::io::codec {
namespace {

constexpr std::uint32_t multi_part_flag = 0x1000;
constexpr std::uint64_t max_channels = 1024, max_lines_a_block = 256;

class Source {
public:
    explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::span<const std::byte> take(std::uint64_t count) {
        if (bytes_.size() - at_ < count) bad_picture("broken EXR: it ends too early");
        at_ += std::size_t(count);
        return bytes_.subspan(at_ - std::size_t(count), std::size_t(count));
    }
    std::uint32_t u32() { return u32_at(take(4), 0); }
    std::string_view name() {
        const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, bytes_.size() - at_);
        const std::size_t end = rest.find('\0');
        if (end == std::string_view::npos || end > 255) bad_picture("broken EXR: a name without an end");
        at_ += end + 1;
        return rest.substr(0, end);
    }
    bool is_at_end() const { return at_ == bytes_.size(); }
    static std::uint32_t u32_at(std::span<const std::byte> bytes, std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t(bytes[at + i]) << (8 * i);
        return value;
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

struct Part {
    std::uint64_t width = 0, height = 0, tile_width = 0, tile_height = 0, bytes_a_pixel = 0;
};

void read_window(std::span<const std::byte> value, Part& part, std::uint64_t most_a_side) {
    const auto at = [&](std::size_t i) { return std::int64_t(std::int32_t(Source::u32_at(value, 4 * i))); };
    // The library adds to these numbers as int, so they must stay far from its limits.
    for (std::size_t i = 0; i < 4; ++i)
        if (at(i) < -(1 << 28) || at(i) > 1 << 28) bad_picture("broken EXR: its data window lies too far out");
    if (at(2) < at(0) || at(3) < at(1)) bad_picture("the picture has no pixels");
    part.width = std::uint64_t(at(2) - at(0) + 1);
    part.height = std::uint64_t(at(3) - at(1) + 1);
    if (part.width > most_a_side || part.height > most_a_side)
        bad_picture(
            format_text("the picture is {} x {} pixels, more than {} per side", part.width, part.height, most_a_side));
}

/// Bytes of one pixel in all channels.
std::uint64_t read_channels(std::span<const std::byte> value) {
    Source source(value);
    std::uint64_t bytes_a_pixel = 0;
    for (std::uint64_t count = 0; !source.name().empty(); ++count) {
        if (count == max_channels) bad_picture(format_text("an EXR picture with more than {} channels", max_channels));
        const auto rest = source.take(16);  // type, linearity, sampling in x and y
        bytes_a_pixel += Source::u32_at(rest, 0) == 1 ? 2 : 4;
        for (const std::size_t at : {8, 12})
            if (Source::u32_at(rest, at) == 0 || Source::u32_at(rest, at) > max_side)
                bad_picture("broken EXR: its sampling");
    }
    if (!source.is_at_end()) bad_picture("broken EXR: its list of channels");
    return bytes_a_pixel;
}

void read_tiles(std::span<const std::byte> value, Part& part) {
    part.tile_width = Source::u32_at(value, 0);
    part.tile_height = Source::u32_at(value, 4);
    if (part.tile_width == 0 || part.tile_height == 0 || part.tile_width > max_side || part.tile_height > max_side)
        bad_picture("broken EXR: tiles of no or too many pixels");
}

/// Types of one size.
constexpr std::array<std::pair<std::string_view, std::size_t>, 24> fixed_sizes{{{"box2i", 16},
                                                                                {"box2f", 16},
                                                                                {"chromaticities", 32},
                                                                                {"compression", 1},
                                                                                {"deepImageState", 1},
                                                                                {"double", 8},
                                                                                {"envmap", 1},
                                                                                {"float", 4},
                                                                                {"int", 4},
                                                                                {"keycode", 28},
                                                                                {"lineOrder", 1},
                                                                                {"m33d", 72},
                                                                                {"m33f", 36},
                                                                                {"m44d", 128},
                                                                                {"m44f", 64},
                                                                                {"rational", 8},
                                                                                {"tiledesc", 9},
                                                                                {"timecode", 8},
                                                                                {"v2d", 16},
                                                                                {"v2f", 8},
                                                                                {"v2i", 8},
                                                                                {"v3d", 24},
                                                                                {"v3f", 12},
                                                                                {"v3i", 12}}};

/// A value of a type that the library knows must take up exactly the size that the file says.
void check_value(std::string_view type, std::span<const std::byte> value) {
    for (const auto& [name, size] : fixed_sizes)
        if (type == name && value.size() != size) bad_picture("broken EXR: a value of a wrong size");
    if (type == "chlist") read_channels(value);
    if (type == "idmanifest") bad_picture("EXR pictures with a manifest of objects are not supported");
    if (type == "floatvector" && value.size() % 4 != 0) bad_picture("broken EXR: a value of a wrong size");
    Source source(value);
    if (type == "preview") {
        const std::uint64_t width = source.u32(), height = source.u32();
        if (width > max_side || height > max_side) bad_picture("broken EXR: its preview");
        source.take(width * height * 4);
    } else if (type == "stringvector") {
        while (!source.is_at_end()) source.take(source.u32());
    } else {
        return;
    }
    if (!source.is_at_end()) bad_picture("broken EXR: a value of a wrong size");
}

void require_type(std::string_view type, std::string_view expected) {
    if (type != expected) bad_picture("broken EXR: a header value of a wrong type");
}

/// @return false at the empty header that ends a list of parts
bool read_part(Source& source, Part& part, std::uint64_t most_a_side) {
    bool any = false;
    for (std::string_view name = source.name(); !name.empty(); name = source.name()) {
        any = true;
        const std::string_view type = source.name();
        const auto value = source.take(source.u32());
        check_value(type, value);
        if (name == "dataWindow") {
            require_type(type, "box2i");
            read_window(value, part, most_a_side);
        } else if (name == "channels") {
            require_type(type, "chlist");
            part.bytes_a_pixel = read_channels(value);
        } else if (name == "tiles") {
            require_type(type, "tiledesc");
            read_tiles(value, part);
        }
    }
    if (any && part.width == 0) bad_picture("broken EXR: no data window");
    return any;
}

/// The library's own needs: one offset a chunk, and room for a block of lines or a row of tiles with every channel.
void check_part(const Part& part, std::size_t file_bytes, Context& context) {
    std::uint64_t lines = max_lines_a_block;
    if (part.tile_width != 0) {
        const std::uint64_t across = (part.width + part.tile_width - 1) / part.tile_width;
        const std::uint64_t down = (part.height + part.tile_height - 1) / part.tile_height;
        if (across * down > file_bytes / 8) bad_picture("broken EXR: it is too short for its tiles");
        lines = part.tile_height;
    }
    const std::uint64_t columns = std::max(part.width, part.tile_width);
    context.memory().check(columns * lines * part.bytes_a_pixel * 2, "the picture while it is decoded");
}

}  // namespace

void check_exr(std::span<const std::byte> bytes, Context& context, std::uint64_t most_a_side) {
    Source source(bytes);
    source.u32();
    const bool several = (source.u32() & multi_part_flag) != 0;
    for (Part part; read_part(source, part, most_a_side); part = {}) {
        check_part(part, bytes.size(), context);
        if (!several) return;
    }
}

}  // namespace rakelight::io::codec
