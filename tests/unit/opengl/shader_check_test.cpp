// SPDX-License-Identifier: Apache-2.0
// Programs with GLSL of the user's in a process of its own: one that crashes, lies or is not there is one clear error, and so is a
// text that takes too much. Small scripts play the process where it misbehaves.
#include "engines/opengl/programs/shader_check.h"

#include <sys/stat.h>

#include <fstream>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight::opengl {
namespace {

ProgramText program_of(const std::string& body, const std::string& before = {}) {
    ProgramText text;
    text.vertices.text = "#version 330 core\nvoid main()\n{\n    gl_Position = vec4(0.0);\n}\n";
    text.pixels.text = "#version 330 core\nout vec4 color;\n" + before + "void main()\n{\n    " + body + "\n}\n";
    text.pixels.files.all[0] = {"mine.glsl", 10};
    return text;
}

/// Functions that call the one before twice: the driver puts each call's text in its place.
std::string doubling_functions(int steps) {
    std::string text = "float f0(float x) { return sin(x) * x; }\n";
    for (int i = 1; i <= steps; ++i) {
        const std::string call = "f" + std::to_string(i - 1);
        text += "float f" + std::to_string(i) + "(float x) { return " + call + "(x) + " + call + "(x * 1.1); }\n";
    }
    return text;
}

class ShaderCheck : public test::OpenGl {
protected:
    std::string script(const std::string& body) {
        const std::string path = folder_.write("check.sh", "#!/bin/sh\n" + body + "\n");
        ::chmod(path.c_str(), 0755);
        return path;
    }
    Error error_by(const std::string& body, const std::string& text) {
        const test::EnvironmentVariable check("RAKELIGHT_SHADER_CHECK", script(body));
        return test::error_of([&] { checked_apart(program_of(text)); });
    }
    test::TemporaryFolder folder_;
};

TEST_F(ShaderCheck, SaysWhatTheDriverSays) {
    EXPECT_FALSE(checked_apart(program_of("color = vec4(1.0);")));
    const auto pixels = checked_apart(program_of("color = vec4(1.0)"));
    ASSERT_TRUE(pixels);
    EXPECT_EQ(pixels->part, CompileFault::Part::pixels);
    EXPECT_NE(pixels->log.find("error"), std::string::npos);
    ProgramText text = program_of("color = vec4(1.0);");
    text.vertices.text += "x";
    const auto vertices = checked_apart(text);
    ASSERT_TRUE(vertices);
    EXPECT_EQ(vertices->part, CompileFault::Part::vertices);
    text = program_of("color = passed;", "in vec4 passed;\n");
    text.vertices.text = "#version 330 core\nout vec3 passed;\nvoid main()\n{\n    passed = vec3(1.0);\n}\n";
    const auto linked = checked_apart(text);
    ASSERT_TRUE(linked);
    EXPECT_EQ(linked->part, CompileFault::Part::both);
}

TEST_F(ShaderCheck, ATextThatTakesTooMuchIsRefused) {
    for (const ProgramText& text :
         {program_of("color = vec4(f30(gl_FragCoord.x));", doubling_functions(30)),
          program_of("float a[200000000]; a[int(gl_FragCoord.x)] = 1.0; color = vec4(a[3]);")}) {
        const Error error = test::error_of([&] { checked_apart(text); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        EXPECT_NE(error.reason().find("the OpenGL driver needs more than 1024 MiB"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(checked_apart(program_of("color = vec4(f5(gl_FragCoord.x));", doubling_functions(5))));
}

TEST_F(ShaderCheck, OneThatMisbehavesIsOneClearError) {
    const Error crashed = error_by("kill -SEGV $$", "color = vec4(2.0);");
    EXPECT_EQ(crashed.code(), ErrorCode::bad_file);
    EXPECT_NE(crashed.reason().find("or crashes on it"), std::string::npos) << crashed.what();
    EXPECT_NE(error_by("kill -XCPU $$", "color = vec4(2.0);").reason().find("more than 10 s"), std::string::npos);
    EXPECT_NE(error_by("echo good; exit 1", "color = vec4(2.0);").reason().find("or crashes"), std::string::npos);
    for (const char* const lie : {"echo fine", "exit 0", "yes good | head -c 100000", "printf goo"}) {
        const Error error = error_by(lie, "color = vec4(2.0);");
        EXPECT_EQ(error.code(), ErrorCode::failed) << lie;
        EXPECT_NE(error.reason().find("something else"), std::string::npos) << error.what();
    }
    const Error own = error_by("exit 3", "color = vec4(2.0);");
    EXPECT_EQ(own.code(), ErrorCode::failed);
    EXPECT_NE(own.reason().find("exit code 3"), std::string::npos) << own.what();
    const Error none = error_by("echo 'no context'; echo 'libEGL is missing'", "color = vec4(2.0);");
    EXPECT_EQ(none.code(), ErrorCode::failed);
    EXPECT_NE(none.reason().find("libEGL is missing"), std::string::npos) << none.what();
}

TEST_F(ShaderCheck, OneThatIsNotThereIsNamed) {
    const test::EnvironmentVariable check("RAKELIGHT_SHADER_CHECK", folder_.file("none"));
    const Error error = test::error_of([&] { checked_apart(program_of("color = vec4(3.0);")); });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_NE(error.reason().find("is not a program"), std::string::npos) << error.what();
}

TEST_F(ShaderCheck, ATextIsCheckedOnce) {
    const std::string log = folder_.file("log");
    const test::EnvironmentVariable check("RAKELIGHT_SHADER_CHECK", script("echo x >> " + log + "; echo good"));
    for (const char* const text : {"color = vec4(4.0);", "color = vec4(4.0);", "color = vec4(5.0);"})
        EXPECT_FALSE(checked_apart(program_of(text)));
    std::ifstream file(log);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "x\nx\n");
}

}  // namespace
}  // namespace rakelight::opengl
