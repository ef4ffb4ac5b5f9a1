#include "compiler/geometry/snap.h"
#include "compiler/plants/placing/placing_steps.h"

namespace citykiln::plants {

void place_hedge(PlacedPlants& placed, const HedgeLine& hedge, const PlacingContext& context) {
  if (length_m(hedge.axis) <= 0 || hedge.height_m <= 0) return;
  std::vector<Vec2> ends = spaced_along(hedge.axis, hedge.height_m);
  if (hedge.axis.front() == hedge.axis.back()) ends.push_back(ends.front());
  for (std::uint32_t piece = 1; piece < ends.size(); ++piece) {
    const Vec2 from = ends[piece - 1], to = ends[piece], middle = snapped((from + to) * 0.5);
    if (from == to || !context.box.contains_half_open(middle)) continue;
    const RandomSequence draw(context.seed, stable_id(stable_id(ObjectId{hedge.feature, 0}), "piece", piece), "hedge");
    place_plant_along(placed, context, Species::kHedge, middle, hedge.height_m, unit(to - from), draw, hedge.feature);
  }
}

}  // namespace citykiln::plants
