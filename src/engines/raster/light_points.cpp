// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/light_points.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t points_per_task = 1024;

/// Which points of each draw are to be lit: bit 1 as they are, bit 2 with the normal turned round.
class Marks {
public:
    explicit Marks(FrontEnd& front) : points_(front.list.draws.size()), sides_(front.list.draws.size(), 0) {
        for (std::size_t d = 0; d < points_.size(); ++d) {
            const Draw& draw = front.list.draws[d];
            if (front.clip[d].empty() || front.list.materials[draw.material].view.unlit) continue;
            const Mesh& mesh = front.list.scene.meshes[draw.mesh];
            const std::size_t count = is_per_face(front, mesh) ? mesh.triangle_count() : mesh.positions.size();
            front.memory.add(count);
            points_[d].resize(count);
        }
    }

    static bool is_per_face(const FrontEnd& front, const Mesh& mesh) {
        return front.settings.shading == Shading::flat || mesh.normals.empty();
    }

    bool is_lit(std::size_t draw) const { return !points_[draw].empty(); }
    /// From any thread.
    void set(std::size_t draw, std::size_t point, std::uint8_t bit) {
        set_bit(points_[draw][point], bit);
        set_bit(sides_[draw], bit);
    }
    std::uint8_t sides(std::size_t draw) const { return sides_[draw]; }
    const std::vector<std::uint8_t>& points(std::size_t draw) const { return points_[draw]; }

private:
    static void set_bit(std::uint8_t& byte, std::uint8_t bit) {
        const std::atomic_ref<std::uint8_t> shared(byte);
        if ((shared.load(std::memory_order_relaxed) & bit) == 0) shared.fetch_or(bit, std::memory_order_relaxed);
    }

    std::vector<std::vector<std::uint8_t>> points_;
    std::vector<std::uint8_t> sides_;
};

void mark(const FrontEnd& front, const std::vector<ScreenTriangle>& triangles, Marks& marks) {
    for (const ScreenTriangle& s : triangles) {
        if (!marks.is_lit(s.draw)) continue;
        if (Marks::is_per_face(front, front.list.scene.meshes[front.list.draws[s.draw].mesh])) {
            marks.set(s.draw, s.triangle, 1);
            continue;
        }
        std::uint32_t index[3];
        const int side = seen_side(front, DrawFrame(front, s.draw), s, index);
        for (const std::uint32_t vertex : index) marks.set(s.draw, vertex, std::uint8_t(1 << side));
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
    /// Dead lanes repeat the last point.
    void pad() {
        for (std::size_t c = 0; c < 3; ++c)
            for (Array* a : {&position[c], &normal[c]})
                std::fill_n(a->begin() + std::ptrdiff_t(count), batch_padding, (*a)[count - 1]);
    }
};

void gather(const FrontEnd& front, const Task& task, bool per_face, const std::vector<std::uint8_t>& marks,
            Batch& batch) {
    const DrawFrame frame(front, task.draw);
    const std::size_t end = std::min(marks.size(), task.first + points_per_task);
    for (std::size_t p = task.first; p < end; ++p) {
        if ((marks[p] & (1 << task.side)) == 0) continue;
        const auto point = std::uint32_t(p);
        if (per_face) {
            const DrawFrame::Face face = frame.face(point);
            batch.add(point, face.centroid, face.normal);
        } else {
            batch.add(point, frame.position(point), frame.normal(point) * (task.side == 0 ? 1.0 : -1.0));
        }
    }
}

/// Roughness with the mean of its map: the last level of the chain.
float mean_roughness(const MaterialView& m) {
    const TextureView* const t = m.metallic_roughness_map.view;
    if (!t) return m.roughness;
    const std::int32_t last = t->levels - 1, first = t->offset[last], count = t->width[last] * t->height[last];
    float sum = 0;
    for (std::int32_t i = first; i < first + count; ++i)
        sum += t->rgba32f ? t->rgba32f[4 * std::ptrdiff_t(i) + 1] : float(t->rgba8[i] >> 8 & 255u) * (1.0f / 255.0f);
    return m.roughness * (sum / float(count));
}

void run_kernel(const ShadeJob& shade, const Kernels& kernels, Batch& batch) {
    batch.pad();
    LightJob job{};
    job.count = std::int32_t(batch.count);
    job.shade = &shade;
    job.roughness = mean_roughness(*shade.material);
    for (std::size_t c = 0; c < 3; ++c) {
        job.position[c] = batch.position[c].data();
        job.normal[c] = batch.normal[c].data();
        job.ambient[c] = batch.ambient[c].data();
        job.diffuse[c] = batch.diffuse[c].data();
        job.specular[c] = batch.specular[c].data();
    }
    kernels.light(&job);
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
std::vector<Task> plan(FrontEnd& front, const Marks& marks, LightPoints& points) {
    std::vector<Task> tasks;
    for (std::size_t d = 0; d < points.draws.size(); ++d)
        for (int side = 0; side < 2; ++side) {
            if ((marks.sides(d) & (1 << side)) == 0) continue;
            const std::size_t count = marks.points(d).size();
            front.memory.add(count * sizeof(LitPoint));
            points.draws[d].side[side].resize(count);
            for (std::size_t p = 0; p < count; p += points_per_task) tasks.push_back({std::uint32_t(d), side, p});
        }
    return tasks;
}

void remark_maps(const FrontEnd& front, const Marks& marks, Context& context) {
    if (front.settings.bump == Bump::none) return;
    for (std::size_t d = 0; d < front.list.draws.size(); ++d)
        if (marks.sides(d) != 0 && front.list.materials[front.list.draws[d].material].view.normal_map.view) {
            context.report().add(
                Remark::dropped, front.list.scene.source, {},
                "normal maps do not act on flat and Gouraud shading: lighting is not evaluated at the pixels");
            return;
        }
}

}  // namespace

LightPoints light_points(FrontEnd& front, const Binned& binned, const std::vector<lighting::LightParameters>& lights,
                         const Kernels& kernels, Context& context) {
    LightPoints points;
    if (front.settings.shading != Shading::flat && front.settings.shading != Shading::gouraud) return points;
    Marks marks(front);
    context.parallel_for(binned.chunks.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        mark(front, binned.chunks[c], marks);
    });
    points.draws.resize(front.list.draws.size());
    for (std::size_t d = 0; d < points.draws.size(); ++d)
        points.draws[d].per_face = Marks::is_per_face(front, front.list.scene.meshes[front.list.draws[d].mesh]);
    const std::vector<Task> tasks = plan(front, marks, points);
    std::atomic<std::uint64_t> evaluations{0}, twice{0};
    context.parallel_for(tasks.size(), [&](std::size_t t) {
        const FlushDenormals guard;
        const Task& task = tasks[t];
        const std::vector<std::uint8_t>& marked = marks.points(task.draw);
        Batch batch;
        gather(front, task, points.draws[task.draw].per_face, marked, batch);
        if (context.cancelled() || batch.count == 0) return;
        run_kernel(material_job(front, lights, front.list.draws[task.draw].material), kernels, batch);
        scatter(batch, points.draws[task.draw].side[task.side]);
        evaluations += batch.count;
        if (task.side == 1)
            twice += std::uint64_t(std::count_if(batch.point.begin(), batch.point.begin() + std::ptrdiff_t(batch.count),
                                                 [&](std::uint32_t p) { return marked[p] == 3; }));
    });
    context.throw_if_cancelled();
    front.stats.lighting_evaluations = evaluations;
    front.stats.vertices_lit_twice = twice;
    remark_maps(front, marks, context);
    return points;
}

}  // namespace rakelight::raster
