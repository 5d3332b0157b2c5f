// SPDX-License-Identifier: Apache-2.0
// Borders that run along each other without shared vertices: closed forms whose error against the surface's own normals must
// fall with the seam, what must stay apart, measures against brute force, threads, and crowds of edges.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/geometry/border_shapes.h"

namespace rakelight::test {
namespace {

struct Joined {
    std::vector<Shape> shapes;
    MatchReport report;
    BorderMeasure before, after;
};

double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

std::vector<Shape> smoothed(const std::vector<Shape>& shapes, const AttributeOptions& options = {}) {
    const std::vector<MeshAttributes> made = compute(shapes, options);
    std::vector<Shape> out;
    for (std::size_t m = 0; m < shapes.size(); ++m) out.push_back(with_attributes(shapes[m], made[m]));
    return out;
}

std::vector<Shape> applied(std::vector<Shape> shapes, const std::vector<MeshSeams>& turned) {
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < turned[m].vertices.size(); ++i)
            shapes[m].normals[turned[m].vertices[i]] = turned[m].normals[i];
    return shapes;
}

Joined join(const std::vector<Shape>& shapes, const MatchOptions& options, int threads = 2) {
    Context context({.threads = threads});
    Joined out;
    out.before = measure_borders(views(shapes), options, context);
    const BorderMatch match = match_borders(views(shapes), options, context);
    out.shapes = applied(shapes, join_borders(match, views(shapes), {}, out.report, context));
    out.after = measure_borders(views(out.shapes), options, context);
    return out;
}

/// Mean over the border vertices at the cut [degrees].
double mean_error(const std::vector<Shape>& shapes, const std::vector<std::vector<dvec3>>& truth,
                  const std::vector<Shape>& turned) {
    double sum = 0;
    int count = 0;
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t v = 0; v < truth[m].size(); ++v)
            if (turned[m].normals[v] != shapes[m].normals[v]) {
                sum += degrees_between(cast<double>(shapes[m].normals[v]), truth[m][v]);
                ++count;
            }
    return count == 0 ? 0 : sum / count;
}

class ClosedForms : public testing::TestWithParam<Cut> {};

TEST_P(ClosedForms, SeamAndErrorFall) {
    const Cut cut = GetParam();
    for (const auto& [name, surface] : {std::pair<const char*, Surface>{"bumpy sphere", bumpy_sphere()},
                                        {"torus", torus()},
                                        {"cylinder", cylinder()}}) {
        SCOPED_TRACE(name);
        const CutSurface model = cut_surface(surface, cut);
        const std::vector<Shape> made = smoothed(model.halves);
        const double reach = (0.05 + cut.gap + 2 * cut.noise) * model.edge;
        const Joined joined = join(made, {.distance = std::max(reach, 0.15 * model.edge)});
        const double before = mean_error(made, model.truth, joined.shapes),
                     after = mean_error(joined.shapes, model.truth, made);
        EXPECT_GT(joined.report.following, 0u);
        EXPECT_LT(joined.after.seam.mean_deg, joined.before.seam.mean_deg * 0.1 + 0.02);
        // straight interpolation is off an arc of 15 degrees by 0.03 at most
        EXPECT_LT(after, std::max(before, 0.03));
    }
}

INSTANTIATE_TEST_SUITE_P(Cuts, ClosedForms,
                         testing::Values(Cut{.times = 2}, Cut{.times = 3}, Cut{.times = 5}, Cut{.phase = 0.37},
                                         Cut{.times = 2, .phase = 0.5}, Cut{.times = 3, .phase = 0.21}, Cut{.gap = 0.1},
                                         Cut{.times = 2, .gap = 0.3}, Cut{.times = 5, .gap = 0.2},
                                         Cut{.times = 3, .phase = 0.4, .gap = 0.1, .noise = 0.03},
                                         Cut{.times = 2, .gap = 0.3, .noise = 0.05}));

}  // namespace
}  // namespace rakelight::test
