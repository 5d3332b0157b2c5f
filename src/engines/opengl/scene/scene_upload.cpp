// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/scene_upload.h"

#include <utility>

#include "engines/posed_arrays.h"
#include "scene/materials/material_table.h"
#include "shading/posed_draw_list.h"

namespace rakelight::opengl {

TakenScene take_scene(GivenScene given, bool poses_here, shading::TextureCache cache,
                      shading::EnvironmentCache environments, Context& context) {
    TakenScene out{
        .list = {}, .cache = std::move(cache), .environments = std::move(environments), .environment = {}, .poses = {}};
    if (given.poses && poses_here)
        given.scene = with_posed_arrays(std::move(given.scene), *given.poses, context);
    else if (given.poses)
        out.poses = *given.poses;
    out.list = shading::make_draw_list(std::move(given.scene), out.poses, out.cache, LevelPacker(), context);
    out.environment = out.environments.update(out.list.scene, EnvironmentLevelPacker(), true, context);
    return out;
}

std::vector<TextureStore::Wish> wishes_of(const shading::DrawList& list, const shading::TextureCache& cache) {
    std::vector<TextureStore::Wish> wishes;
    for (const shading::DrawMaterial& drawn : list.materials)
        for (const TextureRole& role : texture_roles()) {
            if (!drawn.maps[std::size_t(role.number)]) continue;
            const shading::TextureKey key = shading::key_of(list, drawn, role);
            const shading::LoadedTexture* const loaded = cache.find(key);
            wishes.push_back({std::static_pointer_cast<const TextureLevels>(loaded->packed), role.number == role_height,
                              loaded->is_bump, key.image.get()});
        }
    return wishes;
}

bool upload_some(const TakenScene& taken, TextureStore& textures, MeshStore& meshes, Clock::time_point end,
                 Context& context) {
    bool is_first = true;
    const auto has_time = [&] { return std::exchange(is_first, false) || Clock::now() < end; };
    for (const TextureStore::Wish& wish : wishes_of(taken.list, taken.cache)) {
        if (textures.has(wish)) continue;
        if (!has_time()) return false;
        context.throw_if_cancelled();
        textures.add(wish, context);
    }
    for (std::uint32_t m = 0; m < taken.list.scene.meshes.size(); ++m) {
        const Mesh& mesh = taken.list.scene.meshes[m];
        const auto known = taken.poses.find(m);
        const geometry::MeshPose* const pose = known != taken.poses.end() ? &known->second : nullptr;
        while (!meshes.is_there(mesh, pose)) {
            if (!has_time()) return false;
            context.throw_if_cancelled();
            meshes.upload_piece(mesh, pose);
        }
    }
    return true;
}

}  // namespace rakelight::opengl
