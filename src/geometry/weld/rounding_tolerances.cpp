// SPDX-License-Identifier: Apache-2.0
#include "geometry/weld/rounding_tolerances.h"

#include <cmath>
#include <limits>

namespace rakelight::geometry {
namespace {

constexpr double local_ulps = 2, pivot_ulps = 1;
constexpr double widest = 1.0 / 16384;  // of the diagonal: numbers with fewer digits describe no surface of this model
/// sqrt(3) / 2, plus a hundredth for rounding of the decoded values.
constexpr double half_diagonal_of_step = 0.875;

/// The distance from `size` to the next float.
double float_ulp(double size) {
    const float f = float(size);
    return f < std::numeric_limits<float>::max() ? double(std::nextafter(f, INFINITY)) - double(f) : 0;
}

/// [meshes] the largest finite |x|, |y| or |z|.
std::vector<float> largest_coordinates(const AttributeInput& input, Context& context) {
    const std::vector<Chunk> chunks = make_chunks(input.vertex_base, vertices_per_chunk);
    std::vector<std::vector<float>> found(chunks.size());
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            float largest = 0;
            for (std::uint32_t v = first; v != last; ++v) {
                const vec3 p = input.meshes[m].positions[v];
                if (is_finite(p))
                    largest = std::fmax(largest, std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z))));
            }
            found[c].push_back(largest);
        });
    });
    std::vector<float> result(input.meshes.size(), 0.0f);
    for (std::size_t c = 0; c < chunks.size(); ++c)
        for (std::uint32_t m = chunks[c].mesh_begin; m != chunks[c].mesh_end; ++m)
            result[m] = std::fmax(result[m], found[c][m - chunks[c].mesh_begin]);
    return result;
}

}  // namespace

std::vector<double> rounding_tolerances(const AttributeInput& input, const WorldBox& box, Context& context) {
    const std::vector<float> largest = largest_coordinates(input, context);
    const dvec3 center = box.low + (box.high - box.low) * 0.5;
    std::vector<double> reach(input.meshes.size());
    for (std::size_t m = 0; m < reach.size(); ++m) {
        const Placement& placement = input.placements[m];
        const dvec3 pivot = placement.to_world[3].xyz();
        const double from_pivot = std::fmin(length(pivot), length(pivot - center));
        const double rounding =
            local_ulps * float_ulp(double(largest[m]) * placement.scale) + pivot_ulps * float_ulp(from_pivot);
        const double step = half_diagonal_of_step * input.meshes[m].position_step * placement.scale;
        reach[m] = std::fmax(std::fmin(rounding, widest * box.diagonal()), step);
        if (!std::isfinite(reach[m])) reach[m] = 0;
    }
    return reach;
}

}  // namespace rakelight::geometry
