// SPDX-License-Identifier: Apache-2.0
// Which draws of a picture need the full kernel, and what it has to know of them.
#pragma once
#include "engines/raster/front_end.h"

namespace rakelight::raster {

/// What is made once for a picture and read by all its draws.
struct PictureEffects {
    const ShadowView* shadows = nullptr;  ///< [maps]; null: none
    bool is_explained = false;            ///< also what adds nothing is found
};

/// Fills FrontEnd::full and needs_full.
void make_full_jobs(FrontEnd& front, const PictureEffects& effects);

/// The material of a draw; the default one where its mesh has none.
const Material& material_of(const FrontEnd& front, std::uint32_t draw);
/// What draws are lit by: the material's own, else the settings'; never automatic.
Lighting lighting_of(const FrontEnd& front, std::uint32_t draw);
/// Likewise: what acts on the draw, by the maps that could be read and that its mesh has texture coordinates for; none
/// where displacement has made triangles of the bumps.
Bump bump_of(const FrontEnd& front, std::uint32_t draw);
/// Lighting in the tangent space of the vertices: their frames are wanted beside the records.
bool wants_corner_frames(const FrontEnd& front, std::uint32_t draw);
/// Alpha below which a pixel of a draw is not there, of masked materials and of reliefs that end at their texture's
/// edge; < 0: all are there.
float mask_cutoff(const FrontEnd& front, std::uint32_t draw);

}  // namespace rakelight::raster
