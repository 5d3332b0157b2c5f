// SPDX-License-Identifier: Apache-2.0
// The environment's pictures on the GPU.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engines/opengl/context/gl_objects.h"
#include "engines/opengl/scene/textures.h"
#include "shading/environment.h"

namespace rakelight::opengl {

/// On their way to the GPU.
struct EnvironmentLevels final : shading::PackedEnvironment {
    std::vector<MipLevel> sky;
    bool is_srgb = false;      ///< codes of `sky` are
    MipLevel mirrored;         ///< all levels of the octahedral maps beside each other, each with its border
    std::vector<vec3> places;  ///< [levels] x, y of a level's first texel behind its border; its size
};

class EnvironmentLevelPacker final : public shading::EnvironmentPacker {
public:
    std::shared_ptr<const shading::PackedEnvironment> pack(const shading::EnvironmentImages& images,
                                                           const ImageHandle& image, Context& context) const override;
};

class EnvironmentStore {
public:
    /// Nothing where `used` is nothing. @param source  file that warnings name
    /// @throws Error failed: no memory on the GPU; what was there stays
    void update(const std::optional<shading::UsedEnvironment>& used, const Driver& driver, const std::string& source,
                Report& report);
    explicit operator bool() const { return levels_ != nullptr; }
    const shading::EnvironmentFactors& factors() const { return factors_; }
    const EnvironmentLevels& levels() const { return *levels_; }
    int sky_height() const { return sky_height_; }  ///< [texels] of the sky as it was uploaded
    GLuint mirrored() const { return mirrored_.name(); }
    GLuint sky() const { return sky_.name(); }

private:
    std::shared_ptr<const EnvironmentLevels> levels_;
    shading::EnvironmentFactors factors_{};
    GlTexture mirrored_, sky_;
    int sky_height_ = 1;
};

}  // namespace rakelight::opengl
