// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/lights/light_points.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <utility>

#include "base/assert.h"
#include "base/atomic_ref.h"
#include "cpu_shading/make_material_job.h"
#include "engines/raster/lights/tile_lights.h"
#include "engines/raster/material_jobs.h"
#include "math/flush_denormals.h"
#include "shading/draw_choices.h"
#include "shading/remarks/corner_remarks.h"
#include "shading/shading_choice.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t points_per_task = 1024;

void clear(FrontEnd& front, LightPoints& points) {
    points.draws.resize(front.list.draws.size());
    for (std::size_t d = 0; d < points.draws.size(); ++d) {
        const Draw& draw = front.list.draws[d];
        const Mesh& mesh = front.list.scene.meshes[draw.mesh];
        DrawLight& light = points.draws[d];
        light.per_face = shading::is_lit_per_face(front.list, draw, front.shading[d]);
        light.sides = 0;
        light.marks.clear();
        if (!is_lit_at_corners(front, std::uint32_t(d)) || front.clip[d].empty() ||
            front.list.views.materials[draw.material].unlit)
            continue;
        const std::size_t count = light.per_face ? mesh.triangle_count() : mesh.positions.size();
        front.memory.add(count);
        light.marks.resize(count);
    }
}

/// From any thread.
void set_bit(std::uint8_t& byte, std::uint8_t bit) {
    const atomic_ref<std::uint8_t> shared(byte);
    if ((shared.load(std::memory_order_relaxed) & bit) == 0) shared.fetch_or(bit, std::memory_order_relaxed);
}

/// The points of triangles that are all of one draw.
void mark(const FrontEnd& front, std::uint32_t draw, std::span<const ScreenTriangle* const> triangles,
          LightPoints& points) {
    DrawLight& light = points.draws[draw];
    if (light.marks.empty()) return;
    const Mesh& mesh = front.list.scene.meshes[front.list.draws[draw].mesh];
    const DrawFrame frame = frame_of(front, draw);
    for (const ScreenTriangle* const triangle : triangles) {
        const ScreenTriangle& s = *triangle;
        RL_ASSERT(s.draw == draw, "a run is part of one draw");
        const auto bit = std::uint8_t(light.per_face ? 1 : 1 << frame.seen_side(s.triangle, s.is_back));
        set_bit(light.sides, bit);
        if (light.per_face) {
            set_bit(light.marks[s.triangle], bit);
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) set_bit(light.marks[mesh.indices[3 * std::size_t(s.triangle) + k]], bit);
    }
}

/// One side of a run of points of one draw.
struct Task {
    std::uint32_t draw;
    int side;
    std::size_t first;
};

/// Arrays for the kernel, and which points they hold.
struct Batch {
    using Array = std::array<float, points_per_task + batch_padding>;
    std::array<Array, 3> position, normal, ambient, diffuse, specular;
    std::array<std::uint32_t, points_per_task> point;
    std::size_t count = 0;

    void add(std::uint32_t p, dvec3 at, dvec3 n) {
        for (std::size_t c = 0; c < 3; ++c) {
            position[c][count] = float(at[c]);
            normal[c][count] = float(n[c]);
        }
        point[count++] = p;
    }
    std::uint64_t count_marked(const std::vector<std::uint8_t>& marks, std::uint8_t bits) const {
        return std::uint64_t(std::count_if(point.begin(), point.begin() + std::ptrdiff_t(count),
                                           [&](std::uint32_t p) { return marks[p] == bits; }));
    }
    /// Dead lanes repeat the last point.
    void pad() {
        for (std::size_t c = 0; c < 3; ++c)
            for (Array* a : {&position[c], &normal[c]})
                std::fill_n(a->begin() + std::ptrdiff_t(count), batch_padding, (*a)[count - 1]);
    }
};

void gather(const FrontEnd& front, const Task& task, const DrawLight& light, Batch& batch) {
    const DrawFrame frame = frame_of(front, task.draw);
    const std::size_t end = std::min(light.marks.size(), task.first + points_per_task);
    for (std::size_t p = task.first; p < end; ++p) {
        if ((light.marks[p] & (1 << task.side)) == 0) continue;
        const auto point = std::uint32_t(p);
        if (light.per_face) {
            const DrawFrame::Face face = frame.face(point);
            batch.add(point, face.centroid, face.normal);
        } else {
            batch.add(point, frame.position(point), frame.normal(point) * (task.side == 0 ? 1.0 : -1.0));
        }
    }
}

