// SPDX-License-Identifier: Apache-2.0
// Vertices: object space -> clip space. Whole objects outside the frustum are dropped first.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/assert.h"
#include "engines/raster/geometry/front_end.h"
#include "math/flush_denormals.h"
#include "shading/behind.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t vertices_per_task = 16384;
constexpr std::size_t vertex_bytes = sizeof(ClipVertex) + sizeof(ScreenVertex);
static_assert(vertices_per_task % (row_padding + 1) == 0, "tasks begin where a vector does");

/// Object space -> (clip x, clip y, distance) as an affine map, made in double, used in float.
struct ToClip {
    float m[3][4];
    bool orthographic;

    ToClip(const dmat4& object_to_camera, const PictureCamera& view) : orthographic(view.orthographic) {
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

float at_least(double v) {
    const auto f = float(v);
    return double(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}
float at_most(double v) { return -at_least(-v); }

/// All but the vertices.
VertexJob vertex_job(const FrontEnd& front, const ToClip& to_clip, const ClipVolume& volume) {
    const ScreenMap map(front.view);
    VertexJob job{};
    std::copy_n(&to_clip.m[0][0], 12, &job.to_clip[0][0]);
    job.orthographic = map.orthographic;
    job.z_near = at_least(volume.z_near), job.z_far = at_most(volume.z_far);
    job.guard_x = volume.guard_x, job.guard_y = volume.guard_y;
    job.scale_x = map.scale_x, job.offset_x = map.offset_x;
    job.scale_y = map.scale_y, job.offset_y = map.offset_y;
    job.key_scale = map.key_scale, job.key_offset = map.key_offset;
    return job;
}

bool is_outside(const Draw& draw, const ToClip& to_clip, const ClipVolume& volume) {
    unsigned common = ~0u;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p = {corner & 1 ? draw.high.x : draw.low.x, corner & 2 ? draw.high.y : draw.low.y,
                        corner & 4 ? draw.high.z : draw.low.z};
        const unsigned code = outcode(to_clip(p), volume);
        if (code == unsigned(outside_all)) return false;  // overflow: let the triangles decide
        common &= code;
    }
    return common != 0;
}

/// Objects of which no mesh may be seen; the draws of one follow each other.
std::uint64_t count_objects_outside(const FrontEnd& front) {
    const std::vector<Draw>& draws = front.list.draws;
    std::uint64_t count = 0;
    for (std::size_t d = 0, end = 0; d < draws.size(); d = end) {
        bool all_outside = true;
        for (end = d; end < draws.size() && draws[end].node == draws[d].node; ++end)
            all_outside = all_outside && front.clip[end].empty();
        count += all_outside;
    }
    return count;
}

/// Part of a draw's vertices.
struct VertexTask {
    std::size_t draw, first;
};

/// Room for `count` elements; what is in it is of no use any more.
template <class T>
void renew(std::vector<T>& store, std::size_t count) {
    if (store.size() >= count) return;  // the memory of the picture before
    store = {};
    store.resize(count);
}

/// Gives each draw its part of the stores; those outside have none.
void place_draws(FrontEnd& front, const std::vector<bool>& outside) {
    const std::vector<Draw>& draws = front.list.draws;
    const auto vertices_of = [&](std::size_t d) { return front.list.scene.meshes[draws[d].mesh].positions.size(); };
    std::size_t vertices = 0;
    for (std::size_t d = 0; d < draws.size(); ++d) vertices += outside[d] ? 0 : vertices_of(d);
    const std::size_t count = vertices + row_padding;
    if (front.clip_store.size() > 4 * count) front.clip_store = {}, front.screen_store = {};  // a much larger picture's
    front.memory.add(std::max(count, front.clip_store.size()) * vertex_bytes);
    renew(front.clip_store, count);
    renew(front.screen_store, count);
    front.clip.assign(draws.size(), {});
    front.screen.assign(draws.size(), {});
    for (std::size_t d = 0, first = 0; d < draws.size(); ++d) {
        if (outside[d]) continue;
        front.clip[d] = std::span(front.clip_store).subspan(first, vertices_of(d));
        front.screen[d] = std::span(front.screen_store).subspan(first, vertices_of(d));
        first += vertices_of(d);
    }
}

/// Kernels write whole vectors: what does not fill one goes through a buffer, since the next draw follows at once.
void transform(const GeometryKernels& kernels, VertexJob job) {
    constexpr std::int32_t most_lanes = row_padding + 1;
    const std::int32_t count = job.count, whole = count - count % most_lanes;
    job.count = whole;
    if (whole > 0) kernels.transform(&job);
    if (whole == count) return;
    ClipVertex clip[most_lanes];
    ScreenVertex screen[most_lanes];
    float* const to_clip = job.clip + 4 * std::ptrdiff_t(whole);
    ScreenVertex* const to_screen = job.screen + whole;
    job.positions += 3 * std::ptrdiff_t(whole);
    job.total -= whole;
    job.count = count - whole;
    job.clip = &clip[0].x;
    job.screen = screen;
    kernels.transform(&job);
    std::memcpy(to_clip, clip, std::size_t(job.count) * sizeof(ClipVertex));
    std::copy_n(screen, job.count, to_screen);
}

}  // namespace

void transform_draws(FrontEnd& front, Context& context) {
    const ClipVolume volume(front.view);
    const std::size_t count = front.list.draws.size();
    front.memory.add(count * (sizeof(ClipVertices) + sizeof(ScreenVertices) + sizeof(dmat4) + sizeof(ToClip)));
    front.to_eye.assign(count, {});
    std::vector<bool> outside(count);
    std::vector<VertexTask> tasks;
    std::vector<ToClip> to_clip;
    to_clip.reserve(count);
    for (std::size_t d = 0; d < count; ++d) {
        const Draw& draw = front.list.draws[d];
        const Mesh& mesh = front.list.scene.meshes[draw.mesh];
        front.to_eye[d] = front.view.world_to_eye * draw.to_world;
        to_clip.emplace_back(front.view.world_to_camera * draw.to_world, front.view);
        front.stats.triangles_in += mesh.triangle_count();
        outside[d] = is_outside(draw, to_clip[d], volume) ||
                     (front.only_behind && !shading::is_behind(front.list, draw, front.settings));
        if (outside[d])
            front.stats.culled_outside += mesh.triangle_count();
        else
            for (std::size_t v = 0; v < mesh.positions.size(); v += vertices_per_task) tasks.push_back({d, v});
    }
    place_draws(front, outside);
    front.stats.objects_outside = count_objects_outside(front);
    context.parallel_for(tasks.size(), [&](std::size_t t) {
        const FlushDenormals guard;
        const auto [d, first] = tasks[t];
        const Block<vec3>& positions = front.list.scene.meshes[front.list.draws[d].mesh].positions;
        VertexJob job = vertex_job(front, to_clip[d], volume);
        job.positions = &positions[first].x;
        job.total = std::int32_t(std::min(positions.size() - first, std::size_t(2) * vertices_per_task));
        job.count = std::min(job.total, std::int32_t(vertices_per_task));
        job.clip = &front.clip[d][first].x;
        job.screen = &front.screen[d][first];
        transform(front.kernels, job);
    });
}

ScreenMap::ScreenMap(const PictureCamera& view)
    : scale_x(0.5 * view.width * (1 << subpixel_bits)),
      offset_x(scale_x + 0.5 + snap_origin),
      scale_y(-0.5 * view.height * (1 << subpixel_bits)),
      offset_y(-scale_y + 0.5 + snap_origin),
      key_scale(view.z_near),
      key_offset(0),
      orthographic(view.orthographic) {
    if (!orthographic) return;
    const double range = view.z_far - view.z_near;
    key_scale = -1 / range;
    key_offset = 1 + view.z_near / range;
}

ScreenVertex snap_to_screen(const ScreenMap& map, const ClipVertex& v) {
    // Written as in kernels/vertex_kernel.h: a vertex has one place, whether its triangle is cut or not.
    const double inverse = 1.0 / double(v.w);
    std::uint32_t fine = 0;
    const auto snap = [inverse, &fine](float to, double scale, double offset) {
        const double px = double(to) * inverse * scale + offset, low = px > snap_lowest ? px : snap_lowest;
        const double at = low < snap_highest ? low : snap_highest;
        const auto whole = std::int32_t(at);
        fine = std::uint32_t((at - double(whole)) * (1 << fine_bits));
        return whole - snap_origin;
    };
    ScreenVertex out;
    out.x = snap(v.x, map.scale_x, map.offset_x);
    out.bits = fine << outcode_bits;
    out.y = snap(v.y, map.scale_y, map.offset_y);
    out.bits |= fine << (outcode_bits + fine_bits);
    const double key = (map.orthographic ? double(v.distance) : inverse) * map.key_scale + map.key_offset;
    out.key = float(std::clamp(key, 0.0, 1.0));
    return out;
}

}  // namespace rakelight::raster
