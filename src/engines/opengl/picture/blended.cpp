// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/blended.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "shading/draw_choices.h"

namespace rakelight::opengl {
namespace {

struct Layer {
    double place;
    std::uint32_t draw, triangle;
};

/// Nearness of a vertex, within what the view keeps of it; < 0: it is not finite.
class Keys {
public:
    Keys(const shading::DrawList& list, const shading::PictureCamera& view, const shading::Draw& draw)
        : mesh_(list.scene.meshes[draw.mesh]), view_(view), to_camera_(view.world_to_camera * draw.to_world) {}

    float of(std::uint32_t vertex) const {
        const dvec3 p = cast<double>(mesh_.positions[vertex]);
        const double distance = -transform_point(to_camera_, p).z;
        if (!std::isfinite(distance)) return -1;
        if (view_.orthographic)
            return float(std::clamp(1 - (distance - view_.z_near) / (view_.z_far - view_.z_near), 0.0, 1.0));
        return distance <= view_.z_near ? 1.0f : float(view_.z_near / distance);
    }

private:
    const Mesh& mesh_;
    const shading::PictureCamera& view_;
    const dmat4 to_camera_;
};

void add_layers(const shading::DrawList& list, const shading::PictureCamera& view, std::uint32_t number,
                std::vector<Layer>& to) {
    const shading::Draw& draw = list.draws[number];
    const Mesh& mesh = list.scene.meshes[draw.mesh];
    const Keys keys(list, view, draw);
    std::vector<float> key(mesh.positions.size());
    for (std::size_t v = 0; v < key.size(); ++v) key[v] = keys.of(std::uint32_t(v));
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const float a = key[mesh.indices[3 * t]], b = key[mesh.indices[3 * t + 1]], c = key[mesh.indices[3 * t + 2]];
        const float farthest = std::min({a, b, c}), nearest = std::max({a, b, c});
        if (farthest < 0) continue;
        to.push_back({shading::blending_place(farthest, nearest), number, std::uint32_t(t)});
    }
}

}  // namespace

std::vector<BlendedRun> blending_order(const shading::DrawList& list, const shading::PictureCamera& view,
                                       const std::vector<std::uint32_t>& draws, Context& context) {
    std::vector<Layer> layers;
    for (const std::uint32_t draw : draws) {
        context.throw_if_cancelled();
        add_layers(list, view, draw, layers);
    }
    std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.place < b.place; });
    std::vector<BlendedRun> runs;
    for (const Layer& layer : layers) {
        if (runs.empty() || runs.back().draw != layer.draw) runs.push_back({layer.draw, {}});
        runs.back().triangles.push_back(layer.triangle);
    }
    return runs;
}

}  // namespace rakelight::opengl
