// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "shading/draw_frame.h"
#include "shading/guard_band.h"

namespace rakelight::opengl {
namespace {

std::uint64_t next_number() {
    static std::atomic<std::uint64_t> count{0};
    return ++count;
}

void put_row(const dmat4& m, std::size_t row, float* to) {
    for (std::size_t c = 0; c < 4; ++c) to[c] = float(m[c][row]);
}

/// [px] about the pixel's center, as the frame that is bound has them.
void set_samples(GLint place, int samples) {
    float at[2 * 8]{};
    for (int i = 0; i < samples; ++i) {
        glGetMultisamplefv(GL_SAMPLE_POSITION, GLuint(i), at + 2 * i);
        at[2 * i] -= 0.5f, at[2 * i + 1] -= 0.5f;
    }
    glUniform2fv(place, 8, at);
}

/// Where triangles are cut, and clip space of the pixels -> that of the whole picture.
void set_cut(GLint place, const shading::PictureCamera& view, Window pixels) {
    const shading::GuardBand guard(view);
    const float wide = float(pixels.width) / float(view.width), high = float(pixels.height) / float(view.height);
    const float x = (float(view.width) - 2.0f * float(pixels.x)) / float(pixels.width) - 1.0f,
                y = (float(view.height) - 2.0f * float(pixels.y)) / float(pixels.height) - 1.0f;
    const float far = float(std::min(view.z_far, 3e38));
    const float cut[8] = {float(view.z_near), far, guard.x, guard.y, wide, -x * wide, -high, y * high};
    glUniform4fv(place, 2, cut);
}

void put_vec3(dvec3 v, float w, float* to) { to[0] = float(v.x), to[1] = float(v.y), to[2] = float(v.z), to[3] = w; }

}  // namespace

DepthRange::Row DepthRange::nearness(const shading::PictureCamera& view) {
    const double near = view.z_near, far = view.z_far, length = far - near;
    if (view.orthographic) return {-1 / length, far / length, 0};
    if (!std::isfinite(far)) return {0, near, 0};
    return {-near / length, near * far / length, 0};
}

DepthRange::Row DepthRange::row(const shading::PictureCamera& view) const {
    const Row r = nearness(view);
    return is_reversed ? r : Row{-2 * r.scale, -2 * r.offset, 1};
}

dmat4 clip_matrix(const shading::PictureCamera& view, Window pixels, const DepthRange::Row& depth, double y_sign) {
    const double wide = double(view.width) / pixels.width, high = double(view.height) / pixels.height;
    const double x = (view.width - 2.0 * pixels.x) / pixels.width - 1,
                 y = -y_sign * ((view.height - 2.0 * pixels.y) / pixels.height - 1);
    // distance = -z of the camera; w = distance in perspective, else 1
    const double w_z = view.orthographic ? 0 : -1, w_1 = view.orthographic ? 1 : 0;
    dmat4 m;
    m[0] = {view.scale_x * wide, 0, 0, 0};
    m[1] = {0, y_sign * view.scale_y * high, 0, 0};
    m[2] = {x * w_z, y * w_z, -depth.scale + depth.per_w * w_z, w_z};
    m[3] = {x * w_1, y * w_1, depth.offset + depth.per_w * w_1, w_1};
    return m;
}

PictureDrawer::PictureDrawer(const PictureTools& tools, const PictureState& state, Window pixels)
    : tools_(tools),
      state_(state),
      pixels_(pixels),
      depth_(tools.driver),
      camera_to_clip_(clip_matrix(state.view, pixels, depth_.row(state.view), -1)),
      number_(next_number()) {}

void PictureDrawer::begin() const {
    if (depth_.is_reversed) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth_.nearer());
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glActiveTexture(GL_TEXTURE0 + unit_tables);
    glBindTexture(GL_TEXTURE_2D, tools_.albedos);
    glActiveTexture(GL_TEXTURE0 + unit_shadows);
    glBindTexture(GL_TEXTURE_2D, tools_.shadows.texture());
    glActiveTexture(GL_TEXTURE0 + unit_environment);
    glBindTexture(GL_TEXTURE_2D, tools_.environment.mirrored());
    for (GLuint unit = 0; unit < engine_units; ++unit) glBindSampler(unit, 0);
    state_.lights.bind();
}

bool PictureDrawer::is_outside(std::uint32_t number) const {
    if (!state_.settings.vertex_text.empty()) return false;  // its vertices may be anywhere
    const shading::Draw& draw = state_.list.draws[number];
    const dmat4 to_clip = camera_to_clip_ * (state_.view.world_to_camera * draw.to_world);
    const Bounds box{cast<double>(draw.low), cast<double>(draw.high)};
    unsigned common = ~0u;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = box.corner(corner);
        const dvec4 c = to_clip * dvec4{p.x, p.y, p.z, 1};
        common &=
            unsigned(c.x < -c.w) | unsigned(c.x > c.w) << 1 | unsigned(c.y < -c.w) << 2 | unsigned(c.y > c.w) << 3;
    }
    return common != 0;
}

