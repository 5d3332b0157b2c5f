// SPDX-License-Identifier: Apache-2.0
// Surfaces whose exact normals are known, as triangles of all kinds.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight {

/// Numbers from 0 to 1, the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double next() { return double(engine_() >> 11) * 0x1p-53; }
    double within(double low, double high) { return low + (high - low) * next(); }
    double normal();  ///< of mean 0 and deviation 1

private:
    std::mt19937_64 engine_;
};

/// Triangles with the exact normal of the surface at each vertex.
struct KnownSurface {
    std::vector<dvec3> positions, normals;  ///< [V] unit normals
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Point and normal of a surface.
struct KnownPoint {
    dvec3 position, normal;
};
using PointAt = std::function<KnownPoint(double u, double v)>;

/// Turns triangles whose winding is against the normals.
void orient(KnownSurface& surface);

/// Points of the unit sphere: an icosahedron, each of whose triangles was cut into four `levels` times.
KnownSurface icosphere(int levels);
/// The sphere of meridians and parallels.
KnownSurface uv_sphere(std::uint32_t columns, std::uint32_t rows);
/// A torus of radii 1 and 0.4: a grid whose points are moved by up to `jitter` steps, each square cut by either diagonal.
KnownSurface known_torus(std::uint32_t columns, std::uint32_t rows, double jitter, Random& random);
/// The hull of points on the unit sphere, normals as of the sphere.
KnownSurface hull_of_sphere(std::uint32_t points, Random& random);
/// Cuts a share of the triangles into four, of the others as many as are needed, `rounds` times. New points are moved to
/// the unit sphere.
KnownSurface refined_sphere(KnownSurface sphere, int rounds, double share, Random& random);
/// Moves points of the unit sphere by up to `jitter` edges along it.
void jitter_sphere(KnownSurface& sphere, double jitter, Random& random);
/// The unit sphere stretched along the axes.
KnownSurface stretched(KnownSurface sphere, dvec3 half_axes);
/// Height field over -1..1: `columns` x `columns` squares with jitter, each cut by either diagonal.
KnownSurface height_field(std::uint32_t columns, const PointAt& at, double jitter, Random& random);
/// A profile in x and z with its normals, drawn along y.
KnownSurface extruded(const std::vector<KnownPoint>& profile, std::uint32_t rows, double length);
/// An open wall over a closed outline, `rows` rows of squares high, each cut by one diagonal.
/// @param outline  in x and y, counterclockwise, with normals
/// @param top      the scale of the outline at the top
KnownSurface tapered(const std::vector<KnownPoint>& outline, double top, double height, std::uint32_t rows);
std::vector<KnownPoint> elliptic_outline(std::uint32_t sides, double half_axis);
/// A square of half side 1 with corners of radius 0.4.
std::vector<KnownPoint> rounded_square(std::uint32_t segments);
/// The triangles whose centers have a positive x, and their vertices.
KnownSurface half_of(const KnownSurface& surface);
/// Moves each point by Gaussian noise. @param share  deviation on each axis, in mean edges
void add_noise(KnownSurface& surface, double share, Random& random);

/// [V] whether a vertex is at an edge of one triangle only.
std::vector<std::uint8_t> is_at_border(const KnownSurface& surface);

}  // namespace rakelight
