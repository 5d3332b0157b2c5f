// SPDX-License-Identifier: Apache-2.0
#include "convert_nodes.h"

#include <cmath>
#include <set>

#include "math/linear.h"

namespace rakelight::import_helper {
namespace {

dmat4 to_dmat4(const aiMatrix4x4& m) {  // Assimp's are row by row
    return {{{m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}}};
}

dvec3 to_dvec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }
vec3 to_vec3(const aiColor3D& c) { return {c.r, c.g, c.b}; }

Place to_place(const aiNode& node, std::uint32_t parent) {
    Place place;
    place.name = text(node.mName);
    place.parent = parent;
    place.matrix = to_dmat4(node.mTransformation);
    aiVector3D scale, translation;
    aiQuaternion rotation;
    node.mTransformation.Decompose(scale, rotation, translation);
    place.translation = to_dvec3(translation);
    place.scale = to_dvec3(scale);
    place.rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
    return place;
}

/// Names of nodes that something else than the tree means: animations and bones.
std::set<std::string> names_in_use(const aiScene& scene) {
    std::set<std::string> names;
    for (unsigned a = 0; a < scene.mNumAnimations; ++a)
        for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c)
            names.insert(text(scene.mAnimations[a]->mChannels[c]->mNodeName));
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            names.insert(text(scene.mMeshes[m]->mBones[b]->mName));
    return names;
}

/// Assimp makes a chain of nodes from one FBX node with pivots. Where nothing moves them, the chain is one node again.
bool can_be_folded(const aiNode& node, const std::set<std::string>& used) {
    const std::string name = text(node.mName);
    return name.find("_$AssimpFbx$_") != std::string::npos && node.mNumMeshes == 0 && node.mNumChildren == 1 &&
           node.mChildren[0] && !used.contains(name) && !used.contains(text(node.mChildren[0]->mName));
}

}  // namespace

NodeTable::NodeTable(const aiScene& scene, const std::vector<std::vector<std::uint32_t>>& parts_of_mesh,
                     Document& out) {
    struct Waiting {
        const aiNode* node;
        std::uint32_t parent;
        dmat4 above;  // of the nodes that were folded into this one
    };
    const std::set<std::string> used = names_in_use(scene);
    std::vector<Waiting> waiting{{scene.mRootNode, nothing, {}}};
    while (!waiting.empty()) {  // a stack of our own: the file decides how deep the tree is
        const auto [node, parent, above] = waiting.back();
        waiting.pop_back();
        if (can_be_folded(*node, used)) {
            waiting.push_back({node->mChildren[0], parent, above * to_dmat4(node->mTransformation)});
            continue;
        }
        const auto number = std::uint32_t(out.places.size());
        Place place = to_place(*node, parent);
        place.matrix = above * place.matrix;
        for (unsigned i = 0; i < node->mNumMeshes; ++i)
            if (node->mMeshes[i] < parts_of_mesh.size())
                place.meshes.insert(place.meshes.end(), parts_of_mesh[node->mMeshes[i]].begin(),
                                    parts_of_mesh[node->mMeshes[i]].end());
        by_name_.emplace(place.name, number);
        out.places.push_back(std::move(place));
        for (unsigned i = node->mNumChildren; i-- > 0;)  // so that they come off in the file's order
            if (node->mChildren[i]) waiting.push_back({node->mChildren[i], number, {}});
    }
}

std::uint32_t NodeTable::find(const aiString& name) const {
    const auto found = by_name_.find(text(name));
    return found == by_name_.end() ? nothing : found->second;
}

std::uint32_t JointTable::number(const aiBone& bone) {
    const std::uint32_t node = nodes_.find(bone.mName);
    if (node == nothing) return nothing;
    const ai_real* m = bone.mOffsetMatrix[0];
    const auto found = numbers_.find({node, std::vector<float>(m, m + 16)});
    if (found != numbers_.end()) return found->second;
    const std::uint32_t number = std::uint32_t(out_.joints.size());
    if (number > 65535) return nothing;
    numbers_.emplace(std::pair(node, std::vector<float>(m, m + 16)), number);
    out_.joints.push_back({node, to_dmat4(bone.mOffsetMatrix)});
    return number;
}

void JointTable::collect(const aiScene& scene) {
    std::uint64_t lost = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            lost += number(*scene.mMeshes[m]->mBones[b]) == nothing;
    if (lost != 0) out_.notes.push_back({1, {}, std::to_string(lost) + " bones have no node and are left out"});
}

