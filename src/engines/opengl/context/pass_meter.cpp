// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/context/pass_meter.h"

#include <algorithm>

namespace rakelight::opengl {

void PassMeter::begin(const char* name, bool counts) {
    Asked& pass = asked_.emplace_back(Asked{name, {}, {}});
    if (driver_.has_timer) glBeginQuery(GL_TIME_ELAPSED, pass.time.get());
    if (counts && !driver_.is_es) glBeginQuery(GL_SAMPLES_PASSED, pass.samples.get());
}

void PassMeter::end() {
    if (driver_.has_timer) glEndQuery(GL_TIME_ELAPSED);
    if (asked_.back().samples) glEndQuery(GL_SAMPLES_PASSED);
}

void PassMeter::finish(std::vector<GpuPass>& to) {
    answers_.clear();
    for (const Asked& pass : asked_) {
        GLuint samples = 0;
        if (pass.samples) glGetQueryObjectuiv(pass.samples.name(), GL_QUERY_RESULT, &samples);
        auto answer = std::ranges::find(answers_, pass.name, &Answer::name);
        if (answer == answers_.end()) answer = answers_.insert(answers_.end(), {pass.name});
        answer->samples += samples;
        if (!driver_.has_timer) continue;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(pass.time.name(), GL_QUERY_RESULT, &nanoseconds);
        auto sum = std::ranges::find(to, pass.name, &GpuPass::name);
        if (sum == to.end()) sum = to.insert(to.end(), {pass.name});
        sum->seconds += 1e-9 * double(nanoseconds);
    }
    asked_.clear();
}

std::uint64_t PassMeter::samples(const std::string& name) const {
    const auto answer = std::ranges::find(answers_, name, &Answer::name);
    return answer == answers_.end() ? 0 : answer->samples;
}

}  // namespace rakelight::opengl
