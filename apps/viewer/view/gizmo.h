// SPDX-License-Identifier: Apache-2.0
// Handles of the selected light: three axes to move it along, a square to move it across the view, an arrow's head to turn
// it. No window: pixels in, lights out.
#pragma once
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight::viewer {

enum class Handle : std::uint8_t { none, x, y, z, center, tip };

/// The picture in which handles are seen. Pixels count from its upper left corner, y down.
struct GizmoView {
    Camera camera;
    int width = 1, height = 1;  ///< [px]
    double scale = 1;           ///< of the display: handles are as many pixels larger
    Bounds bounds;              ///< of the model: directional lights stand about it
};

/// Those of the light, as seen through surfaces; the `lit` one is highlighted.
std::vector<Line> gizmo_lines(const Light& light, const GizmoView& view, Handle lit);
/// The handle under a pixel. Axes that point at the viewer have none.
Handle handle_at(dvec2 pixel, const Light& light, const GizmoView& view);
/// The light after its handle was dragged. @param start  as it was when the drag began, at pixel `from`
Light dragged(const Light& start, Handle handle, dvec2 from, dvec2 to, const GizmoView& view);

/// The ray of a pixel: the half line from `origin` along the unit `direction`. The inverse of pixel_of().
struct Ray {
    dvec3 origin, direction;
};
Ray ray_of(dvec2 pixel, const GizmoView& view);

}  // namespace rakelight::viewer
