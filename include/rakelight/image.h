// SPDX-License-Identifier: Apache-2.0
// Pictures: decoded pixels, and encoded ones that are decoded only when somebody asks.
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

/// Decoded pixels: row 0 on top, rows tightly packed, `channels` interleaved components a pixel (1 gray, 2 gray +
/// alpha, 3 RGB, 4 RGBA; alpha not premultiplied). u8 and u16 are the file's code values 0..max; f32 are linear values.
struct Pixels {
    int width = 0, height = 0;  ///< [px] >= 0
    int channels = 0;           ///< 1..4
    Component component = Component::u8;
    bool is_linear = false;          ///< the file holds linear light (EXR, HDR); else the role of the texture decides
    std::vector<std::byte> bytes{};  ///< [height * row_bytes()]
    /// The file says that its numbers are sRGB codes (PNG's sRGB chunk, or gAMA of 45455): normal maps are warned of.
    bool is_tagged_srgb = false;
    SharedCharge charge{};  ///< pays for `bytes`; null: nobody counts them

    /// [bytes] from row to row
    std::size_t row_bytes() const { return std::size_t(width) * std::size_t(channels) * size_of(component); }
    /// Row y, from the top.
    const std::byte* row(int y) const { return bytes.data() + std::size_t(y) * row_bytes(); }
    /// Row y, from the top.
    std::byte* row(int y) { return bytes.data() + std::size_t(y) * row_bytes(); }
};

/// A picture as it lies in a file, a buffer or a data URI. Immutable and shared; compared by identity. io makes it and
/// installs `decode`; engines and prepare call it, so neither of them sees a file library.
struct EncodedImage {
    std::string name{};  ///< for people: "textures/body.png" or "image 3 'body' (embedded)"
    std::string file{};  ///< the file it came from (the model for embedded ones), for messages
    std::string path{};  ///< where the encoded bytes lie when they are a file of their own, else empty
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< the encoded bytes when embedded, else null
    std::string mime_type{};                                ///< as the file claims, may be empty; the content decides
    /// Decodes. Reentrant. @throws Error bad_file or not_found: broken, too large for the memory budget, not a picture.
    std::function<Pixels(const EncodedImage&, Context&)> decode{};
    std::string place{};  ///< where `file` names it, for messages: "line 9, column 18" of a world file, else empty
    /// What decode() will give, but without its bytes, so that a picture that is too large is refused before it is decoded.
    /// Null: not known before. Of a file of its own it tells the budget how much was read, which decode() does not: decode
    /// by decoded(). Reentrant. @throws Error as decode()
    std::function<Pixels(const EncodedImage&, Context&)> measure{};
};
/// A picture that several textures may share.
using ImageHandle = std::shared_ptr<const EncodedImage>;

/// Linear light -> 0..1 of a display. none: clamp; Reinhard et al. 2002, "Photographic Tone Reproduction for Digital
/// Images", eq. 3, on the luminance; Khronos PBR Neutral; the fit of ACES by Hill; AgX.
enum class ToneMapping : std::uint8_t { none, reinhard, neutral, aces, agx };

/// From linear light to a display.
struct ToneSettings {
    ToneMapping mapping = ToneMapping::none;
    double exposure_ev = 0;  ///< light is multiplied by 2^exposure_ev first
    bool operator==(const ToneSettings&) const = default;
};

}  // namespace rakelight
