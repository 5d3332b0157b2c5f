// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "render/check_request.h"

namespace rakelight {

void warn_of_unknown_names(const Scene& scene, const RenderSettings& settings, Report& report) {
    const auto has = [](const auto& named, const std::string& name) {
        return std::any_of(named.begin(), named.end(), [&](const auto& one) { return one.name == name; });
    };
    for (const ShadingRule& rule : settings.shading_rules) {
        const bool is_object = rule.of == ShadingRule::Of::object;
        if (is_object ? has(scene.nodes, rule.name) : has(scene.materials, rule.name)) continue;
        report.add(Remark::warning, scene.source, {},
                   std::string("no ") + (is_object ? "object" : "material") + " is named '" + one_line(rule.name, 60) +
                       "': its shading is left as it is");
    }
}

}  // namespace rakelight
