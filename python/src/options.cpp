// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <cmath>
#include <string>

#include <rakelight/prepare/prepare.h>
#include <rakelight/world/values.h>

namespace rakelight::python {
namespace {

constexpr Word<Scope> scopes[] = {{"model", Scope::model}, {"object", Scope::object}, {"face", Scope::face}};
constexpr Word<TangentMode> tangent_modes[] = {{"averaged", TangentMode::averaged},
                                               {"published", TangentMode::published},
                                               {"mikktspace", TangentMode::mikktspace},
                                               {"published-no-handedness", TangentMode::published_no_handedness}};

void require(bool is_fine, const char* name, const char* reason) {
    if (!is_fine) throw values::wrong(name, reason);
}

/// Sets a field where the options name it.
template <class T, class Read>
void set(const py::dict& options, const char* name, T& field, const Read& read) {
    if (options.contains(name)) field = read(options[name]);
}

template <class T, std::size_t n>
void set_word(const py::dict& options, const char* name, const Word<T> (&words)[n], T& field) {
    set(options, name, field,
        [&](const py::object& value) { return values::word(name, py::cast<std::string>(value), words); });
}

}  // namespace

AttributeOptions attribute_options(const py::dict& options) {
    AttributeOptions out;
    set_word(options, "scope", scopes, out.scope);
    set_word(options, "weight", corner_weight_words, out.weight);
    set_word(options, "crease", creasing_words, out.creases);
    set_word(options, "tangent_mode", tangent_modes, out.tangent_mode);
    const auto number = [](const py::object& value) { return py::cast<double>(value); };
    set(options, "crease_angle_rad", out.crease_angle_rad, number);
    require(out.crease_angle_rad >= 0 && out.crease_angle_rad <= pi, "crease_angle", "must be 0 to 180 degrees");
    set(options, "weld_distance", out.weld_distance, number);
    require(std::isfinite(out.weld_distance), "weld_distance", "must be 0 or more");
    const auto flag = [](const py::object& value) { return py::cast<bool>(value); };
    set(options, "tangents", out.tangents, flag);
    set(options, "normals", out.normals, flag);
    return out;
}

}  // namespace rakelight::python
