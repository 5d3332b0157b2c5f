// SPDX-License-Identifier: Apache-2.0
// Forwards to the public arithmetic.
#pragma once
#include <rakelight/math/linear.h>
