// SPDX-License-Identifier: Apache-2.0
// What is done with the surface at a pixel. The painter's thread finds it; it is used when the answer comes.
#pragma once
#include "drop.h"
#include "pictures.h"

namespace rakelight::viewer {

// `pictures` and `ui` outlive the answer. Pixels of the active picture, which is open.

/// Selects the material, and opens its panel.
void select_material_at(int x, int y, Pictures& pictures, UiState& ui);
/// The camera looks at the point, and goes around it.
void center_at(int x, int y, Pictures& pictures);
/// Dropped pictures: an environment for the picture at a pixel of the window, a base color texture for the object there.
void use_pictures(const DropPlan& plan, double window_x, double window_y, Pictures& pictures, UiState& ui);

}  // namespace rakelight::viewer
