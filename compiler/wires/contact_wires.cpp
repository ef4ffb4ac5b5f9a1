#include "compiler/wires/contact_wires.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/snap.h"

namespace citykiln::wires {
namespace {

using things::ContactLines;
using things::ContactSupport;
using things::ContactTrack;

constexpr std::uint8_t kContactWire_mm = 7, kMessenger_mm = 6, kCrossWire_mm = 5;
// Ways that bend more than this at a node do not continue each other; nor do ways after this many others.
constexpr double kStraightOn = 0.7;
constexpr int kMostWays = 8;
// A wire across a street sags by this share of its length.
constexpr double kCrossSag = 0.04;
constexpr double kShortestContact_m = 1, kMarginAbove_m = 2, kLandStep_m = 1;
// Walls of cuttings keep off wires by this, since the ground of a coarse level has them a little elsewhere.
constexpr double kBesideWire_m = 1;

Vec3 on_grid(Vec3 p) {
  return {snapped_to(kWireQuantum_m, p.x), snapped_to(kWireQuantum_m, p.y), snapped_to(kWireQuantum_m, p.z)};
}

double on_grid(double sag_m) { return std::floor(sag_m / kWireQuantum_m) * kWireQuantum_m; }

// The greatest height of the wires above the ground, rounded up.
double above_m_of(const std::vector<Wire>& wires, const ground::GradedTerrain& ground) {
  double greatest_m = 0;
  for (const Wire& wire : wires)
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 place = place_on(wire, t);
      greatest_m = std::max(greatest_m, place.z - land_m(ground, in_plan(place)));
    }
  return std::ceil(greatest_m + kMarginAbove_m);
}

// How much lower than kLeastOverTrack_m a wire is above the land, also beside it; 0: nowhere.
double too_low_m(const Wire& wire, const ground::GradedTerrain& ground) {
  const Vec2 along = in_plan(wire.to) - in_plan(wire.from);
  const int steps = std::max(1, static_cast<int>(length(along) / kLandStep_m));
  double largest_m = 0;
  for (int i = 0; i <= steps; ++i)
    for (const double aside_m : {-kBesideWire_m, 0.0, kBesideWire_m}) {
      const Vec3 place = place_on(wire, static_cast<double>(i) / steps);
      const Vec2 below = in_plan(place) + left_of(unit(along)) * aside_m;
      largest_m = std::max(largest_m, kLeastOverTrack_m - (place.z - land_m(ground, below)));
    }
  return largest_m;
}

std::vector<Wire> wires_between(const ContactSupport& a, const ContactSupport& b) {
  const double long_m = distance(in_plan(a.contact), in_plan(b.contact));
  const bool has_messenger = a.messenger_m > 0 && b.messenger_m > 0;
  const double contact_sag_m = has_messenger ? kContactSag * long_m : long_m * long_m / (8 * kTrolleyParameter_m);
  std::vector<Wire> wires = {{.from = on_grid(a.contact),
                              .to = on_grid(b.contact),
                              .sag_m = on_grid(contact_sag_m),
                              .radius_mm = kContactWire_mm,
                              .kind = WireKind::kContactWire}};
  if (!has_messenger) return wires;
  // below bridges there is less room between the wires
  const double room_m = std::min(a.messenger_m, b.messenger_m) / 2 + contact_sag_m;
  const auto messenger = [](const ContactSupport& s) { return s.contact + Vec3{0, 0, s.messenger_m}; };
  wires.push_back({.from = on_grid(messenger(a)),
                   .to = on_grid(messenger(b)),
                   .sag_m = on_grid(std::min(long_m * long_m / (8 * kMessengerParameter_m), room_m)),
                   .radius_mm = kMessenger_mm,
                   .kind = WireKind::kMessenger});
  return wires;
}

// Where a way is continued: a track, a vertex, and whether forward along it.
struct Continuation {
  std::uint32_t track = 0, vertex = 0;
  bool is_forward = true;
};

// The tracks by the nodes that they share.
using ByNode = std::map<std::int64_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>>;

ByNode tracks_by_node(const things::TrackIndex& index) {
  ByNode nodes;
  for (std::uint32_t t = 0; t < index.tracks.size(); ++t) {
    const ContactTrack& track = index.tracks[t];
    if (!track.has_contact_line) continue;
    for (std::uint32_t v = 0; v < track.node_ids.size(); ++v) nodes[track.node_ids[v]].emplace_back(t, v);
  }
  return nodes;
}

Vec2 direction_from(const ContactTrack& track, std::uint32_t vertex, bool is_forward) {
  const Vec2 next = track.axis[is_forward ? vertex + 1 : vertex - 1];
  return unit(next - track.axis[vertex]);
}

std::optional<Continuation> continuation_of(const ContactLines& lines, const ByNode& nodes, std::uint32_t t,
                                            bool from_end) {
  const ContactTrack& track = lines.index.tracks[t];
  const auto last = static_cast<std::uint32_t>(track.axis.size()) - 1, end = from_end ? last : 0;
  const Vec2 out = direction_from(track, end, !from_end) * -1.0;
  const auto found = nodes.find(track.node_ids[end]);
  if (found == nodes.end()) return std::nullopt;
  std::optional<Continuation> best;
  double straightest = kStraightOn;
  for (const auto& [other, vertex] : found->second)
    for (const bool is_forward : {true, false}) {
      if (other == t) continue;
      const ContactTrack& next = lines.index.tracks[other];
      if (is_forward ? vertex + 1 >= next.axis.size() : vertex == 0) continue;
      const double straight = dot(out, direction_from(next, vertex, is_forward));
      if (straight > straightest) straightest = straight, best = {other, vertex, is_forward};
    }
  return best;
}

// The supports of each track are a range of all.
struct SupportRange {
  std::size_t first = 0, last = 0;  // one beyond
};

std::vector<SupportRange> ranges_of(const ContactLines& lines) {
  std::vector<SupportRange> ranges(lines.index.tracks.size());
  for (std::size_t i = 0; i < lines.supports.size(); ++i) {
    SupportRange& range = ranges[lines.supports[i].track];
    if (range.last == 0) range.first = i;
    range.last = i + 1;
  }
  return ranges;
}

// The first support beyond a vertex of a track.
std::optional<std::size_t> first_beyond(const ContactLines& lines, const SupportRange& range,
                                        const Continuation& from) {
  const double at_m = lines.index.tracks[from.track].along_m[from.vertex];
  std::optional<std::size_t> found;
  for (std::size_t i = range.first; i < range.last; ++i) {
    const double along_m = lines.supports[i].along_m;
    if (from.is_forward && along_m >= at_m) return i;
    if (!from.is_forward && along_m <= at_m) found = i;
  }
  return found;
}

// The support at which the wires of a way end that leave it at one of its ends.
std::optional<std::size_t> support_beyond(const ContactLines& lines, const ByNode& nodes,
                                          const std::vector<SupportRange>& ranges, std::uint32_t t, bool from_end) {
  for (int ways = 0; ways < kMostWays; ++ways) {
    const std::optional<Continuation> next = continuation_of(lines, nodes, t, from_end);
    if (!next) return std::nullopt;
    if (const auto found = first_beyond(lines, ranges[next->track], *next)) return found;
    t = next->track, from_end = next->is_forward;
  }
  return std::nullopt;
}

// Parts number spans by their place along the way.
ObjectId span_id(const ContactLines& lines, const ContactSupport& from) {
  const auto metre = static_cast<std::uint32_t>(from.along_m);
  return derived_id({lines.index.tracks[from.track].id.osm, 0}, metre);
}

// The pairs of supports that wires join, each once, the lower one first.
std::set<std::pair<std::size_t, std::size_t>> joined_supports(const ContactLines& lines) {
  const ByNode nodes = tracks_by_node(lines.index);
  const std::vector<SupportRange> ranges = ranges_of(lines);
  std::set<std::pair<std::size_t, std::size_t>> joined;
  for (std::uint32_t t = 0; t < ranges.size(); ++t) {
    const SupportRange& range = ranges[t];
    if (range.first == range.last) continue;
    for (std::size_t i = range.first; i + 1 < range.last; ++i) joined.emplace(i, i + 1);
    if (const auto next = support_beyond(lines, nodes, ranges, t, true))
      joined.insert(std::minmax(range.last - 1, *next));
    if (const auto next = support_beyond(lines, nodes, ranges, t, false))
      joined.insert(std::minmax(range.first, *next));
  }
  return joined;
}

}  // namespace

