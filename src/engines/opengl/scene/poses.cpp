// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/poses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "engines/opengl/programs/programs.h"

namespace rakelight::opengl {
namespace {

using geometry::JointColumns, geometry::MeshPose, geometry::MeshPoses;

constexpr std::size_t joint_texels = 4;  // its columns

std::size_t rows_of(std::size_t texels) { return (texels + fetch_width - 1) / fetch_width; }

PoseFeatures features_of(const MeshPose& pose) {
    PoseFeatures f;
    f.has_normals = !pose.normals.empty(), f.has_tangents = !pose.tangents.empty();
    f.is_skinned = !pose.joints.empty(), f.has_more = f.is_skinned && !pose.more_influences.empty();
    return f;
}

/// Blocks of offsets that a mesh of these arrays can use, in the order of its targets.
template <class Visit>
void for_each_offsets(const MeshPose& pose, const Visit& visit) {
    for (std::size_t t = 0; t < pose.targets.size(); ++t) {
        const MorphTarget& target = pose.targets[t];
        visit(t, 0, target.positions);
        visit(t, 1, pose.normals.empty() ? Block<vec3>() : target.normals);
        visit(t, 2, pose.tangents.empty() ? Block<vec3>() : target.tangents);
    }
}

std::size_t offset_texels(const MeshPose& pose) {
    std::size_t texels = 0;
    for_each_offsets(pose, [&](std::size_t, int, const Block<vec3>& block) { texels += block.size(); });
    return texels;
}

/// A texel of each target that counts: its weight, and which block of offsets it has for positions, normals, tangents.
std::vector<vec4> target_texels(const MeshPose& pose) {
    std::vector<std::array<float, 3>> blocks(pose.targets.size(), {-1, -1, -1});
    float next = 0;
    for_each_offsets(pose, [&](std::size_t t, int which, const Block<vec3>& block) {
        if (!block.empty()) blocks[t][std::size_t(which)] = next++;
    });
    std::vector<vec4> texels;
    for (std::size_t t = 0; t < blocks.size(); ++t)
        if (pose.weight(t) != 0) texels.push_back({pose.weight(t), blocks[t][0], blocks[t][1], blocks[t][2]});
    return texels;
}

void set_influences(GLuint place, GLuint buffer) {
    if (buffer == 0) {
        for (const GLuint at : {place, place + 1}) glDisableVertexAttribArray(at);
        return;
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (const GLuint at : {place, place + 1}) glEnableVertexAttribArray(at);
    const auto in = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribIPointer(place, 4, GL_UNSIGNED_SHORT, sizeof(JointInfluence), in(offsetof(JointInfluence, joints)));
    glVertexAttribPointer(place + 1, 4, GL_FLOAT, GL_FALSE, sizeof(JointInfluence),
                          in(offsetof(JointInfluence, weights)));
}

void make_room(GlBuffer& buffer, std::size_t bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_COPY);
}

}  // namespace

bool PoseStore::fits(const MeshPose& pose) const {
    const std::size_t most = std::size_t(driver_.texture_size);
    return rows_of(offset_texels(pose)) <= most &&
           rows_of(pose.targets.size() + joint_texels * pose.joints.size()) <= most;
}

PoseStore::Identities PoseStore::arrays_of(const MeshPose& pose) {
    return {pose.positions.identity(),
            pose.normals.identity(),
            pose.tangents.identity(),
            pose.targets.identity(),
            pose.joints.empty() ? nullptr : pose.influences.identity(),
            pose.joints.empty() ? nullptr : pose.more_influences.identity()};
}

void PoseStore::keep_only(const MeshPoses& poses) {
    std::erase_if(posed_, [&](const auto& entry) {
        const auto pose = poses.find(entry.first);
        return pose == poses.end() || arrays_of(pose->second) != arrays_of(entry.second.of);
    });
    std::erase_if(offsets_, [](const auto& entry) { return entry.second.expired(); });
    for (auto& [number, posed] : posed_) {
        posed.stands = false;
        posed.buffers.draw.reset();  // other arrays of the mesh may have changed
    }
    if (posed_.empty()) numbers_.reset(), numbers_bytes_ = 0;
}

PosedBuffers* PoseStore::of(std::uint32_t mesh) {
    const auto known = posed_.find(mesh);
    return known != posed_.end() && known->second.stands ? &known->second.buffers : nullptr;
}

std::uint64_t PoseStore::bytes() const {
    std::uint64_t bytes = numbers_bytes_;
    for (const auto& [number, posed] : posed_)
        bytes += posed.of.positions.size() * sizeof(vec3) + posed.of.normals.size() * sizeof(vec3) +
                 posed.of.tangents.size() * sizeof(vec4);
    for (const auto& [key, offsets] : offsets_)
        if (const std::shared_ptr<const Offsets> shared = offsets.lock()) bytes += shared->bytes;
    return bytes;
}

/// Blocks one after another, as for_each_offsets() goes.
std::shared_ptr<const PoseStore::Offsets> PoseStore::offsets_of(const MeshPose& pose) {
    std::weak_ptr<const Offsets>& known = offsets_[{pose.targets.identity(), features_of(pose)}];
    if (std::shared_ptr<const Offsets> shared = known.lock()) return shared;
    const auto offsets = std::make_shared<Offsets>();
    known = offsets;
    const std::size_t rows = rows_of(offset_texels(pose));
    if (rows == 0) return offsets;
    std::vector<vec3> texels;
    texels.reserve(rows * fetch_width);
    for_each_offsets(pose, [&](std::size_t, int, const Block<vec3>& block) {
        texels.insert(texels.end(), block.begin(), block.end());
    });
    texels.resize(rows * fetch_width);
    glActiveTexture(GLenum(GL_TEXTURE0 + driver_.texture_units));
    set_texels(offsets->texture, GL_RGB32F, GL_RGB, GL_FLOAT, fetch_width, int(rows), texels.data());
    offsets->bytes = texels.size() * sizeof(vec3);
    return offsets;
}

PoseStore::Posed& PoseStore::posed_of(std::uint32_t number, const MeshPose& pose, const Mesh& mesh, MeshStore& meshes) {
    const auto [known, is_new] = posed_.try_emplace(number);
    Posed& posed = known->second;
    if (!is_new) return posed;
    try {
        posed.of = pose;
        make_room(posed.buffers.positions, pose.positions.size() * sizeof(vec3));
        if (!pose.normals.empty()) make_room(posed.buffers.normals, pose.normals.size() * sizeof(vec3));
        if (!pose.tangents.empty()) make_room(posed.buffers.tangents, pose.tangents.size() * sizeof(vec4));
        posed.offsets = offsets_of(pose);
        while (!meshes.is_there(mesh, &pose)) meshes.upload_piece(mesh, &pose);
        bind_attributes(posed, mesh, meshes);
        check_gl("a mesh that moves");
    } catch (...) {
        posed_.erase(known);
        throw;
    }
    return posed;
}

void PoseStore::bind_attributes(Posed& posed, const Mesh& mesh, MeshStore& meshes) {
    glBindVertexArray(posed.bind.get());
    meshes.set_vertices(mesh);
    const MeshPose& pose = posed.of;
    set_influences(3, pose.joints.empty() ? 0 : meshes.buffer_of(pose.influences));
    set_influences(5, pose.joints.empty() ? 0 : meshes.buffer_of(pose.more_influences));
}

/// Targets and joints of the moment, one table for all meshes; what several have in common stands in it once.
std::map<std::uint32_t, PoseStore::Place> PoseStore::upload_numbers(const MeshPoses& poses,
                                                                    const std::vector<std::uint32_t>& numbers) {
    std::map<std::uint32_t, Place> places;
    std::map<const void*, GLint> joints;
    std::map<std::tuple<const void*, const void*, PoseFeatures>, Place> weightings;
    std::vector<vec4> texels;
    for (const std::uint32_t number : numbers) {
        const MeshPose& pose = poses.at(number);
        Place& place = places[number];
        const auto [same, is_new_weighting] =
            weightings.try_emplace({pose.targets.identity(), pose.weights.identity(), features_of(pose)});
        if (is_new_weighting) {
            const std::vector<vec4> targets = target_texels(pose);
            same->second = {GLint(texels.size()), GLint(targets.size()), 0};
            texels.insert(texels.end(), targets.begin(), targets.end());
        }
        place = same->second;
        if (pose.joints.empty()) continue;
        const auto [known, is_new] = joints.try_emplace(pose.joints.identity(), GLint(texels.size()));
        place.first_joint = known->second;
        if (!is_new) continue;
        for (const JointColumns& joint : pose.joints)
            for (const auto& c : joint.columns) texels.push_back({c[0], c[1], c[2], c[3]});
    }
    const std::size_t rows = std::max<std::size_t>(rows_of(texels.size()), 1);
    if (rows > std::size_t(driver_.texture_size))
        throw Error(ErrorCode::failed, "the scene has more joints than this OpenGL driver can look up", {},
                    "render with engine soft");
    texels.resize(rows * fetch_width);
    glActiveTexture(GLenum(GL_TEXTURE0 + driver_.texture_units));
    set_texels(numbers_, GL_RGBA32F, GL_RGBA, GL_FLOAT, fetch_width, int(rows), texels.data());
    numbers_bytes_ = texels.size() * sizeof(vec4);
    return places;
}

const PoseStore::Program& PoseStore::program_of(const PoseFeatures& features) {
    Program& program = programs_[features];
    if (program.name) return program;
    std::vector<const char*> caught = {"v_position"};
    if (features.has_normals) caught.push_back("v_normal");
    if (features.has_tangents) caught.push_back("v_tangent");
    program.name = link_program(pose_text(features, driver_), caught);
    const GLuint name = program.name.name();
    program.pose = glGetUniformLocation(name, "rl_pose");
    glUseProgram(name);
    glUniform1i(glGetUniformLocation(name, "rl_numbers"), driver_.texture_units);
    glUniform1i(glGetUniformLocation(name, "rl_offsets"), driver_.texture_units + 1);
    return program;
}

/// Without a window no framebuffer is whole, and none is drawn with then, not even with nothing.
void PoseStore::bind_frame() {
    const bool is_new = !frame_;
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.get());
    if (!is_new) return;
    glBindRenderbuffer(GL_RENDERBUFFER, pixel_.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixel_.name());
}

