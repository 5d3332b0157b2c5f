// SPDX-License-Identifier: Apache-2.0
// Linked programs as files, so that the next run need not compile them: in $XDG_CACHE_HOME/rakelight/gl (~/.cache). A file is
// named by driver and text; one that is broken or that the driver refuses is recomputed. Where they are too many, the least
// recently used ones are removed. RAKELIGHT_GL_CACHE=off: none.
#pragma once
#include <epoxy/gl.h>

#include <filesystem>

#include "engines/opengl/programs/program_text.h"

namespace rakelight::opengl {

/// Removes the files of a folder that were used least recently until those that are left have at most `most_bytes`.
void remove_least_used(const std::filesystem::path& folder, std::uintmax_t most_bytes);

class ProgramCache {
public:
    static constexpr std::uintmax_t most_bytes = 64 << 20;  ///< of all files

    /// Of one program.
    ProgramCache(const Driver& driver, const ProgramText& text);
    bool load(GLuint program) const;     ///< false: there is none that the driver takes
    void prepare(GLuint program) const;  ///< before it is linked
    void store(GLuint program) const;    ///< errors are ignored: the program exists

private:
    std::filesystem::path file_;  ///< empty: no cache
};

}  // namespace rakelight::opengl
