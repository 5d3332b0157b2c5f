// SPDX-License-Identifier: Apache-2.0
// HIGH for ray casting: triangles, shading normals, curvature.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "bake/high/mapped_normals.h"
#include "engines/raytrace/surface_rays.h"

namespace rakelight::bake {

/// A ray hit on HIGH in world space.
struct HighPoint {
    raytrace::SurfaceHit hit;
    dvec3 place;   ///< [m]
    dvec3 face;    ///< of the triangle, unit, outward
    dvec3 normal;  ///< shading normal, unit
};

/// HIGH with its optional curvature and normal maps.
class HighSurface {
public:
    /// @param scene  prepared, posed
    HighSurface(const Scene& scene, bool wants_curvature, Context& context);

    std::optional<raytrace::SurfaceHit> first(dvec3 from, dvec3 direction, double least, double most) const {
        return rays_.first(from, direction, least, most);
    }
    bool is_blocked(dvec3 from, dvec3 to) const { return rays_.is_blocked(from, to, 1e-6); }
    HighPoint point(const raytrace::SurfaceHit& hit) const;
    double curvature(const raytrace::SurfaceHit& hit) const;  ///< [1/m]
    const Mesh& mesh_of(const raytrace::SurfaceHit& hit) const;
    double diagonal() const { return diagonal_; }  ///< [m]

private:
    std::optional<MappedNormals> mapped_;  ///< from the scene before its textures were removed
    raytrace::SurfaceRays rays_;
    std::vector<std::vector<float>> curvatures_;  ///< [draws][V]
    MemoryCharge charge_;
    double diagonal_ = 0;
};

}  // namespace rakelight::bake
