#include "compiler/buildings/front_lines.h"

#include <string>

#include "compiler/contract/random_sequence.h"

namespace citykiln::buildings {

std::vector<grammars::FrontLine> front_lines(const Building& building, const std::optional<WeekTime>& night,
                                             std::uint64_t seed) {
  const Ring& ring = building.footprint.outer;
  const RandomSequence colours(seed, stable_id(building.id), "front colour");
  std::vector<grammars::FrontLine> lines;
  for (std::uint32_t i = 0; i < building.fronts.size(); ++i) {
    const Front& front = building.fronts[i];
    const map::FrontValues& values = map::values_of(front.kind);
    const Vec2 from = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - from);
    lines.push_back({.from = from + along * front.from_m,
                     .to = from + along * front.to_m,
                     .kind = std::string(values.name),
                     .colour = std::string(values.colours[colours.below(map::kFasciaColours, i)]),
                     .is_lit = night && is_front_lit(building, i, *night, seed)});
  }
  return lines;
}

}  // namespace citykiln::buildings
