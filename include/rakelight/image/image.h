// SPDX-License-Identifier: Apache-2.0
// Pictures: decoded pixels, and encoded pictures that are decoded on demand.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/base/context.h>

namespace rakelight {

/// The type of a component of a pixel.
enum class Component : std::uint8_t { u8, u16, f32 };
/// [bytes] of a component
constexpr std::size_t size_of(Component c) { return c == Component::u8 ? 1 : c == Component::u16 ? 2 : 4; }

/// Decoded pixels. Row 0 is on top; rows are tightly packed. A pixel has `channels` interleaved components: 1 gray,
/// 2 gray and alpha, 3 RGB, 4 RGBA. Alpha is not premultiplied. u8 and u16 components are the code values of the file,
/// 0..max. f32 components are linear values.
struct Pixels {
    int width = 0, height = 0;  ///< [px] >= 0
    int channels = 0;           ///< 1..4
    Component component = Component::u8;
    bool is_linear =
        false;  ///< true: linear light (EXR, HDR); false: the material's use of the texture decides the color space
    std::vector<std::byte> bytes{};  ///< [height * row_bytes()]
    /// The file is marked as sRGB (PNG sRGB chunk, or gAMA of 45455): normal maps with this mark get a warning.
    bool is_tagged_srgb = false;
    SharedCharge charge{};  ///< memory charge of `bytes`; null: none

    /// [bytes] from row to row
    std::size_t row_bytes() const { return std::size_t(width) * std::size_t(channels) * size_of(component); }
    /// Row y, from the top.
    const std::byte* row(int y) const { return bytes.data() + std::size_t(y) * row_bytes(); }
    /// Row y, from the top.
    std::byte* row(int y) { return bytes.data() + std::size_t(y) * row_bytes(); }
};

/// A picture in encoded form: a file, a buffer or a data URI. Immutable and shared; compared by identity. The module io
/// creates it and sets `decode`, so that engines need no image library.
struct EncodedImage {
    std::string name{};  ///< for people: "textures/body.png" or "image 3 'body' (embedded)"
    std::string file{};  ///< for messages: the picture file; for embedded pictures the model file
    std::string path{};  ///< path of the picture file; empty for embedded pictures
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< encoded bytes of an embedded picture, else null
    std::string mime_type{};  ///< as declared by the model file; may be empty. Only the content decides the format
    /// Decodes the picture. Reentrant.
    /// @throws Error not_found; bad_file: broken, too large for the memory budget, or not a picture
    std::function<Pixels(const EncodedImage&, Context&)> decode{};
    std::string place{};  ///< for messages: where `file` names it ("line 9, column 18" of a world file), or empty
    /// The result of decode() without pixel data, so that too large pictures are refused before they are decoded. Null:
    /// not available. For picture files, this function reports the size of the file to the memory budget; decode() does
    /// not. Use decoded(), which calls both functions. Reentrant.
    /// @throws Error as decode()
    std::function<Pixels(const EncodedImage&, Context&)> measure{};
};
/// A shared picture.
using ImageHandle = std::shared_ptr<const EncodedImage>;

/// Tone mapping from linear light to the range 0..1 of a display.
/// - `none`: values are clamped.
/// - `reinhard`: Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 3, applied to
///   luminance.
/// - `neutral`: Khronos PBR Neutral.
/// - `aces`: the ACES fit by Hill.
/// - `agx`: AgX.
enum class ToneMapping : std::uint8_t { none, reinhard, neutral, aces, agx };

/// Exposure and tone mapping.
struct ToneSettings {
    ToneMapping mapping = ToneMapping::none;
    double exposure_ev = 0;  ///< linear light is multiplied by 2^exposure_ev first
    bool operator==(const ToneSettings&) const = default;
};

}  // namespace rakelight
