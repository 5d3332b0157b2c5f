// SPDX-License-Identifier: Apache-2.0
// Bounding box of a scene, and the default lights.
#pragma once
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// An axis-aligned box.
struct RL_API Bounds {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};  ///< [m]
    bool empty() const { return !(low.x <= high.x); }
    dvec3 center() const;  ///< [m]
    /// @param i  0..7: bit 0, 1, 2 choose high x, y, z
    dvec3 corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
    double diagonal() const;  ///< [m]
};

/// Bounding box in world space [m] of all drawn vertices of all objects. Non-finite vertices are ignored. Empty if
/// nothing is drawn.
/// @throws Error bad_file: see validate()
RL_API Bounds bounds(const Scene& scene);

/// The default light rig, fixed to the camera: ambient light (0.12), a key light (0.68) from above left and a fill
/// light (0.2) from the right. The key and fill lights are directional. All lights are white, in classical units. The
/// radiance of a white surface stays just below 1.
RL_API std::vector<Light> default_lights(const dmat4& camera_to_world);
/// The key light of the built-in studio. It lies to the left above the camera.
RL_API std::vector<Light> studio_lights(const dmat4& camera_to_world);

}  // namespace rakelight
