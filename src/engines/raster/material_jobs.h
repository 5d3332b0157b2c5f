// SPDX-License-Identifier: Apache-2.0
// What the draws of a picture are shaded by, and which kernel can.
#pragma once
#include "engines/raster/geometry/front_end.h"

namespace rakelight::raster {

/// What is made once for a picture and read by all its draws.
struct PictureEffects {
    const ShadowView* shadows = nullptr;              ///< [maps]; null: none
    bool is_explained = false;                        ///< also what adds nothing is found
    const cpu_shading::BehindView* behind = nullptr;  ///< null: what transmits is drawn opaque
};

/// Fills FrontEnd::jobs and shadows.
void make_material_jobs(FrontEnd& front, const PictureEffects& effects);

/// The part of a kernel's job that a draw's material, the settings and the view say: no pixels.
ShadeJob draw_job(const FrontEnd& front, const std::vector<lighting::LightParameters>& lights, std::uint32_t draw);

// What shading/draw_choices.h says of a draw of the picture.
Lighting lighting_of(const FrontEnd& front, std::uint32_t draw);
Bump bump_of(const FrontEnd& front, std::uint32_t draw);
float mask_cutoff(const FrontEnd& front, std::uint32_t draw);

/// Lighting in the tangent space of the vertices, bitangents of their own: their frames are wanted beside the records.
bool wants_corner_frames(const FrontEnd& front, std::uint32_t draw);

}  // namespace rakelight::raster
