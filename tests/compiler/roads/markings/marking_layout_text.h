// Marking layouts in the notation of compiler/map/cross_section.h: "cddc vv^^". Raised lanes are in bars, "|c| |^|".
#pragma once

#include <string>

#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

inline map::LaneKind kind_of(char letter) {
  const std::string letters = "dbtcpS/sfrg";
  return static_cast<map::LaneKind>(letters.find(letter));
}

inline map::LaneDirection way_of(char letter) {
  return letter == '^'   ? map::LaneDirection::kForward
         : letter == 'v' ? map::LaneDirection::kBackward
                         : map::LaneDirection::kBoth;
}

inline double usual_width_m(map::LaneKind kind) {
  constexpr double kWidths_m[] = {3.25, 3.25, 3, 1.5, 2, 2.5, 0.5, 2, 2, 4, 1.5};
  return kWidths_m[static_cast<int>(kind)];
}

inline MarkingLayout layout(map::LandCoverClass surface, const std::string& section) {
  MarkingLayout layout;
  layout.surface = surface;
  const std::string kinds = section.substr(0, section.find(' ')), ways = section.substr(section.find(' ') + 1);
  const bool is_all_raised = kinds.front() == '|';
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == '|') continue;
    const map::LaneKind kind = kind_of(kinds[i]);
    layout.lanes.push_back({kind, way_of(ways[i]), usual_width_m(kind), 0, is_all_raised});
  }
  return layout;
}

}  // namespace citykiln::roads
