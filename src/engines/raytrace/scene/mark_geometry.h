// SPDX-License-Identifier: Apache-2.0
// What lines and points as geometries of Embree share.
#pragma once
#include <cmath>
#include <vector>

#include "engines/raytrace/scene/embree_library.h"
#include "math/linear.h"
#include "shading/picture_camera.h"

namespace rakelight::raytrace {

/// Whether coordinates may be given to Embree.
inline bool is_in_reach(vec3 v) {
    constexpr float most = 1e18f;
    return std::fabs(v.x) < most && std::fabs(v.y) < most && std::fabs(v.z) < most;
}

/// How much larger than at 1 m what covers a pixel is at a place about the eye.
inline double mark_scale(const shading::PictureCamera& view, dvec3 place) {
    if (view.orthographic) return 1;
    const double away = -dot(place, view.camera_to_world[2].xyz());
    return away > view.z_near ? away : length(place);  // mirrors show what is behind the eye
}

/// @param primitives  must outlive the scene
template <class Primitive>
void attach_marks(RTCDevice device, RTCScene scene, unsigned number, std::vector<Primitive>& primitives,
                  RTCBoundsFunction bounds, RTCIntersectFunctionN meet) {
    RTCGeometry geometry = embree().NewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    embree().SetGeometryUserPrimitiveCount(geometry, unsigned(primitives.size()));
    embree().SetGeometryUserData(geometry, primitives.data());
    embree().SetGeometryBoundsFunction(geometry, bounds, nullptr);
    embree().SetGeometryIntersectFunction(geometry, meet);
    embree().CommitGeometry(geometry);
    embree().AttachGeometryByID(scene, geometry, number);
    embree().ReleaseGeometry(geometry);
}

}  // namespace rakelight::raytrace