void run_kernel(const MaterialJob& shade, const Kernels& kernels, Batch& batch) {
    batch.pad();
    LightJob job{};
    job.count = std::int32_t(batch.count);
    job.material = &shade;
    job.roughness = cpu_shading::mean_roughness(*shade.material);
    for (std::size_t c = 0; c < 3; ++c) {
        job.position[c] = batch.position[c].data();
        job.normal[c] = batch.normal[c].data();
        job.ambient[c] = batch.ambient[c].data();
        job.diffuse[c] = batch.diffuse[c].data();
        job.specular[c] = batch.specular[c].data();
    }
    kernels.light(&job);
}

/// Of many lights those that may reach a point of the batch.
void list_lights(const LightReach& reach, const Batch& batch, std::vector<lighting::LightParameters>& to) {
    LightBox box;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto begin = batch.position[c].begin(), end = begin + std::ptrdiff_t(batch.count);
        box.low[c] = *std::min_element(begin, end);
        box.high[c] = *std::max_element(begin, end);
    }
    reach.in_box(box, nullptr, to);
}

void scatter(const Batch& batch, std::vector<LitPoint>& to) {
    for (std::size_t i = 0; i < batch.count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            LitPoint& point = to[batch.point[i]];
            point.ambient[c] = batch.ambient[c][i];
            point.diffuse[c] = batch.diffuse[c][i];
            point.specular[c] = batch.specular[c][i];
        }
}

/// Room for the sides that are seen, and what is to be done.
std::vector<Task> plan(FrontEnd& front, LightPoints& points) {
    std::vector<Task> tasks;
    for (std::size_t d = 0; d < points.draws.size(); ++d)
        for (int side = 0; side < 2; ++side) {
            DrawLight& light = points.draws[d];
            if ((light.sides & (1 << side)) == 0) continue;
            const std::size_t count = light.marks.size();
            front.memory.add(count * sizeof(LitPoint));
            light.side[side].resize(count);
            for (std::size_t p = 0; p < count; p += points_per_task) tasks.push_back({std::uint32_t(d), side, p});
        }
    return tasks;
}

}  // namespace

bool is_lit_at_corners(const FrontEnd& front, std::uint32_t draw) {
    return front.shading[draw] == Shading::flat || front.shading[draw] == Shading::gouraud;
}

LightPoints light_points(FrontEnd& front, const Binned& binned, const std::vector<lighting::LightParameters>& lights,
                         const Kernels& kernels, LightPoints&& used, Context& context) {
    LightPoints points = std::move(used);
    front.shading = shading::choose_shading(front.list, front.settings, front.view, context);
    points.is_used = false;
    for (std::uint32_t d = 0; d < front.shading.size(); ++d)
        points.is_used = points.is_used || is_lit_at_corners(front, d);
    if (!points.is_used) return points;
    clear(front, points);
    context.parallel_for(binned.runs.size(), [&](std::size_t r) {
        const FlushDenormals guard;
        const TileRun& run = binned.runs[r];
        mark(front, run.draw, {binned.items.data() + run.first, run.count}, points);
    });
    const std::vector<Task> tasks = plan(front, points);
    const LightReach reach(lights);
    std::atomic<std::uint64_t> evaluations{0}, twice{0};
    context.parallel_for(tasks.size(), [&](std::size_t t) {
        const FlushDenormals guard;
        const Task& task = tasks[t];
        DrawLight& light = points.draws[task.draw];
        Batch batch;
        gather(front, task, light, batch);
        if (context.cancelled() || batch.count == 0) return;
        std::vector<lighting::LightParameters> listed;
        if (reach.is_worth_it()) list_lights(reach, batch, listed);
        run_kernel(draw_job(front, reach.is_worth_it() ? listed : lights, task.draw), kernels, batch);
        scatter(batch, light.side[task.side]);
        evaluations += batch.count;
        if (task.side == 1) twice += batch.count_marked(light.marks, 3);
    });
    context.throw_if_cancelled();
    front.stats.lighting_evaluations = evaluations;
    front.stats.vertices_lit_twice = twice;
    shading::remark_corner_shading(
        front.list, front.settings, [&points](std::uint32_t d) { return points.draws[d].sides != 0; },
        context.report());
    return points;
}

}  // namespace rakelight::raster
