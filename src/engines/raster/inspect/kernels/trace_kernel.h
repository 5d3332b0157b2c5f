// SPDX-License-Identifier: Apache-2.0
// The kernels with a recorder.
#pragma once
#include "engines/raster/inspect/traced_pixel.h"
#include "engines/raster/kernels/kernel_types.h"

namespace rakelight::raster::trace {

/// Lights one point of flat and Gouraud shading as the engine's `light` does, and records how. `received` is ambient,
/// diffuse and specular, each summed over the lights in order. TracedLight::sum is left at 0. `lights` takes
/// job->light_count entries, `parts` as many.
void trace_point(const ShadeJob* job, float roughness, const float (&position)[3], const float (&normal)[3],
                 float (&received)[3][3], TracedLight* lights, TracedParts* parts);
/// Shades the first pixel of a job as its `shade` does and records how. `lights` takes job->light_count entries; those
/// of unlit surfaces and of surfaces lit at their corners are left as they are. `texels` takes texture_role_count entries, or
/// null; `parts` those of each light and after them those of what shines without one, or null. The numbers are those of
/// the engine's kernels to the bit, which run the same source.
void trace_pixel(const ShadeJob* job, PixelTrace* pixel, TracedLight* lights, TracedTexels* texels, TracedParts* parts);

}  // namespace rakelight::raster::trace
