// SPDX-License-Identifier: Apache-2.0
// Shadow maps (Williams 1978, "Casting Curved Shadows on Curved Surfaces"): what each light sees, drawn by the engine's
// own front end from the light. Read by kernels/shadow.h.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/engine.h>

#include "engines/raster/draw_list.h"

namespace rakelight::raster {

class ShadowMaps {
public:
    ShadowMaps() = default;
    /// Draws the maps of the lights that cast shadows, where the settings ask for them. Opaque surfaces throw shadows
    /// from both their sides, masked ones where their texture is opaque, blended ones none; lines and points none.
    /// A directional light has one parallel map about all that is drawn; a spot of at most 60 degrees about its axis
    /// one in perspective; other spots and point lights six.
    /// @param eye     what `lights` are about
    /// @param lights  as Scene::lights; their `shadow` is set
    /// @throws Error usage: the maps need more than half of what MemoryBudget grants; failed: cancelled
    /// The same bits for any number of threads and instruction set; the picture's window does not count.
    ShadowMaps(const DrawList& list, const RenderSettings& settings, const Kernels& kernels,
               const GeometryKernels& geometry_kernels, dvec3 eye, std::vector<lighting::LightParameters>& lights,
               Context& context);
    ShadowMaps(const ShadowMaps&) = delete;
    ShadowMaps& operator=(const ShadowMaps&) = delete;
    ShadowMaps(ShadowMaps&&) = default;
    ShadowMaps& operator=(ShadowMaps&&) = default;

    /// [maps] LightParameters::shadow says which; null: no shadows. They point into this.
    const ShadowView* data() const { return views_.empty() ? nullptr : views_.data(); }

private:
    std::vector<ShadowView> views_;
    std::vector<std::unique_ptr<float[]>> nearness_;  ///< of each view
    std::vector<std::unique_ptr<std::int32_t[]>> slopes_;
};

}  // namespace rakelight::raster
