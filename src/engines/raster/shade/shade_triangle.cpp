// SPDX-License-Identifier: Apache-2.0
// The kernels' records of triangles: by a vector of triangles where the corners are the mesh's; one by one, in double,
// for the few pieces that clipping made.
#include <algorithm>
#include <cmath>

#include "cpu_shading/make_mesh_view.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/tile.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

/// What the triangles of a draw have in common.
struct DrawRecords {
    const FrontEnd& front;
    const Mesh& mesh;
    shading::DrawFrame frame;

    DrawRecords(const FrontEnd& f, std::uint32_t draw)
        : front(f), mesh(f.list.scene.meshes[f.list.draws[draw].mesh]), frame(frame_of(f, draw)) {}
    const vec2* texcoords(std::size_t set) const {
        return set < mesh.texcoords.size() && !mesh.texcoords[set].empty() ? mesh.texcoords[set].data() : nullptr;
    }
};

void set_planes(const DrawRecords& d, const ScreenTriangle& s, const std::uint32_t (&index)[3], int tile_x, int tile_y,
                ShadeTriangle& out) {
    ClipVertex v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = d.front.clip[s.draw][index[k]];
    EdgePlanes e;
    if (!edge_planes(v, d.front.view, tile_x + 0.5, tile_y + 0.5, e)) e = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
    const double* const planes[3] = {e.ex, e.ey, e.e0};
    for (std::size_t c = 0; c < 3; ++c) {
        out.b1[c] = float(planes[c][1]);
        out.b2[c] = float(planes[c][2]);
        double depth = 0;
        for (std::size_t k = 0; k < 3; ++k)
            depth += planes[c][k] * (d.front.view.orthographic ? double(v[k].distance) : 1.0);
        out.depth[c] = float(depth);
    }
}

/// Interpolation on the screen of what clipping left: barycentrics are right at its corners and linear between them, as
/// where clipping makes new vertices. From the planes b1 / w, b2 / w and 1 / w.
void flatten_planes(const ScreenTriangle& s, int tile_x, int tile_y, ShadeTriangle& out) {
    double x[3], y[3], b[2][3];
    for (std::size_t k = 0; k < 3; ++k) {
        x[k] = double(s.x(k)) / (1 << subpixel_bits) - tile_x - 0.5;
        y[k] = double(s.y(k)) / (1 << subpixel_bits) - tile_y - 0.5;
        const auto at = [&](const float(&p)[3]) { return double(p[0]) * x[k] + double(p[1]) * y[k] + double(p[2]); };
        const double per_w = at(out.depth), w = per_w > 0 ? 1 / per_w : 0;
        b[0][k] = at(out.b1) * w;
        b[1][k] = at(out.b2) * w;
    }
    const double x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0],
                 per_area = 1 / (x1 * y2 - x2 * y1);
    float(*const planes[2])[3] = {&out.b1, &out.b2};
    for (std::size_t i = 0; i < 2; ++i) {
        const double d1 = b[i][1] - b[i][0], d2 = b[i][2] - b[i][0];
        const double slope_x = (d1 * y2 - d2 * y1) * per_area, slope_y = (d2 * x1 - d1 * x2) * per_area;
        (*planes[i])[0] = float(slope_x);
        (*planes[i])[1] = float(slope_y);
        (*planes[i])[2] = float(b[i][0] - slope_x * x[0] - slope_y * y[0]);
    }
}

/// a0, a1 - a0, a2 - a0 of a vector attribute.
void set_deltas(float (&to)[3][3], const dvec3 (&a)[3]) {
    for (std::size_t c = 0; c < 3; ++c) {
        to[c][0] = float(a[0][c]);
        to[c][1] = float(a[1][c] - a[0][c]);
        to[c][2] = float(a[2][c] - a[0][c]);
    }
}

/// A set of texture coordinates and its slopes, by the record's planes.
void set_texcoords(float (&to)[2][3], float (&slope)[2][2], const vec2* uv, const std::uint32_t (&index)[3],
                   const ShadeTriangle& planes) {
    if (!uv) return;
    for (std::size_t c = 0; c < 2; ++c) {
        to[c][0] = uv[index[0]][c];
        to[c][1] = uv[index[1]][c] - to[c][0];
        to[c][2] = uv[index[2]][c] - to[c][0];
        for (std::size_t axis = 0; axis < 2; ++axis)
            slope[c][axis] = planes.b1[axis] * to[c][1] + planes.b2[axis] * to[c][2];
    }
}

