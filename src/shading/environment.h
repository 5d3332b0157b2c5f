// SPDX-License-Identifier: Apache-2.0
// A scene's environment: decoded and prefiltered once for a picture of all around, packed by the engine as it samples it,
// kept while the scene uses it.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include <rakelight/scene/scene.h>

#include "image/maps/environment.h"
#include "shading/effect_factors.h"

namespace rakelight::shading {

/// The picture of all around with its mip levels, and what is prefiltered of it.
struct EnvironmentImages {
    MipChain sky;  ///< no levels where nothing shows it
    EnvironmentLight light;
};

/// As an engine samples it.
struct PackedEnvironment {
    virtual ~PackedEnvironment() = default;
};

class EnvironmentPacker {
public:
    virtual ~EnvironmentPacker() = default;
    /// @param image  null: the studio
    /// @throws Error bad_file: too many texels, over the memory budget
    virtual std::shared_ptr<const PackedEnvironment> pack(const EnvironmentImages& images, const ImageHandle& image,
                                                          Context& context) const = 0;
};

/// The picture of all around. @throws Error as decoding does
MipChain sky_of(const Environment& environment, Context& context);

/// Whether pictures show the environment, or are lit by it.
bool uses_environment(const Scene& scene);

struct UsedEnvironment {
    std::shared_ptr<const PackedEnvironment> packed;
    EnvironmentFactors factors;
};

class EnvironmentCache {
public:
    /// Nothing where the scene uses no environment, or where its picture cannot be decoded or packed: that is a warning
    /// in the report.
    /// @param follows_rays  rays may meet the picture itself, whether it is the background or not
    std::optional<UsedEnvironment> update(const Scene& scene, const EnvironmentPacker& packer, bool follows_rays,
                                          Context& context);

private:
    ImageHandle image_;  ///< of what is packed
    std::shared_ptr<const PackedEnvironment> packed_;
    bool has_sky_ = false;  ///< in what is packed
    std::array<vec3, 9> irradiance_{};
};

}  // namespace rakelight::shading
