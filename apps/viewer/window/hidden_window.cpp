// SPDX-License-Identifier: Apache-2.0
#include "hidden_window.h"

#include <GLFW/glfw3.h>

#include <rakelight/base/error.h>

namespace rakelight::viewer {
namespace {

class HiddenWindow final : public SharedContext {
public:
    explicit HiddenWindow(GLFWwindow* shared) {
        wish_for_opengl();
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        window_ = glfwCreateWindow(1, 1, "", nullptr, shared);
        glfwDefaultWindowHints();
        if (!window_) throw Error(ErrorCode::failed, "no second context of OpenGL: " + last_glfw_error());
    }
    ~HiddenWindow() override { glfwDestroyWindow(window_); }
    void make_current() override {
        glfwMakeContextCurrent(window_);
        if (glfwGetCurrentContext() != window_)
            throw Error(ErrorCode::failed, "no context of OpenGL in another thread: " + last_glfw_error());
    }
    void release() override { glfwMakeContextCurrent(nullptr); }

private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? one_line(text) : "GLFW gives no reason";
}

void wish_for_opengl() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS,
                   GLFW_LOSE_CONTEXT_ON_RESET);  // else a GPU that was reset would not be distinguished of
}

std::unique_ptr<SharedContext> make_hidden_window(GLFWwindow* shared) { return std::make_unique<HiddenWindow>(shared); }

}  // namespace rakelight::viewer
