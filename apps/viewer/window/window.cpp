// SPDX-License-Identifier: Apache-2.0
#include "window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>  // ErrorCheckEndFrameRecover(), ClosePopupToLevel()

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include <rakelight/base/error.h>

#include "held_modifiers.h"
#include "hidden_window.h"

namespace rakelight::viewer {
namespace {

static_assert(GLFW_KEY_A == 'A' && GLFW_KEY_ESCAPE == 256 && GLFW_KEY_F1 == 290 && GLFW_KEY_KP_0 == 320);
static_assert(GLFW_KEY_LEFT_SHIFT == key_left_shift && GLFW_KEY_RIGHT_SHIFT == key_right_shift);
static_assert(GLFW_MOD_SHIFT == mod_shift && GLFW_MOD_CONTROL == mod_control && GLFW_MOD_ALT == mod_alt);

/// glfw3.h declares what OpenGL 1.1 has; the functions themselves are the driver's.
template <class F>
F* gl(const char* name) {
    return reinterpret_cast<F*>(glfwGetProcAddress(name));
}

constexpr float text_px = 16;
std::atomic<bool> is_open{false};  // GLFW has no events before

/// Places of legible fonts in distributions.
constexpr const char* fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"};

/// For texts in columns.
constexpr const char* table_fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf",
    "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf", "/usr/share/fonts/TTF/DejaVuSansMono.ttf"};

/// Adds the first font that is there; false: none is.
template <std::size_t n>
bool add_first(const char* const (&paths)[n], float size_px) {
    std::error_code ignored;
    for (const char* path : paths)
        if (std::filesystem::exists(path, ignored) && ImGui::GetIO().Fonts->AddFontFromFileTTF(path, size_px))
            return true;
    return false;
}

/// The letter or digit on a key as the keyboard is laid out; other keys are known by their place.
int letter_of(int key, int code) {
    const bool is_printed = key > 32 && key < 128;
    const char* const name = is_printed ? glfwGetKeyName(key, code) : nullptr;
    const auto sign = name && !name[1] ? static_cast<unsigned char>(name[0]) : 0u;
    return sign < 128 && std::isalnum(int(sign)) ? std::toupper(int(sign)) : key;
}

/// Fields need Control with letters for their own: copy, paste, undo, select all.
bool goes_past_text_fields(const Event& event) {
    const bool is_function_key = event.place >= GLFW_KEY_F1 && event.place <= GLFW_KEY_F12;
    return is_function_key || ((event.modifiers & mod_control) && (event.key == 'S' || event.key == 'Q'));
}

/// ImGui's coordinates of a pixel's corner.
ImVec2 corner(int x, int y) {
    const ImVec2 pixels_a_point = ImGui::GetIO().DisplayFramebufferScale;
    return {float(x) / pixels_a_point.x, float(y) / pixels_a_point.y};
}

/// Whether a press is for the panels. ImGui knows only where the pointer was at the last frame; a finger or a pen may
/// press where it has not been.
bool is_press_for_panels(double x, double y) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_held = std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
    if (is_held || ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) return io.WantCaptureMouse;
    const ImVec2 at = corner(int(x), int(y));
    const auto takes_it = [&](const ImGuiWindow* w) {
        return w->Active && !w->Hidden && (w->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
               w->OuterRectClipped.Contains(at);
    };
    const ImVector<ImGuiWindow*>& windows = ImGui::GetCurrentContext()->Windows;
    return std::any_of(windows.begin(), windows.end(), takes_it);
}

}  // namespace

