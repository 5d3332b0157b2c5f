// SPDX-License-Identifier: Apache-2.0
#include "examined_model.h"

#include <algorithm>

#include <rakelight/world/render_keys.h>

#include "../../apps/viewer/background/load_model.h"
#include "../../apps/viewer/view/overlay.h"

namespace rakelight::web {
namespace {

/// Surfaces are looked at for near borders alone, which takes as long as all else.
constexpr std::uint64_t most_for_surfaces = 500'000;

}  // namespace

PrepareOptions as_measured(const Scene& scene, PrepareOptions options) {
    const bool has_normals =
        std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return !mesh.normals.empty() || mesh.normal_choice; });
    if (options.normals == NormalSource::automatic && !has_normals) options.normals = NormalSource::object;
    return options;
}

std::shared_ptr<const ExaminedModel> examine(const std::string& file, std::span<const WorldValue> settings,
                                             Context& context) {
    viewer::Start start;
    start.threads = 1;
    return examine(viewer::load_model(file, start, context), settings, context);
}

std::shared_ptr<const ExaminedModel> examine(std::shared_ptr<const viewer::Model> model,
                                             std::span<const WorldValue> settings, Context& context) {
    auto examined = std::make_shared<ExaminedModel>();
    examined->model = std::move(model);
    PictureRequest request = examined->model->request;
    read_render_keys(settings, request);
    InspectOptions options{.surfaces = examined->model->triangles <= most_for_surfaces, .seam_lines = true};
    options.prepare = request.prepare;
    options.weld_distance = request.prepare.weld_distance;
    options.border_distance = request.prepare.border_distance;
    examined->inspection = inspect(examined->model->scene, options, context);
    examined->seams = viewer::worst_seams(std::move(examined->inspection.seam_lines)).drawn;
    std::erase_if(examined->seams, [](const SeamLine& s) { return std::max(s.deg_a, s.deg_b) <= continuous_deg; });
    examined->heat_map = viewer::seam_lines(examined->seams);
    return examined;
}

}  // namespace rakelight::web
