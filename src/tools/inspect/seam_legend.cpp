// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/seam_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "image/draw_text.h"
#include "tools/inspect/inspect_text.h"
#include "tools/inspect/largest_seam.h"

namespace rakelight {
namespace {

constexpr Code black{0, 0, 0}, white{255, 255, 255};
/// The colors between two ticks take the same length.
struct Tick {
    double deg;
    const char* text;
};
constexpr std::array<Tick, 5> ticks = {{{continuous_deg, "0.01"}, {1, "1"}, {5, "5"}, {20, "20"}, {60, "60+"}}};

/// The frame's colors as a picture, and back.
Pixels pixels_of(const Frame& frame) {
    Pixels out{frame.window.width, frame.window.height, 4, Component::f32, true, {}};
    out.bytes.resize(frame.color.size() * sizeof(vec4));
    std::memcpy(out.bytes.data(), frame.color.data(), out.bytes.size());
    return out;
}

class Legend {
public:
    Legend(Pixels& picture, int scale)
        : picture_(picture), scale_(scale), line_((text_dots_down + 2) * scale), margin_(6 * scale) {}

    void draw(const Inspection& i, const std::optional<SeamPlace>& place) {
        const std::string objects = objects_text(i), largest = largest_text(i, place);
        const int bar = std::min(picture_.width - 4 * margin_ - text_width("60+ deg", scale_), 160 * scale_);
        const int bar_height = 6 * scale_, lines = objects.empty() ? 1 : 2;
        int y = picture_.height - margin_ - bar_height - line_ - lines * line_;
        say(margin_, y, largest);
        if (!objects.empty()) say(margin_, y + line_, objects);
        y += lines * line_;
        fill_rectangle(picture_, margin_ - scale_, y - scale_, bar + 2 * scale_, bar_height + 2 * scale_, black);
        for (int x = 0; x < bar; ++x)
            fill_rectangle(picture_, margin_ + x, y, 1, bar_height, code_of_light(heat_color(deg_at(double(x) / bar))));
        for (std::size_t t = 0; t < ticks.size(); ++t) {
            const int at = margin_ + int(std::lround(double(bar) * double(t) / double(ticks.size() - 1)));
            const bool is_last = t + 1 == ticks.size();
            fill_rectangle(picture_, at - (is_last ? scale_ : 0), y, scale_, bar_height + 2 * scale_, white);
            say(t == 0 ? at : at - text_width(ticks[t].text, scale_) / 2, y + bar_height + 3 * scale_,
                ticks[t].text + std::string(is_last ? " degrees" : ""));
        }
    }

    /// A white ring with dark rims; broken in eight where it is hidden.
    void ring(const SeamPlace& place, const std::string& text) {
        const double radius = std::max(8.0, 0.028 * picture_.height), half = 0.75 * scale_ + 0.5;
        const int reach = int(std::ceil(radius + half + scale_));
        const int cx = int(std::floor(place.x)), cy = int(std::floor(place.y));
        for (const bool is_rim : {true, false})
            for (int y = cy - reach; y <= cy + reach; ++y)
                for (int x = cx - reach; x <= cx + reach; ++x) {
                    const double dx = x + 0.5 - place.x, dy = y + 0.5 - place.y;
                    if (std::fabs(std::sqrt(dx * dx + dy * dy) - radius) > half + (is_rim ? scale_ : 0)) continue;
                    if (place.is_hidden && is_in_gap(dx, dy)) continue;
                    fill_rectangle(picture_, x, y, 1, 1, is_rim ? black : white);
                }
        const int width = text_width(text, scale_), side = int(std::lround(radius)) + 4 * scale_;
        const int right = cx + side, left = cx - side - width;
        const int top = std::clamp(cy - line_ / 2, 0, std::max(0, picture_.height - line_));
        say(right + width <= picture_.width || left < 0 ? right : left, top, text);
    }

private:
    /// Every second eighth of the circle, by the signs and the order of the coordinates.
    static bool is_in_gap(double dx, double dy) {
        return ((dx > 0) + (dy > 0) + (std::fabs(dx) > std::fabs(dy))) % 2 == 0;
    }

    static double deg_at(double share) {
        const double at = share * double(ticks.size() - 1);
        const auto below = std::min(std::size_t(at), ticks.size() - 2);
        const double t = at - double(below);
        return ticks[below].deg * (1 - t) + ticks[below + 1].deg * t;
    }

    void say(int x, int y, const std::string& text) {
        draw_text(picture_, x, y, text, {.color = white, .scale = scale_, .halo = black});
    }

    static std::string largest_text(const Inspection& i, const std::optional<SeamPlace>& place) {
        const std::optional<LargestSeam> seam = largest_seam(i);
        if (!seam) return "no seam above 0.01 degrees";
        const char* const where = !place ? " (not in this picture)" : place->is_hidden ? " (behind a surface)" : "";
        return "largest seam " + number(seam->deg, "%.2f") + " degrees" + where;
    }

    static std::string objects_text(const Inspection& i) {
        const std::optional<LargestSeam> seam = largest_seam(i);
        return seam ? between_text(i, *seam) : "";
    }

    Pixels& picture_;
    int scale_, line_, margin_;
};

}  // namespace

void draw_seam_legend(Frame& frame, const Inspection& inspection, const std::optional<SeamPlace>& place) {
    if (frame.window.width < least_legend_width || frame.window.height < least_legend_height) return;
    Pixels picture = pixels_of(frame);
    Legend legend(picture, text_scale_for(frame.window.height));
    const std::optional<LargestSeam> seam = largest_seam(inspection);
    if (seam && place) legend.ring(*place, number(seam->deg, "%.1f"));
    legend.draw(inspection, seam ? place : std::nullopt);
    std::memcpy(frame.color.data(), picture.bytes.data(), picture.bytes.size());
}

}  // namespace rakelight
