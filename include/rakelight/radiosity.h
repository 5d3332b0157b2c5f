// SPDX-License-Identifier: Apache-2.0
// Radiosity: diffuse interreflection computed on the surfaces, independent of the view.
#pragma once
#include <cstdint>

#include <rakelight/context.h>
#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Statistics of a solution. Powers are luminances in [W], with Rec. 709 primaries. Energy balance: emitted = absorbed
/// + unshot + escaped.
struct RadiosityReport {
    std::uint32_t elements = 0;       ///< elements that store the light; both sides count
    std::uint32_t patches = 0;        ///< patches that shoot
    std::uint32_t shots = 0;          ///< number of shots
    int rounds = 0;                   ///< rounds of subdivision at shadow boundaries
    double emitted = 0;               ///< by emissive surfaces, and by lights onto surfaces
    double absorbed = 0, unshot = 0;  ///< by surfaces; remaining power to shoot
    double escaped = 0;               ///< left the scene, or hit the backs of one-sided surfaces
    double seconds = 0;               ///< [s] wall clock
};

/// The quantity in the colors of the result. `radiance`: exitant radiance, as pictures show it. `irradiance`:
/// irradiance / pi of front sides, as if surfaces were white.
enum class LitColors : std::uint8_t { radiance, irradiance };

/// The scene with its light as vertex colors. Surfaces are subdivided into elements and unlit; vertex color times base
/// color (and its texture) is the exitant radiance. Lights, and the environment as a light, are removed. Non-diffuse
/// reflection (metal, glass, highlights) is ignored and mentioned in the report. Progressive refinement: Cohen, Chen,
/// Wallace & Greenberg 1988, "A Progressive Refinement Approach to Fast Radiosity Image Generation". Bit-identical for
/// any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible settings; bad_file: more than max_radiosity_elements triangle sides, or over the
///         memory budget; failed: the library is built without engine trace, Embree is not installed, cancelled
RL_API Scene with_radiosity(Scene scene, const RadiositySettings& settings, RadiosityReport& report, Context& context,
                            LitColors colors = LitColors::radiance);

}  // namespace rakelight
