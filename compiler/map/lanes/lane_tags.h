// A road's tags as its cross-section asks for them: by direction of traffic and by roadside, whichever side one drives
// on.
//
// The two flows of a road are mirror images. Every lane list here runs from the middle of the road outwards, and the
// roadside of a flow is the one beside its outer lane. So one code serves both flows and both driving sides.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/map/lanes/lanes.h"
#include "compiler/map/read_context.h"

namespace citykiln::map {

enum class Flow : std::uint8_t { kForward, kBackward };  ///< Along the way, and against it.
inline constexpr std::array kFlows = {Flow::kForward, Flow::kBackward};

inline Flow opposite(Flow flow) { return flow == Flow::kForward ? Flow::kBackward : Flow::kForward; }
inline LaneDirection way_of(Flow flow) {
  return flow == Flow::kForward ? LaneDirection::kForward : LaneDirection::kBackward;
}

/// Which flows a road has.
enum class Traffic : std::uint8_t { kTwoWay, kForward, kBackward, kInTurns /* oneway=reversible, alternating */ };

/// A thing of each flow.
template <typename T>
struct PerFlow {
  std::array<T, 2> values{};
  T& operator[](Flow flow) { return values[static_cast<std::size_t>(flow)]; }
  const T& operator[](Flow flow) const { return values[static_cast<std::size_t>(flow)]; }
};

struct LaneTags {
  const ReadContext& context;
  OsmId id;
  source::Range tags;
  DrivingSide side;
  Traffic traffic = Traffic::kTwoWay;

  std::string_view operator()(std::string_view key) const { return context.tag(tags, key); }
  void add_bad_value() const { context.report.add(Code::kBadTagValue, id); }

  bool is_one_way() const { return traffic == Traffic::kForward || traffic == Traffic::kBackward; }
  /// The flow of a one-way road.
  Flow only_flow() const { return traffic == Traffic::kBackward ? Flow::kBackward : Flow::kForward; }
  /// The flow has lanes of its own right: it is not the other one of a one-way road.
  bool has(Flow flow) const { return traffic == Traffic::kTwoWay || (is_one_way() && flow == only_flow()); }

  /// ":forward" or ":backward".
  static std::string_view suffix(Flow flow) { return flow == Flow::kForward ? ":forward" : ":backward"; }
  /// "left" or "right": the roadside of a flow.
  std::string_view roadside(Flow flow) const;
  /// The value of key:<side>suffix, key:both+suffix, whichever comes first; "" where neither is tagged.
  std::string_view beside(Flow flow, std::string_view key, std::string_view suffix = "") const;
  /// The value for lanes of one flow: key+":forward", or key alone on a one-way road of that flow.
  std::string_view along(Flow flow, const std::string& key) const;
  /// A list of one flow's lanes, "a|b|c", from the middle of the road outwards; empty where it is not tagged.
  std::vector<std::string_view> list_along(Flow flow, const std::string& key) const;

  /// A number of lanes, least … kMaxLanes; diagnosed and nothing where it is not one.
  std::optional<double> count(const std::string& key, double least) const;
  /// A width beside the road, 0.1 … 20 m; of verges verge:width too. Not diagnosed here: one value may tell of both
  /// sides.
  std::optional<double> width_beside(Flow flow, std::string_view key) const;
};

/// One way.
inline constexpr int kMaxLanes = 16;
/// Of both directions together; with four cycle lanes and two roadsides of six, 42.
inline constexpr int kMaxLanesOfRoad = 26;

/// What a value of oneway=* says; nothing where nobody knows the word.
std::optional<Traffic> tagged_traffic(std::string_view oneway);
/// What oneway=*, junction=* and the class say. Diagnoses a word of oneway=* that nobody knows.
Traffic traffic_of(const LaneTags& tags);

/// Diagnoses, once each, the widths and buffers of what lies beside the road that cannot be read.
void diagnose_widths_beside(const LaneTags& tags);

}  // namespace citykiln::map
