// SPDX-License-Identifier: Apache-2.0
// What the report says of suspicious normal maps.
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/scene/scene.h>

#include "shading/texture_cache.h"

namespace rakelight::shading {

/// Looks once at each normal map of 8 bits of a scene that is prepared (image/normal_map_check.h). It warns of
/// - maps that look green-down (or green-up where the material says down)
/// - maps that look or are tagged sRGB
/// - texels that point into the surface, where they are a thousandth of all or more; fewer of those are a note
/// - gray maps: they are height maps
///
/// The place is that in the world file which names the map, else the material.
class NormalMapRemarks {
public:
    NormalMapRemarks(const Scene& scene, Report& report) : scene_(scene), report_(report) {}
    void look_at(const Material& material, const TextureUse& use, const LoadedTexture& texture);
    /// A height map that is a normal map: files of old formats often name one where a bump map belongs.
    void look_at_heights(const Material& material, const TextureUse& use, const LoadedTexture& texture);

private:
    bool begin(const Material& material, const TextureUse& use, const LoadedTexture& texture);
    void say(Remark remark, const char* message, std::vector<std::string> settings = {}) {
        report_.add(remark, scene_.source, place_, message, std::move(settings));
    }

    const Scene& scene_;
    Report& report_;
    std::string place_;         ///< of the map that is looked at
    bool is_of_world_ = false;  ///< a world file names it, in that place
    std::set<const EncodedImage*> seen_;
};

}  // namespace rakelight::shading
