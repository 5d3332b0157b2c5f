// SPDX-License-Identifier: Apache-2.0
#include "held_modifiers.h"

#ifdef RAKELIGHT_VIEWER_X11
#include <X11/Xlib.h>

#include "../document/keys.h"

extern "C" Display* glfwGetX11Display();  // of glfw3native.h, which asks for the headers of Xrandr, too
#endif

namespace rakelight::viewer {

#ifdef RAKELIGHT_VIEWER_X11
int held_modifiers() {
    Display* const display = glfwGetX11Display();
    if (!display) return 0;
    Window root = 0, child = 0;
    int root_x = 0, root_y = 0, x = 0, y = 0;
    unsigned mask = 0;
    if (!XQueryPointer(display, XDefaultRootWindow(display), &root, &child, &root_x, &root_y, &x, &y, &mask)) return 0;
    return (mask & ShiftMask ? mod_shift : 0) | (mask & ControlMask ? mod_control : 0) |
           (mask & Mod1Mask ? mod_alt : 0);
}
#else
int held_modifiers() { return 0; }
#endif

}  // namespace rakelight::viewer
