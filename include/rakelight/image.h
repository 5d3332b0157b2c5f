// SPDX-License-Identifier: Apache-2.0
// Pictures: decoded pixels, and encoded pictures that are decoded on demand.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/context.h>

namespace rakelight {

/// The type of a component of a pixel.
enum class Component : std::uint8_t { u8, u16, f32 };
/// [bytes] of a component
constexpr std::size_t size_of(Component c) { return c == Component::u8 ? 1 : c == Component::u16 ? 2 : 4; }

/// Decoded pixels. Row 0 is on top; rows are tightly packed. A pixel has `channels` interleaved components: 1 gray,
/// 2 gray and alpha, 3 RGB, 4 RGBA; alpha is not premultiplied. u8 and u16 are the file's code values 0..max; f32 are linear values.
struct Pixels {
    int width = 0, height = 0;  ///< [px] >= 0
    int channels = 0;           ///< 1..4
    Component component = Component::u8;
    bool is_linear =
        false;  ///< the file holds linear light (EXR, HDR); else the role of the texture decides the color space
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
    std::string file{};  ///< its file (the model for embedded pictures), for messages
    std::string path{};  ///< path of the encoded file, or empty if embedded
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< the encoded bytes when embedded, else null
    std::string mime_type{};  ///< as declared by the file, may be empty; the content decides
    /// Decodes. Reentrant.
    /// @throws Error bad_file or not_found: broken, too large for the memory budget, not a picture.
    std::function<Pixels(const EncodedImage&, Context&)> decode{};
    std::string place{};  ///< for messages: where `file` names it ("line 9, column 18" of a world file), or empty
    /// The result of decode() without pixel data, so that too large pictures are refused before decoding. Null: not
    /// available. For separate files it reports the bytes read to the memory budget, and decode() does not. Call
    /// decoded(), which calls both. Reentrant.
    /// @throws Error as decode()
    std::function<Pixels(const EncodedImage&, Context&)> measure{};
};
/// A shared picture.
using ImageHandle = std::shared_ptr<const EncodedImage>;

/// Tone mapping from linear light to 0..1 of a display. `none` clamps. `reinhard`: Reinhard et al. 2002, "Photographic
/// Tone Reproduction for Digital Images", eq. 3, on the luminance. `neutral`: Khronos PBR Neutral. `aces`: the fit of
/// ACES by Hill. `agx`: AgX.
enum class ToneMapping : std::uint8_t { none, reinhard, neutral, aces, agx };

/// Exposure and tone mapping.
struct ToneSettings {
    ToneMapping mapping = ToneMapping::none;
    double exposure_ev = 0;  ///< linear light is multiplied by 2^exposure_ev first
    bool operator==(const ToneSettings&) const = default;
};

}  // namespace rakelight
