#include "compiler/map/lane_tags.h"

#include <algorithm>

#include "compiler/map/tag_values.h"

namespace citykiln::map {

std::string_view LaneTags::roadside(Flow flow) const {
  return (flow == Flow::kForward) == (side == DrivingSide::kRight) ? "right" : "left";
}

std::string_view LaneTags::beside(Flow flow, std::string_view key, std::string_view suffix) const {
  for (const std::string_view where : {roadside(flow), std::string_view("both")}) {
    std::string full(key);
    full.append(":").append(where).append(suffix);
    if (const std::string_view value = (*this)(full); !value.empty()) return value;
  }
  return {};
}

std::string_view LaneTags::along(Flow flow, const std::string& key) const {
  const std::string_view directed = (*this)(key + std::string(suffix(flow)));
  if (!directed.empty() || !is_one_way() || flow != only_flow()) return directed;
  return (*this)(key);
}

std::vector<std::string_view> LaneTags::list_along(Flow flow, const std::string& key) const {
  std::string_view text = along(flow, key);
  if (text.empty()) return {};
  std::vector<std::string_view> entries;
  for (std::size_t bar = text.find('|'); bar != std::string_view::npos; bar = text.find('|')) {
    entries.push_back(text.substr(0, bar));
    text.remove_prefix(bar + 1);
  }
  entries.push_back(text);
  // written left to right as the driver sees them: who drives on the left has the road's middle on the right
  if (side == DrivingSide::kLeft) std::reverse(entries.begin(), entries.end());
  return entries;
}

std::optional<double> LaneTags::count(const std::string& key, double least) const {
  const std::string_view text = (*this)(key);
  if (text.empty()) return std::nullopt;
  const auto number = number_of(text);
  if (number && *number >= least && *number <= kMostLanes) return number;
  add_bad_value();
  return std::nullopt;
}

std::optional<double> LaneTags::width_beside(Flow flow, std::string_view key) const {
  const std::string_view text = beside(flow, key, ":width");
  if (text.empty()) return std::nullopt;
  const auto length = length_m_of(text);
  if (length && *length >= 0.1 && *length <= 20) return length;
  add_bad_value();
  return std::nullopt;
}

Traffic traffic_of(const LaneTags& tags) {
  const std::string_view oneway = tags("oneway"), junction = tags("junction"), highway = tags("highway");
  if (oneway == "-1" || oneway == "reverse") return Traffic::kBackward;
  if (oneway == "reversible" || oneway == "alternating") return Traffic::kInTurns;
  if (!oneway.empty()) return says_yes(oneway) ? Traffic::kForward : Traffic::kTwoWay;
  const bool is_implied =
      junction == "roundabout" || junction == "circular" || highway == "motorway" || highway == "motorway_link";
  return is_implied ? Traffic::kForward : Traffic::kTwoWay;
}

}  // namespace citykiln::map