void set_colors(float (&to)[4][3], const Mesh& mesh, const std::uint32_t (&index)[3]) {
    for (std::size_t c = 0; c < 4; ++c) {
        to[c][0] = mesh.colors.empty() ? 1.0f : mesh.colors[index[0]][c];
        to[c][1] = mesh.colors.empty() ? 0.0f : mesh.colors[index[1]][c] - to[c][0];
        to[c][2] = mesh.colors.empty() ? 0.0f : mesh.colors[index[2]][c] - to[c][0];
    }
}

void make_piece_record(const DrawRecords& d, const ScreenTriangle& s, int tile_x, int tile_y, ShadeTriangle& out) {
    const Mesh& mesh = d.mesh;
    std::uint32_t index[3];
    for (std::size_t k = 0; k < 3; ++k) index[k] = mesh.indices[3 * std::size_t(s.triangle) + k];
    out = {};
    set_planes(d, s, index, tile_x, tile_y, out);
    if (d.front.settings.interpolation == AttributeInterpolation::screen && !d.front.view.orthographic)
        flatten_planes(s, tile_x, tile_y, out);
    const shading::DrawFrame::Corners corners = d.frame.corners(s.triangle);
    out.handedness = corners.handedness;
    set_deltas(out.normal, corners.normal);
    set_deltas(out.tangent, corners.tangent);
    set_texcoords(out.texcoord0, out.slope0, d.texcoords(0), index, out);
    set_texcoords(out.texcoord1, out.slope1, d.texcoords(1), index, out);
    set_colors(out.color, mesh, index);
    out.facing = d.frame.side().is_turned(s.triangle, s.is_back) ? -1.0f : 1.0f;
}

RecordJob record_job(const DrawRecords& d, std::uint32_t number, bool whole) {
    RecordJob job{};
    static_cast<cpu_shading::MeshView&>(job) = cpu_shading::make_mesh_view(d.mesh, d.frame);
    job.clip = &d.front.clip[number][0].x;
    job.whole = whole || d.front.list.view(number).vertex_colors || d.front.list.view(number).uses_texcoords[1];
    job.orthographic = d.front.view.orthographic;
    job.affine = is_affine(d.front);
    return job;
}

void set3(float (&to)[3], dvec3 v) { to[0] = float(v.x), to[1] = float(v.y), to[2] = float(v.z); }

/// The frames that the vertices have in the world, as a vertex stage would see them.
CornerFrame corner_frame(const DrawRecords& d, const ScreenTriangle& s) {
    const shading::DrawFrame::Corners corners = d.frame.corners(s.triangle);
    CornerFrame out{};
    out.handedness = corners.handedness;
    for (std::size_t k = 0; k < 3; ++k) {
        set3(out.position[k], corners.position[k]);
        set3(out.normal[k], corners.normal[k]);
        set3(out.tangent[k], corners.tangent[k]);
        set3(out.bitangent[k], corners.bitangent[k]);
    }
    return out;
}

}  // namespace

void make_records(const TileJob& job, std::uint32_t draw, std::span<const ScreenTriangle* const> triangles, int tile_x,
                  int tile_y, TileScratch& s) {
    const DrawRecords d(job.front, draw);
    if (s.triangles.size() < triangles.size() + batch_padding) s.triangles.resize(triangles.size() + batch_padding);
    s.rows.assign(triangles.begin(), triangles.end());
    s.rows.resize(triangles.size() + batch_padding, triangles.back());
    RecordJob kernel_job = record_job(d, draw, job.whole_records);
    kernel_job.count = std::int32_t(triangles.size());
    kernel_job.row = s.rows.data();
    kernel_job.tile_x = tile_x, kernel_job.tile_y = tile_y;
    kernel_job.out = s.triangles.data();
    const bool has_piece = job.front.kernels.record(&kernel_job) != 0;
    for (std::size_t i = 0; i < triangles.size() && has_piece; ++i)
        if (triangles[i]->is_piece) make_piece_record(d, *triangles[i], tile_x, tile_y, s.triangles[i]);
    if (wants_corner_frames(job.front, draw)) {
        s.frames.resize(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) s.frames[i] = corner_frame(d, *triangles[i]);
    }
    if (!is_lit_at_corners(job.front, draw) || job.points.draws.empty()) return;  // depths alone need no light
    s.lit.resize(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        make_lit_triangle(job.front, job.points, *triangles[i], s.triangles[i], s.lit[i]);
}

}  // namespace rakelight::raster
