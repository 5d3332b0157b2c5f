// SPDX-License-Identifier: Apache-2.0
// Checks of cameras, subdivision and relief parameters, shared by scenes, requests and engines.
#include <cmath>

#include "base/enumerators.h"
#include "math/linear.h"
#include "scene/faults.h"

namespace rakelight {
namespace {

bool is_length(double l) { return l > 0 && std::isfinite(l); }
bool is_angle(double fov_rad) { return fov_rad > 0 && fov_rad < pi; }

const char* fault_of_perspective(const Camera& c, CameraUse use) {
    const bool is_across_alone = use == CameraUse::in_scene && c.vertical_fov_rad == 0 && c.horizontal_fov_rad;
    if (!is_across_alone && !is_angle(c.vertical_fov_rad)) return "the field of view is not between 0 and pi";
    if (c.horizontal_fov_rad && !is_angle(*c.horizontal_fov_rad))
        return "the horizontal field of view is not between 0 and pi";
    return c.z_near > 0 ? nullptr : "near must be greater than 0";
}

const char* fault_of_parallel(const Camera& c, CameraUse use) {
    if (!is_length(c.half_height)) return "the visible height is not a number > 0";
    if (c.half_width && !is_length(*c.half_width)) return "the visible width is not a number > 0";
    return use == CameraUse::in_scene || std::isfinite(c.z_far) ? nullptr
                                                                : "far of a parallel projection must be finite";
}

}  // namespace

const char* fault_of(const Camera& c, CameraUse use) {
    for (const dvec4& column : c.to_world.columns)
        if (!is_finite(column.xyz()) || !std::isfinite(column.w)) return "the matrix is not finite";
    if (!exists(c.projection, Projection::orthographic)) return "there is no such projection";
    if (c.aspect && !is_length(*c.aspect)) return "the aspect is not a number > 0";
    if (!std::isfinite(c.z_near) || !(c.z_far > c.z_near)) return "near must be a number and less than far";
    return c.projection == Projection::perspective ? fault_of_perspective(c, use) : fault_of_parallel(c, use);
}

const char* fault_of(const Subdivision& s) {
    if (s.level < 0 || s.level > 8) return "subdivision goes by 0 to 8 levels";
    if (s.crease_angle_rad && !(*s.crease_angle_rad >= 0 && *s.crease_angle_rad <= pi))
        return "the crease angle of a subdivision must be 0 to 180 degrees";
    if (!(s.sharpness >= 0 && s.sharpness <= 10)) return "the sharpness of creases must be 0 to 10";
    if (!(s.edge >= 0 && std::isfinite(s.edge))) return "the edge of a subdivision must be 0 or more";
    if (!exists(s.scheme, SubdivisionScheme::loop)) return "there is no such scheme of subdivision";
    return exists(s.uv, SubdivisionUv::linear) ? nullptr
                                               : "there is no such rule for texture coordinates of a subdivision";
}

/// Step counts are clamped where they are used.
const char* fault_of(const Relief& r) {
    return std::isfinite(r.depth) && std::isfinite(r.bias) ? nullptr : "the relief is not finite";
}

}  // namespace rakelight
