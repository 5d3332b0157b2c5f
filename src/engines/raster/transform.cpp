// SPDX-License-Identifier: Apache-2.0
// Vertices: object space -> clip space. Whole objects outside the frustum are dropped first.
#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "engines/raster/front_end.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t vertices_per_task = 16384;
constexpr std::size_t vertex_bytes = sizeof(ClipVertex) + sizeof(ScreenPoint) + sizeof(std::uint16_t);

/// Object space -> (clip x, clip y, distance) as an affine map, made in double, used in float.
struct ToClip {
    float m[3][4];
    bool orthographic;

    ToClip(const dmat4& object_to_camera, const View& view) : orthographic(view.orthographic) {
        for (std::size_t c = 0; c < 4; ++c) {
            m[0][c] = float(object_to_camera[c].x * view.scale_x);
            m[1][c] = float(object_to_camera[c].y * view.scale_y);
            m[2][c] = float(-object_to_camera[c].z);
        }
    }
    ClipVertex operator()(vec3 p) const {
        const auto row = [&](int r) { return m[r][0] * p.x + m[r][1] * p.y + m[r][2] * p.z + m[r][3]; };
        const float distance = row(2);
        return {row(0), row(1), orthographic ? 1.0f : distance, distance};
    }
};

bool is_outside(const Draw& draw, const ToClip& to_clip, const ClipVolume& volume) {
    unsigned common = ~0u;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p = {corner & 1 ? draw.high.x : draw.low.x, corner & 2 ? draw.high.y : draw.low.y,
                        corner & 4 ? draw.high.z : draw.low.z};
        const unsigned code = outcode(to_clip(p), volume);
        if (code == ~0u) return false;  // overflow: let the triangles decide
        common &= code;
    }
    return common != 0;
}

}  // namespace

void transform_draws(FrontEnd& front, Context& context) {
    const ClipVolume volume(front.view);
    const std::size_t count = front.list.draws.size();
    front.clip.resize(count);  // the memory of the picture before is used again
    front.screen.resize(count);
    front.codes.resize(count);
    front.to_eye.assign(count, {});
    struct Task { std::size_t draw, first; };
    std::vector<Task> tasks;
    std::vector<ToClip> to_clip;
    to_clip.reserve(count);
    for (std::size_t d = 0; d < count; ++d) {
        const Draw& draw = front.list.draws[d];
        const Mesh& mesh = front.list.scene.meshes[draw.mesh];
        front.to_eye[d] = front.view.world_to_eye * draw.to_world;
        to_clip.emplace_back(front.view.world_to_camera * draw.to_world, front.view);
        front.stats.triangles_in += mesh.triangle_count();
        if (is_outside(draw, to_clip[d], volume)) {
            front.stats.culled_outside += mesh.triangle_count();
            front.clip[d].clear();
            front.codes[d].clear();
            continue;
        }
        front.memory.add(mesh.positions.size() * vertex_bytes);
        front.clip[d].resize(mesh.positions.size());
        front.screen[d].resize(mesh.positions.size());
        front.codes[d].resize(mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); v += vertices_per_task) tasks.push_back({d, v});
    }
    context.parallel_for(tasks.size(), [&](std::size_t t) {
        const FlushDenormals guard;
        const auto [d, first] = tasks[t];
        const Block<vec3>& positions = front.list.scene.meshes[front.list.draws[d].mesh].positions;
        const std::size_t end = std::min(positions.size(), first + vertices_per_task);
        for (std::size_t v = first; v < end; ++v) {
            const ClipVertex vertex = to_clip[d](positions[v]);
            const unsigned code = outcode(vertex, volume);
            front.clip[d][v] = vertex;
            front.codes[d][v] = std::uint16_t(code);
            if ((code & cutting_planes) == 0) front.screen[d][v] = snap_to_screen(front.view, vertex);
        }
    });
    context.parallel_for(count, [&](std::size_t d) {
        if (std::none_of(front.codes[d].begin(), front.codes[d].end(), [](std::uint16_t code) { return code != 0; }))
            front.codes[d].clear();
    });
}

ScreenPoint snap_to_screen(const View& view, const ClipVertex& v) {
    const auto snap =
        [](double px) {  // where numbers end (w near the smallest float) clipping leaves what is out of the band
            const double in_band = px > -guard_band_px ? (px < guard_band_px ? px : guard_band_px) : -guard_band_px;
            return std::int32_t(std::floor(in_band * (1 << subpixel_bits) + 0.5));
        };
    const dvec2 p = view.screen(v);
    return {snap(p.x), snap(p.y)};
}

}  // namespace rakelight::raster
