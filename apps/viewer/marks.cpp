// SPDX-License-Identifier: Apache-2.0
#include "marks.h"

#include <algorithm>

namespace rakelight::viewer {

std::vector<Line> MarkLines::lines(const Marks& marks, const Look& look, const Model& model,
                                   const std::shared_ptr<const PreparedScene>& prepared, int width, int height) {
    const Bounds& bounds = model.box.bounds();
    std::vector<Line> lines;
    const auto add = [](std::vector<Line>& to, const std::vector<Line>& more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    if (marks.grid) add(lines, grid_lines(bounds, look.world_up));
    if (marks.seams) add(lines, seam_lines(*marks.seams));
    if (vectors_of_ != prepared || !std::ranges::equal(vectors_which_, marks.vectors)) {
        vectors_.clear();
        for (int i = 0; i < 3; ++i)
            if (marks.vectors[i] && prepared) add(vectors_, vertex_lines(scene_of(*prepared), VertexVector(i), bounds));
        vectors_of_ = prepared;
        std::ranges::copy(marks.vectors, vectors_which_);
    }
    add(lines, vectors_);
    if (marks.axes) add(lines, axis_lines(bounds));
    if (marks.lights) {
        Look lit = look;
        add(lines, light_lines(changing_lights(lit, model, width, height), bounds, marks.light));
    }
    return lines;
}

}  // namespace rakelight::viewer
