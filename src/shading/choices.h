// SPDX-License-Identifier: Apache-2.0
// What is chosen for a material once, for every engine: its lighting model and form, what its bumps do, which of its sides
// are shown. Conversions to the numbers of the lighting text.
#pragma once
#include <rakelight/engines/engine.h>

#include "shading/text_numbers.h"

namespace rakelight::shading {

/// What a material is lit by: its own model, else the picture's; never automatic.
Lighting lighting_of(const Material& material, Lighting wanted);
BumpTerms bump_terms_of(const Material& material, BumpTerms wanted);

ReflectionModel reflection_model(Lighting lighting);  ///< @param lighting  not automatic
ReflectionForm reflection_form(SpecularForm form);    ///< @param form  not automatic
WardNumber ward_number(WardForm form);
ReliefTechnique relief_technique(Bump bump);  ///< relief_none where no height map is read
BumpTermsNumber bump_terms_number(BumpTerms terms);
TangentSpaceNumber tangent_space_number(TangentSpace space);
FogNumber fog_number(FogKind kind);

/// The form of Ward's model that a material is lit by: its own, else the picture's.
WardForm ward_form_of(const Material& material, WardForm wanted);

/// Formats that say nothing about sides show both, as double-sided materials are.
bool is_two_sided(const Material& material);

/// The sides of a surface that are left out.
struct CulledSides {
    bool back = false, front = false;
};
CulledSides culled_sides(Cull cull, bool is_two_sided);

}  // namespace rakelight::shading
