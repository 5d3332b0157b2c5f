// SPDX-License-Identifier: Apache-2.0
// One picture, or one shadow map, as it is drawn: numbers that all of its programs get, and the drawing of one draw.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/opengl/picture/draw_state.h"
#include "engines/opengl/picture/shadow_atlas.h"
#include "engines/opengl/programs/programs.h"
#include "engines/opengl/scene/meshes.h"
#include "engines/opengl/scene/poses.h"

namespace rakelight::opengl {

/// Depth as this driver keeps it precise.
struct DepthRange {
    explicit DepthRange(const Driver& driver) : is_reversed(driver.has_reversed_depth) {}
    bool is_reversed;
    float far_depth() const { return is_reversed ? 0.0f : 1.0f; }
    GLenum nearer() const { return is_reversed ? GL_GREATER : GL_LESS; }
    GLenum farther() const { return is_reversed ? GL_LESS : GL_GREATER; }
    GLenum not_farther() const { return is_reversed ? GL_GEQUAL : GL_LEQUAL; }
    /// Of a distance along the view axis: (scale * distance + offset) / w + per_w.
    struct Row {
        double scale, offset, per_w;
    };
    /// 1 at the near plane, 0 at the far one: what reversed depth holds; 1 minus it: what the other depth does.
    static Row nearness(const shading::PictureCamera& view);
    /// Clip-space depth.
    Row row(const shading::PictureCamera& view) const;
};

/// Camera axes -> clip space of a part of the picture. @param depth  what comes as z: z * w
/// @param y_sign  -1: upside down, as pictures are drawn
dmat4 clip_matrix(const shading::PictureCamera& view, Window pixels, const DepthRange::Row& depth, double y_sign);

/// What draws of a picture share on the GPU.
struct PictureTools {
    const Driver& driver;
    Programs& programs;
    MeshStore& meshes;
    const EnvironmentStore& environment;
    const ShadowAtlas& shadows;
    GLuint albedos = 0;  ///< texture of the tables
    GLuint behind = 0;   ///< texture of what is behind transmissive surfaces; 0: none
    PoseStore& poses;
};

class PictureDrawer {
public:
    /// All must outlive this. @param pixels  what of the picture is drawn; to the whole viewport
    PictureDrawer(const PictureTools& tools, const PictureState& state, Window pixels);

    /// Binds textures, sets the state that all draws have.
    void begin() const;
    /// A whole draw.
    void draw(std::uint32_t number, const DrawState& state) const;
    /// Program, numbers and textures of a draw; then draw_triangles() any number of times.
    const Program& use(std::uint32_t number, const DrawState& state) const;
    static void draw_triangles(const DrawState& state, const Program& program, std::uint32_t first,
                               std::uint32_t count);
    const Driver& driver() const { return tools_.driver; }
    void draw_sky() const;
    /// What shows lines and points, in the numbers of glsl/marks_main.glsl.
    struct Mark {
        enum Kind : std::uint8_t { lines, points, edges, vertices } kind = lines;
        enum Shape : std::uint8_t { line, square, disc } shape = line;
        float size = 1;  ///< [px]
        vec4 color;      ///< linear, opacity
        bool has_vertex_colors = false;
        bool fills = false;  ///< only pixels that it covers as a whole
    };
    /// Over what is bound, hidden by `depth`. @param draw  of DrawList::draws or line_draws
    void draw_marks(const shading::Draw& draw, const Mark& mark, Output output, GLuint depth) const;
    /// Whether a draw's box is outside of what is drawn.
    bool is_outside(std::uint32_t number) const;
    void set_map_texels(float texels) { map_texels_ = texels; }
    /// Whose terms Output::user_terms shows.
    void set_term_light(int number) { term_light_ = number; }

private:
    void set_picture(const Program& program) const;
    void set_object(const Program& program, const shading::Draw& draw) const;
    void bind_table(const Program& program, const Mesh& mesh, const std::int32_t* against) const;

    const PictureTools& tools_;
    const PictureState& state_;
    const Window pixels_;
    const DepthRange depth_;
    dmat4 camera_to_clip_;  ///< of the pixels that are drawn
    std::uint64_t number_;  ///< of this picture
    float map_texels_ = 0;
    int term_light_ = 0;
};

}  // namespace rakelight::opengl
