// SPDX-License-Identifier: Apache-2.0
#include "convert_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "join.h"

namespace rakelight::import_helper {
namespace {

vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Topology by the number of corners; 3 for what cannot be drawn.
std::uint32_t topology_of(const aiFace& face) {
    return face.mNumIndices >= 1 && face.mNumIndices <= 3 ? 3 - face.mNumIndices : 3;
}

bool in_range(const aiMesh& mesh, const aiFace& face) {
    return face.mIndices && std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
                                        [&](unsigned i) { return i < mesh.mNumVertices; });
}

void convert_faces(const aiMesh& mesh, std::uint32_t topology, bool with_hint, const MeshSmoothing& groups,
                   Part& part) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (topology_of(face) != topology || !in_range(mesh, face)) continue;
        part.indices.insert(part.indices.end(), face.mIndices, face.mIndices + face.mNumIndices);
        if (topology == 0 && !groups.masks.empty()) part.smoothing.push_back(groups.masks[face.mIndices[0]]);
        for (unsigned k = 0; k < 3 && topology == 0 && !groups.fans.empty(); ++k)
            part.smoothing_hint.push_back(groups.fans[face.mIndices[k]]);
        if (!with_hint) continue;
        for (unsigned k = 0; k < 3; ++k) part.smoothing_hint.push_back(to_vec3(mesh.mNormals[face.mIndices[k]]));
    }
    if (mesh.mNumFaces == 0 && topology == 2)  // a point cloud
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) part.indices.push_back(v);
}

/// Assimp marks the two triangles of what was a quad by one first vertex; what had more corners cannot be told.
void convert_quads(const aiMesh& mesh, Part& part) {
    if (part.topology != 0 || (mesh.mPrimitiveTypes & aiPrimitiveType_NGONEncodingFlag) == 0) return;
    std::vector<std::uint32_t> polygons;
    const std::vector<std::uint32_t>& corners = part.indices;
    bool has_quads = false;
    for (std::uint32_t t = 0; t < corners.size() / 3; ++t) {
        const bool goes_on = t > 0 && polygons[t - 1] == t - 1 && corners[3 * t] == corners[3 * t - 3];
        polygons.push_back(goes_on ? t - 1 : t);
        has_quads = has_quads || goes_on;
    }
    if (has_quads) part.polygons = std::move(polygons);
}

void convert_tangents(const aiMesh& mesh, Part& part) {
    part.tangents.reserve(mesh.mNumVertices);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D &n = mesh.mNormals[v], &t = mesh.mTangents[v];
        const bool mirrored =
            ((n ^ t) * mesh.mBitangents[v]) < 0;  // Assimp's bitangent points to increasing v-up, as ours
        part.tangents.push_back({t.x, t.y, t.z, mirrored ? -1.0f : 1.0f});
    }
}

/// Strongest first, the sum is 1.
void sort_and_scale(Influence& f) {
    std::array<std::pair<float, std::uint16_t>, 8> all;
    for (std::size_t k = 0; k < 8; ++k) all[k] = {-f.weights[k], f.joints[k]};
    std::sort(all.begin(), all.end());
    float sum = 0;
    for (const auto& [weight, joint] : all) sum -= weight;
    for (std::size_t k = 0; k < 8; ++k) {
        f.joints[k] = all[k].second;
        f.weights[k] = sum > 0 ? -all[k].first / sum : 0;
    }
}

void convert_influences(const aiMesh& mesh, JointTable& joints, Part& part) {
    part.influences.resize(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const std::uint32_t joint = joints.number(bone);
        if (joint == nothing) continue;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            if (weight.mVertexId >= mesh.mNumVertices || !(weight.mWeight > 0) || !std::isfinite(weight.mWeight))
                continue;
            Influence& f = part.influences[weight.mVertexId];
            const auto least = std::min_element(f.weights.begin(), f.weights.end());  // the eight largest stay
            if (*least >= weight.mWeight) continue;
            f.joints[std::size_t(least - f.weights.begin())] = std::uint16_t(joint);
            *least = weight.mWeight;
        }
    }
    for (Influence& f : part.influences) sort_and_scale(f);
}

/// Assimp's morph targets hold places, ours offsets.
void convert_shapes(const aiMesh& mesh, bool with_normals, Part& part) {
    for (unsigned k = 0; k < mesh.mNumAnimMeshes; ++k) {
        const aiAnimMesh* target = mesh.mAnimMeshes[k];
        if (!target || !target->mVertices || target->mNumVertices != mesh.mNumVertices) continue;
        Shape& shape = part.shapes.emplace_back();
        shape.name = text(target->mName);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            shape.positions.push_back(to_vec3(target->mVertices[v] - mesh.mVertices[v]));
        if (!with_normals || !target->mNormals) continue;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            shape.normals.push_back(to_vec3(target->mNormals[v] - mesh.mNormals[v]));
    }
}

