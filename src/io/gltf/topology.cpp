// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/topology.h"

namespace rakelight::io::gltf {
namespace {

std::uint32_t corners_per_item(PrimitiveMode mode) {
    const Topology topology = topology_of(mode);
    return topology == Topology::triangles ? 3 : topology == Topology::lines ? 2 : 1;
}

bool is_list(PrimitiveMode mode) {
    return mode == PrimitiveMode::points || mode == PrimitiveMode::lines || mode == PrimitiveMode::triangles;
}

}  // namespace

Topology topology_of(PrimitiveMode mode) {
    switch (mode) {
        case PrimitiveMode::points:
            return Topology::points;
        case PrimitiveMode::lines:
        case PrimitiveMode::line_loop:
        case PrimitiveMode::line_strip:
            return Topology::lines;
        default:
            return Topology::triangles;
    }
}

std::uint64_t expanded_size(PrimitiveMode mode, std::uint64_t corners) {
    const std::uint32_t per_item = corners_per_item(mode);
    if (corners < per_item) return 0;
    if (is_list(mode)) return corners - corners % per_item;
    if (mode == PrimitiveMode::line_loop) return 2 * corners;
    return per_item * (corners - (per_item - 1));
}

Expanded expand(PrimitiveMode mode, std::vector<std::uint32_t> corners) {
    const std::uint64_t size = expanded_size(mode, corners.size());
    Expanded result;
    if (is_list(mode)) {
        result.left_over = corners.size() - size;
        corners.resize(std::size_t(size));
        result.indices = std::move(corners);
        return result;
    }
    if (size == 0) {
        result.left_over = corners.size();
        return result;
    }
    std::vector<std::uint32_t>& out = result.indices;
    out.reserve(std::size_t(size));
    const std::size_t n = corners.size();
    switch (mode) {
        case PrimitiveMode::line_loop:
        case PrimitiveMode::line_strip:
            for (std::size_t i = 0; i + 1 < n; ++i) out.insert(out.end(), {corners[i], corners[i + 1]});
            if (mode == PrimitiveMode::line_loop) out.insert(out.end(), {corners[n - 1], corners[0]});
            break;
        case PrimitiveMode::triangle_strip:
            for (std::size_t i = 0; i + 2 < n; ++i)
                out.insert(out.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
            break;
        default:  // triangle_fan
            for (std::size_t i = 0; i + 2 < n; ++i) out.insert(out.end(), {corners[i + 1], corners[i + 2], corners[0]});
            break;
    }
    return result;
}

}  // namespace rakelight::io::gltf
