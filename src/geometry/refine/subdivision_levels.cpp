// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/subdivision_levels.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <mutex>

namespace rakelight::geometry {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

namespace {

Sdc::SchemeType type_of(Scheme scheme) { return scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK; }

/// The library would write to standard output.
void be_quiet() {
    static std::once_flag once;
    std::call_once(once, [] {
        Far::SetErrorCallback([](Far::ErrorType, const char*) {});
        Far::SetWarningCallback([](const char*) {});
    });
}
float after_a_level(float sharpness) { return sharpness >= sharp_forever ? sharpness : std::max(sharpness - 1, 0.0f); }

}  // namespace

std::unique_ptr<Far::TopologyRefiner> refine(const ControlSurface& surface, const std::vector<std::uint32_t>& corners,
                                             std::size_t count, const Sharpness& sharpness) {
    be_quiet();
    std::vector<int> sizes, indices(corners.begin(), corners.end());
    for (std::uint32_t f = 0; f < surface.faces.count(); ++f) sizes.push_back(int(surface.faces.size(f)));
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = int(count);
    descriptor.numFaces = int(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = indices.data();
    descriptor.numCreases = int(sharpness.of_edges.size());
    descriptor.creaseVertexIndexPairs = sharpness.edges.data();
    descriptor.creaseWeights = sharpness.of_edges.data();
    descriptor.numCorners = int(sharpness.vertices.size());
    descriptor.cornerVertexIndices = sharpness.vertices.data();
    descriptor.cornerWeights = sharpness.of_vertices.data();
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(surface.sharpens_corners ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                               : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(type_of(surface.scheme), rules)));
    if (!refiner)
        throw Error(ErrorCode::bad_file, "the surface cannot be subdivided: too many faces at a vertex or edge");
    Far::TopologyRefiner::UniformOptions options(surface.level);
    options.fullTopologyInLastLevel = true;
    refiner->RefineUniform(options);
    return refiner;
}
int far_end(const Level& level, int edge, int vertex) {
    const auto ends = level.GetEdgeVertices(edge);
    return ends[0] == vertex ? ends[1] : ends[0];
}

Corner corner_at(const Level& level, int vertex, bool is_later) {
    Corner corner{Rule::smooth, {0, 0}};
    int sharp = 0;
    for (const int edge : {0, 1}) corner.ends[edge] = vertex;
    const auto edges = level.GetVertexEdges(vertex);
    for (int i = 0; i < edges.size(); ++i) {
        const float s = level.GetEdgeSharpness(edges[i]);
        if ((is_later ? after_a_level(s) : s) <= 0) continue;
        if (sharp < 2) corner.ends[sharp] = far_end(level, edges[i], vertex);
        ++sharp;
    }
    const float own = level.GetVertexSharpness(vertex);
    if ((is_later ? after_a_level(own) : own) > 0 || sharp > 2)
        corner.rule = Rule::corner;
    else if (sharp == 2)
        corner.rule = Rule::crease;
    return corner;
}

double part_of_sharp_rule(const Level& level, int vertex) {
    double sum = 0;
    int count = 0;
    const auto add = [&](float s) {
        if (s > 0 && after_a_level(s) <= 0) sum += double(s), ++count;
    };
    add(level.GetVertexSharpness(vertex));
    const auto edges = level.GetVertexEdges(vertex);
    for (int i = 0; i < edges.size(); ++i) add(level.GetEdgeSharpness(edges[i]));
    return count > 0 ? std::min(sum / count, 1.0) : 1;
}
}  // namespace rakelight::geometry
