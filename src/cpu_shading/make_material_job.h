// SPDX-License-Identifier: Apache-2.0
// The job that points of a draw are shaded by (material_job.h): what material, settings and view say.
#pragma once
#include <rakelight/engines/engine.h>

#include "cpu_shading/material_views.h"
#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::cpu_shading {

/// Without lights; `unlit` and `bump` are for lighting at every pixel.
/// @param is_explained  also what adds nothing is found
MaterialJob make_material_job(const shading::DrawList& list, const MaterialViews& views, const shading::Draw& draw,
                              const RenderSettings& settings, const shading::PictureCamera& view, bool is_explained);

/// The kernel that leaves out most of what a job does not ask for.
KernelNumber kernel_for(const MaterialJob& job, bool has_shadows);

/// Roughness with the mean of its map, for light that is found before there are pixels.
float mean_roughness(const MaterialView& material);

}  // namespace rakelight::cpu_shading