AxisSystem axes_of(const aiScene& scene) {
    AxisSystem axes;
    if (!scene.mMetaData) return axes;
    const auto number = [&](const char* key, std::int32_t& out) {
        int value = 0;
        if (scene.mMetaData->Get(std::string(key), value)) out = value;
    };
    number("UpAxis", axes.up);
    number("UpAxisSign", axes.up_sign);
    number("FrontAxis", axes.front);
    number("FrontAxisSign", axes.front_sign);
    number("CoordAxis", axes.side);
    number("CoordAxisSign", axes.side_sign);
    float as_float = 0;
    double as_double = 0;
    if (scene.mMetaData->Get(std::string("UnitScaleFactor"), as_double))
        axes.unit_m = as_double * 0.01;  // FBX counts in centimeters
    else if (scene.mMetaData->Get(std::string("UnitScaleFactor"), as_float))
        axes.unit_m = double(as_float) * 0.01;
    return axes;
}

void convert_lamps_and_views(const aiScene& scene, const NodeTable& nodes, Document& out) {
    for (unsigned i = 0; i < scene.mNumLights; ++i) {
        const aiLight& light = *scene.mLights[i];
        Lamp lamp;
        lamp.name = text(light.mName);
        lamp.node = nodes.find(light.mName);
        lamp.type = light.mType == aiLightSource_AMBIENT       ? 0
                    : light.mType == aiLightSource_DIRECTIONAL ? 1
                    : light.mType == aiLightSource_SPOT        ? 3
                                                               : 2;
        if (light.mType == aiLightSource_AREA || light.mType == aiLightSource_UNDEFINED)
            out.notes.push_back({0, "light '" + lamp.name + "'", "an area light became a point light"});
        lamp.position = to_dvec3(light.mPosition);
        lamp.direction = to_dvec3(light.mDirection);
        lamp.ambient = to_vec3(light.mColorAmbient);
        lamp.diffuse = to_vec3(light.mColorDiffuse);
        lamp.specular = to_vec3(light.mColorSpecular);
        lamp.constant = light.mAttenuationConstant;
        lamp.linear = light.mAttenuationLinear;
        lamp.quadratic = light.mAttenuationQuadratic;
        lamp.cone_rad = light.mAngleOuterCone;
        out.lamps.push_back(std::move(lamp));
    }
    for (unsigned i = 0; i < scene.mNumCameras; ++i) {
        const aiCamera& camera = *scene.mCameras[i];
        out.views.push_back({text(camera.mName), nodes.find(camera.mName), to_dvec3(camera.mPosition),
                             to_dvec3(camera.mLookAt), to_dvec3(camera.mUp), camera.mHorizontalFOV, camera.mAspect,
                             camera.mClipPlaneNear, camera.mClipPlaneFar, camera.mOrthographicWidth});
    }
}

namespace {

template <class Key>
Track track_of(std::uint32_t node, std::uint32_t path, const Key* keys, unsigned count, double per_second) {
    Track track{node, path, {}, {}};
    for (unsigned k = 0; k < count; ++k) {
        const auto time = float(keys[k].mTime / per_second);
        if (!std::isfinite(time) || (!track.times.empty() && time <= track.times.back()))
            continue;  // times must ascend
        track.times.push_back(time);
        if constexpr (std::is_same_v<Key, aiQuatKey>)
            track.values.insert(track.values.end(),
                                {keys[k].mValue.x, keys[k].mValue.y, keys[k].mValue.z, keys[k].mValue.w});
        else
            track.values.insert(track.values.end(), {keys[k].mValue.x, keys[k].mValue.y, keys[k].mValue.z});
    }
    return track;
}

}  // namespace

void convert_motions(const aiScene& scene, const NodeTable& nodes, Document& out) {
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        const aiAnimation& animation = *scene.mAnimations[a];
        const double per_second =
            animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;  // Assimp's own default
        Motion motion;
        motion.name = text(animation.mName);
        for (unsigned c = 0; c < animation.mNumChannels; ++c) {
            const aiNodeAnim& channel = *animation.mChannels[c];
            const std::uint32_t node = nodes.find(channel.mNodeName);
            if (node == nothing) continue;
            out.places[node].animated = 1;
            motion.tracks.push_back(track_of(node, 0, channel.mPositionKeys, channel.mNumPositionKeys, per_second));
            motion.tracks.push_back(track_of(node, 1, channel.mRotationKeys, channel.mNumRotationKeys, per_second));
            motion.tracks.push_back(track_of(node, 2, channel.mScalingKeys, channel.mNumScalingKeys, per_second));
        }
        std::erase_if(motion.tracks, [](const Track& t) { return t.times.empty(); });
        if (animation.mNumMeshChannels + animation.mNumMorphMeshChannels > 0)
            out.notes.push_back(
                {1, "animation '" + motion.name + "'", "animations of vertices and of morph weights are left out"});
        if (!motion.tracks.empty()) out.motions.push_back(std::move(motion));
    }
}

}  // namespace rakelight::import_helper
