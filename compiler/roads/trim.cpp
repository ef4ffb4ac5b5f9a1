#include "compiler/roads/trim.h"

#include <array>

namespace citykiln::roads {

std::vector<Road> trimmed_to(const Road& road, const Box2& box) {
  // a bend's tip lies within 1.42 half widths of its point
  const Box2 reach = box.widened(breadth_m(road));
  std::vector<Road> runs;
  bool continues = false;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const bool touches = box_of(std::array{road.axis[i], road.axis[i + 1]}).touches(reach);
    if (touches && !continues) {
      runs.push_back({road.id,
                      {road.axis[i]},
                      road.surface,
                      road.width_m,
                      i == 0 && road.rounds_start,
                      false,
                      road.pavement_left_m,
                      road.pavement_right_m});
    }
    if (touches) {
      runs.back().axis.push_back(road.axis[i + 1]);
      runs.back().rounds_end = i + 2 == road.axis.size() && road.rounds_end;
    }
    continues = touches;
  }
  return runs;
}

}  // namespace citykiln::roads
