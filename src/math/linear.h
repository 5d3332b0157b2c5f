// SPDX-License-Identifier: Apache-2.0
// The public arithmetic, under the name that the modules know.
#pragma once
#include <rakelight/linear.h>
