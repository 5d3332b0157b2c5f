// SPDX-License-Identifier: Apache-2.0
// The materials and the environment of a draw list as kernels read them.
#pragma once
#include <deque>
#include <memory>
#include <vector>

#include "cpu_shading/material_job.h"
#include "shading/draw_list.h"
#include "shading/environment.h"

namespace rakelight::cpu_shading {

/// Not to be copied: views point into it, and into what the draw list's scene and the caches hold.
struct MaterialViews {
    MaterialViews() = default;
    MaterialViews(MaterialViews&&) = default;
    MaterialViews& operator=(MaterialViews&&) = default;

    std::vector<MaterialView> materials;                            ///< [DrawList::materials]
    std::deque<TextureView> textures;                               ///< what their slots point to
    std::shared_ptr<const shading::PackedEnvironment> environment;  ///< null: none
    EnvironmentView environment_view{};                             ///< of it
};

/// Of a list whose textures a TexturePacker of textures.h has packed into the cache.
MaterialViews make_material_views(const shading::DrawList& list, const shading::TextureCache& textures);

/// The scene's environment, whose picture the cache keeps. @param follows_rays  as EnvironmentCache::update()
void set_environment(const Scene& scene, shading::EnvironmentCache& cache, bool follows_rays, MaterialViews& views,
                     Context& context);

}  // namespace rakelight::cpu_shading
