// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/meshes.h"

#include <algorithm>
#include <set>
#include <string>

#include <rakelight/base/error.h>

#include "engines/opengl/programs/program_text.h"

namespace rakelight::opengl {
namespace {

const Block<vec2>& texcoords_of(const Mesh& mesh, std::size_t set) {
    static const Block<vec2> none;
    return set < mesh.texcoords.size() ? mesh.texcoords[set] : none;
}

/// Attributes by the places of vertices.glsl; one that the mesh lacks has what the lighting text takes as none.
void set_attribute(GLuint place, GLint components, GLuint buffer, vec4 otherwise) {
    if (buffer == 0) {
        glDisableVertexAttribArray(place);
        glVertexAttrib4f(place, otherwise.x, otherwise.y, otherwise.z, otherwise.w);
        return;
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

template <class Texel>
void upload_table(GlTexture& texture, GLint format, GLenum layout, GLenum type, std::vector<Texel> texels,
                  const Driver& driver) {
    const std::size_t rows = (texels.size() + fetch_width - 1) / fetch_width;
    if (rows > std::size_t(driver.texture_size))
        throw Error(ErrorCode::failed,
                    "a mesh has more vertices than this OpenGL driver can look up for flat shading and channels");
    texels.resize(std::max<std::size_t>(rows, 1) * fetch_width);
    glActiveTexture(GLenum(GL_TEXTURE0 + driver.texture_units));  // one that no pixels read: pictures are being drawn
    set_texels(texture, format, layout, type, fetch_width, int(std::max<std::size_t>(rows, 1)), texels.data());
}

/// In the order of fetch_vertex().
std::vector<vec4> vertex_texels(const Mesh& mesh) {
    const Block<vec2>&set0 = texcoords_of(mesh, 0), &set1 = texcoords_of(mesh, 1);
    std::vector<vec4> out;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const vec3 p = mesh.positions[v];
        out.push_back({p.x, p.y, p.z, 1});
        if (!mesh.normals.empty()) out.push_back({mesh.normals[v].x, mesh.normals[v].y, mesh.normals[v].z, 0});
        if (!mesh.tangents.empty()) out.push_back(mesh.tangents[v]);
        if (!mesh.bitangents.empty())
            out.push_back({mesh.bitangents[v].x, mesh.bitangents[v].y, mesh.bitangents[v].z, 0});
        const vec2 a = set0.empty() ? vec2{0, 0} : set0[v], b = set1.empty() ? vec2{0, 0} : set1[v];
        if (!set0.empty() || !set1.empty()) out.push_back({a.x, a.y, b.x, b.y});
        if (!mesh.colors.empty()) out.push_back(mesh.colors[v]);
    }
    return out;
}

}  // namespace

MeshStore::Key MeshStore::key_of(const Mesh& mesh) {
    return {mesh.positions.identity(), mesh.indices.identity(),          mesh.normals.identity(),
            mesh.tangents.identity(),  texcoords_of(mesh, 0).identity(), texcoords_of(mesh, 1).identity(),
            mesh.colors.identity(),    mesh.bitangents.identity()};
}

void MeshStore::keep_only(const Scene& scene, const geometry::MeshPoses& poses) {
    std::set<Key> keys;
    std::set<const void*> blocks;
    for (const Mesh& mesh : scene.meshes) {
        const Key key = key_of(mesh);
        blocks.insert(key.begin(), key.end());
        keys.insert(key);
    }
    for (const auto& [number, pose] : poses)
        blocks.insert({pose.influences.identity(), pose.more_influences.identity()});
    std::erase_if(arrays_, [&](const auto& entry) { return !keys.contains(entry.first); });
    std::erase_if(tables_, [&](const auto& entry) { return !keys.contains(entry.first); });
    std::erase_if(buffers_, [&](const auto& entry) { return !blocks.contains(entry.first); });
}

std::uint64_t MeshStore::bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [identity, buffer] : buffers_) bytes += buffer.there;
    return bytes;
}

std::vector<MeshStore::Part> MeshStore::parts_of(const Mesh& mesh, const geometry::MeshPose* pose) {
    std::vector<Part> parts;
    const auto add = [&parts](const auto& block, GLenum target = GL_ARRAY_BUFFER) {
        if (block.empty()) return;
        const auto owner = [&block] { return std::make_shared<std::decay_t<decltype(block)>>(block); };
        parts.push_back({block.identity(), block.data(), block.size() * sizeof(block[0]), target, owner});
    };
    add(mesh.positions), add(mesh.indices, GL_ELEMENT_ARRAY_BUFFER);
    add(mesh.normals), add(mesh.tangents), add(mesh.colors);
    add(mesh.bitangents);
    add(texcoords_of(mesh, 0)), add(texcoords_of(mesh, 1));
    if (pose) add(pose->influences), add(pose->more_influences);
    return parts;
}

