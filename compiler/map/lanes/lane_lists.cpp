#include "compiler/map/lanes/lane_lists.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

struct TurnRow {
  std::string_view value;
  LaneTurn turn;
};
constexpr TurnRow kTurns[] = {
#define TURN(value, name, bit) {value, name},
#define TURN_ALIAS(value, name) {value, name},
#include "compiler/map/lane_turns.inc"
#undef TURN
#undef TURN_ALIAS
};

using Entries = std::vector<std::string_view>;

// Per direction.
constexpr int kMostCycleLanes = 2;

bool is_reserved(std::string_view value) { return value == "designated" || value == "official"; }

// Each function reads one list into the lanes; false where a word is unknown.
bool mark_cycling(const Entries& entries, std::vector<ListedLane>& lanes) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (is_reserved(entries[i])) lanes[i].kind = LaneKind::kCycle;
  return true;
}

// "yes" reserves a lane only if another lane says "no".
bool mark_buses(const Entries& entries, std::vector<ListedLane>& lanes) {
  const bool yes_reserves = std::find(entries.begin(), entries.end(), "no") != entries.end();
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (is_reserved(entries[i]) || (yes_reserves && entries[i] == "yes")) lanes[i].kind = LaneKind::kBus;
  return true;
}

bool mark_turns(const Entries& entries, std::vector<ListedLane>& lanes) {
  bool is_known = true;
  for (std::size_t i = 0; i < entries.size(); ++i) lanes[i].turns = turns_of(entries[i], is_known);
  return is_known;
}

bool mark_widths(const Entries& entries, std::vector<ListedLane>& lanes) {
  bool is_known = true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].empty()) continue;
    const auto width = length_m_of(entries[i]);
    if (width && *width >= 0.5 && *width <= 20)
      lanes[i].width_m = snapped(*width);
    else
      is_known = false;
  }
  return is_known;
}

struct ListRow {
  const char* key;
  bool (*mark)(const Entries&, std::vector<ListedLane>&);
};
// buses come after bicycles, so a lane reserved for both is a bus lane
constexpr ListRow kLists[] = {{"bicycle:lanes", mark_cycling},
                              {"bus:lanes", mark_buses},
                              {"psv:lanes", mark_buses},
                              {"turn:lanes", mark_turns},
                              {"width:lanes", mark_widths}};

}  // namespace

int LaneList::cycle_count() const {
  return static_cast<int>(
      std::count_if(lanes.begin(), lanes.end(), [](const ListedLane& lane) { return lane.kind == LaneKind::kCycle; }));
}

LaneList listed_lanes(const LaneTags& tags, Flow flow) {
  LaneList list;
  for (const ListRow& row : kLists) {
    const Entries entries = tags.list_along(flow, row.key);
    if (entries.empty()) continue;
    if (list.lanes.empty() && entries.size() <= kMaxLanes) list.lanes.resize(entries.size());
    if (entries.size() != list.lanes.size() || !row.mark(entries, list.lanes))
      tags.add_bad_value(tags.key_along(flow, row.key));
  }
  if (list.cycle_count() <= kMostCycleLanes) return list;
  tags.add_bad_value(tags.key_along(flow, "bicycle:lanes"));
  return {};
}

std::uint16_t turns_of(std::string_view text, bool& is_known) {
  unsigned turns = 0;
  if (text.find('|') != std::string_view::npos) {
    is_known = false;
    return 0;
  }
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto* row = std::find_if(std::begin(kTurns), std::end(kTurns),
                                   [&](const TurnRow& candidate) { return candidate.value == word; });
    if (row != std::end(kTurns))
      turns |= row->turn;
    else if (!word.empty() && word != "none")
      is_known = false;
  }
  return static_cast<std::uint16_t>(turns);
}

}  // namespace citykiln::map
