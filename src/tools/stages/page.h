// SPDX-License-Identifier: Apache-2.0
// Stages as a page and as JSON. The page needs no script and nothing from outside of its folder.
#pragma once
#include <string>
#include <vector>

#include "tools/stages/stage.h"

namespace rakelight::stages {

/// One stage's table: {"schema": "rakelight.stages/1", "stage": ..., ...}
std::string table_json(const Stage& stage);
/// A page. @param is_whole  its pictures and tables are in it, else beside it
std::string page(const std::string& model, const std::vector<Stage>& stages, bool is_whole, Context& context);

}  // namespace rakelight::stages
