// SPDX-License-Identifier: Apache-2.0
// How often lighting is evaluated on each object: by the settings, by rules for objects and materials, by what the scene
// says of them; where that is `automatic`, by the size of its triangles in the picture.
#pragma once
#include <optional>
#include <set>
#include <vector>

#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

class ShadingChoice {
public:
    /// Both must outlive this.
    ShadingChoice(const Scene& scene, const RenderSettings& settings);

    /// Whether what the settings say of the whole is what all of it is shaded like.
    bool is_all_alike() const;
    /// May be automatic. @param material  `none`: the default one
    Shading of(std::uint32_t node, std::uint32_t material) const;

private:
    /// What nodes are to be shaded like, with all that hangs from them.
    struct NodeChoice {
        std::ptrdiff_t rule = -1;    ///< the last that fits its name or one of those that it hangs from; -1: none
        std::optional<Shading> own;  ///< its own, else that of the nearest node above that has one
    };
    std::ptrdiff_t last_rule(ShadingRule::Of of, const std::string& name, std::ptrdiff_t known) const;

    const Scene& scene_;
    const RenderSettings& settings_;
    std::vector<NodeChoice> nodes_;
};

/// The meshes whose vertices choose_shading() reads, which must be posed.
std::set<std::uint32_t> measured_meshes(const DrawList& list, const RenderSettings& settings);

/// [draws] never automatic. Where nothing says how often, small triangles that need no lighting at their pixels are
/// shaded by Gouraud, others by Phong. The same for any engine and window.
std::vector<Shading> choose_shading(const DrawList& list, const RenderSettings& settings, const PictureCamera& view,
                                    Context& context);

}  // namespace rakelight::shading
