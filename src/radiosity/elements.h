// SPDX-License-Identifier: Apache-2.0
// Elements: one side of one triangle of the subdivided meshes, which receives light.
#pragma once
#include <array>
#include <vector>

#include "radiosity/mean_colors.h"
#include "radiosity/parts.h"

namespace rakelight::radiosity {

struct Element {
    std::array<dvec3, 3> corner;  ///< [m] world
    dvec3 center;
    dvec3 normal;       ///< unit, shading normal at the center, for the cosine of incident light
    dvec3 face_normal;  ///< unit, away from the surface on this side
    double area = 0;    ///< [m^2]
    dvec3 albedo;       ///< 0..1 each, diffuse
    dvec3 emission;     ///< radiance
};

/// Elements of all parts in order: a part's front sides, then its back sides if two-sided.
struct Elements {
    std::vector<Element> list;
    std::vector<std::uint32_t> base;  ///< [parts + 1]
    std::size_t size() const { return list.size(); }
};

/// @param meshes  [parts]
Elements make_elements(const Scene& scene, const std::vector<Part>& parts,
                       const std::vector<geometry::FineMesh>& meshes, const ColorMaps& colors, Context& context);

}  // namespace rakelight::radiosity
