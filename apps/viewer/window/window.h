// SPDX-License-Identifier: Apache-2.0
// The window, its OpenGL context and what comes from it. The one place that sees GLFW, with the panels' back end.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "../view/gl_pictures.h"
#include "../view/shared_context.h"
#include "input.h"

struct GLFWwindow;

namespace rakelight::viewer {

class GlfwWindow {
public:
    /// @param width,height  [px] of the framebuffer @throws Error failed: no display, no OpenGL 3.3
    GlfwWindow(const std::string& title, int width, int height);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    /// Waits for events, at most so long; 0: takes those that exist.
    void wait(double seconds);
    /// Ends a wait(); from any thread, also while there is no window.
    static void wake();
    std::vector<Event> take_events();
    bool is_closing() const;
    void hide();
    bool needs_drawing() const { return needs_drawing_; }  ///< resized or uncovered since swap()

    int width() const { return width_; }    ///< [px] of the framebuffer; 0: minimized
    int height() const { return height_; }  ///< likewise
    float scale() const;                    ///< of texts on this display, 1 where a pixel has 1/96 inch
    float pixels_a_point() const;           ///< panels count in points: 1 on X11, else the display's scale
    void set_title(const std::string& title);
    void set_full_screen(bool is_full);
    bool is_full_screen() const { return is_full_; }
    /// The pointer disappears and moves without end, for walking.
    void catch_pointer(bool is_caught);
    void set_clipboard(const std::string& text);

    /// Panels: between the two calls ImGui's functions are used. Its font 0 is for words, font 1 for texts in columns.
    void begin_panels();
    void end_panels();
    /// Instead of end_panels() where a fault came between: nothing of them is drawn.
    void abandon_panels();
    /// Between them: shows a picture below the panels. @param to  where all of it would lie  @param clip  what of that is seen
    void show(const GlPicture& picture, const PixelBox& to, const PixelBox& clip);
    /// Between them: fills a box below the panels. @param color  sRGB, R in the low byte, A in the highest
    void fill(const PixelBox& box, std::uint32_t color);
    /// Between them: shows a short word below the panels, its upper left corner at a pixel.
    void label(int x, int y, const char* text, bool is_highlighted);
    /// Drop-down lists of panels. False: none was open.
    bool close_lists();
    void set_theme(bool is_dark);
    /// [px] rows from above; everything that is drawn from now on lies there. All 0: the whole window
    void set_viewport(int x, int y, int width, int height);
    void clear();
    void swap();
    /// Ends before the window. @throws Error failed
    std::unique_ptr<SharedContext> make_shared_context();

private:
    void make_panels();
    void load_font();
    void find_pointer();
    friend struct Callbacks;

    GLFWwindow* window_ = nullptr;
    std::vector<Event> events_;
    int width_ = 0, height_ = 0;
    int windowed_[4] = {0, 0, 1280, 800};
    double pointer_x_ = 0, pointer_y_ = 0;  ///< [px] at the event before, y down
    float font_scale_ = 0;
    bool is_full_ = false, needs_drawing_ = true, is_dark_ = true, is_caught_ = false, has_frame_ = false;
};

}  // namespace rakelight::viewer
