// SPDX-License-Identifier: Apache-2.0
// Renderer: who poses the meshes of a moment.
#include "engines/opengl/renderer.h"
#include "engines/posed_arrays.h"
#include "shading/shading_choice.h"

namespace rakelight::opengl {

/// Lines and points, edges, vertices and channels of triangles are drawn from tables of triangles. So are flat shading
/// and the other cases that DrawStateMaker::set_vertices() names. Blended triangles are sorted on the processor.
std::set<std::uint32_t> Renderer::meshes_read_by_processor() {
    bool reads_all = settings_.edges || settings_.points != PointShape::none;
    for_each_group(settings_.channels, [&](Output, bool wants_triangles) { reads_all = reads_all || wants_triangles; });
    std::set<std::uint32_t> meshes;
    for (const shading::Draw& draw : list_.line_draws) meshes.insert(draw.mesh);
    const PictureState state = picture_state();
    for (std::uint32_t d = 0; d < list_.draws.size(); ++d) {
        const std::uint32_t mesh = list_.draws[d].mesh;
        if (!unposed_.contains(mesh)) continue;
        if (reads_all || list_.material(list_.draws[d]).factors.blend ||
            draw_state(state, d, Output::color, false).features.from_triangles)
            meshes.insert(mesh);
    }
    return meshes;
}

void Renderer::pose_here(std::uint32_t mesh, Context& context) {
    const auto pose = unposed_.find(mesh);
    if (pose == unposed_.end()) return;
    context.throw_if_cancelled();
    take_posed_arrays(list_.scene.meshes[mesh], pose->second, context);
    poses_.drop(mesh);
    unposed_.erase(pose);
}

void Renderer::pose_measured_meshes(Context& context) {
    if (unposed_.empty()) return;
    for (const std::uint32_t mesh : shading::measured_meshes(list_, settings_)) pose_here(mesh, context);
}

/// Decides what poses a mesh at this moment: the processor if it reads the vertices or the driver's textures are too
/// small, else the driver. (OpenGL 3.3 and ES 3.0 have transform feedback. Whose vertices prepare needed, come posed:
/// Preparing::finish_unposed() of prepare_scene.cpp.)
void Renderer::pose_meshes(Context& context) {
    if (unposed_.empty()) return;
    const std::set<std::uint32_t> read = meshes_read_by_processor();
    std::vector<std::uint32_t> here;
    for (const auto& [number, of] : unposed_)
        if (read.contains(number) || !poses_.fits(of)) here.push_back(number);
    for (const std::uint32_t number : here) pose_here(number, context);
    poses_.pose(list_.scene, unposed_, meshes_);
}

}  // namespace rakelight::opengl
