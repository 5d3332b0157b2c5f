// SPDX-License-Identifier: Apache-2.0
#include "convert_surface.h"

#include <assimp/material.h>

#include <algorithm>

namespace rakelight::import_helper {
namespace {

struct RoleSource {
    Role role;
    aiTextureType type;
};

/// In order: the first kind that has a texture gives the role.
constexpr RoleSource role_sources[] = {
    {Role::diffuse, aiTextureType_DIFFUSE},         {Role::diffuse, aiTextureType_BASE_COLOR},
    {Role::specular, aiTextureType_SPECULAR},       {Role::normal, aiTextureType_NORMALS},
    {Role::normal, aiTextureType_NORMAL_CAMERA},    {Role::height, aiTextureType_HEIGHT},
    {Role::opacity, aiTextureType_OPACITY},         {Role::emission, aiTextureType_EMISSIVE},
    {Role::emission, aiTextureType_EMISSION_COLOR}, {Role::occlusion, aiTextureType_AMBIENT_OCCLUSION},
};

std::uint32_t wrap_of(const aiMaterial& m, const char* key, aiTextureType type) {
    int mode = aiTextureMapMode_Wrap;
    aiGetMaterialInteger(&m, key, type, 0, &mode);
    const WrapMode wrap = mode == aiTextureMapMode_Mirror ? WrapMode::mirror
                          : mode == aiTextureMapMode_Wrap ? WrapMode::repeat
                                                          : WrapMode::clamp;
    return std::uint32_t(wrap);
}

std::uint32_t picture_of(const aiScene& scene, const std::string& path) {
    const auto [texture, number] = scene.GetEmbeddedTextureAndIndex(path.c_str());
    return texture && number >= 0 && unsigned(number) < scene.mNumTextures ? std::uint32_t(number) : nothing;
}

TextureLink link_of(const aiScene& scene, const aiMaterial& m, const RoleSource& source, bool max_placement) {
    TextureLink link;
    aiString path;
    m.Get(AI_MATKEY_TEXTURE(source.type, 0), path);
    link.path = text(path);
    link.picture = picture_of(scene, link.path);
    link.role = std::uint32_t(source.role);
    int set = 0;
    if (m.Get(AI_MATKEY_UVWSRC(source.type, 0), set) == aiReturn_SUCCESS && set > 0) link.uv_set = std::uint32_t(set);
    link.wrap_u = wrap_of(m, _AI_MATKEY_MAPPINGMODE_U_BASE, source.type);
    link.wrap_v = wrap_of(m, _AI_MATKEY_MAPPINGMODE_V_BASE, source.type);
    link.placement = std::uint32_t(max_placement ? Placement::max : Placement::standard);
    aiUVTransform placing;
    if (m.Get(AI_MATKEY_UVTRANSFORM(source.type, 0), placing) == aiReturn_SUCCESS) {
        link.offset = {placing.mTranslation.x, placing.mTranslation.y};
        link.scale = {placing.mScaling.x, placing.mScaling.y};
        link.rotation_rad = placing.mRotation;
    }
    return link;
}

void convert_links(const aiScene& scene, const aiMaterial& m, const Format& format, Surface& surface, Document& out) {
    for (const RoleSource& source : role_sources) {
        const unsigned count = m.GetTextureCount(source.type);
        if (count == 0) continue;
        const auto same_role = [&](const TextureLink& l) { return l.role == std::uint32_t(source.role); };
        if (std::none_of(surface.links.begin(), surface.links.end(), same_role))
            surface.links.push_back(link_of(scene, m, source, format.max_placement));
        if (count > 1)
            out.notes.push_back(
                {1, "material '" + surface.name + "'", "several layers of textures: only the first is used"});
    }
}

/// The color, and the bit when the file gave it.
std::uint32_t color(const aiMaterial& m, const char* key, unsigned type, unsigned index, vec3& out, std::uint32_t bit) {
    aiColor4D c;  // takes three numbers as well as four
    if (m.Get(key, type, index, c) != aiReturn_SUCCESS) return 0;
    out = {c.r, c.g, c.b};
    return bit;
}

Surface to_surface(const aiMaterial& m) {
    Surface s;
    aiString name;
    m.Get(AI_MATKEY_NAME, name);
    s.name = text(name);
    s.has |= color(m, AI_MATKEY_BASE_COLOR, s.diffuse, Surface::has_diffuse);
    s.has |= color(m, AI_MATKEY_COLOR_DIFFUSE, s.diffuse, Surface::has_diffuse);
    s.has |= color(m, AI_MATKEY_COLOR_SPECULAR, s.specular, Surface::has_specular);
    s.has |= color(m, AI_MATKEY_COLOR_AMBIENT, s.ambient, Surface::has_ambient);
    s.has |= color(m, AI_MATKEY_COLOR_EMISSIVE, s.emission, Surface::has_emission);
    if (m.Get(AI_MATKEY_SHININESS, s.shininess) == aiReturn_SUCCESS) s.has |= Surface::has_shininess;
    float strength = 1;
    if (m.Get(AI_MATKEY_SHININESS_STRENGTH, strength) == aiReturn_SUCCESS)
        for (std::size_t k = 0; k < 3; ++k) s.specular[k] *= strength;
    m.Get(AI_MATKEY_OPACITY, s.opacity);
    m.Get(AI_MATKEY_BUMPSCALING, s.bump_scale);
    int two_sided = 0, shading = aiShadingMode_Phong;
    m.Get(AI_MATKEY_TWOSIDED, two_sided);
    m.Get(AI_MATKEY_SHADING_MODEL, shading);
    s.two_sided = two_sided != 0;
    s.unlit = shading == aiShadingMode_NoShading;
    const bool lambert = shading == aiShadingMode_Gouraud ||
                         shading == aiShadingMode_Flat;  // what Assimp calls materials without highlight
    if (lambert) s.specular = {0, 0, 0};
    return s;
}

Picture to_picture(const aiTexture& texture) {
    Picture p;
    p.name = text(texture.mFilename);
    p.hint.assign(texture.achFormatHint,
                  std::find(texture.achFormatHint, texture.achFormatHint + sizeof texture.achFormatHint, '\0'));
    if (!texture.pcData) return p;
    if (texture.mHeight == 0) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(texture.pcData);
        p.bytes.assign(bytes, bytes + texture.mWidth);
        return p;
    }
    p.width = texture.mWidth;
    p.height = texture.mHeight;
    const std::uint64_t count = std::uint64_t(p.width) * p.height;
    p.bytes.reserve(count * 4);
    for (std::uint64_t i = 0; i < count; ++i) {
        const aiTexel& t = texture.pcData[i];
        p.bytes.insert(p.bytes.end(), {t.r, t.g, t.b, t.a});
    }
    return p;
}

}  // namespace

void convert_surfaces(const aiScene& scene, const Format& format, Document& out) {
    for (unsigned i = 0; i < scene.mNumTextures; ++i) out.pictures.push_back(to_picture(*scene.mTextures[i]));
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
        Surface surface = to_surface(*scene.mMaterials[i]);
        convert_links(scene, *scene.mMaterials[i], format, surface, out);
        out.surfaces.push_back(std::move(surface));
    }
}

}  // namespace rakelight::import_helper
