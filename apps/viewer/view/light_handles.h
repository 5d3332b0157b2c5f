// SPDX-License-Identifier: Apache-2.0
// Lights in the picture: how the pointer selects and moves them.
#pragma once
#include <optional>

#include "gizmo.h"
#include "pictures.h"

namespace rakelight::viewer {

/// The handles of lights in the active picture. Pointers are in pixels of the window; `scale` is that of the display.
class LightHandles {
public:
    LightHandles(Pictures& pictures, UiState& ui) : pictures_(pictures), ui_(ui) {}

    /// Whether a light that is displayed, or a handle of the selected one, is under the pointer: that light is selected then.
    bool take(dvec2 pointer, double scale);
    /// Moves the light that was taken.
    void move(dvec2 pointer, double scale);
    /// Highlights the handle that a press would take. @param pointer  none: it is over a panel
    void hover(std::optional<dvec2> pointer, double scale);
    Handle taken() const { return drag_.handle; }
    Handle hovered() const { return hovered_; }

private:
    struct Drag {
        Handle handle = Handle::none;
        Light start;
        dvec2 from;
    };
    GizmoView gizmo_view(double scale) const;
    bool are_displayed() const;
    std::vector<LightItem> displayed_lights() const;
    bool take_glyph(const std::vector<LightItem>& lights, dvec2 pixel, double scale);

    Pictures& pictures_;
    UiState& ui_;
    Drag drag_;
    Handle hovered_ = Handle::none;
};

}  // namespace rakelight::viewer
