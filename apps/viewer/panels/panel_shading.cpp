// SPDX-License-Identifier: Apache-2.0
// Engine, shading frequency, lighting model, bump technique, channels, lines, tone; every setting by its name.
#include <imgui.h>
// clang-format off: it stands on the line above
#include <imgui_stdlib.h>
// clang-format on

#include <cmath>

#include <rakelight/render/picture.h>
#include <rakelight/version.h>

#include "../../common/picture_options.h"
#include "../document/commands.h"
#include "../document/display_path.h"
#include "../document/setting_text.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

/// sRGB code 0..255 by IEC 61966-2-1, for showing alone.
float code_of_linear(float c) {
    c = std::clamp(c, 0.0f, 1.0f);
    return std::round(255 * (c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f));
}

void draw_channels(PanelView& view) {
    static const std::vector<std::string> words = channel_words();
    std::size_t now = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (view.look.channel == 1u << i) now = i + 1;
    if (!ImGui::BeginCombo("channel", now == 0 ? "colors" : words[now - 1].c_str())) return;
    if (ImGui::Selectable("colors", now == 0)) view.look.channel = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (ImGui::Selectable(words[i].c_str(), now == i + 1)) view.look.channel = 1u << i;
    ImGui::EndCombo();
}

void draw_bumps(PictureRequest& r) {
    RenderSettings& s = r.settings;
    choose("bump", bump_words, s.bump);
    constexpr Word<BumpTerms> terms[] = {{"auto", BumpTerms::automatic},
                                         {"both", BumpTerms::both},
                                         {"diffuse", BumpTerms::diffuse},
                                         {"specular", BumpTerms::specular}};
    choose("bump terms", terms, s.bump_terms);
    slide("depth", s.relief.depth, 0, 0.5f);
    slide("bias", s.relief.bias, 0, 1);
    choose("height maps contain", polarity_words, s.relief.holds_depth);
    slide("min layers", s.relief.min_steps, 1, 128);
    slide("max layers", s.relief.max_steps, 1, 256);
    s.relief.max_steps = std::max(s.relief.max_steps, s.relief.min_steps);
    slide("bisections", s.relief.refinement_steps, 0, 32);
    ImGui::Checkbox("self-shadow", &s.relief.self_shadow);
    ImGui::SameLine();
    ImGui::Checkbox("silhouette", &s.relief.limit_silhouette);
    float scale = float(r.materials.normal_scale.value_or(1));
    if (slide("normal map scale", scale, 0, 4)) r.materials.normal_scale = double(scale);
}

/// In codes of the display: only such colors are written as texts that are read as the same.
void edit_background(vec4& background) {
    float shown[3];
    for (std::size_t i = 0; i < 3; ++i) shown[i] = code_of_linear(background[i]) / 255.0f;
    if (!ImGui::ColorEdit3("background", shown)) return;
    const auto code = [&](int i) { return std::round(shown[i] * 255) / 255; };
    const vec3 linear = linear_from_srgb({code(0), code(1), code(2)});
    background = {linear.x, linear.y, linear.z, background.w};
}

void draw_lines(RenderSettings& s) {
    ImGui::Checkbox("surfaces", &s.surfaces);
    ImGui::SameLine();
    ImGui::Checkbox("edges", &s.edges);
    ImGui::SameLine();
    bool has_points = s.points != PointShape::none;
    if (ImGui::Checkbox("vertices", &has_points)) s.points = has_points ? PointShape::disc : PointShape::none;
    slide("line width", s.line_width, 0.5f, 16, "%.1f px");
    slide("point size", s.point_size, 1, 32, "%.1f px");
}

/// The values of the uniforms that GLSL files declare.
void draw_uniforms(RenderSettings& s) {
    std::vector<DeclaredUniform> all;
    try {
        all = declared_uniforms(s);
    } catch (const Error&) {
        return;  // the picture says why
    }
    for (DeclaredUniform& u : all) {
        std::vector<float>& values = u.uniform.values;
        const float step = u.is_integer ? 1.0f : 0.01f;
        const bool is_moved =
            ImGui::DragScalarN(u.uniform.name.c_str(), ImGuiDataType_Float, values.data(), int(values.size()), step,
                               nullptr, nullptr, u.is_integer ? "%.0f" : "%.3f");
        if (!is_moved) continue;
        for (float& value : values) value = u.is_integer ? std::round(value) : value;
        std::erase_if(s.uniforms, [&](const ShaderUniform& old) { return old.name == u.uniform.name; });
        s.uniforms.push_back(u.uniform);
    }
}

