// SPDX-License-Identifier: Apache-2.0
// Meshes that the engine gl poses by transform feedback, beside those that the processor poses.
#include <rakelight/load.h>
#include <rakelight/motion.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include "engines/opengl/headless.h"
#include "engines/opengl/renderer.h"
#include "engines/posing_engine.h"
#include "engines/raster/raster_engine.h"
#include "geometry/mesh_pose.h"
#include "scene/scene_tools.h"
#include "support/scene_builder.h"
#include "support/shared.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using geometry::MeshPose, geometry::MeshPoses, geometry::PosedArrays;
using test::EnvironmentVariable;

}  // namespace
}  // namespace rakelight
