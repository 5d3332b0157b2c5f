// SPDX-License-Identifier: Apache-2.0
// The families of models, each with the models that it adds.
#pragma once
#include <vector>

#include "tools/creases/crease_model.h"

namespace rakelight {

using CreaseModels = std::vector<CreaseModel>;

void add_prisms(CreaseModels& to);         ///< nuts, columns, cylinders
void add_revolved(CreaseModels& to);       ///< cones, shafts, bottles, domes
void add_extruded(CreaseModels& to);       ///< fillets, gears, beams, roofs
void add_boxes(CreaseModels& to);          ///< chamfers, tapers, twisted and stacked boxes
void add_machine_parts(CreaseModels& to);  ///< bolts, threads, countersunk holes, rims
void add_freeform(CreaseModels& to);       ///< spheres, blobs, terrain, rocks
void add_cut_models(CreaseModels& to);     ///< models that are there already, as several objects

/// Made by thinking of what drawings and games are full of, without a look at any rule. Rules are not tuned by them.
void add_holdout_parts(CreaseModels& to);
void add_holdout_turned(CreaseModels& to);
void add_holdout_objects(CreaseModels& to);
void add_holdout_buildings(CreaseModels& to);

}  // namespace rakelight
