// SPDX-License-Identifier: Apache-2.0
// Tone mapping: unbounded linear light -> displayable linear light 0..1, before encoding.
#pragma once
#include <span>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// [EV] limit of exposures on either side: 2^32 is more than any picture spans.
inline constexpr double max_exposure_ev = 32;

/// Exposure and curve. Bit-identical on every machine: + - * / and tables computed with math/functions.h.
///
/// - none: the light times 2^exposure; the encoder clamps values above 1
/// - reinhard: Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 3. The luminance (Rec.
///   709 weights) becomes L / (1 + L), hue and saturation stay; saturated colors may still pass 1 in a component
/// - neutral: Khronos PBR Neutral, specification of 2024: base colors under 0.8 stay as they are up to the Fresnel
///   offset
/// - aces: Hill's fit of the ACES 1.0 reference and output transforms for sRGB displays (in Pettineo's "Baking Lab")
/// - agx: Sobotka's AgX, base look: inset matrix, log2 from 10 EV under to 6.5 EV over 0.18, sigmoid, outset matrix.
///   Then the display's power 2.2 is taken off again, because what follows encodes as sRGB
///
/// Negative light and NaN count as 0; values are clamped to a million.
class ToneCurve {
public:
    /// @param behind linear color and alpha of a background composited behind transparent pixels, without exposure and
    ///         curve. Alpha 0: none
    /// @throws Error usage: an exposure that is not a number or beyond max_exposure_ev
    explicit ToneCurve(const ToneSettings& settings = {}, vec4 behind = {});
    /// No curve, exposure 0, and no background.
    bool is_identity() const { return is_identity_; }
    vec3 operator()(vec3 light) const;
    /// The inverse of exposure and tone curve for a linear color 0..1; an approximation for colors out of the curve's
    /// range.
    vec3 light_for(vec3 displayed) const;
    /// A displayed pixel with straight alpha: the mapped color, clamped to 0..1 if composited over the background.
    vec4 displayed(vec4 pixel) const;
    /// The linear pixel composited over the background.
    vec4 laid(vec4 pixel) const;
    /// Whether the background is opaque.
    bool is_opaque_behind() const { return behind_.w >= 1; }
    /// displayed() of each pixel. `in` may be `out`.
    void apply(std::span<const vec4> in, std::span<vec4> out) const;

private:
    vec4 mixed(vec3 mapped, float alpha) const;

    ToneMapping mapping_;
    float gain_;
    vec4 behind_;
    bool is_identity_;
};

}  // namespace rakelight
