// SPDX-License-Identifier: Apache-2.0
// Programs by features: made when they are first needed, kept while the context lives unless there are too many, and as
// binaries from one run to the next where the driver has a form for them.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "engines/opengl/context/gl_objects.h"
#include "engines/opengl/programs/program_text.h"

namespace rakelight::opengl {

/// Texture units of the engine's own; materials' maps follow.
enum TextureUnit : GLint { unit_lights, unit_shadows, unit_environment, unit_tables, engine_units };
/// Of the vertex stage alone, behind all of the pixels'.
inline constexpr GLint vertex_units = 2;

struct Program {
    GlProgram name;
    GLint object = -1, material = -1, lights = -1, light_count = -1, view_direction = -1, ray = -1, fog = -1,
          environment = -1, environment_levels = -1, first_corner = -1, against = -1, map_texels = -1, shadow_size = -1,
          numbers = -1, samples = -1, mark = -1, mark_color = -1, mark_view = -1, mark_cull = -1, behind_view = -1,
          cut = -1;
    GLint behind_unit = -1;             ///< of transmissive materials alone
    mutable std::uint64_t picture = 0;  ///< whose numbers it has been given
    GLint time = -1, term_light = -1;
    std::vector<GLint> uniforms;  ///< [UserShaders::uniforms] of the user's shaders
    std::vector<GLint> map_unit;  ///< [texture_role_count] -1: it has none
};

/// A program of two texts. @param caught  what transform feedback catches of the vertices, a buffer each
/// @throws Error failed: it does not compile
GlProgram link_program(const ProgramText& text, std::span<const char* const> caught = {});

class Programs {
public:
    /// A driver takes some 3 MB for one (llvmpipe of Mesa 22.3).
    static constexpr std::size_t most_kept = 48;

    /// @param most  that are kept, but for those of the last picture
    explicit Programs(const Driver& driver, std::size_t most = most_kept) : driver_(driver), most_(most) {}

    /// Drops the least recently used ones where too many are kept. Those of the last picture stay.
    void begin_picture();
    /// Stays until the next picture begins.
    /// @throws Error failed: it does not compile: the line names file and line of the text
    const Program& of(const Features& features) { return find(features, programs_, &Programs::make); }
    /// Of lines and points.
    const Program& of_marks(const Features& features) { return find(features, marks_, &Programs::make_marks); }
    /// Shaders of the user's and their values: programs with other texts are dropped.
    /// @return whether vertices are elsewhere than before
    /// @throws Error as user_shaders_of()
    bool set_user(const RenderSettings& settings);
    /// Those of the user's, of the program that is in use.
    void set_uniforms(const Program& program) const;
    std::size_t count() const { return programs_.size() + marks_.size(); }

private:
    struct Kept {
        std::unique_ptr<Program> program;
        std::uint64_t used = 0;  ///< in which picture it was used last
    };
    using Table = std::map<Features, Kept>;
    const Program& find(const Features& features, Table& in,
                        std::unique_ptr<Program> (Programs::*make)(const Features&) const) {
        auto at = in.find(features);
        if (at == in.end()) at = in.emplace(features, Kept{(this->*make)(features)}).first;
        at->second.used = picture_;
        return *at->second.program;
    }
    std::unique_ptr<Program> make(const Features& features) const;
    std::unique_ptr<Program> make_marks(const Features& features) const;
    std::unique_ptr<Program> make_of(const ProgramText& text, const Features& features) const;

    const Driver& driver_;
    const std::size_t most_;
    UserShaders user_;
    RenderSettings settings_;  ///< of user_
    Table programs_, marks_;
    std::uint64_t picture_ = 0;
};

}  // namespace rakelight::opengl
