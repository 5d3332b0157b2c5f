// SPDX-License-Identifier: Apache-2.0
#include "marks.h"

#include <algorithm>

namespace rakelight::viewer {

namespace {

void add(std::vector<Line>& to, const std::vector<Line>& more) { to.insert(to.end(), more.begin(), more.end()); }

void add_lights(const Marks& marks, const Look& look, const Model& model, const Camera& camera, int width, int height,
                std::vector<Line>& to) {
    Look lit = look;
    const std::vector<LightItem>& lights = changing_lights(lit, model, width, height);
    const Bounds& bounds = model.box.bounds();
    add(to, light_lines(lights, bounds, marks.light));
    if (marks.has_handles && marks.light < lights.size())
        add(to, gizmo_lines(lights[marks.light].light, {camera, width, height, marks.scale, bounds}, marks.lit));
}

}  // namespace

std::vector<Line> MarkLines::lines(const Marks& marks, const Look& look, const Model& model,
                                   const std::shared_ptr<const PreparedScene>& prepared, const Camera& camera,
                                   int width, int height) {
    const Bounds& bounds = model.box.bounds();
    std::vector<Line> lines;
    if (marks.grid) add(lines, grid_lines(bounds, look.world_up));
    if (marks.seams) add(lines, seam_lines(marks.seams->drawn));
    if (vectors_of_ != prepared || !std::ranges::equal(vectors_which_, marks.vectors)) {
        vectors_.clear();
        for (int i = 0; i < 3; ++i)
            if (marks.vectors[i] && prepared) add(vectors_, vertex_lines(scene_of(*prepared), VertexVector(i), bounds));
        vectors_of_ = prepared;
        std::ranges::copy(marks.vectors, vectors_which_);
    }
    add(lines, vectors_);
    if (marks.axes) add(lines, axis_lines(bounds));
    if (marks.lights) add_lights(marks, look, model, camera, width, height, lines);
    return lines;
}

}  // namespace rakelight::viewer
