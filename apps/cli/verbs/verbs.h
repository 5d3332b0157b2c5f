// SPDX-License-Identifier: Apache-2.0
// The commands of the program, a file each (render_verb.cpp, ...): what it takes, and its run, which returns the exit code.
#pragma once
#include "../run.h"

namespace rakelight::cli {

/// Pictures of models.
Command render_command();
int run_render(const Run& run);

/// What is in models.
Command inspect_command();
int run_inspect(const Run& run);

/// Models rewritten with seam-free normals and tangents.
Command smooth_command();
int run_smooth(const Run& run);

/// Models written in another format.
Command convert_command();
int run_convert(const Run& run);

/// The speed of the program itself.
Command bench_command();
int run_bench(const Run& run);

/// Why a pixel has its color.
Command explain_command();
int run_explain(const Run& run);

/// The stages of the pipeline for a model, as a page.
Command stages_command();
int run_stages(const Run& run);

/// How much pictures differ, of files or as engines draw them.
Command compare_command();
int run_compare(const Run& run);

/// Whether scene files load, and what they contain.
Command check_command();
int run_check(const Run& run);

/// Windows of one picture joined to the whole.
Command join_windows_command();
int run_join_windows(const Run& run);

/// A detailed model as maps for a simple one.
Command bake_command();
int run_bake(const Run& run);

/// Models with their diffuse global illumination.
Command radiosity_command();
int run_radiosity(const Run& run);

/// The small picture of a model for file managers.
Command thumbnail_command();
int run_thumbnail(const Run& run);

}  // namespace rakelight::cli
