// SPDX-License-Identifier: Apache-2.0
// A scene's environment as the kernels read it.
#pragma once
#include <memory>
#include <vector>

#include "engines/raster/draw_list.h"
#include "engines/raster/textures/textures.h"
#include "shading/environment.h"

namespace rakelight::raster {

/// What is made of the picture alone. Not to be copied: views point into it.
struct EnvironmentMaps final : shading::PackedEnvironment {
    EnvironmentMaps() = default;
    EnvironmentMaps(const EnvironmentMaps&) = delete;
    EnvironmentMaps& operator=(const EnvironmentMaps&) = delete;

    std::shared_ptr<const TextureData> sky;
    std::vector<float> mirrored;
    TextureView sky_view, mirrored_view;
};

class SoftEnvironmentPacker final : public shading::EnvironmentPacker {
public:
    std::shared_ptr<const shading::PackedEnvironment> pack(const shading::EnvironmentImages& images,
                                                           const ImageHandle& image, Context& context) const override;
};

/// The scene's environment for the list's pictures.
void set_environment(DrawList& list, shading::EnvironmentCache& cache, Context& context);

}  // namespace rakelight::raster
