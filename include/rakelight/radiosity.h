// SPDX-License-Identifier: Apache-2.0
// Radiosity: the light that diffuse surfaces give one another, worked out on the surfaces, for pictures from anywhere.
#pragma once
#include <cstdint>

#include <rakelight/context.h>
#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// What came of a solution. Powers are luminances of [W], of Rec. 709 primaries; their sum holds:
/// emitted = absorbed + unshot + left.
struct RadiosityReport {
    std::uint32_t elements = 0;       ///< that the light is shown on, sides counted
    std::uint32_t patches = 0;        ///< that shoot
    std::uint32_t shots = 0;          ///< times that a patch has sent its light out
    int rounds = 0;                   ///< of subdivision at shadow borders
    double emitted = 0;               ///< by surfaces, and by lights onto surfaces
    double absorbed = 0, unshot = 0;  ///< by surfaces; still to be shot
    double left = 0;                  ///< went out of the scene, or onto the backs of one-sided surfaces
    double seconds = 0;               ///< [s] wall clock
};

/// What the colors of the result are. `leaving`: radiance, as pictures show it. `arriving`: irradiance / pi, as if
/// surfaces were white, of front sides alone.
enum class LitColors : std::uint8_t { leaving, arriving };

/// The scene with its light as the colors of its surfaces: cut into elements, unlit, vertex colors times base color (and its
/// texture) are what diffuse surfaces send out. Its lights and its environment as a light are gone; what is not diffuse
/// (metal, glass, highlights) is left out and said in the report.
/// Progressive refinement: Cohen, Chen, Wallace & Greenberg 1988, "A Progressive Refinement Approach to Fast Radiosity Image
/// Generation". The same bits for any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible settings; bad_file: more than most_radiosity_elements triangles, counted with their sides,
///         over the memory budget; failed: the library is built without engine trace, Embree is not installed, cancelled
RL_API Scene with_radiosity(Scene scene, const RadiositySettings& settings, RadiosityReport& report, Context& context,
                            LitColors colors = LitColors::leaving);

}  // namespace rakelight
