// SPDX-License-Identifier: Apache-2.0
// A default up vector for views parallel to the given up vector.
#pragma once
#include <string>

#include <rakelight/math/vector.h>

namespace rakelight {

/// Whether `up` is parallel to the view within 1e-6 rad, so that look_at() would use an arbitrary one.
bool is_along(dvec3 up, dvec3 view);

struct NamedUp {
    dvec3 up;
    std::string name;  ///< "+Y"
};
/// +Y; -Z for a view straight down, as from the top, and +Z for one straight up, as from the bottom.
NamedUp default_up(dvec3 view);

}  // namespace rakelight
