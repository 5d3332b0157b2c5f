// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/normal_rule.h"

namespace rakelight {

double own_crease_angle(const Mesh& mesh) {
    return mesh.normal_choice ? mesh.normal_choice->crease_angle_rad.value_or(-1) : -1;
}

NormalRule normal_rule(const Scene& scene, const Mesh& mesh, NormalSource source) {
    NormalRule rule;
    bool missing_are_flat = scene.missing_normals_are_flat;
    if (source == NormalSource::automatic && mesh.normal_choice) {
        source = mesh.normal_choice->source;
        missing_are_flat = mesh.normal_choice->missing_are_flat;
        rule.crease_angle_rad = own_crease_angle(mesh);
    }
    rule.joins_seams = source == NormalSource::seams;
    rule.keeps_given = rule.joins_seams || source == NormalSource::automatic || source == NormalSource::file;
    switch (source) {
        case NormalSource::automatic:
            rule.scope = missing_are_flat ? Scope::face : Scope::model;
            rule.groups = !missing_are_flat;
            break;
        case NormalSource::file:
        case NormalSource::flat:
            rule.scope = Scope::face;
            break;
        case NormalSource::object:
            rule.scope = Scope::object;
            break;
        case NormalSource::model:
            rule.scope = Scope::model;
            break;
        case NormalSource::seams:
            rule.scope = Scope::model;
            rule.groups = true;
            break;
    }
    return rule;
}

}  // namespace rakelight
