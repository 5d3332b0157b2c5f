// SPDX-License-Identifier: Apache-2.0
// The families of models, a file each (boxes.cpp, ...), and all models.
#pragma once
#include <vector>

#include "tools/creases/crease_model.h"

namespace rakelight {

using CreaseModels = std::vector<CreaseModel>;

struct ModelFamily {
    void (*add)(CreaseModels& to);  ///< `to` has the models of the families before it
    /// Made by thinking of what drawings and games are full of, without a look at any rule. Rules are not tuned by them.
    bool is_holdout = false;
};

extern const ModelFamily prism_models;         ///< nuts, columns, cylinders
extern const ModelFamily revolved_models;      ///< cones, shafts, bottles, domes
extern const ModelFamily extruded_models;      ///< fillets, gears, beams, roofs
extern const ModelFamily box_models;           ///< chamfers, tapers, twisted and stacked boxes
extern const ModelFamily machine_part_models;  ///< bolts, threads, countersunk holes, rims
extern const ModelFamily freeform_models;      ///< spheres, blobs, terrain, rocks
extern const ModelFamily cut_models;           ///< models that are there already, as several objects
extern const ModelFamily holdout_parts, holdout_turned, holdout_objects, holdout_buildings;

/// All models: those beside which rules are developed, then the holdout, which nobody tunes a rule by.
CreaseModels crease_models();

}  // namespace rakelight
