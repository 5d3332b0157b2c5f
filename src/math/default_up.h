// SPDX-License-Identifier: Apache-2.0
// What is up in a view along which the up that was named says nothing.
#pragma once
#include <string>

#include <rakelight/vector.h>

namespace rakelight {

/// Whether `up` lies along the view, closer than 1e-6 rad, so that look_at() would take any other.
bool is_along(dvec3 up, dvec3 view);

struct NamedUp {
    dvec3 up;
    std::string name;  ///< "+Y"
};
/// +Y; -Z for a view straight down, as from the top, and +Z for one straight up, as from the bottom.
NamedUp default_up(dvec3 view);

}  // namespace rakelight
