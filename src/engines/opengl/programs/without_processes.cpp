// SPDX-License-Identifier: Apache-2.0
// In a build that starts no other programs: no texts of users, and programs are kept by the browser.
#include <rakelight/base/error.h>

#include "engines/opengl/programs/program_cache.h"
#include "engines/opengl/programs/shader_check.h"

namespace rakelight::opengl {

std::optional<CompileFault> checked_apart(const ProgramText&) {
    throw Error(ErrorCode::failed, "this build does not compile shaders of users");
}

ProgramCache::ProgramCache(const Driver&, const ProgramText&) {}
bool ProgramCache::load(GLuint) const { return false; }
void ProgramCache::prepare(GLuint) const {}
void ProgramCache::store(GLuint) const {}

}  // namespace rakelight::opengl
