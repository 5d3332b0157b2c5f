// SPDX-License-Identifier: Apache-2.0
// The page's functions for JavaScript (site/src/worker.ts). Each gives a report as the program's --json writes it, or "" where there is
// nothing to report but errors.
#include <emscripten.h>

#include <chrono>
#include <string>
#include <string_view>

#include <rakelight/base/current_error.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>

#include "../../apps/viewer/view/overlay.h"
#include "page.h"

using namespace rakelight;
using namespace rakelight::web;

// clang-format off
EM_JS(void, rl_tell_progress, (const char* stage, double share), {
    if (Module.onProgress) Module.onProgress(UTF8ToString(stage), share);
});
// clang-format on

namespace {

Page& page() {
    static Page only;
    return only;
}

void tell_progress(std::string_view stage, double share) {
    using Clock = std::chrono::steady_clock;
    static Clock::time_point last;
    static std::string last_stage;
    const Clock::time_point now = Clock::now();
    if (stage == last_stage && now - last < std::chrono::milliseconds(50)) return;
    last = now, last_stage = stage;
    rl_tell_progress(last_stage.c_str(), share);
}

/// Whether the last rl_draw() drew a coarse picture, which a whole one follows.
bool is_coarse = false;

/// By the last rl_explain().
std::shared_ptr<const ExplainedPixel> explained;

/// What the last call gave. Stays until the next one.
std::string& answer() {
    static std::string text;
    return text;
}

/// Runs a call; an error becomes the row's.
template <class Row, class Call>
const char* reported(Row row, Call call) {
    Context context({.threads = 1, .progress = tell_progress});
    try {
        call(row, context);
    } catch (...) {
        row.error = current_error();
    }
    row.remarks = context.report().entries();
    row.remarks_left_out = context.report().left_out();
    answer() = to_json(std::span<const Row>(&row, 1));
    return answer().c_str();
}

/// Of calls without a report: "" or the error as a report has it.
template <class Call>
const char* checked(Call call) {
    Context context({.threads = 1, .progress = tell_progress});
    try {
        call(context);
        return "";
    } catch (...) {
        PictureRow row;
        row.error = current_error();
        answer() = to_json(std::span<const PictureRow>(&row, 1));
        return answer().c_str();
    }
}

/// A line for each key, its words behind it, all with tabs between them.
std::vector<WorldValue> settings_of(std::string_view text) {
    std::vector<WorldValue> settings;
    for (const std::string_view line : values::split(text, '\n')) {
        if (line.empty()) continue;
        const std::vector<std::string_view> words = values::split(line, '\t');
        WorldValue value{.key = std::string(words[0]), .is_array = words.size() > 2};
        for (std::size_t i = 1; i < words.size(); ++i) value.words.emplace_back(words[i]);
        settings.push_back(std::move(value));
    }
    return settings;
}

const char* inspected(const char* file, const Inspection& (Page::*open)(const std::string&, Context&)) {
    InspectionRow row;
    row.file = file;
    return reported(std::move(row), [&](InspectionRow& to, Context& context) {
        to.inspection = (page().*open)(to.file, context);
        to.inspection->file = to.file;
    });
}

}  // namespace

