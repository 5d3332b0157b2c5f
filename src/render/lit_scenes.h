// SPDX-License-Identifier: Apache-2.0
// Scenes lit by radiosity, for the method of that name: computed once for a scene and its lights, independent of the
// viewpoint.
#pragma once
#include <rakelight/radiosity/radiosity.h>

#include "render/prepared_scene.h"

namespace rakelight {

/// with_radiosity(), with its result as a note in the report.
/// @param posed  with the lights of the picture
Scene lit_by_radiosity(Scene posed, const RadiositySettings& settings, RadiosityReport& report, Context& context);
/// The same for a prepared scene. @param lights  as in Shot
std::shared_ptr<PreparedScene> lit_by_radiosity(const PreparedScene& prepared,
                                                const std::optional<std::vector<Light>>& lights,
                                                const RadiositySettings& settings, Context& context);

/// The result of a solution, as a note.
void add_note(const RadiosityReport& solution, const std::string& file, Report& report);

/// The last one that was lit is kept.
class LitScenes {
public:
    /// @param lights  as in Shot
    std::shared_ptr<const PreparedScene> of(const std::shared_ptr<const PreparedScene>& prepared,
                                            const std::optional<std::vector<Light>>& lights,
                                            const RadiositySettings& settings, Context& context);

private:
    std::shared_ptr<const PreparedScene> prepared_, lit_;
    std::optional<std::vector<Light>> lights_;
    std::vector<Light> own_lights_;  ///< of `prepared_` when it was lit: owners may change them
    RadiositySettings settings_;
};

}  // namespace rakelight
