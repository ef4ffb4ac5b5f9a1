#include "compiler/assume/verges.h"

#include <algorithm>

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {
namespace {

struct VergeRow {
  map::CountryGroup country;
  map::LandCoverClass surface;
  double width_m, most_houses;
};
constexpr VergeRow kVergeRows[] = {
#define VERGE(country, surface, width_m, most_houses) \
  {map::CountryGroup::country, map::LandCoverClass::surface, width_m, most_houses},
#include "compiler/assume/verges.inc"
#undef VERGE
};

// Walls this near to the kerb belong to a town, in which the whole width is paved.
constexpr double kGardenRoom_m = 6;

const VergeRow* row_of(const map::Track& track) {
  const auto* row = std::ranges::find_if(kVergeRows, [&](const VergeRow& candidate) {
    return candidate.country == track.country && candidate.surface == track.surface;
  });
  return row == std::end(kVergeRows) ? nullptr : row;
}

// The width of all that is raised on a side; 0 unless the side has nothing but a pavement there.
double pavement_alone_m(const map::Track& track, bool is_left) {
  const std::vector<map::Lane>& lanes = track.section.lanes;
  const map::Lane& outer = is_left ? lanes.front() : lanes.back();
  if (lanes.size() < 2 || outer.kind != map::LaneKind::kSidewalk) return 0;
  return (is_left ? lanes[1] : lanes[lanes.size() - 2]).is_raised ? 0 : outer.width_m;
}

bool may_have_verge(const map::Track& track) {
  if (row_of(track) == nullptr || track.tagged_verges == map::kBothSides) return false;
  if (track.passage != map::Passage::kGround || track.is_rail || track.is_indoor || track.is_link) return false;
  if (track.is_through_building || track.is_transition || track.is_roundabout) return false;
  return pavement_alone_m(track, true) > 0 || pavement_alone_m(track, false) > 0;
}

// Returns the width of the verge that is assumed on a side of a stretch with a pavement of this width; 0 for none.
double assumed_verge_m(const map::Track& stretch, const SideFacts& side, double pavement_m) {
  const VergeRow* row = row_of(stretch);
  if (row == nullptr || side.land != LandUse::kResidential || side.houses > row->most_houses) return 0;
  return side.room_m >= std::max(kGardenRoom_m, pavement_m + row->width_m) ? row->width_m : 0;
}

bool add_verges(const Surroundings& surroundings, map::Track& stretch) {
  if (length_m(stretch.axis) > kLongestWhole_m) return false;
  const BothSides facts = facts_beside(surroundings, stretch);
  bool is_any = false;
  for (const std::uint8_t side : {map::kLeftSide, map::kRightSide}) {
    const bool is_left = side == map::kLeftSide;
    const double pavement_m = pavement_alone_m(stretch, is_left);
    if (pavement_m <= 0 || (stretch.tagged_verges & side) != 0) continue;
    const double width_m = assumed_verge_m(stretch, is_left ? facts.left : facts.right, pavement_m);
    if (width_m <= 0) continue;
    stretch.section = with_verge(std::move(stretch.section), side, width_m);
    stretch.assumed_sides |= side;
    is_any = true;
  }
  return is_any;
}

}  // namespace

bool has_usual_verge(const map::Track& street, double houses) {
  const VergeRow* row = row_of(street);
  return row != nullptr && houses <= row->most_houses;
}

std::vector<map::Track> assume_verges(const map::FeatureView& features, std::span<const map::Track> mapped,
                                      Report& report) {
  const Surroundings surroundings = index_surroundings(features, mapped);
  const CommonNodes common = common_nodes_of(features.tracks);
  const auto cut = [&](const map::Track& track) {
    const bool may_be_cut = may_have_verge(track) && !track.is_piece;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](map::Track& stretch) { return may_have_verge(stretch) && add_verges(surroundings, stretch); };
  return with_changed_stretches(features.tracks, Assumption::kVerges, "verge_track", cut, change, report);
}

}  // namespace citykiln::assume
