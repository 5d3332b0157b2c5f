// SPDX-License-Identifier: Apache-2.0
// A scene's environment as the kernels read it.
#pragma once
#include <memory>
#include <vector>

#include "cpu_shading/textures.h"
#include "shading/environment.h"

namespace rakelight::cpu_shading {

/// What is made of the picture alone. Not to be copied: views point into it.
struct EnvironmentMaps final : shading::PackedEnvironment {
    EnvironmentMaps() = default;
    EnvironmentMaps(const EnvironmentMaps&) = delete;
    EnvironmentMaps& operator=(const EnvironmentMaps&) = delete;

    std::shared_ptr<const TextureData> sky;
    std::vector<float> mirrored;
    TextureView sky_view, mirrored_view;
};

class CpuEnvironmentPacker final : public shading::EnvironmentPacker {
public:
    std::shared_ptr<const shading::PackedEnvironment> pack(const shading::EnvironmentImages& images,
                                                           const ImageHandle& image, Context& context) const override;
};

}  // namespace rakelight::cpu_shading
