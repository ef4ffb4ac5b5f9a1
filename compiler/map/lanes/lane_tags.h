// Reads a road's tags by direction of traffic and by side, for both driving sides.
//
// The two flows of a road are mirror images. Every lane list in this folder runs from the middle of the road outwards,
// and the roadside of a flow is the one beside its outer lane. So one implementation serves both flows and both driving
// sides.
#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/map/countries/road_guidelines.h"
#include "compiler/map/lanes/lanes.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// The traffic in one direction: along the way, or against it.
enum class Flow : std::uint8_t { kForward, kBackward };
inline constexpr std::array kFlows = {Flow::kForward, Flow::kBackward};

inline Flow opposite(Flow flow) { return flow == Flow::kForward ? Flow::kBackward : Flow::kForward; }
/// Returns a flow as the direction of a lane (Lane::way).
inline LaneDirection way_of(Flow flow) {
  return flow == Flow::kForward ? LaneDirection::kForward : LaneDirection::kBackward;
}

/// The directions in which a road is used.
enum class Traffic : std::uint8_t { kTwoWay, kForward, kBackward, kInTurns /* oneway=reversible, alternating */ };

/// One value for each flow.
template <typename T>
struct PerFlow {
  std::array<T, 2> values{};
  T& operator[](Flow flow) { return values[static_cast<std::size_t>(flow)]; }
  const T& operator[](Flow flow) const { return values[static_cast<std::size_t>(flow)]; }
};

/// The tags of one way.
struct LaneTags {
  const ReadContext& context;
  OsmId id;
  source::Range tags;
  DrivingSide side;
  RoadGuidelines guidelines = RoadGuidelines::kElsewhere;
  Traffic traffic = Traffic::kTwoWay;

  std::string_view operator()(std::string_view key) const { return context.tag(tags, key); }
  /// Diagnoses the value of a key.
  void add_bad_value(std::string_view key) const { context.report.add_tag(Code::kBadTagValue, id, key, (*this)(key)); }
  /// Diagnoses a tagged number of lanes that contradicts other tags: the first of lanes, lanes:forward, lanes:backward
  /// and lanes:both_ways that is tagged.
  void add_bad_count() const;

  bool is_one_way() const { return traffic == Traffic::kForward || traffic == Traffic::kBackward; }
  /// The flow of a one-way road.
  Flow only_flow() const {
    assert(is_one_way());
    return traffic == Traffic::kBackward ? Flow::kBackward : Flow::kForward;
  }
  /// True if the flow has lanes of its own: both flows of a two-way road, and the flow of a one-way road. False for the
  /// opposite flow of a one-way road, and for both flows of kInTurns, whose traffic shares its lanes.
  bool has(Flow flow) const { return traffic == Traffic::kTwoWay || (is_one_way() && flow == only_flow()); }

  /// Returns ":forward" or ":backward".
  static std::string_view suffix(Flow flow) { return flow == Flow::kForward ? ":forward" : ":backward"; }
  /// Returns the side of the road on which a flow drives: "left" or "right", as seen along the way.
  std::string_view roadside(Flow flow) const;
  /// Returns the value of key:<side><suffix> for the side of a flow, else of key:both<suffix>; "" if neither is tagged.
  ///
  /// @param suffix  The rest of the key with its colon, such as ":width"; "" for none.
  std::string_view beside(Flow flow, std::string_view key, std::string_view suffix = "") const;
  /// The key that applies to the lanes of one flow: key+":forward" or key+":backward"; if that is not tagged and the
  /// road is one-way in this direction, the key alone.
  std::string key_along(Flow flow, const std::string& key) const;
  /// The entries of a list "a|b|c" for one flow's lanes, from the middle of the road outwards; empty if not tagged.
  std::vector<std::string_view> list_along(Flow flow, const std::string& key) const;

  /// A tagged number of lanes, `least` to kMaxLanes; nothing if the key is not tagged. Other values are diagnosed.
  std::optional<double> count(const std::string& key, double least) const;
  /// The tagged width of a lane on the side of a flow, 0.1 to 20 m; for verges also verge:width. Bad values are not
  /// diagnosed here, since one value may apply to both sides (diagnose_widths_beside()).
  std::optional<double> width_beside(Flow flow, std::string_view key) const;
};

/// The most lanes of a flow.
inline constexpr int kMaxLanes = 16;
/// The most lanes of both flows together; with four cycle lanes and two roadsides of six, 42 lanes.
inline constexpr int kMaxLanesOfRoad = 26;

/// Returns the traffic of a value of oneway=*; nothing for unknown values.
std::optional<Traffic> tagged_traffic(std::string_view oneway);
/// Returns the traffic by oneway=*, junction=* and the class. Diagnosed: unknown values of oneway=*.
Traffic traffic_of(const LaneTags& tags);

/// Diagnoses each unreadable width and buffer beside the road once.
void diagnose_widths_beside(const LaneTags& tags);

}  // namespace citykiln::map