extern "C" {

/// A context of WebGL 2 is current from now on. @returns "" or why it cannot be used
EMSCRIPTEN_KEEPALIVE const char* rl_start_gl() {
    return checked([](Context&) { page().start_gl(); });
}
EMSCRIPTEN_KEEPALIVE void rl_end_gl() { page().end_gl(); }
EMSCRIPTEN_KEEPALIVE const char* rl_renderer() { return (answer() = page().renderer()).c_str(); }

EMSCRIPTEN_KEEPALIVE const char* rl_open(const char* file) { return inspected(file, &Page::open); }
EMSCRIPTEN_KEEPALIVE const char* rl_open_fixed(const char* file) { return inspected(file, &Page::open_fixed); }

/// The same model by the settings of now.
EMSCRIPTEN_KEEPALIVE const char* rl_examine() {
    return reported(InspectionRow(), [&](InspectionRow& to, Context& context) {
        to.inspection = page().examine_again(context);
        to.file = to.inspection->file;
    });
}

EMSCRIPTEN_KEEPALIVE const char* rl_smooth(const char* output) {
    return reported(SmoothedFileRow(), [&](SmoothedFileRow& row, Context& context) {
        row.result = page().smooth(output, context);
        row.file = row.result->file;
    });
}

/// @param half  0 left, 1 right  @param version  0 the model, 1 its fixed version  @param channel  a word or ""
EMSCRIPTEN_KEEPALIVE const char* rl_set(int half, int version, const char* channel, const char* settings) {
    return checked([&](Context&) { page().set(half != 0, Version(version != 0), channel, settings_of(settings)); });
}

/// @param line  [px] where the right half begins  @param marks  bits: 1 seams, 2 hard edges
EMSCRIPTEN_KEEPALIVE const char* rl_draw(int width, int height, int line, int marks, int is_moving) {
    return checked([&](Context& context) {
        is_coarse = false;
        is_coarse = !page().draw(width, height, line, {(marks & 1) != 0, (marks & 2) != 0}, is_moving != 0, context);
    });
}
EMSCRIPTEN_KEEPALIVE int rl_is_coarse() { return is_coarse; }
/// The picture without OpenGL: sRGB codes, rows from the top.
EMSCRIPTEN_KEEPALIVE const void* rl_soft_picture() { return page().soft_picture().codes.data(); }
EMSCRIPTEN_KEEPALIVE int rl_soft_width() { return page().soft_picture().width; }
EMSCRIPTEN_KEEPALIVE int rl_soft_height() { return page().soft_picture().height; }

EMSCRIPTEN_KEEPALIVE const char* rl_turn(double dx, double dy) {
    return checked([&](Context&) { page().turn(dx, dy); });
}
EMSCRIPTEN_KEEPALIVE const char* rl_pan(double dx, double dy) {
    return checked([&](Context&) { page().pan(dx, dy); });
}
EMSCRIPTEN_KEEPALIVE const char* rl_dolly(double factor) {
    return checked([&](Context&) { page().dolly(factor); });
}
EMSCRIPTEN_KEEPALIVE const char* rl_show_whole() {
    return checked([](Context&) { page().show_whole(); });
}
EMSCRIPTEN_KEEPALIVE const char* rl_fly_to_border(int border) {
    return checked([&](Context&) { page().fly_to_border(std::size_t(border)); });
}
/// @param share  0..1 of the way to that border
EMSCRIPTEN_KEEPALIVE const char* rl_fly(double share) {
    return checked([&](Context&) { page().fly(share); });
}
EMSCRIPTEN_KEEPALIVE const char* rl_end_raking_light() {
    return checked([](Context&) { page().end_raking_light(); });
}

/// The color of a seam in the heat map, 0xRRGGBB.
EMSCRIPTEN_KEEPALIVE int rl_heat_color(double degrees) {
    const SeamLine seam{.deg_a = float(degrees), .deg_b = float(degrees)};
    const vec4 c = viewer::seam_lines({&seam, 1})[0].color;
    const auto code = [](float v) { return int(v * 255 + 0.5f); };
    return code(c.x) << 16 | code(c.y) << 8 | code(c.z);
}

/// @param width,height  [px] of the picture  @param x,y  [px] in it
EMSCRIPTEN_KEEPALIVE const char* rl_explain(int half, int width, int height, int x, int y) {
    explained.reset();
    return reported(ExplainRow{.x = x, .y = y}, [&](ExplainRow& row, Context& context) {
        row.pixel = explained = page().explain(half != 0, width, height, x, y, context);
    });
}
/// The same pixel as text; "" where rl_explain() reported an error.
EMSCRIPTEN_KEEPALIVE const char* rl_explain_text() {
    return (answer() = explained ? to_text(*explained) : std::string()).c_str();
}

}  // extern "C"