bool MeshStore::is_there(const Mesh& mesh, const geometry::MeshPose* pose) const {
    for (const Part& part : parts_of(mesh, pose)) {
        const auto at = buffers_.find(part.identity);
        if (at == buffers_.end() || at->second.there < part.bytes) return false;
    }
    return true;
}

void MeshStore::upload_piece(const Part& part) {
    Buffer& buffer = buffers_[part.identity];
    const bool is_new = !buffer.name;
    if (is_new) buffer.of = part.owner();
    glBindVertexArray(no_arrays_.get());  // what indices are bound to is a vertex array's own
    glBindBuffer(part.target, buffer.name.get());
    if (is_new) glBufferData(part.target, GLsizeiptr(part.bytes), nullptr, GL_STATIC_DRAW);
    const std::size_t bytes = std::min(piece_bytes, part.bytes - buffer.there);
    glBufferSubData(part.target, GLintptr(buffer.there), GLsizeiptr(bytes),
                    static_cast<const char*>(part.data) + buffer.there);
    buffer.there += bytes;
    if (bytes < checked_bytes) return;  // browsers answer late; what small arrays lack is told after the picture
    try {
        check_gl("a mesh");
    } catch (...) {
        buffers_.erase(part.identity);
        throw;
    }
}

void MeshStore::upload_piece(const Mesh& mesh, const geometry::MeshPose* pose) {
    for (const Part& part : parts_of(mesh, pose))
        if (const auto at = buffers_.find(part.identity); at == buffers_.end() || at->second.there < part.bytes)
            return upload_piece(part);
}

void MeshStore::set_vertices(const Mesh& mesh, const PosedBuffers* posed) {
    set_attribute(0, 3, posed ? posed->positions.name() : buffer_of(mesh.positions), {0, 0, 0, 1});
    set_attribute(1, 3, posed ? posed->normals.name() : buffer_of(mesh.normals), {0, 0, 1, 0});
    set_attribute(2, 4, posed ? posed->tangents.name() : buffer_of(mesh.tangents), {0, 0, 0, 1});
}

GLuint MeshStore::vertex_array(const Mesh& mesh, PosedBuffers* posed) {
    GlVertexArray& array = posed ? posed->draw : arrays_[key_of(mesh)];
    const bool is_new = !array;
    while (is_new && !is_there(mesh)) upload_piece(mesh);
    glBindVertexArray(array.get());
    if (is_new) {
        set_vertices(mesh, posed);
        set_attribute(3, 2, buffer_of(texcoords_of(mesh, 0)), {0, 0, 0, 1});
        set_attribute(4, 2, buffer_of(texcoords_of(mesh, 1)), {0, 0, 0, 1});
        set_attribute(5, 4, buffer_of(mesh.colors), {1, 1, 1, 1});
        set_attribute(6, 3, buffer_of(mesh.bitangents), {0, 0, 0, 1});
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_of(mesh.indices));
    }
    // Values of attributes that are off belong to the context, not to the array.
    glVertexAttrib4f(2, 0, 0, 0, 1);
    glVertexAttrib4f(5, 1, 1, 1, 1);
    return array.name();
}

const TriangleTable& MeshStore::table(const Mesh& mesh, const std::int32_t* against) {
    TriangleTable& kept = tables_[key_of(mesh)];
    if (kept.indices && (kept.against >= 0 || !against)) return kept;
    TriangleTable table;
    std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
    if (against) {
        table.against = std::int32_t(indices.size());
        const std::size_t triangles = mesh.triangle_count();
        indices.resize(indices.size() + (triangles + 31) / 32);
        for (std::size_t t = 0; t < triangles; ++t)
            if (against[t] != 0) indices[std::size_t(table.against) + t / 32] |= 1u << (t % 32);
    }
    upload_table(table.indices, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, std::move(indices), driver_);
    upload_table(table.vertices, GL_RGBA32F, GL_RGBA, GL_FLOAT, vertex_texels(mesh), driver_);
    check_gl("a mesh");
    kept = std::move(table);
    return kept;
}

}  // namespace rakelight::opengl
