// SPDX-License-Identifier: Apache-2.0
// The whole library in one include. Each folder has the headers of one module.
// Reading order: render/render.h (the facade), world/load.h, scene/scene.h (the data), engines/engine.h (settings, frame),
// render/session.h (many pictures), world/request.h and render/picture.h (files, worlds, cameras), math/linear.h,
// scene/scene_queries.h.
#pragma once
#include <rakelight/bake/bake.h>
#include <rakelight/base/context.h>
#include <rakelight/base/error.h>
#include <rakelight/base/interleaved.h>
#include <rakelight/base/report.h>
#include <rakelight/engines/engine.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/creases.h>
#include <rakelight/geometry/matching_borders.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/image/block.h>
#include <rakelight/image/image.h>
#include <rakelight/io/image_sources.h>
#include <rakelight/io/movie.h>
#include <rakelight/io/world.h>
#include <rakelight/io/world_words.h>
#include <rakelight/math/linear.h>
#include <rakelight/math/vector.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/camera_chooser.h>
#include <rakelight/render/channel_view.h>
#include <rakelight/render/picture.h>
#include <rakelight/render/render.h>
#include <rakelight/render/sequence.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/light_limits.h>
#include <rakelight/scene/motion.h>
#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>
#include <rakelight/tools/compare.h>
#include <rakelight/tools/convert_file.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/smooth_file.h>
#include <rakelight/tools/stages.h>
#include <rakelight/version.h>
#include <rakelight/world/load.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/request.h>
#include <rakelight/world/world_request.h>
