// SPDX-License-Identifier: Apache-2.0
// Which lines and points a picture has, in which colors; into tiles.
#include "engines/raster/marks/marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engines/raster/marks/mark_set_up.h"
#include "math/flush_denormals.h"
#include "shading/mark_color.h"

namespace rakelight::raster {
namespace {

/// What is to be made, cut by numbers of elements; with the colors.
class MarkPlan {
public:
    MarkPlan(FrontEnd& front, Marks& marks) : front_(front), marks_(marks) {}

    std::vector<MarkChunk> run() {
        const RenderSettings& s = front_.settings;
        for (const Draw& draw : front_.list.line_draws) {
            const Mesh& mesh = mesh_of(draw);
            const bool is_line = mesh.topology == Topology::lines;
            add(draw, is_line ? MarkSource::lines : MarkSource::points, mesh.indices.size() / (is_line ? 2 : 1),
                own_color(draw));
        }
        const bool is_over = s.surfaces && s.line_color.w == 0;
        for (const auto& [wanted, source] :
             {std::pair{s.edges, MarkSource::edges}, {s.points != PointShape::none, MarkSource::vertices}}) {
            if (!wanted) continue;
            const vec4 color = is_over ? vec4{0, 0, 0, 1} : s.line_color;
            for (const Draw& draw : front_.list.draws)
                add(draw, source, mesh_of(draw).triangle_count(), color.w > 0 ? one(color) : own_color(draw));
        }
        for (std::size_t i = 1; i < marks_.colors.size(); ++i)
            marks_.is_of_one_color = marks_.is_of_one_color && marks_.colors[i] == marks_.colors[0];
        return std::move(chunks_);
    }

private:
    struct Colors {
        std::uint32_t all, first;
    };
    const Mesh& mesh_of(const Draw& draw) const { return front_.list.scene.meshes[draw.mesh]; }

    Colors one(vec4 color) {
        if (marks_.colors.empty() || !(marks_.colors.back() == color)) marks_.colors.push_back(color);
        return {std::uint32_t(marks_.colors.size() - 1), 0};
    }
    /// The material's, times the vertices' where there are any.
    Colors own_color(const Draw& draw) {
        const vec4 color = shading::mark_color(front_.list.materials[draw.material]);
        const Block<vec4>& vertices = mesh_of(draw).colors;
        if (vertices.empty()) return one(color);
        front_.memory.add(vertices.size() * sizeof(vec4));
        const auto first = std::uint32_t(marks_.colors.size());
        for (const vec4& v : vertices) marks_.colors.push_back({v.x * color.x, v.y * color.y, v.z * color.z, color.w});
        return {no_color, first};
    }
    void add(const Draw& draw, MarkSource source, std::size_t count, Colors color) {
        for (std::size_t i = 0; i < count; i += marks_per_chunk)
            chunks_.push_back({&draw, source, color.all, color.first, i, std::min(count, i + marks_per_chunk), {}, {}});
    }

    FrontEnd& front_;
    Marks& marks_;
    std::vector<MarkChunk> chunks_;
};

void check_size(const char* what, float pixels) {
    if (!(pixels > 0 && pixels <= 256))
        throw Error(ErrorCode::usage, std::string(what) + " must be more than 0 and at most 256 pixels");
}

/// Counting sort by tile, in the order of the chunks.
void sort_into_tiles(std::vector<MarkChunk>& chunks, std::size_t tiles, Marks& marks) {
    std::uint64_t total = 0;
    std::vector<std::uint64_t> count(tiles + 1, 0);
    for (const MarkChunk& c : chunks) {
        total += c.tiles.size();
        for (const auto& [tile, index] : c.tiles) ++count[tile + 1];
    }
    if (total > 0xFFFFFFFFull) throw Error(ErrorCode::failed, "too many lines and points for one picture");
    for (std::size_t t = 0; t < tiles; ++t) count[t + 1] += count[t];
    marks.offsets.assign(count.begin(), count.end());
    marks.items.resize(std::size_t(total));
    for (std::size_t c = 0; c < chunks.size(); ++c) {
        for (const auto& [tile, index] : chunks[c].tiles)
            marks.items[std::size_t(count[tile]++)] = std::uint64_t(c) << 32 | index;
        marks.chunks.push_back(std::move(chunks[c].marks));
        marks.draws.push_back(chunks[c].draw);
    }
}

}  // namespace

Marks make_marks(FrontEnd& front, const TileGrid& grid, Context& context) {
    Marks marks;
    check_size("the line width", front.settings.line_width);
    check_size("the point size", front.settings.point_size);
    std::vector<MarkChunk> chunks = MarkPlan(front, marks).run();
    if (chunks.empty()) return marks;
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        if (!context.cancelled()) set_up_marks(front, grid, chunks[c]);
    });
    context.throw_if_cancelled();
    sort_into_tiles(chunks, grid.count(), marks);
    return marks;
}

}  // namespace rakelight::raster
