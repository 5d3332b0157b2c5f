// SPDX-License-Identifier: Apache-2.0
#include "bake/mapped_normals.h"

#include <cmath>

#include "bake/tangent_frame.h"
#include "image/decode.h"
#include "math/functions.h"
#include "scene/scene_tools.h"
#include "scene/wrapped_texel.h"

namespace rakelight::bake {
namespace {

dvec3 color(const MipChain& chain, const MipLevel& level, int x, int y) {
    const std::size_t i = std::size_t(y) * std::size_t(level.width) + std::size_t(x);
    if (chain.is_float) return cast<double>(level.rgba32f[i].xyz());
    const std::uint32_t c = level.rgba8[i];
    return dvec3{double(c & 255u), double(c >> 8 & 255u), double(c >> 16 & 255u)} / 255.0;
}

double in_range(double v) { return v > -1e5 && v < 1e5 ? v : 0; }

}  // namespace

MappedNormals::MappedNormals(const Scene& scene, Context& context) : materials_(scene.materials) {
    std::map<const EncodedImage*, std::shared_ptr<const MipChain>> chains;
    for (std::uint32_t i = 0; i < materials_.size(); ++i) {
        const Material& m = materials_[i];
        if (!m.normal_texture || bump_of(m, Bump::automatic) != Bump::normal) continue;
        const Texture& texture = scene.textures[m.normal_texture.texture];
        const auto [entry, is_new] = chains.try_emplace(texture.image.get());
        if (is_new) try {
                entry->second = std::make_shared<const MipChain>(
                    make_mip_chain(decode(*texture.image, context), ColorSpace::linear, context));
            } catch (const Error& error) {
                context.throw_if_cancelled();
                context.report().add(Remark::warning, texture.image->file, texture.image->name,
                                     "a normal map is left out: " + error.reason());
            }
        if (!entry->second || entry->second->levels.empty()) continue;
        const TextureTransform& t = m.normal_texture.transform;
        const float c = float(math::cos(double(t.rotation_rad))), s = float(math::sin(double(t.rotation_rad)));
        maps_.emplace(i, Map{.chain = entry->second,
                             .material = &m,
                             .wrap_u = texture.sampler.wrap_u,
                             .wrap_v = texture.sampler.wrap_v,
                             .row_u = {c * t.scale.x, s * t.scale.y},  // as KHR_texture_transform
                             .row_v = {-s * t.scale.x, c * t.scale.y}});
    }
}

dvec3 MappedNormals::Map::texel(dvec2 uv) const {
    const MipLevel& level = chain->levels[0];
    const vec2 offset = material->normal_texture.transform.offset;
    const double u = in_range(double(row_u.x) * uv.x + double(row_u.y) * uv.y + double(offset.x)),
                 v = in_range(double(row_v.x) * uv.x + double(row_v.y) * uv.y + double(offset.y));
    const double x = u * level.width - 0.5, y = v * level.height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const auto read = [&](int column, int row) {
        return color(*chain, level, wrapped_texel(column, level.width, wrap_u),
                     wrapped_texel(row, level.height, wrap_v));
    };
    const double tx = x - x0, ty = y - y0;
    const dvec3 upper = read(x0, y0) * (1 - tx) + read(x0 + 1, y0) * tx;
    const dvec3 lower = read(x0, y0 + 1) * (1 - tx) + read(x0 + 1, y0 + 1) * tx;
    return upper * (1 - ty) + lower * ty;
}

dvec3 MappedNormals::at(const dmat4& to_world, const Mesh& mesh, std::uint32_t triangle, const double (&weight)[3],
                        dvec3 normal) const {
    const auto found = maps_.find(mesh.material);
    if (found == maps_.end() || mesh.tangents.empty()) return normal;
    const Material& m = *found->second.material;
    const std::uint32_t set = m.normal_texture.texcoord_set;
    if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) return normal;
    dvec2 uv{};
    dvec3 tangent{};
    double handedness = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.indices[3 * std::size_t(triangle) + k];
        const vec2 at = mesh.texcoords[set][v];
        const vec4 t = mesh.tangents[v];
        uv = uv + dvec2{double(at.x), double(at.y)} * weight[k];
        tangent = tangent + normalize_or(upper_left(to_world) * cast<double>(t.xyz()), dvec3{}) * weight[k];
        handedness = double(t.w);
    }
    if (determinant(upper_left(to_world)) < 0) handedness = -handedness;
    const dvec3 code = found->second.texel(uv);
    dvec3 mapped = m.centered_normals ? (code * 255.0 - dvec3{128, 128, 128}) / 127.0 : code * 2.0 - dvec3{1, 1, 1};
    mapped = {mapped.x * double(m.normal_scale), mapped.y * double(m.normal_scale) * (m.green_down ? -1 : 1), mapped.z};
    const TangentFrame frame = unit_frame(normal, tangent, handedness);
    return normalize_or(frame.tangent * mapped.x + frame.bitangent * mapped.y + frame.normal * mapped.z, normal);
}

}  // namespace rakelight::bake
