// Railings: rails between posts.
#pragma once

#include <span>

#include "compiler/structures/loft.h"

namespace citykiln::structures {

/// How a tolerance sees a railing.
enum class RailingForm { kPosts, kPanel, kNone };

struct RailingDetail {
  RailingForm form{};
  double error_m = 0;  ///< Against posts and rails.
};
/// @param high_m  From its foot to its top.
RailingDetail railing_detail(double high_m, double tolerance_m);

/// Adds a railing along ribs. Every post and rail is closed, and so is the panel.
/// @param left_m           Of its middle, from the axis.
/// @param from_m, to_m     Of its foot and its top, above the road.
void add_railing(std::span<const Rib> ribs, double left_m, double from_m, double to_m, RailingForm form, Mesh& mesh);

}  // namespace citykiln::structures
