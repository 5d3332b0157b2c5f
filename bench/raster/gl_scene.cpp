// SPDX-License-Identifier: Apache-2.0
#define GL_GLEXT_PROTOTYPES
#include "raster/gl_scene.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <string>

#include "image/maps/mip_chain.h"
#include "math/linear.h"
#include "raster/gl_shaders.h"
#include "scene/placement.h"

namespace rakelight::bench {
namespace {

struct Vertex {
    vec3 position, normal;
    vec4 tangent;
    vec2 texcoord;
};

unsigned compile(GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
    char log[1000] = "";
    if (!is_good) glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    if (!is_good) throw Error(ErrorCode::failed, std::string("a shader does not compile: ") + log);
    return shader;
}

/// The levels that the soft engine filters: both sides read the same texels, trilinear.
void upload_texture(unsigned unit, const Texture& texture, ColorSpace space, Context& context) {
    const MipChain chain = make_mip_chain(texture.image->decode(*texture.image, context), space, context);
    GLuint name = 0;
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name);
    GLint number = 0;
    for (const MipLevel& level : chain.levels)
        glTexImage2D(GL_TEXTURE_2D, number++, space == ColorSpace::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, level.width,
                     level.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, level.rgba8.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void set_attribute(GLuint index, int components, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
}

template <class Value>
GLuint buffer(GLenum target, const std::vector<Value>& values) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, GLsizeiptr(values.size() * sizeof(Value)), values.data(), GL_STATIC_DRAW);
    return name;
}

}  // namespace

GlScene::GlScene(const Scene& scene, Shading shading, Bump bump, double aspect, Context& context) {
    upload_vertices(scene);
    make_program(scene, shading, bump);
    glUseProgram(program_);
    const auto place = [&](const char* name) { return glGetUniformLocation(program_, name); };
    const Camera& camera = scene.cameras[0];
    mat4 projection = cast<float>(perspective(camera.vertical_fov_rad, aspect, camera.z_near, camera.z_far));
    for (std::size_t c = 0; c < 4; ++c) projection[c].y = -projection[c].y;  // on its head: fronts turn clockwise
    glFrontFace(GL_CW);
    glUniformMatrix4fv(place("projection"), 1, GL_FALSE, &projection[0].x);
    if (!scene.textures.empty()) {
        upload_texture(0, scene.textures[0], ColorSpace::srgb, context);
        upload_texture(1, scene.textures[1], ColorSpace::linear, context);
    }
    glUniform1i(place("color_map"), 0);
    glUniform1i(place("normal_map"), 1);
    const ClassicalParameters& surface = scene.materials[0].classical;
    glUniform3f(place("specular_color"), surface.specular.x, surface.specular.y, surface.specular.z);
    glUniform1f(place("shininess"), surface.shininess);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& l = scene.lights[i];
        const auto of = [&](const char* name) {
            return place((std::string(name) + "[" + std::to_string(i) + "]").c_str());
        };
        glUniform3f(of("light_position"), float(l.position.x), float(l.position.y), float(l.position.z));
        glUniform3f(of("light_color"), l.diffuse.x, l.diffuse.y, l.diffuse.z);
        glUniform3f(of("light_ambient"), l.ambient.x, l.ambient.y, l.ambient.z);
        glUniform3f(of("light_thinning"), l.constant, l.linear, l.quadratic);
    }
    model_ = place("model");
    rotation_ = place("rotation");
    base_color_ = place("base_color");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void GlScene::upload_vertices(const Scene& scene) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        const Mesh& mesh = scene.meshes[scene.nodes[n].meshes.at(0)];
        Object& o = objects_.emplace_back();
        o.indices = int(mesh.indices.size());
        o.base_vertex = int(vertices.size());
        o.first_index = indices.size() * sizeof(std::uint32_t);
        const double scale = 1 / length(world[n][0].xyz());
        for (std::size_t c = 0; c < 4; ++c) {
            const vec4 column = cast<float>(world[n][c]);
            const float values[] = {column.x, column.y, column.z, column.w};
            for (std::size_t r = 0; r < 4; ++r) o.model[4 * c + r] = values[r];
            for (std::size_t r = 0; r < 3 && c < 3; ++r) o.rotation[3 * c + r] = values[r] * float(scale);
        }
        const vec4 color = scene.materials[mesh.material].base_color;
        o.base_color[0] = color.x, o.base_color[1] = color.y, o.base_color[2] = color.z;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            vertices.push_back({mesh.positions[v], mesh.normals[v], mesh.tangents[v], mesh.texcoords[0][v]});
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    buffer(GL_ARRAY_BUFFER, vertices);
    buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    set_attribute(0, 3, offsetof(Vertex, position));
    set_attribute(1, 3, offsetof(Vertex, normal));
    set_attribute(2, 4, offsetof(Vertex, tangent));
    set_attribute(3, 2, offsetof(Vertex, texcoord));
}

void GlScene::make_program(const Scene& scene, Shading shading, Bump bump) {
    std::string head = "#version 330 core\n#define LIGHTS " + std::to_string(scene.lights.size()) + "\n";
    if (scene.textures.empty()) head += "#define PLAIN\n";
    if (shading == Shading::unlit) head += "#define UNLIT\n";
    if (shading == Shading::gouraud) head += "#define GOURAUD\n";
    if (shading == Shading::phong && bump == Bump::normal) head += "#define NORMAL_MAP\n";
    program_ = glCreateProgram();
    glAttachShader(program_, compile(GL_VERTEX_SHADER, head + lighting_text + vertex_text));
    glAttachShader(program_, compile(GL_FRAGMENT_SHADER, head + lighting_text + fragment_text));
    glLinkProgram(program_);
    GLint is_good = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &is_good);
    char log[1000] = "";
    if (!is_good) glGetProgramInfoLog(program_, sizeof log, nullptr, log);
    if (!is_good) throw Error(ErrorCode::failed, std::string("a program does not link: ") + log);
}

void GlScene::draw() const {
    glBindVertexArray(vertex_array_);
    glUseProgram(program_);
    for (const Object& o : objects_) {
        glUniformMatrix4fv(model_, 1, GL_FALSE, o.model);
        if (rotation_ >= 0) glUniformMatrix3fv(rotation_, 1, GL_FALSE, o.rotation);
        glUniform3fv(base_color_, 1, o.base_color);
        glDrawElementsBaseVertex(GL_TRIANGLES, o.indices, GL_UNSIGNED_INT, reinterpret_cast<const void*>(o.first_index),
                                 o.base_vertex);
    }
}

}  // namespace rakelight::bench
