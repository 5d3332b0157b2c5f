// SPDX-License-Identifier: Apache-2.0
// The soft engine with access to its stages, for tools that show intermediate results (`rakelight explain`, `rakelight
// stages`). open_scene.h implements it.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "engines/raster/inspect/explanation.h"
#include "lighting/light_parameters.h"
#include "shading/draw_list.h"
#include "shading/lights/shadow_factors.h"
#include "shading/picture_camera.h"

namespace rakelight::raster {

using shading::ClipVertex, shading::PictureCamera;
class OpenScene;
struct OpenGeometry;

/// One light's shadow map. It points into the Inspection.
struct ShadowMapView : shading::ShadowFactors {
    std::span<const float> nearness;  ///< [faces][size][size]
};

/// A prepared scene seen by a camera. Not to be copied: its parts refer to each other.
class Inspection {
public:
    /// @throws Error as Engine::prepare() and Engine::render()
    Inspection(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
    ~Inspection();

    const shading::DrawList& list() const;
    const PictureCamera& view() const;
    const RenderSettings& settings() const;
    const std::vector<lighting::LightParameters>& lights() const;
    /// LightParameters::shadow says which; empty: no shadows.
    std::vector<ShadowMapView> shadow_maps() const;

    /// The geometry stages of a window of the picture.
    class Geometry {
    public:
        /// @param with_culled  also the triangles that culling drops, so that they can be shown
        Geometry(const Inspection& of, Window window, bool with_culled, Context& context);
        ~Geometry();

        /// [vertices] of a draw in clip space; empty where it is wholly outside.
        std::span<const ClipVertex> clip(std::size_t draw) const;
        const RenderStats& stats() const;

        const OpenGeometry& opened() const { return *opened_; }

    private:
        std::unique_ptr<const OpenGeometry> opened_;
    };

    /// Everything about one pixel. @throws Error usage: outside of the picture
    PixelExplanation explain(int x, int y, Context& context) const;

    const OpenScene& opened() const { return *opened_; }

private:
    std::unique_ptr<const OpenScene> opened_;
};

/// [1/256 px] where set-up puts a vertex that is in front of the near plane.
struct SnappedPlace {
    int x, y;
};
SnappedPlace snapped_place(const PictureCamera& view, const ClipVertex& vertex);

}  // namespace rakelight::raster
