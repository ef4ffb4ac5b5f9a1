#include "compiler/structures/railing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace citykiln::structures {
namespace {

// Thickness of posts and rails, and the largest distance between posts.
constexpr double kPost_m = 0.0625, kRail_m = 0.0625, kPostsApart_m = 2;
constexpr int kRails = 3;

void add_rail(std::span<const Rib> ribs, double left_m, double top_m, double high_m, Mesh& mesh) {
  const double l = left_m + kRail_m / 2, r = left_m - kRail_m / 2, bottom_m = top_m - high_m;
  add_tube(ribs, {{l, bottom_m}, {l, top_m}, {r, top_m}, {r, bottom_m}}, mesh);
}

void add_post(const Rib& rib, double left_m, double from_m, double to_m, Mesh& mesh) {
  const Vec2 across = unit(rib.out) * (kPost_m / 2), along = left_of(across);
  const Vec2 at = rib.at + rib.out * left_m;
  const double road_m = rib.z_m + rib.tilt * left_m;
  add_box(std::array{at - across - along, at + across - along, at + across + along, at - across + along},
          road_m + from_m, road_m + to_m, mesh);
}

void add_posts(std::span<const Rib> ribs, double left_m, double from_m, double to_m, Mesh& mesh) {
  const double first_m = ribs.front().along_m + kPost_m, long_m = ribs.back().along_m - kPost_m - first_m;
  const int gaps = std::max(1, static_cast<int>(std::ceil(long_m / kPostsApart_m)));
  for (int i = 0; i <= gaps; ++i) add_post(rib_at(ribs, first_m + long_m * i / gaps), left_m, from_m, to_m, mesh);
}

}  // namespace

RailingDetail railing_detail(double high_m, double tolerance_m) {
  assert(high_m > 0 && tolerance_m >= 0);
  // the middle between two rails is half their distance from them
  const double panel_error_m = high_m / kRails / 2 + kRail_m;
  if (tolerance_m < panel_error_m) return {RailingForm::kPosts, 0};
  if (tolerance_m < high_m) return {RailingForm::kPanel, panel_error_m};
  return {RailingForm::kNone, high_m};
}

void add_railing(std::span<const Rib> ribs, double left_m, double from_m, double to_m, RailingForm form, Mesh& mesh) {
  assert(ribs.size() >= 2 && from_m <= to_m);
  if (form == RailingForm::kPanel) add_rail(ribs, left_m, to_m, to_m - from_m, mesh);
  if (form != RailingForm::kPosts) return;
  for (int i = 1; i <= kRails; ++i) add_rail(ribs, left_m, from_m + (to_m - from_m) * i / kRails, kRail_m, mesh);
  add_posts(ribs, left_m, from_m, to_m - kRail_m, mesh);
}

}  // namespace citykiln::structures
