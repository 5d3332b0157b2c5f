// SPDX-License-Identifier: Apache-2.0
#include "lighting/albedo_tables.h"

namespace rakelight::lighting {
namespace {

#include "lighting/albedo_tables.inc"
static_assert(sizeof lobe_loss_table == sizeof(float) * albedo_rows * albedo_columns);
static_assert(sizeof grazing_table == sizeof lobe_loss_table);
static_assert(sizeof loss_table == sizeof(float) * albedo_rows);
static_assert(sizeof sheen_table == sizeof(float) * sheen_rows * albedo_columns);

}  // namespace

AlbedoTables albedo_tables() { return {lobe_loss_table, grazing_table, loss_table, sheen_table}; }

}  // namespace rakelight::lighting
