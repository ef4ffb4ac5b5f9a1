// Railings: rails between posts.
#pragma once

#include <span>

#include "compiler/structures/loft.h"

namespace citykiln::structures {

enum class RailingForm { kPosts, kPanel, kNone };

struct RailingDetail {
  RailingForm form{};
  double error_m = 0;  ///< Deviation from the form kPosts.
};
/// Returns the coarsest form of a railing within the tolerance.
/// @param high_m  Height from its foot to its top.
RailingDetail railing_detail(double high_m, double tolerance_m);

/// Adds a railing along ribs. Every post, rail and panel is closed.
/// @param left_m        Distance of its middle to the left of the axis.
/// @param from_m, to_m  Height of its foot and its top above the road.
void add_railing(std::span<const Rib> ribs, double left_m, double from_m, double to_m, RailingForm form, Mesh& mesh);

}  // namespace citykiln::structures
