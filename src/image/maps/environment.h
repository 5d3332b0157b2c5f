// SPDX-License-Identifier: Apache-2.0
// Prefiltered environment light: irradiance as nine spherical-harmonics coefficients per color, and a chain of radiance
// maps filtered for increasing roughness.
//
// Directions: +Y up; in an equirectangular picture row 0 is up, the middle column is -Z, and +X is right of it.
#pragma once
#include <array>
#include <vector>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

#include "image/maps/mip_chain.h"

namespace rakelight {

/// [1] GGX roughness (square root of alpha) of the levels of `mirrored`: level / (levels - 1).
inline constexpr int environment_levels = 8;

/// A map of all directions on a square (Cigolle et al. 2014, "A Survey of Efficient Representations for Independent
/// Unit Vectors", octahedral): up is the middle, down the corners. Row 0 is at v = 0.
struct OctahedralMap {
    int size = 0;              ///< [texels] side
    std::vector<vec3> texels;  ///< [size * size] linear
    const vec3& at(int x, int y) const { return texels[std::size_t(y) * std::size_t(size) + std::size_t(x)]; }
};

/// u, v in 0..1 of a nonzero direction, and the inverse.
dvec2 octahedral(dvec3 direction);
dvec3 octahedral_direction(double u, double v);
/// u, v in 0..1 of a unit direction in an equirectangular picture, and the inverse.
dvec2 equirectangular(dvec3 direction);
dvec3 equirectangular_direction(double u, double v);

/// A texel of the map or of its one-texel border, which continues the sphere beyond the edge: x, y from -1 to size.
const vec3& bordered_texel(const OctahedralMap& map, int x, int y);

struct EnvironmentLight {
    /// Irradiance / pi as a polynomial of the unit normal: sum of c[i] times 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy.
    /// Ramamoorthi & Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", eq. 2, 3 and 7-9:
    /// the band limit has about 1 % error for typical light, and a few % with ringing for a small sun.
    std::array<vec3, 9> irradiance;
    /// [environment_levels] Karis 2013, "Real Shading in Unreal Engine 4": the mean of the light reflected by a GGX
    /// surface for view = normal, weighted by n.l. Level 0 is the picture itself.
    std::vector<OctahedralMap> mirrored;
};

/// The picture itself, level 0 of `mirrored`. Bit-identical for any number of threads.
OctahedralMap sharp_map(const MipChain& panorama, Context& context);

/// @param panorama levels of an equirectangular picture, rgba32f or sRGB rgba8 Bit-identical for any number of threads.
///         About 0.15 s on two cores.
EnvironmentLight make_environment_light(const MipChain& panorama, Context& context);

/// Value of the polynomial above, may be negative.
vec3 irradiance_over_pi(const EnvironmentLight& light, vec3 normal);

/// A neutral photo studio: a large soft key light at the upper left in front, a weaker fill at the right, a strip
/// behind, in a gray room with a darker floor. Radiance of a unit direction; gray; by formula.
double studio_radiance(dvec3 direction);
/// The studio as an equirectangular picture, 512 x 256 linear floats.
Pixels studio_panorama();

}  // namespace rakelight