void draw_rays(Look& look) {
    PictureRequest& r = look.request;
    constexpr Word<RayMethod> words[] = {{"whitted", RayMethod::automatic},
                                         {"cast", RayMethod::cast},
                                         {"path", RayMethod::path},
                                         {"radiosity", RayMethod::radiosity}};
    RayMethod method = r.settings.method == RayMethod::whitted ? RayMethod::automatic : r.settings.method;
    if (choose("rays", words, method)) choose_method(method, look);
    slide("reflections", r.settings.max_depth, 0, 64);
    if (method == RayMethod::path) ImGui::Checkbox("denoise", &r.settings.paths.denoise);
}

void draw_setting(PanelView& view, const apps::Option& option) {
    static std::string edited, text;  // of the one field that has the keyboard
    const std::string now = setting_text(view.look.request, option.name);
    std::string shown = edited == option.name ? text : now;
    const bool is_entered = ImGui::InputText(option.name, &shown, ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemActive()) edited = option.name, text = shown;
    if (!ImGui::IsItemActive() && edited == option.name) edited.clear();
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(400 * view.scale);
        ImGui::TextUnformatted(option.help);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (is_entered && shown != now) try {
            set_setting(view.look, option.name, shown);
            view.ui.message.clear();
        } catch (const Error& error) {
            view.ui.message.fail(with_short_paths(error.what()));
        }
}

/// Whether a setting has no field here. The window decides the view, the picture's size and its files; lights have a
/// panel of their own.
bool is_left_out(const std::string& name) {
    constexpr const char* names[] = {"resolution", "window", "channels", "channel-files",
                                     "exr-colors", "light",  "material"};
    return std::ranges::find(names, name) != std::end(names);
}

/// Every setting of pictures by its key, as the command line has it, with a field each.
void draw_all_settings(PanelView& view) {
    static const std::vector<apps::Option> options = apps::picture_options();
    ImGui::InputTextWithHint("##filter", "filter", &view.ui.option_filter);
    for (const apps::Option& option : options) {
        const std::string name = option.name, group = option.group;
        if (is_left_out(name) || group == "Camera" || name.find(view.ui.option_filter) == std::string::npos) continue;
        draw_setting(view, option);
    }
}

}  // namespace

void draw_shading_panel(PanelView& view) {
    PictureRequest& r = view.look.request;
    RenderSettings& s = r.settings;
    if (ImGui::BeginCombo("engine", r.engine.c_str())) {
        for (const std::string& name : build_info().engines)
            if (ImGui::Selectable(name.c_str(), name == r.engine)) choose_engine(name, view.look);
        ImGui::EndCombo();
    }
    draw_channels(view);
    if (choose("shading", shading_words, s.shading)) s.material_shading = false, s.shading_rules.clear();
    if (choose("lighting", lighting_words, s.lighting))
        s.lighting_name.clear(), s.lighting_text.clear(), s.uniforms.clear();
    if (!s.lighting_name.empty())
        ImGui::TextWrapped("replaced by: %s", one_line(display_path(s.lighting_name), 100).c_str());
    if (!s.vertex_name.empty())
        ImGui::TextWrapped("vertex shader: %s", one_line(display_path(s.vertex_name), 100).c_str());
    draw_uniforms(s);
    choose("specular", specular_form_words, s.specular_form);
    constexpr Word<int> sample_words[] = {{"1", 1}, {"4", 4}, {"8", 8}};
    if (r.engine == "trace") draw_rays(view.look);
    if (s.method == RayMethod::path)
        slide("paths per pixel", s.samples, 1, max_paths_per_pixel, true);
    else
        choose("samples", sample_words, s.samples);
    slide("anisotropy", s.anisotropy, 1, 16);
    if (r.engine == "soft" || r.engine == "auto") ImGui::Checkbox("ambient occlusion", &s.ambient_occlusion);
    constexpr Word<Cull> cull_words[] = {
        {"auto", Cull::automatic}, {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}};
    choose("culling", cull_words, s.cull);
    choose("tone mapping", tone_mapping_words, r.tone.mapping);
    slide("exposure", r.tone.exposure_ev, -8, 8, "%.2f EV");
    edit_background(s.background);
    if (ImGui::TreeNode("Bump mapping")) draw_bumps(r), ImGui::TreePop();
    if (ImGui::TreeNode("Wireframe and vertices")) draw_lines(s), ImGui::TreePop();
    if (ImGui::TreeNode("All settings")) draw_all_settings(view), ImGui::TreePop();
}

}  // namespace rakelight::viewer
