// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "engines/raster/coverage.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility_methods.h"

namespace rakelight::raster {
namespace {

bool is_finite(float v) { return v - v == 0; }

bool is_lit_at_pixels(const ShadeJob& job) { return !job.unlit && !job.lit; }

/// Colors of a finished batch into the tile; `over` blends (Porter & Duff 1984, straight alpha over an opaque ground).
void store_batch(std::size_t count, bool over, TileScratch& s) {
    const auto finite = [&s](float v) {
        if (is_finite(v)) return v;
        ++s.not_finite;
        return 0.0f;
    };
    for (std::size_t i = 0; i < count; ++i) {
        vec4& to = s.color[std::size_t(s.y[i] * tile_size + s.x[i])];
        if (!over && is_finite(s.red[i] + s.green[i] + s.blue[i])) {  // nearly all; a sum that overflows is looked at below
            to = {s.red[i], s.green[i], s.blue[i], 1.0f};
            continue;
        }
        const float opacity = over ? std::clamp(finite(s.alpha[i]), 0.0f, 1.0f) : 1.0f;
        const vec4 c = {finite(s.red[i]), finite(s.green[i]), finite(s.blue[i]), opacity};
        const float under = to.w * (1 - c.w), alpha = c.w + under;
        if (!over || !(alpha > 0))
            to = over ? to : c;
        else
            to = {(c.x * c.w + to.x * under) / alpha, (c.y * c.w + to.y * under) / alpha, (c.z * c.w + to.z * under) / alpha, alpha};
    }
    s.shaded += count;
}

/// Position in the list -> record, made on first use.
std::int32_t record_of(const TileJob& job, std::size_t tile, std::int32_t position, TileScratch& s) {
    std::int32_t& record = s.record[std::size_t(position)];
    if (record < 0) {
        record = std::int32_t(s.triangles.size());
        make_records(job, job.binned.at(job.binned.items[job.binned.offsets[tile] + std::uint32_t(position)]), job.grid.origin_x(tile),
                     job.grid.origin_y(tile), s.triangles.size(), s);
    }
    return record;
}

void shade_run(const TileJob& job, std::size_t tile, std::uint32_t material, const std::uint32_t* pixels, std::size_t count,
               TileScratch& s) {
    std::int32_t position = -1, record = -1;
    for (std::size_t i = 0; i < count; ++i) {
        s.x[i] = std::int32_t(pixels[i] % tile_size);
        s.y[i] = std::int32_t(pixels[i] / tile_size);
        if (s.visible[pixels[i]] != position) {  // neighbors mostly show one triangle
            position = s.visible[pixels[i]];
            record = record_of(job, tile, position, s);
        }
        s.triangle[i] = record;
    }
    ShadeJob batch = make_job(job, material, count, s);
    if (job.front.settings.channels & channel_normal) {
        batch.normal_x = s.normal_x.data();
        batch.normal_y = s.normal_y.data();
        batch.normal_z = s.normal_z.data();
    }
    job.kernels.shade(&batch);
    if (is_lit_at_pixels(batch)) s.lit_pixels += count;
    if (batch.normal_x)
        for (std::size_t i = 0; i < count; ++i) s.normal[pixels[i]] = {s.normal_x[i], s.normal_y[i], s.normal_z[i]};
    store_batch(count, false, s);
}

}  // namespace

namespace {

/// Lists the covered pixels with the object and material of each. Neighbors mostly show one triangle.
void find_owners(const TileJob& job, std::uint32_t first, TileScratch& s) {
    std::int32_t position = -1;
    const Draw* draw = nullptr;
    for (std::uint32_t p = 0; p < tile_pixels; ++p) {
        if (s.visible[p] < 0) continue;
        if (s.visible[p] != position) {
            position = s.visible[p];
            draw = &job.front.list.draws[job.binned.at(job.binned.items[first + std::uint32_t(position)]).draw];
        }
        s.pixels.push_back(p);
        s.object[p] = draw->node;
        s.material[p] = draw->material;
    }
}

/// Brings the pixels of one triangle together, row by row: where a vector of them has one triangle its record need not be gathered.
void group_by_triangle(std::size_t list, TileScratch& s) {
    s.tally.assign(list + 1, 0);
    for (const std::uint32_t p : s.pixels) ++s.tally[std::size_t(s.visible[p]) + 1];
    for (std::size_t i = 0; i < list; ++i) s.tally[i + 1] += s.tally[i];
    s.grouped.resize(s.pixels.size());
    for (const std::uint32_t p : s.pixels) s.grouped[s.tally[std::size_t(s.visible[p])]++] = p;
    s.pixels.swap(s.grouped);
}

constexpr std::size_t most_groups = 64;  // that are looked through one by one

void sort_by_material(TileScratch& s) {
    std::stable_sort(s.pixels.begin(), s.pixels.end(), [&s](std::uint32_t a, std::uint32_t b) { return s.material[a] < s.material[b]; });
}

/// Brings the pixels of one material together, each group row by row; groups in the order of their first pixels.
void group_by_material(TileScratch& s) {
    struct Group {
        std::uint32_t material;
        std::size_t at;  ///< first their number, then where the next pixel goes
    };
    std::vector<Group> groups;
    auto group_of = [&, last = std::size_t(0)](std::uint32_t material) mutable -> Group& {
        if (last < groups.size() && groups[last].material == material) return groups[last];  // neighbors mostly are of one
        for (last = 0; last < groups.size() && groups[last].material != material; ++last) {
        }
        if (last == groups.size()) groups.push_back({material, 0});
        return groups[last];
    };
    for (const std::uint32_t p : s.pixels) {
        ++group_of(s.material[p]).at;
        if (groups.size() > most_groups) return sort_by_material(s);
    }
    if (groups.size() < 2) return;
    std::size_t sum = 0;
    for (Group& group : groups) sum += std::exchange(group.at, sum);
    s.grouped.resize(s.pixels.size());
    for (const std::uint32_t p : s.pixels) s.grouped[group_of(s.material[p]).at++] = p;
    s.pixels.swap(s.grouped);
}

}  // namespace

ShadeJob make_job(const TileJob& job, std::uint32_t material, std::size_t count, TileScratch& s) {
    ShadeJob out = material_job(job.front, job.lights, material);
    out.count = std::int32_t(count);
    for (std::size_t i = 0; i < batch_padding; ++i) {  // dead lanes repeat the last pixel
        s.x[count + i] = s.x[count - 1];
        s.y[count + i] = s.y[count - 1];
        s.triangle[count + i] = s.triangle[count - 1];
    }
    out.x = s.x.data();
    out.y = s.y.data();
    out.triangle = s.triangle.data();
    out.triangles = s.triangles.data();
    if (job.points.is_used) out.lit = s.lit.data();
    out.red = s.red.data();
    out.green = s.green.data();
    out.blue = s.blue.data();
    out.alpha = s.alpha.data();
    return out;
}

void make_records(const TileJob& job, const ScreenTriangle& s, int tile_x, int tile_y, std::size_t record, TileScratch& scratch) {
    scratch.triangles.resize(record + 1);
    make_shade_triangle(job.front, s, tile_x, tile_y, scratch.triangles[record]);
    if (!job.points.is_used) return;
    scratch.lit.resize(record + 1);
    make_lit_triangle(job.front, job.points, s, scratch.triangles[record], scratch.lit[record]);
}

void shade_opaque(const TileJob& job, std::size_t tile, TileScratch& s) {
    const RenderSettings& settings = job.front.settings;
    std::fill(s.color.begin(), s.color.end(), settings.background);
    if (settings.channels & channel_normal) std::fill(s.normal.begin(), s.normal.end(), vec3{});
    if (settings.channels & channel_object) std::fill(s.object.begin(), s.object.end(), none);
    if (settings.channels & channel_material) std::fill(s.material.begin(), s.material.end(), none);
    const std::uint32_t first = job.binned.offsets[tile];
    s.record.assign(job.binned.offsets[tile + 1] - first, -1);
    s.triangles.clear();
    s.pixels.clear();
    find_owners(job, first, s);
    s.covered += s.pixels.size();
    group_by_triangle(s.record.size(), s);
    group_by_material(s);
    for (std::size_t i = 0; i < s.pixels.size();) {
        const std::uint32_t material = s.material[s.pixels[i]];
        std::size_t end = i + 1;
        while (end < s.pixels.size() && s.material[s.pixels[end]] == material) ++end;
        shade_run(job, tile, material, s.pixels.data() + i, end - i, s);
        i = end;
    }
    if (settings.channels & channel_material)
        for (const std::uint32_t p : s.pixels) s.material[p] = job.front.list.materials[s.material[p]].scene_material;
}

void blend_transparent(const TileJob& job, std::size_t tile, TileScratch& s) {
    if (!job.has_blended) return;
    struct Layer {
        double place;
        std::uint32_t item;
    };
    std::vector<Layer> layers;
    for (std::uint32_t i = job.binned.offsets[tile]; i < job.binned.offsets[tile + 1]; ++i) {
        const ScreenTriangle& t = job.binned.at(job.binned.items[i]);
        if (job.front.list.materials[job.front.list.draws[t.draw].material].view.blend)
            layers.push_back({blending_place(job.front, t), i});
    }
    if (layers.empty()) return;
    std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.place < b.place; });
    const Window area = job.grid.pixels(tile);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    for (const Layer& layer : layers) {
        const ScreenTriangle& t = job.binned.at(job.binned.items[layer.item]);
        std::size_t count = 0;
        const BlendTest is_before(job.front, t, std::int32_t(layer.item - job.binned.offsets[tile]));
        cover(t, area, ox, oy, [&](int x, int y, float depth) {
            if (!is_before(x, y, ox, oy, depth, s)) return;
            s.x[count] = x;
            s.y[count] = y;
            s.triangle[count++] = 0;
        });
        if (count == 0) continue;
        make_records(job, t, ox, oy, 0, s);
        const ShadeJob batch = make_job(job, job.front.list.draws[t.draw].material, count, s);
        job.kernels.shade(&batch);
        if (is_lit_at_pixels(batch)) s.lit_pixels += count;
        store_batch(count, true, s);
    }
}

}  // namespace rakelight::raster
