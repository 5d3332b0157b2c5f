// SPDX-License-Identifier: Apache-2.0
// Contexts of OpenGL by GLFW, which has them with windows alone.
#pragma once
#include <memory>
#include <string>

#include "../view/shared_context.h"

struct GLFWwindow;

namespace rakelight::viewer {

/// The last error message of GLFW in this thread, in one line.
std::string last_glfw_error();

/// OpenGL as windows ask for it that are made from now on.
void wish_for_opengl();

/// A window that is never seen. @throws Error failed
std::unique_ptr<SharedContext> make_hidden_window(GLFWwindow* shared);

}  // namespace rakelight::viewer
