// SPDX-License-Identifier: Apache-2.0
#include "load_model.h"

#include <chrono>

#include <rakelight/linear.h>
#include <rakelight/picture_parts.h>

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
        request.settings.own_shading = !shades_the_whole(start.settings);
    }
    request.input = file;
    request.settings.channels = 0;
    return request;
}

std::vector<Light> lights_in_world(const Scene& scene) {
    std::vector<Light> lights = scene.lights;
    const std::vector<dmat4> world = node_matrices(scene);
    for (Light& light : lights) {
        if (light.node >= world.size()) continue;
        const dmat4& m = world[light.node];
        light.position = m[3].xyz();
        light.direction = normalize_or(-m[2].xyz(), dvec3{0, 0, -1});
        light.node = no_index;
    }
    return lights;
}

/// What was read, and the pictures, which are read when they are drawn.
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

}  // namespace

std::vector<dmat4> node_matrices(const Scene& scene) {
    std::vector<dmat4> world(scene.nodes.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Node& node = scene.nodes[i];
        const dmat4 local = node.local.matrix ? *node.local.matrix
                                              : compose(node.local.translation, node.local.rotation, node.local.scale);
        world[i] = node.parent == no_index ? local : world[node.parent] * local;
    }
    return world;
}

std::shared_ptr<const Model> load_model(const std::string& file, const Start& start, Context& context) {
    const auto begin = std::chrono::steady_clock::now();
    auto model = std::make_shared<Model>();
    model->file = file;
    model->request = request_for(file, start);
    if (is_world_file(file)) model->world = read_world(file, context);
    model->scene = load(file, model->request.load, context);
    context.throw_if_cancelled();
    take_look(model->scene, model->request, context);
    take_look_of_picture(with_asked_surfaces(model->scene, model->request, context), model->request, context);
    model->request.look = rakelight::Look::plain;
    model->box = ViewBox(model->scene);
    model->lights = lights_in_world(model->scene);
    count(*model);
    model->files = files_of(*model, context);
    model->remarks = context.report().entries();
    model->load_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return model;
}

}  // namespace rakelight::viewer
