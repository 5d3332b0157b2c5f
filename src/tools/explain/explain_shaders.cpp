// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain_shaders.h"

#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>
#include <rakelight/math/linear.h>

#include "tools/explain/explain_values.h"

namespace rakelight {
namespace {

Json list(vec3 v) { return {double(v.x), double(v.y), double(v.z)}; }

}  // namespace

std::string shaded_text(const ShadedPixel& s) {
    std::string text;
    if (!s.vertex.empty())
        text += "\nVertices by " + one_line(s.vertex, 120) + ": what stands above is of the model without it\n";
    text += s.lighting.empty() ? "\nLighting by engine gl\n"
                               : "\nLighting by " + one_line(s.lighting, 120) + ", all lights\n";
    Values sum(4);
    sum.add("ambient", cast<double>(s.ambient));
    sum.add("+ diffuse", cast<double>(s.diffuse));
    sum.add("+ specular", cast<double>(s.specular));
    sum.add("+ emission", cast<double>(s.emission));
    sum.add("= color, alpha", s.color, "of the picture");
    text += sum.text("  ");
    if (s.terms.empty()) return text;
    text += "  Terms that it declares\n";
    TextTable table({"", ">", ">", ">", ">"});
    for (const ShadedPixel::Term& term : s.terms) {
        std::vector<std::string> cells{"light " + digits(term.light) + " " + term.name};
        for (const float v : term.value) cells.push_back(digits(v));
        cells.resize(5);
        table.add(std::move(cells));
    }
    const std::string rows = table.text("    ");
    return text + rows.substr(rows.find('\n') + 1);  // the head is empty
}

Json shaded_json(const ShadedPixel& s) {
    Json out = {{"lighting", s.lighting},     {"vertex_shader", s.vertex},    {"ambient", list(s.ambient)},
                {"diffuse", list(s.diffuse)}, {"specular", list(s.specular)}, {"emission", list(s.emission)},
                {"terms", Json::array()}};
    for (const ShadedPixel::Term& term : s.terms)
        out["terms"].push_back({{"light", term.light}, {"name", term.name}, {"value", term.value}});
    return out;
}

}  // namespace rakelight
