// SPDX-License-Identifier: Apache-2.0
// The whole library in one include. Headers for the project's own programs are in rakelight/tools/.
// Reading order: render.h (the facade), load.h, scene.h (the data), engine.h (settings, frame), session.h (many
// pictures), request.h and picture.h (files, worlds, cameras), linear.h, scene_queries.h.
#pragma once
#include <rakelight/attributes.h>
#include <rakelight/bake.h>
#include <rakelight/block.h>
#include <rakelight/camera_chooser.h>
#include <rakelight/compare.h>
#include <rakelight/context.h>
#include <rakelight/convert_file.h>
#include <rakelight/creases.h>
#include <rakelight/engine.h>
#include <rakelight/error.h>
#include <rakelight/explain.h>
#include <rakelight/image.h>
#include <rakelight/image_sources.h>
#include <rakelight/inspect.h>
#include <rakelight/interleaved.h>
#include <rakelight/light_limits.h>
#include <rakelight/linear.h>
#include <rakelight/load.h>
#include <rakelight/matching_borders.h>
#include <rakelight/movie.h>
#include <rakelight/picture.h>
#include <rakelight/prepare.h>
#include <rakelight/render.h>
#include <rakelight/report.h>
#include <rakelight/request.h>
#include <rakelight/scene.h>
#include <rakelight/scene_queries.h>
#include <rakelight/seams.h>
#include <rakelight/sequence.h>
#include <rakelight/session.h>
#include <rakelight/smooth_file.h>
#include <rakelight/stages.h>
#include <rakelight/validate.h>
#include <rakelight/vector.h>
#include <rakelight/version.h>
#include <rakelight/world.h>
