#include "compiler/commands/view/hidden_by_land.h"

#include "compiler/surroundings/curvature.h"

namespace citykiln::commands {
namespace {

bool is_below_land(const scene::Header& header, Vec3 p) {
  const double drop_m = surroundings::drop_m(surroundings::away_m(header.extent, in_plan(p)));
  return p.z < surroundings::height_m_at(header.around, in_plan(p)) - drop_m;
}

}  // namespace

bool is_hidden_by_land(const scene::Header& header, const Box2& tiles, Vec3 eye, Vec3 look) {
  // finer than what is seen at the narrowest ridge of the grid, for views of some kilometres
  constexpr int kSteps = 512;
  if (header.around.is_empty() || tiles.contains(in_plan(eye))) return false;
  if (!tiles.contains(in_plan(look))) return is_below_land(header, eye);
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3 p = eye + (look - eye) * (static_cast<double>(i) / kSteps);
    if (tiles.contains(in_plan(p))) return false;
    if (is_below_land(header, p)) return true;
  }
  return false;
}

}  // namespace citykiln::commands
