// Patterns written as the cross-sections of compiler/map/lanes/lanes.h: "cddc vv^^", raised where in bars, "|c| |^|".
#pragma once

#include <string>

#include "compiler/roads/markings/pattern.h"

namespace citykiln::roads {

inline map::LaneKind kind_of(char letter) {
  const std::string letters = "dbtcpS/sfrg";
  return static_cast<map::LaneKind>(letters.find(letter));
}

inline map::LaneWay way_of(char letter) {
  return letter == '^' ? map::LaneWay::kForward : letter == 'v' ? map::LaneWay::kBackward : map::LaneWay::kBoth;
}

inline double usual_width_m(map::LaneKind kind) {
  constexpr double kWidths_m[] = {3.25, 3.25, 3, 1.5, 2, 2.5, 0.5, 2, 2, 4, 1.5};
  return kWidths_m[static_cast<int>(kind)];
}

inline Pattern pattern(map::SurfaceClass surface, const std::string& section) {
  Pattern pattern;
  pattern.surface = surface;
  const std::string kinds = section.substr(0, section.find(' ')), ways = section.substr(section.find(' ') + 1);
  const bool is_all_raised = kinds.front() == '|';
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == '|') continue;
    const map::LaneKind kind = kind_of(kinds[i]);
    pattern.lanes.push_back({kind, way_of(ways[i]), usual_width_m(kind), 0, is_all_raised});
  }
  return pattern;
}

}  // namespace citykiln::roads
