// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/image_formats.h"

#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"

namespace rakelight::io::codec {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view magic;
    const ReadableFormat* format;
    std::string_view at_8{};  ///< what follows four bytes of a size
};
constexpr std::array signatures{Signature{"\x89PNG\r\n\x1a\n", &readable_png},
                                Signature{"\xff\xd8\xff", &readable_jpeg},
                                Signature{"RIFF", &readable_webp, "WEBP"},
                                Signature{"\x76\x2f\x31\x01", &readable_exr},
                                Signature{"#?", &readable_hdr},
                                Signature{"BM", &readable_bmp}};

struct Ending {
    std::string_view name;
    const WritableFormat* format;
};
constexpr std::array endings{Ending{"png", &writable_png},   Ending{"jpg", &writable_jpeg},
                             Ending{"jpeg", &writable_jpeg}, Ending{"webp", &writable_webp},
                             Ending{"ppm", &writable_ppm},   Ending{"exr", &writable_exr},
                             Ending{"hdr", &writable_hdr}};

bool begins_with(std::span<const std::byte> bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

/// Formats that occur in models but are not read here are named in the message.
void refuse_known_formats(std::span<const std::byte> bytes) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> known{
        {{"GIF8"sv, "GIF"sv},
         {"\xabKTX"sv, "KTX"sv},
         {"DDS "sv, "DDS"sv},
         {"II*\0"sv, "TIFF"sv},
         {"MM\0*"sv, "TIFF"sv},
         {"8BPS"sv, "Photoshop"sv},
         {"sB\x13\0"sv, "Basis"sv},
         {"\0\0\0\x0cJXL "sv, "JPEG XL"sv}}};
    for (const auto& [magic, name] : known)
        if (begins_with(bytes, magic))
            bad_picture("pictures in " + std::string(name) + " format are not supported", "convert it to PNG or JPEG");
}

}  // namespace

const ReadableFormat* format_by_signature(std::span<const std::byte> bytes) {
    for (const Signature& s : signatures) {
        if (!begins_with(bytes, s.magic)) continue;
        if (s.at_8.empty() || (bytes.size() >= 12 && begins_with(bytes.subspan(8), s.at_8))) return s.format;
    }
    return nullptr;
}

const ReadableFormat& readable_format(std::span<const std::byte> bytes) {
    if (bytes.empty()) bad_picture("is not a picture: it is empty");
    if (const ReadableFormat* const format = format_by_signature(bytes)) return *format;
    refuse_known_formats(bytes);
    if (readable_tga.may_be(bytes)) return readable_tga;
    bad_picture("is not a picture of a known format");
}

const WritableFormat& writable_format(const std::string& path) {
    const std::string name = file_ending(path);
    std::string all;
    for (const Ending& ending : endings) {
        if (name == ending.name) return *ending.format;
        all += (all.empty() ? "." : ", .") + std::string(ending.name);
    }
    throw Error(ErrorCode::usage, "a picture file cannot end in '" + one_line(name, 40) + "'", {},
                "use one of " + all + "; of movies .mp4, .webm, .gif, .apng, .webp")
        .with_file(path);
}

}  // namespace rakelight::io::codec
