// SPDX-License-Identifier: Apache-2.0
// The model of the measurements of attributes: a displaced sphere, cut into objects.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/geometry/attributes.h>

namespace rakelight {

struct BenchPart {
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

struct BenchModel {
    std::vector<BenchPart> parts;  ///< one object each
    double grid_step = 0;          ///< height of a row of the grid
    std::uint64_t triangles() const;
    std::uint64_t vertices() const;
    /// Views of it. @param textured  with texture coordinates
    std::vector<AttributeMesh> meshes(bool textured) const;
};

/// A UV sphere of radius 1 without its poles, so that no face is degenerate. Every vertex is moved outward by up to a
/// quarter of the grid's step, bit-equal where parts meet and where the sphere closes. Its rows go to the parts in
/// equal shares; parts beyond the number of rows share a row's columns.
/// @param shuffled  the triangles of each part, and its vertices, in random order (fixed seed)
BenchModel make_bench_sphere(std::uint64_t triangles, std::uint32_t parts, bool shuffled);

/// The same sphere with waves of 24 edges on a share of its rows, else smooth: where there are waves, the faces of a
/// vertex turn from each other by some degrees.
BenchModel make_waved_sphere(std::uint64_t triangles, std::uint32_t parts, double share);

/// A smooth sphere of bands, an object each, of which neighbors have their columns in the ratio 1 : 2 : 3 and lie an eighth of the
/// coarsest edge apart: no vertices are shared.
BenchModel make_uneven_sphere(std::uint64_t triangles, std::uint32_t parts);

}  // namespace rakelight