struct Callbacks {
    static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }
    /// Window coordinates are points on some systems, pixels on others.
    static void to_pixels(GLFWwindow* window, double& x, double& y) {
        int w = 0, h = 0;
        glfwGetWindowSize(window, &w, &h);
        if (w > 0 && h > 0) x *= double(of(window).width_) / w, y *= double(of(window).height_) / h;
    }
    /// An event at the place where the events have brought the pointer: by now, and so by glfwGetCursorPos(), it may be
    /// elsewhere.
    static Event at_pointer(GLFWwindow* window, Event::Kind kind) {
        Event event{.kind = kind, .x = of(window).pointer_x_, .y = of(window).pointer_y_};
        event.is_for_panels = !of(window).is_caught_ && ImGui::GetIO().WantCaptureMouse;
        return event;
    }
    static int modifiers_of(GLFWwindow* window) {
        const auto down = [window](int key) { return glfwGetKey(window, key) == GLFW_PRESS; };
        return (down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT) ? mod_shift : 0) |
               (down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL) ? mod_control : 0);
    }
    static void key(GLFWwindow* window, int key, int code, int action, int modifiers) {
        ImGui_ImplGlfw_KeyCallback(window, key, code, action, modifiers);
        Event event{.kind = action == GLFW_RELEASE ? Event::Kind::key_up : Event::Kind::key_down};
        event.key = letter_of(key, code), event.place = key;
        event.modifiers = modifiers & (mod_shift | mod_control | mod_alt);
        event.is_for_panels = ImGui::GetIO().WantTextInput && !goes_past_text_fields(event);
        if (action != GLFW_REPEAT) of(window).events_.push_back(event);
    }
    static void button(GLFWwindow* window, int button, int action, int modifiers) {
        ImGui_ImplGlfw_MouseButtonCallback(window, button, action, modifiers);
        Event event = at_pointer(window, action == GLFW_PRESS ? Event::Kind::button_down : Event::Kind::button_up);
        if (button > 2) return;
        event.button = Button(button);
        if (action == GLFW_PRESS) event.is_for_panels = !of(window).is_caught_ && is_press_for_panels(event.x, event.y);
        event.modifiers = modifiers & (mod_shift | mod_control | mod_alt);
        of(window).events_.push_back(event);
    }
    static void move(GLFWwindow* window, double x, double y) {
        to_pixels(window, x, y);
        of(window).pointer_x_ = x, of(window).pointer_y_ = y;
        of(window).events_.push_back(at_pointer(window, Event::Kind::move));
    }
    static void scroll(GLFWwindow* window, double dx, double dy) {
        ImGui_ImplGlfw_ScrollCallback(window, dx, dy);
        Event event = at_pointer(window, Event::Kind::scroll);
        event.x = dx, event.y = dy;
        event.modifiers = modifiers_of(window);
        of(window).events_.push_back(event);
    }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        Event event = at_pointer(window, Event::Kind::drop);
        event.modifiers = modifiers_of(window) | held_modifiers();
        event.files.assign(paths, paths + count);
        of(window).events_.push_back(event);
    }
    static void size(GLFWwindow* window, int width, int height) {
        of(window).width_ = width, of(window).height_ = height;
        of(window).needs_drawing_ = true;
    }
    static void refresh(GLFWwindow* window) { of(window).needs_drawing_ = true; }
    static void focus(GLFWwindow* window, int has_focus) {
        ImGui_ImplGlfw_WindowFocusCallback(window, has_focus);
        if (!has_focus)
            of(window).events_.push_back({.kind = Event::Kind::key_up, .key = -1});  // keys held are forgotten
    }
};

GlfwWindow::GlfwWindow(const std::string& title, int width, int height) {
    if (!glfwInit())
        throw Error(ErrorCode::failed, "no window can be opened: " + last_glfw_error(), {},
                    "rakelight render makes pictures without a display");
    wish_for_opengl();
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string why = last_glfw_error();
        glfwTerminate();
        throw Error(ErrorCode::failed, "no window with OpenGL 3.3 can be opened: " + why);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwGetFramebufferSize(window_, &width_, &height_);
    if (const float points = 1 / pixels_a_point(); points != 1)
        glfwSetWindowSize(window_, std::max(1, int(float(width) * points)), std::max(1, int(float(height) * points)));
    find_pointer();
    make_panels();
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetCharCallback(window_, ImGui_ImplGlfw_CharCallback);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetCursorPosCallback(window_, Callbacks::move);
    glfwSetCursorEnterCallback(window_, ImGui_ImplGlfw_CursorEnterCallback);
    glfwSetScrollCallback(window_, Callbacks::scroll);
    glfwSetDropCallback(window_, Callbacks::drop);
    glfwSetFramebufferSizeCallback(window_, Callbacks::size);
    glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
    glfwSetWindowFocusCallback(window_, Callbacks::focus);
    is_open = true;
}

GlfwWindow::~GlfwWindow() {
    is_open = false;
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

/// Reads the place of the pointer when no event reports it.
void GlfwWindow::find_pointer() {
    glfwGetCursorPos(window_, &pointer_x_, &pointer_y_);
    Callbacks::to_pixels(window_, pointer_x_, pointer_y_);
}

void GlfwWindow::make_panels() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the viewer has settings of its own
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    set_theme(true);
}

void GlfwWindow::load_font() {
    font_scale_ = scale();
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const bool has_font = add_first(fonts, std::round(text_px * font_scale_));
    if (!has_font) io.Fonts->AddFontDefault();
    if (!add_first(table_fonts, std::round(0.85f * text_px * font_scale_))) io.Fonts->AddFontDefault();
    io.FontGlobalScale = (has_font ? 1 : font_scale_ * text_px / 13) / pixels_a_point();  // 13: the size of ImGui's own
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    set_theme(is_dark_);
}

void GlfwWindow::set_theme(bool is_dark) {
    is_dark_ = is_dark;
    ImGuiStyle style;
    style.WindowRounding = 0, style.FrameRounding = 3, style.WindowBorderSize = 1,
    style.FrameBorderSize = is_dark ? 0 : 1;
    ImGui::GetStyle() = style;
    is_dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
    ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.97f;
    ImGui::GetStyle().ScaleAllSizes(std::max(1.0f, font_scale_ / pixels_a_point()));
}

float GlfwWindow::scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(x, 0.5f, 4.0f);
}

