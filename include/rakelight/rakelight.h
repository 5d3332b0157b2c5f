// SPDX-License-Identifier: Apache-2.0
// The whole library in one include. Reading order: render.h (the facade), scene.h (the data), engine.h (settings,
// frame).
#pragma once
#include <rakelight/attributes.h>
#include <rakelight/bench.h>
#include <rakelight/block.h>
#include <rakelight/check_scene.h>
#include <rakelight/context.h>
#include <rakelight/current_error.h>
#include <rakelight/engine.h>
#include <rakelight/error.h>
#include <rakelight/explain.h>
#include <rakelight/image.h>
#include <rakelight/inspect.h>
#include <rakelight/light_limits.h>
#include <rakelight/picture.h>
#include <rakelight/prepare.h>
#include <rakelight/render.h>
#include <rakelight/report.h>
#include <rakelight/scene.h>
#include <rakelight/smooth_file.h>
#include <rakelight/stages.h>
#include <rakelight/unfinished_outputs.h>
#include <rakelight/vector.h>
#include <rakelight/version.h>
#include <rakelight/words.h>
#include <rakelight/world.h>
