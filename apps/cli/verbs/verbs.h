// SPDX-License-Identifier: Apache-2.0
// The commands of the program, a file each (render_verb.cpp, ...).
#pragma once
#include "../run.h"

namespace rakelight::cli {

struct Verb {
    Command (*command)();    ///< what it takes
    int (*run)(const Run&);  ///< returns the exit code; null: another program does it
};

extern const Verb render_verb;        ///< pictures of models
extern const Verb inspect_verb;       ///< what is in models
extern const Verb smooth_verb;        ///< models rewritten with seam-free normals and tangents
extern const Verb convert_verb;       ///< models written in another format
extern const Verb bench_verb;         ///< the speed of the program itself
extern const Verb explain_verb;       ///< why a pixel has its color
extern const Verb stages_verb;        ///< the stages of the pipeline for a model, as a page
extern const Verb compare_verb;       ///< how much pictures differ, of files or as engines draw them
extern const Verb check_verb;         ///< whether scene files load, and what they contain
extern const Verb join_windows_verb;  ///< windows of one picture joined to the whole
extern const Verb bake_verb;          ///< a detailed model as maps for a simple one
extern const Verb radiosity_verb;     ///< models with their diffuse global illumination
extern const Verb thumbnail_verb;     ///< the small picture of a model for file managers

}  // namespace rakelight::cli
