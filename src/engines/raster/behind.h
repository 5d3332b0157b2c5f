// SPDX-License-Identifier: Apache-2.0
// The picture of what is behind transmissive surfaces, drawn by the engine's own stages.
#pragma once
#include <memory>
#include <vector>

#include "cpu_shading/behind_picture.h"
#include "engines/raster/geometry/front_end.h"

namespace rakelight::raster {

/// What it is drawn of: that of the picture.
struct BehindJob {
    const DrawList& list;
    const PictureCamera& view;
    const RenderSettings& settings;
    const std::vector<lighting::LightParameters>& lights;  ///< about the eye, with their shadows
    const ShadowView* shadows;                             ///< null: none
    const Kernels& kernels;
    const GeometryKernels& geometry_kernels;
};

/// Null if unused. Of the whole view, not only the window. @throws Error over the memory budget, cancelled
std::unique_ptr<const cpu_shading::BehindPicture> picture_behind(const BehindJob& job, Context& context);

}  // namespace rakelight::raster