float GlfwWindow::pixels_a_point() const {
    int points = 0, pixels = 0, ignored = 0;  // both of now: width_ is that of the event before
    glfwGetWindowSize(window_, &points, &ignored);
    glfwGetFramebufferSize(window_, &pixels, &ignored);
    return points > 0 && pixels > 0 ? float(pixels) / float(points) : 1;
}

void GlfwWindow::wait(double seconds) { seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents(); }
void GlfwWindow::wake() {
    if (is_open) glfwPostEmptyEvent();
}
std::vector<Event> GlfwWindow::take_events() { return std::exchange(events_, {}); }
bool GlfwWindow::is_closing() const { return glfwWindowShouldClose(window_); }
void GlfwWindow::hide() { glfwHideWindow(window_); }
void GlfwWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void GlfwWindow::set_clipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

void GlfwWindow::set_full_screen(bool is_full) {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    if (is_full == is_full_ || !monitor) return;
    is_full_ = is_full;
    if (is_full) {
        glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
        glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
        const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], GLFW_DONT_CARE);
    }
}

void GlfwWindow::catch_pointer(bool is_caught) {
    if (is_caught == is_caught_) return;
    is_caught_ = is_caught;
    glfwSetInputMode(window_, GLFW_CURSOR, is_caught ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    find_pointer();
    if (is_caught)  // else ImGui shows the pointer again
        ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange | ImGuiConfigFlags_NoMouse;
    else
        ImGui::GetIO().ConfigFlags &= ~(ImGuiConfigFlags_NoMouseCursorChange | ImGuiConfigFlags_NoMouse);
}

void GlfwWindow::begin_panels() {
    if (font_scale_ != scale()) load_font();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    has_frame_ = true;
}

bool GlfwWindow::close_lists() {
    if (ImGui::GetCurrentContext()->OpenPopupStack.empty()) return false;
    ImGui::ClosePopupToLevel(0, true);
    return true;
}

void GlfwWindow::abandon_panels() {
    if (!has_frame_) return;
    has_frame_ = false;
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    ImGui::EndFrame();
}

void GlfwWindow::end_panels() {
    has_frame_ = false;
    ImGui::Render();
    set_viewport(0, 0, 0, 0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GlfwWindow::show(const GlPicture& picture, const PixelBox& to, const PixelBox& clip) {
    const bool is_same_size = picture.width == to.width && picture.height == to.height;
    // Pixels of the same size hit the centers of texels, and a little more, so that rounding does not mix in
    // neighbors. Others stay within the picture, beyond which the texture continues.
    const float first = is_same_size ? 1.0f / 512 : 0.5f, behind = is_same_size ? -first : 0.5f;
    const float u = 1.0f / float(picture.texture_width), v = 1.0f / float(picture.texture_height);
    const ImVec2 top_left{first * u, (float(picture.height) - behind) * v},
        bottom_right{(float(picture.width) - behind) * u, first * v};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect(corner(clip.x, clip.y), corner(clip.x + clip.width, clip.y + clip.height));
    list.AddImage(reinterpret_cast<ImTextureID>(std::uintptr_t(picture.texture)), corner(to.x, to.y),
                  corner(to.x + to.width, to.y + to.height), top_left, bottom_right);
    list.PopClipRect();
}

void GlfwWindow::fill(const PixelBox& box, std::uint32_t color) {
    ImGui::GetBackgroundDrawList()->AddRectFilled(corner(box.x, box.y), corner(box.x + box.width, box.y + box.height),
                                                  color);
}

void GlfwWindow::label(int x, int y, const char* text, bool is_highlighted) {
    const ImVec2 from = corner(x, y), size = ImGui::CalcTextSize(text), pad = ImGui::GetStyle().FramePadding;
    const ImVec2 to{from.x + size.x + 2 * pad.x, from.y + size.y + 2 * pad.y};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(from, to, is_highlighted ? IM_COL32(255, 160, 64, 255) : IM_COL32(0, 0, 0, 160), 3);
    list.AddText({from.x + pad.x, from.y + pad.y}, is_highlighted ? IM_COL32_BLACK : IM_COL32_WHITE, text);
}

void GlfwWindow::set_viewport(int x, int y, int width, int height) {
    using Viewport = void(GLint, GLint, GLsizei, GLsizei);
    static auto* const viewport = gl<Viewport>("glViewport");
    if (width == 0) return viewport(0, 0, width_, height_);
    viewport(x, height_ - y - height, width, height);
}

void GlfwWindow::clear() {
    using ClearColor = void(GLfloat, GLfloat, GLfloat, GLfloat);
    using Clear = void(GLbitfield);
    static auto* const clear_color = gl<ClearColor>("glClearColor");
    static auto* const clear = gl<Clear>("glClear");
    const float gray = is_dark_ ? 0.12f : 0.85f;
    clear_color(gray, gray, gray, 1);
    clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

std::unique_ptr<SharedContext> GlfwWindow::make_shared_context() { return make_hidden_window(window_); }

void GlfwWindow::swap() {
    needs_drawing_ = false;
    glfwSwapBuffers(window_);
}

}  // namespace rakelight::viewer
