// SPDX-License-Identifier: Apache-2.0
// What several panels are made of.
#pragma once
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <rakelight/scene/words.h>

namespace rakelight::viewer {

inline ImVec4 color(vec3 c) { return {c.x, c.y, c.z, 1}; }

/// A choice by the words of the command line. True: it was changed.
template <class T, std::size_t n>
bool choose(const char* label, const Word<T> (&words)[n], T& value) {
    const char* now = "?";
    for (const Word<T>& word : words)
        if (word.value == value) now = word.name;
    bool is_changed = false;
    if (!ImGui::BeginCombo(label, now)) return false;
    for (const Word<T>& word : words) {
        if (!ImGui::Selectable(word.name, word.value == value)) continue;
        value = word.value;
        is_changed = true;
    }
    ImGui::EndCombo();
    return is_changed;
}

/// A number between limits; typed ones (Ctrl+click) are kept within them, too.
inline bool slide(const char* label, float& value, float low, float high, const char* format = "%.3f",
                  bool is_logarithmic = false) {
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    return ImGui::SliderFloat(label, &value, low, high, format, flags);
}
inline bool slide(const char* label, double& value, double low, double high, const char* format = "%.3f",
                  bool is_logarithmic = false) {
    float single = float(value);
    if (!slide(label, single, float(low), float(high), format, is_logarithmic)) return false;
    value = std::clamp(double(single), low, high);
    return true;
}
inline bool slide(const char* label, int& value, int low, int high, bool is_logarithmic = false) {
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    return ImGui::SliderInt(label, &value, low, high, "%d", flags);
}

/// Linear light, shown as a color of the display; values above 1 stay possible.
inline bool edit_light_color(const char* label, vec3& c) {
    return ImGui::ColorEdit3(label, &c.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
}

inline bool edit_place(const char* label, dvec3& p, double step) {
    dvec3 shown = p;
    for (std::size_t c = 0; c < 3; ++c)
        if (std::fabs(shown[c]) < 1e-6 * step) shown[c] = 0;  // what rounding has left
    if (!ImGui::DragScalarN(label, ImGuiDataType_Double, &shown.x, 3, float(step), nullptr, nullptr, "%.4g"))
        return false;
    p = shown;
    return true;
}

}  // namespace rakelight::viewer
