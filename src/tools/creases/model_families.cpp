// SPDX-License-Identifier: Apache-2.0
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// In the order of the models: the models of cut_models are made of those before.
constexpr const ModelFamily* all_families[] = {
    &prism_models, &revolved_models, &extruded_models, &box_models,      &machine_part_models, &freeform_models,
    &cut_models,   &holdout_parts,   &holdout_turned,  &holdout_objects, &holdout_buildings,
};

}  // namespace

CreaseModels crease_models() {
    CreaseModels models;
    for (const ModelFamily* family : all_families) {
        const std::size_t first = models.size();
        family->add(models);
        for (std::size_t i = first; i < models.size(); ++i) models[i].is_holdout = family->is_holdout;
    }
    return models;
}

}  // namespace rakelight