void PictureDrawer::set_picture(const Program& p) const {
    if (p.picture == number_) return;
    p.picture = number_;
    const shading::PictureCamera& view = state_.view;
    const dvec3 back = view.camera_to_world[2].xyz();
    glUniform3f(p.view_direction, float(back.x), float(back.y), float(back.z));
    if (p.cut >= 0) set_cut(p.cut, view, pixels_);
    if (p.lights >= 0) glUniform4fv(p.lights, GLsizei(state_.lights.count()) * light_texels, state_.lights.numbers());
    if (p.light_count >= 0) glUniform4iv(p.light_count, 1, state_.lights.counts());
    if (p.map_texels >= 0) glUniform1f(p.map_texels, map_texels_);
    if (p.shadow_size >= 0) glUniform1i(p.shadow_size, tools_.shadows.size());
    if (p.samples >= 0) set_samples(p.samples, state_.settings.samples);
    if (p.ray >= 0) {
        const shading::PixelRays rays = shading::pixel_rays(view, pixels_.x, pixels_.y);
        float ray[12];
        const bool is_sky_parallel = view.orthographic;
        put_vec3(rays.along_x, is_sky_parallel ? 0.0f : float(2.0 / (view.height * view.scale_y)), ray);
        put_vec3(rays.along_y, tools_.environment ? float(tools_.environment.sky_height()) : 1.0f, ray + 4);
        put_vec3(rays.first, 0, ray + 8);
        glUniform4fv(p.ray, 3, ray);
    }
    if (p.behind_view >= 0 && state_.behind) {
        float rows[16]{};
        std::copy_n(state_.behind->to_u, 4, rows);
        std::copy_n(state_.behind->to_v, 4, rows + 4);
        std::copy_n(state_.behind->to_w, 4, rows + 8);
        rows[12] = state_.behind->last_level;
        glUniform4fv(p.behind_view, 4, rows);
    }
    tools_.programs.set_uniforms(p);
    if (p.term_light >= 0) glUniform1i(p.term_light, term_light_);
    if (p.fog >= 0) {
        const shading::FogFactors fog = shading::fog_factors(state_.list.scene.fog);
        const float numbers[8] = {fog.color[0], fog.color[1], fog.color[2], 0, fog.start, fog.end, fog.density, 0};
        glUniform4fv(p.fog, 2, numbers);
    }
    if (p.environment >= 0 && tools_.environment) {
        const shading::EnvironmentFactors& e = tools_.environment.factors();
        const float last = float(tools_.environment.levels().places.size() - 1);
        float numbers[48]{};
        for (std::size_t i = 0; i < 9; ++i) std::copy_n(e.irradiance[i], 3, numbers + 4 * i);
        for (std::size_t i = 0; i < 3; ++i) std::copy_n(e.turn[i], 3, numbers + 4 * (9 + i));
        numbers[3] = e.intensity, numbers[7] = last;
        glUniform4fv(p.environment, 12, numbers);
        const std::vector<vec3>& places = tools_.environment.levels().places;
        if (p.environment_levels >= 0) glUniform3fv(p.environment_levels, GLsizei(places.size()), &places[0].x);
    }
}

void PictureDrawer::set_object(const Program& program, const shading::Draw& draw) const {
    const dmat4 to_eye = state_.view.world_to_eye * draw.to_world;
    const dmat4 to_clip = camera_to_clip_ * (state_.view.world_to_camera * draw.to_world);
    const shading::DrawFrame frame(state_.list, draw, to_eye, state_.view, state_.settings.front_face);
    float rows[44]{};
    for (std::size_t r = 0; r < 4; ++r) put_row(to_clip, r, rows + 4 * r);
    for (std::size_t r = 0; r < 3; ++r) put_row(to_eye, r, rows + 16 + 4 * r);
    const dmat3& n = frame.to_normal();
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
        largest = std::max({largest, std::fabs(n[c].x), std::fabs(n[c].y), std::fabs(n[c].z)});
    const double scale = largest > 0 ? 1 / largest : 1;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) rows[28 + 4 * r + c] = float(n[c][r] * scale);
    rows[40] = float(frame.mirror());
    glUniform4fv(program.object, 11, rows);
}

void PictureDrawer::bind_table(const Program& program, const Mesh& mesh, const std::int32_t* against) const {
    const TriangleTable& table = tools_.meshes.table(mesh, against);
    glBindVertexArray(tools_.meshes.no_arrays());
    for (GLint k = 0; k < vertex_units; ++k) {
        glActiveTexture(GLenum(GL_TEXTURE0 + tools_.driver.texture_units + k));
        glBindTexture(GL_TEXTURE_2D, k == 0 ? table.indices.name() : table.vertices.name());
    }
    if (program.against >= 0) glUniform1i(program.against, against ? table.against : -1);
}

