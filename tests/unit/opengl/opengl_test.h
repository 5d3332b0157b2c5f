// SPDX-License-Identifier: Apache-2.0
// What tests of the engine gl share. Skipped where there is no OpenGL.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "engines/opengl/opengl_engine.h"
#include "support/environment_variable.h"

namespace rakelight::test {

class OpenGl : public testing::Test {
protected:
    void SetUp() override {
        try {
            engine = opengl::make_engine();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }
    EnvironmentVariable no_cache{"RAKELIGHT_GL_CACHE", "off"}, exact_filters{"GALLIVM_PERF", "no_aos_sampling"};
    std::unique_ptr<Engine> engine;
    Context context{{.threads = 1}};
};

}  // namespace rakelight::test
