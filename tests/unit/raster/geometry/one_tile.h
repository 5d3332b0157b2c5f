// SPDX-License-Identifier: Apache-2.0
// A picture of one tile, ready to be drawn stage by stage.
#pragma once
#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/tile.h"

namespace rakelight::test {

inline constexpr RenderSettings one_tile{.width = 64, .height = 64};

inline Camera camera_at_origin() {
    Camera camera;
    camera.vertical_fov_rad = radians(60);
    camera.z_near = 0.1;
    camera.z_far = 1000;
    return camera;
}

/// The only tile of a scene.
struct OneTile {
    OneTile(const Scene& scene, const RenderSettings& settings)
        : of(scene, camera_at_origin(), settings, preparing),
          drawn(of, {}, false, preparing),
          job(raster::tile_job(of, drawn)) {
        job.context = &run;
    }
    Context preparing{{.threads = 1}}, run{{.threads = 1}};
    raster::OpenScene of;
    raster::OpenGeometry drawn;
    raster::TileJob job;
    raster::TileScratch scratch;
};

}  // namespace rakelight::test