const Program& PictureDrawer::use(std::uint32_t number, const DrawState& state) const {
    const Program& program = tools_.programs.of(state.features);
    glUseProgram(program.name.name());
    set_picture(program);
    set_object(program, state_.list.draws[number]);
    if (program.numbers >= 0) {
        const shading::Draw& draw = state_.list.draws[number];
        glUniform4ui(program.numbers, draw.node, state_.list.material(draw).scene_material, draw.mesh, 0);
    }
    if (program.material >= 0) {
        const PackedMaterial numbers = pack(state.numbers);
        glUniform4fv(program.material, material_vectors, numbers.data());
    }
    if (program.behind_unit >= 0) {
        glActiveTexture(GLenum(GL_TEXTURE0 + program.behind_unit));
        glBindTexture(GL_TEXTURE_2D, tools_.behind);
        glBindSampler(GLuint(program.behind_unit), 0);
    }
    for (const BoundMap& map : state.maps) {
        const GLint unit = program.map_unit[std::size_t(map.role)];
        if (unit < 0) continue;
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, map.texture);
        glBindSampler(GLuint(unit), map.sampler);
    }
    const Mesh& mesh = state_.list.scene.meshes[state_.list.draws[number].mesh];
    if (!state.features.from_triangles) {
        tools_.meshes.vertex_array(mesh, tools_.poses.of(state_.list.draws[number].mesh));
    } else {
        bind_table(program, mesh, state.against);
    }
    glFrontFace(state.culling.front_is_negative ? GL_CW : GL_CCW);
    const bool culls = state.culling.back || state.culling.front;
    (culls ? glEnable : glDisable)(GL_CULL_FACE);
    if (culls)
        glCullFace(state.culling.back && state.culling.front ? GL_FRONT_AND_BACK
                   : state.culling.back                      ? GL_BACK
                                                             : GL_FRONT);
    return program;
}

void PictureDrawer::draw_triangles(const DrawState& state, const Program& program, std::uint32_t first,
                                   std::uint32_t count) {
    if (state.features.from_triangles) {
        glUniform1i(program.first_corner, GLint(3 * first));
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * count) * (state.features.is_cut ? cut_pieces : 1));
    } else {
        glDrawElements(GL_TRIANGLES, GLsizei(3 * count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(std::size_t(first) * 3 * sizeof(std::uint32_t)));
    }
}

void PictureDrawer::draw(std::uint32_t number, const DrawState& state) const {
    const Mesh& mesh = state_.list.scene.meshes[state_.list.draws[number].mesh];
    const Program& program = use(number, state);
    draw_triangles(state, program, 0, std::uint32_t(mesh.triangle_count()));
}

void PictureDrawer::draw_marks(const shading::Draw& draw, const Mark& mark, Output output, GLuint depth) const {
    const Mesh& mesh = state_.list.scene.meshes[draw.mesh];
    const std::size_t elements = mark.kind == Mark::lines ? mesh.indices.size() / 2 : mesh.indices.size();
    if (elements == 0) return;
    Features features;
    features.output = output;
    features.from_triangles = 1;
    features.is_parallel = state_.view.orthographic;
    features.has_colors = mark.has_vertex_colors;
    features.has_vertex_shader = !state_.settings.vertex_text.empty();
    set_mesh_features(mesh, features);
    const Program& program = tools_.programs.of_marks(features);
    glUseProgram(program.name.name());
    set_picture(program);
    set_object(program, draw);
    bind_table(program, mesh, nullptr);
    glActiveTexture(GL_TEXTURE0 + unit_shadows);
    glBindTexture(GL_TEXTURE_2D, depth);
    const shading::PictureCamera& view = state_.view;
    const shading::Culling culling = shading::culling_of(state_.list, draw, state_.settings);
    glUniform4f(program.mark, mark.size, float(mark.kind), float(mark.shape + 4 * mark.fills),
                view.orthographic ? 0.5f : float(view.z_near));
    glUniform4f(program.mark_color, mark.color.x, mark.color.y, mark.color.z, mark.color.w);
    const DepthRange::Row nearness = DepthRange::nearness(view);
    glUniform4f(program.mark_view, float(pixels_.width), float(pixels_.height), float(nearness.scale),
                float(nearness.offset));
    const double radius = mark.shape == Mark::line ? 0 : double(mark.size) / (view.scale_y * view.height);
    glUniform4f(program.mark_cull, culling.back, culling.front, culling.front_is_negative,
                float(view.orthographic ? -nearness.scale * radius : radius));
    if (program.numbers >= 0)
        glUniform4ui(program.numbers, draw.node, state_.list.material(draw).scene_material, draw.mesh, 0);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(6 * elements));
}

void PictureDrawer::draw_sky() const {
    Features features;
    features.output = Output::sky;
    features.is_parallel = state_.view.orthographic;
    const Program& program = tools_.programs.of(features);
    glUseProgram(program.name.name());
    set_picture(program);
    glActiveTexture(GL_TEXTURE0 + unit_environment);
    glBindTexture(GL_TEXTURE_2D, tools_.environment.sky());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(tools_.meshes.no_arrays());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, tools_.environment.mirrored());
    glEnable(GL_DEPTH_TEST);
}

}  // namespace rakelight::opengl
