// SPDX-License-Identifier: Apache-2.0
#include "load_model.h"

#include <chrono>

#include <rakelight/render/session.h>
#include <rakelight/render/shot.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

namespace rakelight::viewer {
namespace {

PictureRequest request_for(const std::string& file, const Start& start) {
    PictureRequest request;
    if (is_world_file(file)) {
        Context quiet({.threads = 1});
        request = read_world_request(file, start.load, {start.settings, start.takes}, quiet).picture;
    } else {
        request.load = start.load;
        request.look = rakelight::Look::standard;
        read_render_keys(start.settings, request);
        request.settings.material_shading = !sets_shading(start.settings);
    }
    request.input = file;
    request.settings.channels = 0;
    return request;
}

/// Options are for all files of the list, of which one may have no such clip: it stands as it is then.
std::vector<ClipTime> wanted_clips(const Scene& scene, PictureRequest& request, Context& context) {
    try {
        std::vector<ClipTime> clips = clips_of(scene, request.motion);
        if (clips.empty()) request.motion = {};
        return clips;
    } catch (const Error& error) {
        context.report().add(Remark::warning, scene.source, "", error.reason() + "; it is shown at rest");
        request.motion = {};
        return {};
    }
}

/// The files that were read, and those of the pictures, which are read when they are drawn.
std::vector<std::string> files_of(const Model& model, const Context& context) {
    std::vector<std::string> files = context.files();
    const auto add = [&](const ImageHandle& image) {
        if (image && !image->path.empty()) files.push_back(image->path);
    };
    for (const Texture& texture : model.scene.textures) add(texture.image);
    if (model.scene.environment) add(model.scene.environment->image);
    if (!model.request.hdri_file.empty()) files.push_back(model.request.hdri_file);
    return files;
}

void count(Model& model) {
    for (const Mesh& mesh : model.scene.meshes) model.has_meshes_without_material |= mesh.material == no_index;
    for (const Node& node : model.scene.nodes) {
        if (!node.meshes.empty()) ++model.objects;
        for (const std::uint32_t m : node.meshes) {
            model.triangles += model.scene.meshes[m].triangle_count();
            model.vertices += model.scene.meshes[m].positions.size();
        }
    }
}

/// Takes over the settings that the look chooses.
void decide(const std::shared_ptr<Model>& model, Context& context) {
    PictureRequest& request = model->request;
    const std::shared_ptr<const Scene> scene(model, &model->scene);
    const std::vector<ClipTime> clips = wanted_clips(*scene, request, context);
    const ShotOptions options{.is_view = true, .without_adjusting = true};
    if (request.look == rakelight::Look::plain) return apply_look(*scene, request, context);
    const Coloring coloring = request.coloring;     // what it leaves open stays open
    request.given_keys.emplace_back("point-size");  // the painter draws points as points: their size is chosen below
    Session session("soft");
    Shot shot = rakelight::decide(session, scene, request, clips, {}, options, context);
    request.coloring = coloring;
    request.given_keys.pop_back();
    const RayMethod method = request.settings.method;
    if (method == RayMethod::radiosity)  // the painter solves it
        request.settings.method = shot.settings.method = RayMethod::automatic;
    adjust_shot(session, shot, request, options, context);
    request.settings.method = method;
    request.look = rakelight::Look::plain;
}

}  // namespace

std::shared_ptr<const Model> load_model(const std::string& file, const Start& start, Context& context) {
    const auto begin = std::chrono::steady_clock::now();
    auto model = std::make_shared<Model>();
    model->file = file;
    model->request = request_for(file, start);
    if (is_world_file(file)) model->world = read_world(file, context);
    model->scene = load(file, model->request.load, context);
    context.throw_if_cancelled();
    decide(model, context);
    model->box = ViewBox(model->scene);
    count(*model);
    model->files = files_of(*model, context);
    model->remarks = context.report().entries();
    model->load_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return model;
}

}  // namespace rakelight::viewer
