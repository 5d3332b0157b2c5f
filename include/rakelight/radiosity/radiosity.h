// SPDX-License-Identifier: Apache-2.0
// Radiosity: diffuse interreflection computed on the surfaces, independent of the view.
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Statistics of a solution. Powers are in [W]: the RGB components weighted as in luminance (Rec. 709). Energy balance:
/// emitted = absorbed + unshot + escaped.
struct RadiosityReport {
    std::uint32_t elements = 0;  ///< elements that store the light; a two-sided element counts twice
    std::uint32_t patches = 0;   ///< patches that shoot light
    std::uint32_t shots = 0;     ///< number of shots
    int rounds = 0;              ///< rounds of subdivision at shadow boundaries
    double emitted = 0;          ///< power emitted by emissive surfaces, and by lights onto surfaces
    /// `absorbed`: power absorbed by surfaces. `unshot`: power that was not yet shot.
    double absorbed = 0, unshot = 0;
    double escaped = 0;  ///< power that left the scene, or hit the backs of one-sided surfaces
    double seconds = 0;  ///< [s] wall clock
};

/// The quantity in the colors of the result. `radiance`: exitant radiance, as pictures show it. `irradiance`:
/// irradiance / pi of front sides, which is the radiance of a white surface.
enum class LitColors : std::uint8_t { radiance, irradiance };

/// The scene with its light as vertex colors. Surfaces are subdivided into elements, and their materials become unlit.
/// Vertex color times base color times base color texture is the exitant radiance. Lights are removed, and the
/// environment no longer lights the scene. Non-diffuse reflection (metal, glass, highlights) is ignored, with a remark
/// in the report. Progressive refinement: Cohen, Chen, Wallace & Greenberg 1988, "A Progressive Refinement Approach to
/// Fast Radiosity Image Generation". Bit-identical for any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible settings; bad_file: more than max_radiosity_elements triangle sides, or over the
///         memory budget; failed: the library is built without engine trace, Embree is not installed, cancelled
RL_API Scene with_radiosity(Scene scene, const RadiositySettings& settings, RadiosityReport& report, Context& context,
                            LitColors colors = LitColors::radiance);

}  // namespace rakelight
