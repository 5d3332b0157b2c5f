// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_baselines.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "geometry/input/fast_memory.h"
#include "math/linear.h"

namespace rakelight {

void plain_loop(const BenchModel& model, std::span<const AttributeBuffers> out) {
    for (std::size_t k = 0; k < model.parts.size(); ++k) {
        const BenchPart& part = model.parts[k];
        vec3* const normals = out[k].normals.data();
        std::fill_n(normals, part.positions.size(), vec3{});
        const vec3* const positions = part.positions.data();
        const std::uint32_t* const indices = part.indices.data();
        const std::size_t corners = part.indices.size();
        for (std::size_t i = 0; i < corners; i += 3) {
            const vec3 a = positions[indices[i]];
            vec3 n = cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a);
            n = n * (1 / length(n));
            for (std::size_t c = 0; c < 3; ++c) normals[indices[i + c]] += n;
        }
        for (std::size_t v = 0; v < part.positions.size(); ++v) normals[v] = normals[v] * (1 / length(normals[v]));
    }
}

void brute_force(const BenchModel& model, std::span<const AttributeBuffers> out, const Context& context) {
    struct Face {
        vec3 corner[3], normal;
    };
    std::vector<Face> faces;
    for (const BenchPart& part : model.parts)
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            Face f;
            for (std::size_t k = 0; k < 3; ++k) f.corner[k] = part.positions[part.indices[i + k]];
            f.normal = normalize_or(cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]), vec3{});
            faces.push_back(f);
        }
    for (std::size_t k = 0; k < model.parts.size(); ++k)
        for (std::size_t v = 0; v < model.parts[k].positions.size(); ++v) {
            if (v % 64 == 0) context.throw_if_cancelled();  // each takes as long as there are faces
            const vec3 p = model.parts[k].positions[v];
            vec3 sum;
            for (const Face& f : faces)
                if (f.corner[0] == p || f.corner[1] == p || f.corner[2] == p) sum += f.normal;
            out[k].normals[v] = normalize_or(sum, vec3{0, 0, 1});
        }
}

double copy_bandwidth(Context& context) {
    constexpr std::size_t bytes = std::size_t(1) << 28, piece = std::size_t(1) << 24;
    geometry::LargeArray<char> from, to;
    from.reserve(bytes);
    to.reserve(bytes);
    std::memset(from.data(), 1, bytes);
    std::memset(to.data(), 2, bytes);
    double best = 0;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        context.parallel_for(
            bytes / piece, [&](std::size_t p) { std::memcpy(to.data() + p * piece, from.data() + p * piece, piece); });
        best = std::max(best, 2.0 * double(bytes) /
                                  std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best * 1e-9;
}

}  // namespace rakelight
