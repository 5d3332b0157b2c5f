// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/view.h"

#include "engines/check_settings.h"
#include "engines/raster/draw_list.h"

namespace rakelight::raster {

View view_of(const DrawList& list, const Camera& camera, const RenderSettings& settings) {
    check_settings(settings);
    check_camera(camera, list.scene.nodes.size());
    View view = shading::make_view(camera, camera_to_world(list.scene, camera, list.node_to_world), settings);
    if (settings.visibility == Visibility::z_reversed) shading::narrow_depths(view, list.bounds);
    return view;
}

}  // namespace rakelight::raster