std::vector<WireSpan> contact_spans(const ContactLines& lines, const ground::GradedTerrain& ground, Report& report) {
  std::vector<WireSpan> spans;
  Account account;
  for (const auto& [from, to] : joined_supports(lines)) {
    const ContactSupport &a = lines.supports[from], &b = lines.supports[to];
    const double long_m = distance(in_plan(a.contact), in_plan(b.contact));
    if (long_m < kShortestContact_m || long_m > things::kLongestContactSpan_m) continue;
    std::vector<Wire> wires = wires_between(a, b);
    const OsmId way = span_id(lines, a).osm;
    account.in += report.counts(way);
    if (const double low_m = too_low_m(wires.front(), ground); low_m > 0) {
      report.drop(account, Code::kWireTooLow, way, low_m);
      continue;
    }
    account.out += report.counts(way);
    const auto above_m = above_m_of(wires, ground);
    spans.push_back({.id = span_id(lines, a), .above_m = above_m, .wires = std::move(wires)});
  }
  for (const things::CrossWire& cross : lines.cross_wires) {
    const double sag_m = on_grid(kCrossSag * distance(in_plan(cross.from), in_plan(cross.to)));
    std::vector<Wire> wires = {{.from = on_grid(cross.from),
                                .to = on_grid(cross.to),
                                .sag_m = sag_m,
                                .radius_mm = kCrossWire_mm,
                                .kind = WireKind::kMessenger}};
    const auto above_m = above_m_of(wires, ground);
    spans.push_back({.id = cross.id, .above_m = above_m, .wires = std::move(wires)});
  }
  std::ranges::sort(spans, {}, order_of);
  report.account("wires", "contact span") = account;
  return spans;
}

}  // namespace citykiln::wires
