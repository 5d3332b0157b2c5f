// SPDX-License-Identifier: Apache-2.0
#include "tools/stages/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/format_text.h"

namespace rakelight::stages {
namespace {

constexpr std::size_t drawn_triangles = 500000;

struct Extent {
    dvec2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    dvec2 high{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    void add(dvec2 p) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    bool is_empty() const { return low.x > high.x; }
};

/// One of so many triangles, so that large models do not take long.
class Triangles {
public:
    Triangles(const Vertices& vertices, bool only_transformed) : vertices_(vertices) {
        std::size_t total = 0;
        for (std::size_t d = 0; d < vertices.draws().size(); ++d)
            if (!only_transformed || vertices.is_transformed(d))
                draws_.push_back(d), total += vertices.mesh(d).triangle_count();
        step_ = total / drawn_triangles + 1;
    }
    std::string note() const { return step_ > 1 ? format_text(" About one of {} triangles is drawn.", step_) : ""; }

    template <class Visit>
    void visit(const Visit& visit) const {
        std::size_t n = 0;
        for (const std::size_t d : draws_) {
            const Mesh& mesh = vertices_.mesh(d);
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
                if (is_drawn(n++)) visit(d, mesh.indices.data() + 3 * t);
        }
    }

private:
    /// Scattered (Knuth's multiplicative hash): each so many-th would make stripes of a grid.
    bool is_drawn(std::size_t n) const { return step_ == 1 || (std::uint32_t(n) * 2654435761u >> 8) % step_ == 0; }

    const Vertices& vertices_;
    std::vector<std::size_t> draws_;
    std::size_t step_ = 1;
};

/// Everything that is plotted, in the picture.
Fit fit_all(const Triangles& triangles, const Space& space, int width, int height) {
    Extent e;
    triangles.visit([&](std::size_t d, const std::uint32_t* index) {
        for (int k = 0; k < 3; ++k) e.add(space.place(d, index[k]));
    });
    for (const std::vector<PlotLine>* lines : {&space.behind, &space.before})
        for (const PlotLine& l : *lines) e.add(l.a), e.add(l.b);
    return e.is_empty() ? Fit{} : fit(e.low, e.high, width, height);
}

}  // namespace

Cell cell(double v) { return std::isfinite(v) ? Cell(v) : Cell(v > 0 ? "inf" : v < 0 ? "-inf" : "nan"); }

double Vertices::depth_key(double distance) const {
    const shading::PictureCamera& view = of_.engine.view();
    return view.orthographic ? 1 - (distance - view.z_near) / (view.z_far - view.z_near) : view.z_near / distance;
}

dvec3 Vertices::device(std::size_t d, std::uint32_t v) const {
    const shading::ClipVertex c = clip(d, v);
    return {double(c.x) / double(c.w), double(c.y) / double(c.w), depth_key(double(c.distance))};
}

double Vertices::farthest() const {
    double far = 0;
    for (std::size_t d = 0; d < draws().size(); ++d)
        for (std::uint32_t v = 0; v < mesh(d).positions.size(); ++v) {
            const double distance = -camera(d, v).z;
            if (std::isfinite(distance)) far = std::max(far, distance);
        }
    return far;
}

Fit fit(dvec2 low, dvec2 high, int width, int height) {
    const double w = std::max(high.x - low.x, 1e-30), h = std::max(high.y - low.y, 1e-30);
    Fit f;
    f.scale = std::min(width * 0.9 / w, height * 0.9 / h);
    f.x = width * 0.5 - (low.x + high.x) * 0.5 * f.scale;
    f.y = height * 0.5 + (low.y + high.y) * 0.5 * f.scale;
    return f;
}

dvec2 oblique(dvec3 p) {
    return {(p.x - p.z) * 0.70710678118654752, p.y * 0.81649658092772603 - (p.x + p.z) * 0.40824829046386302};
}

std::array<dvec3, 8> frustum(const shading::PictureCamera& view, double far) {
    std::array<dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        const double distance = i < 4 ? view.z_near : far, w = view.orthographic ? 1 : distance;
        const double x = (i % 4 == 1 || i % 4 == 2 ? 1 : -1) * w / view.scale_x,
                     y = (i % 4 >= 2 ? 1 : -1) * w / view.scale_y;
        corners[i] = {x, y, -distance};
    }
    return corners;
}

void add_plot(Stage& stage, const Sources& of, const Vertices& vertices, const std::string& name, const Space& space) {
    const Triangles triangles(vertices, space.only_transformed);
    Canvas canvas(of.engine.settings().width, of.engine.settings().height, ground);
    const Fit f = space.fixed ? *space.fixed : fit_all(triangles, space, canvas.width(), canvas.height());
    for (const PlotLine& l : space.behind) canvas.line(f(l.a), f(l.b), l.color);
    LineCounts lines(canvas.width(), canvas.height());
    triangles.visit([&](std::size_t d, const std::uint32_t* index) {
        const dvec2 p[3] = {f(space.place(d, index[0])), f(space.place(d, index[1])), f(space.place(d, index[2]))};
        for (int k = 0; k < 3; ++k) lines.line(p[k], p[(k + 1) % 3]);
    });
    lines.draw(canvas, wire);
    for (const PlotLine& l : space.before) canvas.line(f(l.a), f(l.b), l.color);
    const char* const crowded =
        lines.is_crowded() ? " The lines are too close to be told apart: the more, the brighter." : "";
    stage.pictures.push_back({name, space.caption + crowded + triangles.note(), std::move(canvas)});
}

void add_table(Stage& stage, const Vertices& vertices, bool only_transformed, const std::vector<std::string>& columns,
               const VertexRow& values) {
    std::vector<double> low(columns.size(), std::numeric_limits<double>::infinity()),
        high(columns.size(), -std::numeric_limits<double>::infinity());
    std::size_t count = 0;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
        if (only_transformed && !vertices.is_transformed(d)) continue;
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v, ++count) {
            const std::vector<double> row = values(d, v);
            for (std::size_t c = 0; c < row.size(); ++c) {
                if (!std::isfinite(row[c])) continue;
                low[c] = std::min(low[c], row[c]);
                high[c] = std::max(high[c], row[c]);
            }
            if (count >= listed_rows) continue;
            Cell::List cells = {vertices.object(d), v};
            for (const double value : row) cells.push_back(cell(value));
            stage.rows.push_back(std::move(cells));
        }
    }
    stage.numbers["vertices"] = count;
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (low[c] <= high[c]) stage.numbers["range of " + columns[c]] = {cell(low[c]), cell(high[c])};
    stage.columns = {"object", "vertex"};
    stage.columns.insert(stage.columns.end(), columns.begin(), columns.end());
    stage.rows_note =
        count == 0 ? "There are no vertices." : format_text("The first {} of {} vertices", stage.rows.size(), count);
}

}  // namespace rakelight::stages
