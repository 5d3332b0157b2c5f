// SPDX-License-Identifier: Apache-2.0
// Tone mapping: linear light of any brightness -> linear light 0..1 that a display can show, before it becomes codes.
#pragma once
#include <span>

#include <rakelight/image.h>
#include <rakelight/vector.h>

namespace rakelight {

/// [EV] limit of exposures on either side: 2^32 is more than any picture spans.
inline constexpr double max_exposure_ev = 32;

/// Exposure and curve. The same bits on every machine: + - * / and tables made by math/functions.h.
///
/// none       the light times 2^exposure; what is over 1 is clamped by the encoder
/// reinhard   Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 3: the luminance (Rec. 709
///            weights) becomes L / (1 + L), hue and saturation stay; saturated colors may still pass 1 in a component
/// neutral    Khronos PBR Neutral, specification of 2024: base colors under 0.8 stay as they are up to the Fresnel offset
/// aces       Hill's fit of the ACES 1.0 reference and output transforms for sRGB displays (in Pettineo's "Baking Lab")
/// agx        Sobotka's AgX, base look: inset matrix, log2 from 10 EV under to 6.5 EV over 0.18, sigmoid, outset matrix,
///            then the display's power 2.2 taken off again, because what follows encodes as sRGB
///
/// Curves take negative light and NaN as 0 and everything over a million as a million.
class ToneCurve {
public:
    /// @param behind  linear color that lies behind pixels which are not opaque, and its alpha: what is seen of it is not changed
    ///                by exposure and curve. Alpha 0: nothing lies there
    /// @throws Error usage: an exposure that is not a number or beyond max_exposure_ev
    explicit ToneCurve(const ToneSettings& settings = {}, vec4 behind = {});
    /// Nothing changes: no curve, exposure 0, and nothing lies behind.
    bool is_identity() const { return is_identity_; }
    vec3 operator()(vec3 light) const;
    /// The inverse of exposure and tone curve for a linear color 0..1; an approximation for colors out of the curve's
    /// range.
    vec3 light_for(vec3 displayed) const;
    /// A pixel as it is displayed, straight alpha: its color under the curve, clamped to 0..1 where it is mixed with what
    /// lies behind it by its alpha.
    vec4 displayed(vec4 pixel) const;
    /// The pixel, linear as it is, over what lies behind.
    vec4 laid(vec4 pixel) const;
    /// Whether what lies behind leaves no pixel transparent.
    bool is_opaque_behind() const { return behind_.w >= 1; }
    /// displayed() of each. `in` may be `out`.
    void apply(std::span<const vec4> in, std::span<vec4> out) const;

private:
    vec4 mixed(vec3 mapped, float alpha) const;

    ToneMapping mapping_;
    float gain_;
    vec4 behind_;
    bool is_identity_;
};

}  // namespace rakelight
