// Compares colours in tests.
#pragma once

#include <gtest/gtest.h>

#include "preview/rgb.h"

namespace citykiln::preview {

inline void expect_near(const Rgb& a, const Rgb& b, double near = 1e-6) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], near);
}

}  // namespace citykiln::preview
