// SPDX-License-Identifier: Apache-2.0
// What tests of the engine gl share. Skipped where there is no OpenGL.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "engines/opengl/opengl_engine.h"

namespace rakelight::test {

/// A variable of the environment while this lives.
class EnvironmentVariable {
public:
    EnvironmentVariable(const char* name, const char* value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        ::setenv(name, value, 1);
    }
    ~EnvironmentVariable() {
        if (before_)
            ::setenv(name_, before_->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

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