void convert_vertices(const aiMesh& mesh, const Format& format, JointTable& joints, Part& part) {
    const unsigned count = mesh.mNumVertices;
    part.positions.reserve(count);
    for (unsigned v = 0; v < count; ++v) part.positions.push_back(to_vec3(mesh.mVertices[v]));
    const bool normals = format.file_normals && mesh.HasNormals();
    for (unsigned v = 0; normals && v < count; ++v) part.normals.push_back(to_vec3(mesh.mNormals[v]));
    if (normals && mesh.HasTangentsAndBitangents()) convert_tangents(mesh, part);
    for (unsigned s = 0; s < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(s); ++s) {
        auto& set = part.texcoords.emplace_back();
        for (unsigned v = 0; v < count; ++v) set.push_back({mesh.mTextureCoords[s][v].x, mesh.mTextureCoords[s][v].y});
    }
    for (unsigned v = 0; mesh.HasVertexColors(0) && v < count; ++v) {
        const aiColor4D& c = mesh.mColors[0][v];
        part.colors.push_back({c.r, c.g, c.b, c.a});
    }
    if (mesh.HasBones()) convert_influences(mesh, joints, part);
    convert_shapes(mesh, normals, part);
}

}  // namespace

std::vector<PartSource> list_parts(const aiScene& scene) {
    std::vector<PartSource> parts;
    for (std::uint32_t m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        if (!mesh.HasPositions()) continue;
        bool has[4] = {false, false, mesh.mNumFaces == 0, false};
        for (unsigned f = 0; f < mesh.mNumFaces; ++f)
            if (in_range(mesh, mesh.mFaces[f])) has[topology_of(mesh.mFaces[f])] = true;
        for (std::uint32_t t = 0; t < 3; ++t)
            if (has[t]) parts.push_back({m, t});
    }
    return parts;
}

Part convert_part(const aiMesh& mesh, const PartSource& source, const Format& format, const FbxSmoothing& smoothing,
                  JointTable& joints) {
    Part part;
    part.name = text(mesh.mName);
    part.topology = source.topology;
    part.surface = mesh.mMaterialIndex;
    convert_vertices(mesh, format, joints, part);
    convert_faces(mesh, source.topology, format.hint_normals && mesh.HasNormals() && source.topology == 0,
                  smoothing.of(mesh), part);
    convert_quads(mesh, part);
    join_equal_vertices(part);
    return part;
}

void note_dropped(const aiScene& scene, Document& out) {
    std::uint64_t faces = 0, many = 0, bad_numbers = 0, color_sets = 0, unused = 0;
    for (std::uint32_t m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f)
            faces +=
                topology_of(mesh.mFaces[f]) == 3 ? mesh.mFaces[f].mNumIndices > 0 : !in_range(mesh, mesh.mFaces[f]);
        std::vector<unsigned> influences(mesh.HasBones() ? mesh.mNumVertices : 0, 0);
        for (unsigned b = 0; b < mesh.mNumBones; ++b)
            for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w)
                if (mesh.mBones[b]->mWeights[w].mVertexId < influences.size())
                    many += ++influences[mesh.mBones[b]->mWeights[w].mVertexId] == 9;
        for (unsigned v = 0; mesh.HasPositions() && v < mesh.mNumVertices; ++v)
            bad_numbers += !(std::isfinite(mesh.mVertices[v].x) && std::isfinite(mesh.mVertices[v].y) &&
                             std::isfinite(mesh.mVertices[v].z));
        color_sets += mesh.GetNumColorChannels() > 1;
        unused += !mesh.HasPositions();
    }
    const auto note = [&out](std::uint64_t count, std::uint32_t kind, const char* what) {
        if (count != 0) out.notes.push_back({kind, {}, std::to_string(count) + what});
    };
    note(faces, 1, " faces have vertex numbers out of range and are left out");
    note(many, 1, " vertices follow more than four joints; the four strongest are kept");
    note(bad_numbers, 2, " vertices are not finite numbers");
    note(color_sets, 1, " meshes have several sets of vertex colors; the first is kept");
    note(unused, 1, " meshes have no positions and are left out");
}

}  // namespace rakelight::import_helper
