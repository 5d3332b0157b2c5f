// SPDX-License-Identifier: Apache-2.0
// How long passes take on the GPU, and how many samples they draw.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"

namespace rakelight::opengl {

/// What is drawn while a Pass lives counts for it; the answers are fetched at last, so that nothing waits.
class PassMeter {
public:
    explicit PassMeter(const Driver& driver) : driver_(driver) {}

    class Pass {
    public:
        /// @param counts  samples too
        Pass(PassMeter& meter, const char* name, bool counts = true) : meter_(meter) { meter.begin(name, counts); }
        ~Pass() { meter_.end(); }
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;

    private:
        PassMeter& meter_;
    };
    /// Forgets what was asked and not fetched.
    void reset() { asked_.clear(); }
    /// Fetches all answers and begins again; passes of one name are summed, in the order in which they came first.
    void finish(std::vector<GpuPass>& to);
    /// Samples that passes of that name drew, after finish(). 0 in OpenGL ES, which does not count them.
    std::uint64_t samples(const std::string& name) const;

private:
    void begin(const char* name, bool counts);
    void end();
    struct Asked {
        const char* name;
        GlQuery time, samples;
    };
    struct Answer {
        std::string name;
        std::uint64_t samples = 0;
    };
    const Driver& driver_;
    std::vector<Asked> asked_;
    std::vector<Answer> answers_;
};

}  // namespace rakelight::opengl