void PoseStore::run(const Posed& posed, const Place& place) {
    const MeshPose& pose = posed.of;
    const Program& program = program_of(features_of(pose));
    glUseProgram(program.name.name());
    glUniform4i(program.pose, place.first_target, place.targets, place.first_joint, GLint(pose.positions.size()));
    glActiveTexture(GLenum(GL_TEXTURE0 + driver_.texture_units));
    glBindTexture(GL_TEXTURE_2D, numbers_.name());
    glActiveTexture(GLenum(GL_TEXTURE0 + driver_.texture_units + 1));
    glBindTexture(GL_TEXTURE_2D, posed.offsets->texture ? posed.offsets->texture.name() : no_offsets_.name());
    glBindVertexArray(posed.bind.name());
    GLuint next = 0;
    for (const GlBuffer* const to : {&posed.buffers.positions, &posed.buffers.normals, &posed.buffers.tangents})
        if (*to) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, next++, to->name());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, GLsizei(pose.positions.size()));
    glEndTransformFeedback();
    while (next > 0) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, --next, 0);
}

void PoseStore::pose(const Scene& scene, const MeshPoses& poses, MeshStore& meshes) {
    std::vector<std::uint32_t> numbers;
    for (const auto& [number, pose] : poses)
        if (!of(number) && fits(pose)) numbers.push_back(number);
    if (numbers.empty()) return;
    for (const std::uint32_t number : numbers) posed_of(number, poses.at(number), scene.meshes[number], meshes);
    const std::map<std::uint32_t, Place> places = upload_numbers(poses, numbers);
    if (!no_offsets_) {
        const vec3 none{0, 0, 0};
        set_texels(no_offsets_, GL_RGB32F, GL_RGB, GL_FLOAT, 1, 1, &none);
    }
    bind_frame();
    glEnable(GL_RASTERIZER_DISCARD);
    for (const std::uint32_t number : numbers) run(posed_.at(number), places.at(number));
    glDisable(GL_RASTERIZER_DISCARD);
    check_gl("a mesh that moves");
    for (const std::uint32_t number : numbers) posed_.at(number).stands = true;
}

}  // namespace rakelight::opengl
