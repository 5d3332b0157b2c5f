// SPDX-License-Identifier: Apache-2.0
// Shadow maps: what each light sees (shading/shadow_cameras.h), drawn by the engine's own front end from the light. Read by kernels/shadow.h.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "cpu_shading/draw_list.h"
#include "engines/raster/kernels/kernel_types.h"
#include "shading/lights/shadow_cameras.h"
#include "shading/picture_camera.h"

namespace rakelight::raster {

using cpu_shading::DrawList;

class ShadowMaps {
public:
    /// Draws the maps of the lights that cast shadows, where the settings ask for them. Opaque surfaces cast shadows
    /// from both their sides, masked ones where their texture is opaque, blended ones none; lines and points none.
    /// Maps of the call before are kept where they would be the
    /// same: they depend on the list and on the settings' size and filter, not on the eye.
    /// @param list    the one of the call before, unless forget() came between
    /// @param eye     what `lights` are about
    /// @param lights  as Scene::lights; their `shadow` is set
    /// They are charged to the budget as long as they are kept.
    /// @throws Error usage: the maps need more than half of what MemoryBudget grants, or more than the scene leaves of
    ///         it; failed: cancelled
    /// The same bits for any number of threads and instruction set; the picture's window does not count.
    void update(const DrawList& list, const RenderSettings& settings, const Kernels& kernels,
                const GeometryKernels& geometry_kernels, dvec3 eye, std::vector<lighting::LightParameters>& lights,
                Context& context);
    /// The list is another one from now on.
    void forget();

    std::uint64_t drawn() const { return drawn_; }           ///< maps so far
    std::uint64_t count() const;                             ///< maps that exist
    std::uint64_t bytes() const { return charge_.bytes(); }  ///< of those

    /// [maps] LightParameters::shadow says which; null: no shadows. They point into this.
    const ShadowView* data() const { return views_.empty() ? nullptr : views_.data(); }
    std::span<const ShadowView> all() const { return views_; }

private:
    /// The maps of one light.
    struct Maps {
        std::size_t light = 0;
        std::vector<shading::MapCamera> cameras;
        shading::PictureCamera view{};  ///< of the last of them
        std::unique_ptr<float[]> nearness;
        std::unique_ptr<std::int32_t[]> slopes;
    };

    void plan(const DrawList& list, const RenderSettings& settings, Context& context);

    std::vector<ShadowView> views_;
    std::vector<Maps> maps_;     ///< of each view
    int size_ = 0, filter_ = 0;  ///< of what is there; size 0: nothing is
    std::uint64_t drawn_ = 0;
    MemoryCharge charge_;  ///< of `maps_`
};

}  // namespace rakelight::raster
