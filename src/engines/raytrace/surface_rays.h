// SPDX-License-Identifier: Apache-2.0
// Rays against the surfaces of a scene for what is computed on surfaces and not for pixels: form factors, baked maps.
#pragma once
#include <memory>
#include <optional>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "cpu_shading/draw_list.h"

namespace rakelight::raytrace {

/// Where a ray hits a triangle first.
struct SurfaceHit {
    std::uint32_t draw = 0;      ///< into SurfaceRays::list().draws
    std::uint32_t triangle = 0;  ///< of the draw's mesh
    double t = 0;                ///< [lengths of the direction] along the ray
    double weight[3] = {};       ///< of the triangle's corners at the place, sum 1
};

/// Immutable once made; from any thread. The same hits for any RAKELIGHT_ISA.
class SurfaceRays {
public:
    /// @param scene  valid, posed and prepared; shapes are met as their triangles
    /// @throws Error failed: Embree is not installed, cancelled; bad_file: over the memory budget
    SurfaceRays(Scene scene, Context& context);
    ~SurfaceRays();

    /// The placed triangles, their materials and textures.
    const cpu_shading::DrawList& list() const;

    /// @param from       [m] world
    /// @param direction  not 0; `least` and `most` count in it. Both sides of a triangle count
    std::optional<SurfaceHit> first(dvec3 from, dvec3 direction, double least, double most) const;
    /// Whether something is between two places in the world: from a fraction `margin` of the way to 1 - `margin`.
    bool is_blocked(dvec3 from, dvec3 to, double margin = 1e-4) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace rakelight::raytrace
