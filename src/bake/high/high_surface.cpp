// SPDX-License-Identifier: Apache-2.0
#include "bake/high/high_surface.h"

#include "bake/high/mean_curvature.h"
#include "math/linear.h"
#include "scene/materials/texture_uses.h"
#include "scene/placed_normal.h"

namespace rakelight::bake {
namespace {

/// Rays need no textures, so none are decoded.
Scene without_textures(Scene scene) {
    for (Material& material : scene.materials) for_each_texture_use(material, [](TextureUse& use) { use = {}; });
    return scene;
}

std::vector<AttributeMesh> placed_meshes(const cpu_shading::DrawList& list) {
    std::vector<AttributeMesh> meshes;
    for (const shading::Draw& draw : list.draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        meshes.push_back({.object = draw.node,
                          .positions = mesh.positions,
                          .indices = mesh.indices,
                          .to_world = draw.to_world,
                          .position_step = mesh.position_step});
    }
    return meshes;
}

}  // namespace

HighSurface::HighSurface(const Scene& scene, bool wants_curvature, Context& context)
    : mapped_(std::in_place, scene, context),
      rays_(without_textures(scene), context),
      charge_(context.memory()),
      diagonal_(rays_.list().bounds.diagonal()) {
    if (rays_.list().draws.empty())
        throw Error(ErrorCode::bad_file, "has no triangles to be baked from").with_file(scene.source);
    if (!wants_curvature) return;
    curvatures_ = mean_curvatures(placed_meshes(rays_.list()), context);
    for (const std::vector<float>& values : curvatures_) charge_.grow(values.size() * sizeof(float), "curvatures");
}

HighPoint HighSurface::point(const raytrace::SurfaceHit& hit) const {
    const shading::Draw& draw = rays_.list().draws[hit.draw];
    const Mesh& mesh = rays_.list().scene.meshes[draw.mesh];
    const PlacedNormals placed(draw.to_world);
    dvec3 places[3], sum{}, at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.indices[3 * std::size_t(hit.triangle) + k];
        places[k] = transform_point(draw.to_world, cast<double>(mesh.positions[v]));
        at = at + places[k] * hit.weight[k];
        sum = sum + cast<double>(placed(mesh.normals[v])) * hit.weight[k];
    }
    const double turn = draw.mirrored ? -1 : 1;
    HighPoint point{.hit = hit, .place = at};
    point.face = normalize_or(cross(places[1] - places[0], places[2] - places[0]) * turn, dvec3{0, 0, 1});
    point.normal = normalize_or(sum, point.face);
    point.normal = mapped_->at(draw.to_world, mesh, hit.triangle, hit.weight, point.normal);
    return point;
}

const Mesh& HighSurface::mesh_of(const raytrace::SurfaceHit& hit) const {
    return rays_.list().scene.meshes[rays_.list().draws[hit.draw].mesh];
}

double HighSurface::curvature(const raytrace::SurfaceHit& hit) const {
    const Mesh& mesh = mesh_of(hit);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
        sum += double(curvatures_[hit.draw][mesh.indices[3 * std::size_t(hit.triangle) + k]]) * hit.weight[k];
    return sum;
}

}  // namespace rakelight::bake
