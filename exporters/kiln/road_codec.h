// Reads and writes the fields of roads, junctions, watercourses, bridges and tunnels in a chunk (the recipes of one
// tile). `io` is a Writer or a Reader (chunk_io.h); each function does both. A span is a bridge or tunnel.
#pragma once

#include <span>
#include <vector>

#include "compiler/scene/scene.h"
#include "exporters/kiln/line_codec.h"
#include "exporters/kiln/member_codecs.h"
#include "exporters/kiln/road_kinds.h"

namespace citykiln::exporters {

// Kind, direction and whether the lane is raised, as one number.
void serialise(auto& io, map::Lane& l) {
  constexpr std::uint64_t kWays = 3, kRaised = 2;
  auto number =
      (static_cast<std::uint64_t>(l.kind) * kWays + static_cast<std::uint64_t>(l.way)) * kRaised + l.is_raised;
  io.number("lane kind", number);
  MixedRadix packed{number};
  l.is_raised = packed.take(kRaised) != 0;
  l.way = static_cast<map::LaneDirection>(packed.take(kWays));
  l.kind = static_cast<map::LaneKind>(packed.number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (packed.number >= static_cast<std::uint64_t>(map::LaneKind::kCount)) io.fail("lane kind");
  io.metres("lane width", l.width_m);
  io.number("lane turns", l.turns);
}

// The slope of an axis in its carriageway: a multiple of 2^-16, counted from the least, in the stream of the offset.
void axis_drift(auto& io, double& drift) {
  constexpr double kStep = 0x1p-16;
  auto steps = static_cast<std::uint64_t>((drift + map::kMostDrift) / kStep);
  io.number("axis offset", steps);
  drift = static_cast<double>(steps) * kStep - map::kMostDrift;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (drift > map::kMostDrift) io.fail("axis offset"), drift = 0;
}

/// A road kind: properties that many roads share (road_kinds.h).
void serialise(auto& io, RoadKind& k) {
  // above all assumptions, of which there may be more one day
  constexpr std::uint64_t kKerbParking = std::uint64_t{1} << 40;
  enumerator(io, "road surface", k.surface, map::LandCoverClass::kCount);
  const bool drives_left = k.side == map::DrivingSide::kLeft;
  const bool drifts = k.section.axis_drift != 0;
  auto traits =
      static_cast<std::uint64_t>(drives_left | k.is_lit << 1 | k.is_link << 2 | k.is_roundabout << 3 | drifts << 4);
  traits += 32 * std::uint64_t{k.assumed_sides} + 128 * std::uint64_t{k.assumed} + kKerbParking * k.kerb_parking;
  io.number("road traits", traits);
  enumerator(io, "road country", k.country, map::CountryGroup::kCount);
  k.side = (traits & 1) != 0 ? map::DrivingSide::kLeft : map::DrivingSide::kRight;
  k.is_lit = (traits & 2) != 0, k.is_link = (traits & 4) != 0, k.is_roundabout = (traits & 8) != 0;
  half_steps(io, "axis offset", k.section.axis_offset_m);
  if ((traits & 16) != 0) axis_drift(io, k.section.axis_drift);
  list(io, "lanes", k.section.lanes, 1, [&](map::Lane& l) { serialise(io, l); });
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    const std::uint64_t assumed = traits % kKerbParking / 128, kerbs = traits / kKerbParking;
    if (assumed > kAllAssumptions || kerbs > map::kBothSides) io.fail("road traits");
    k.assumed_sides = static_cast<std::uint8_t>(traits / 32 % 4);
    k.assumed = static_cast<Assumptions>(assumed);
    k.kerb_parking = static_cast<std::uint8_t>(kerbs & map::kBothSides);
    if (!is_sound(k.section)) io.fail("lanes");
  }
}

// Traits, kind and direction as one number.
void serialise(auto& io, map::TrackPoint& p) {
  constexpr std::uint64_t kFacings = 3, kKinds = 16, kTraits = 64;
  static_assert(static_cast<std::uint64_t>(map::TrackPointKind::kCount) <= kKinds);
  io.number("track vertex", p.vertex);
  auto sign = (std::uint64_t{p.traits} * kKinds + static_cast<std::uint64_t>(p.kind)) * kFacings +
              static_cast<std::uint64_t>(p.facing + 1);
  io.number("track sign", sign);
  MixedRadix packed{sign};
  p.facing = static_cast<std::int8_t>(static_cast<int>(packed.take(kFacings)) - 1);
  const std::uint64_t kind = packed.take(kKinds);
  p.kind = static_cast<map::TrackPointKind>(kind);
  p.traits = static_cast<std::uint8_t>(packed.number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (kind >= static_cast<std::uint64_t>(map::TrackPointKind::kCount) || packed.number >= kTraits)
      io.fail("track sign");
  if (p.kind == map::TrackPointKind::kLevelCrossing) io.number("crossing reach", p.reach_quarters);
}

// A multiple of 2^-10 m. It is mostly zero and therefore not written as a difference.
void start_offset(auto& io, double& value) {
  auto steps = static_cast<std::uint64_t>(value / kQuantum_m);
  io.number("start offset", steps);
  value = static_cast<double>(steps) * kQuantum_m;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (value > kMaxCoordinate_m) io.fail("start offset"), value = 0;
}

/// A road, with the number of its kind.
void serialise(auto& io, roads::Road& r, std::span<const RoadKind> kinds, std::uint32_t& number) {
  id(io, r.id);
  curved_points(io, "road points", r.axis, 2);
  io.number("road kind", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number >= kinds.size()) return io.fail("road kind");
    set_kind(kinds[number], r);
  }
  start_offset(io, r.start_along_m);
  list(io, "track points", r.points, 0, [&](map::TrackPoint& p) {
    serialise(io, p);
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (p.vertex >= r.axis.size()) io.fail("track vertex");
  });
  profile(io, r.profile);
}

// The kinds of all roads of a chunk, bridges and tunnels included, and the kind of each road in the order of the chunk.
struct KindsOfChunk {
  RoadKinds kinds;
  std::size_t next = 0;

  template <typename Io>
  void road(Io& io, roads::Road& r) {
    if constexpr (Io::kReads) kinds.of_road.push_back(0);
    serialise(io, r, kinds.kinds, kinds.of_road[next++]);
  }
};

/// The road kinds of a chunk: a Writer collects them from its roads.
template <typename Io>
KindsOfChunk kinds_of_chunk(Io& io, const scene::Chunk& c) {
  KindsOfChunk all;
  if constexpr (!Io::kReads) {
    std::vector<roads::Road> roads = c.roads;
    roads.insert(roads.end(), c.bridges.begin(), c.bridges.end());
    roads.insert(roads.end(), c.tunnels.begin(), c.tunnels.end());
    all.kinds = kinds_of(roads);
  }
  list(io, "road kinds", all.kinds.kinds, 0, [&](RoadKind& k) { serialise(io, k); });
  return all;
}

// A width limit: its distance from the one before on its side, in quarters of a metre, whether the limit is straight in
// between (is_wall), and the largest half width in 32nds of a metre.
void serialise(auto& io, roads::WidthLimit& limit, const roads::WidthLimit* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((limit.at_m - from_m) * 4) * 2 + limit.is_wall;
  io.number("width limit steps", steps);
  limit.is_wall = steps % 2 != 0;
  limit.at_m = from_m + static_cast<double>(steps / 2) / 4;
  auto half = static_cast<std::int64_t>(limit.half_m * 32);
  io.delta("width limit half", half);
  limit.half_m = static_cast<double>(half) / 32;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    const bool follows = before ? limit.at_m > from_m : !limit.is_wall;
    if (!follows || limit.at_m > kMaxCoordinate_m) io.fail("width limit steps");
    if (half <= 0 || limit.half_m > kMaxCoordinate_m) io.fail("width limit half");
  }
}

/// The width limits of one side of a road.
void width_limits(auto& io, std::vector<roads::WidthLimit>& side) {
  std::size_t i = 0;
  list(io, "width limits", side, 0, [&](roads::WidthLimit& limit) {
    serialise(io, limit, i > 0 ? &side[i - 1] : nullptr);
    ++i;
  });
}

/// Calls code(number) for a road's number in a list of roads, given as the number of roads since the one before.
/// @param next  The number after the road before; it is set to the number after this one.
/// @param code  Writes or reads the difference; false if it is no road.
template <typename Io>
bool road_number(std::uint64_t& road, std::uint64_t& next, std::size_t count, auto code) {
  std::uint64_t skipped = road - next;
  code(skipped);
  if (Io::kReads && skipped >= count - next) return false;
  road = next + skipped, next = road + 1;
  return true;
}

/// Returns the numbers of the roads for which a predicate holds.
std::vector<std::uint64_t> numbers_of(const std::vector<roads::Road>& roads, auto holds) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t i = 0; i < roads.size(); ++i)
    if (holds(roads[i])) numbers.push_back(i);
  return numbers;
}

// Writes only roads with width limits: most roads have none, and take no bytes.
template <typename Io>
void narrowings(Io& io, std::vector<roads::Road>& roads) {
  std::vector<std::uint64_t> narrowed = numbers_of(roads, [](const auto& r) { return !r.width_limits.is_empty(); });
  std::uint64_t next = 0;
  list(io, "narrowed roads", narrowed, 0, [&](std::uint64_t& road) {
    const auto code = [&](std::uint64_t& skipped) { io.number("narrowed road", skipped); };
    const bool is_road = road_number<Io>(road, next, roads.size(), code);
    if constexpr (Io::kReads)
      if (!is_road) return io.fail("narrowed road");
    width_limits(io, roads[road].width_limits.left), width_limits(io, roads[road].width_limits.right);
  });
}

// The height of a step and the handrails of stairs.
template <typename Io>
void stairs(Io& io, roads::Road& road) {
  constexpr double kMostRiser_m = 1;
  auto riser = static_cast<std::uint64_t>(road.riser_m / kQuantum_m);
  io.number("riser", riser);
  road.riser_m = static_cast<double>(riser) * kQuantum_m;
  io.number("handrails", road.handrails);
  if constexpr (Io::kReads) {
    if (road.riser_m > kMostRiser_m) io.fail("riser");
    if (road.handrails > 7) io.fail("handrails");
  }
}

// Writes only stairs with a tagged number of steps, or with handrails.
template <typename Io>
void stepped(Io& io, std::vector<roads::Road>& roads) {
  std::vector<std::uint64_t> numbers =
      numbers_of(roads, [](const auto& r) { return r.riser_m > 0 || r.handrails != 0; });
  std::uint64_t next = 0;
  list(io, "stepped roads", numbers, 0, [&](std::uint64_t& road) {
    const auto code = [&](std::uint64_t& skipped) { io.number("stepped road", skipped); };
    const bool is_road = road_number<Io>(road, next, roads.size(), code);
    if constexpr (Io::kReads)
      if (!is_road) return io.fail("stepped road");
    stairs(io, roads[road]);
  });
}

// Cuttings. Beginnings and ends are written as distances from the number before, in quarters of a metre.
void cuttings(auto& io, std::vector<roads::Cutting>& all) {
  double last_m = 0;
  list(io, "cuttings", all, 1, [&](roads::Cutting& cutting) {
    for (double* at_m : {&cutting.from_m, &cutting.to_m}) {
      auto steps = static_cast<std::uint64_t>((*at_m - last_m) * 4);
      io.number("cutting step", steps);
      last_m = *at_m = last_m + static_cast<double>(steps) / 4;
    }
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (cutting.to_m <= cutting.from_m || cutting.to_m > kMaxCoordinate_m) io.fail("cutting step");
  });
}

// Writes only roads in cuttings.
template <typename Io>
void walled(Io& io, std::vector<roads::Road>& roads) {
  std::vector<std::uint64_t> numbers = numbers_of(roads, [](const auto& r) { return !r.cuttings.empty(); });
  std::uint64_t next = 0;
  list(io, "walled roads", numbers, 0, [&](std::uint64_t& road) {
    const auto code = [&](std::uint64_t& skipped) { io.number("walled road", skipped); };
    const bool is_road = road_number<Io>(road, next, roads.size(), code);
    if constexpr (Io::kReads)
      if (!is_road) return io.fail("walled road");
    cuttings(io, roads[road].cuttings);
  });
}

/// The roads of a chunk, then their width limits, then risers and handrails of stairs, then cuttings.
template <typename Io>
void roads_of(Io& io, std::vector<roads::Road>& roads, KindsOfChunk& kinds) {
  list(io, "roads", roads, 0, [&](roads::Road& r) { kinds.road(io, r); });
  narrowings(io, roads);
  stepped(io, roads);
  walled(io, roads);
}

// The unit of Strip::influence_radius_m.
inline constexpr double kReachStep_m = 16;

/// A strip: a watercourse, as an axis with a width on each side.
void serialise(auto& io, roads::Strip& s) {
  id(io, s.id);
  curved_points(io, "road points", s.axis, 2);
  enumerator(io, "water class", s.surface, map::LandCoverClass::kCount);
  io.metres("water sides", s.left_m), io.metres("water sides", s.right_m);
  start_offset(io, s.start_along_m);
  profile(io, s.profile);
  auto reach = static_cast<std::uint64_t>(s.influence_radius_m / kReachStep_m);
  io.number("water influence", reach);
  s.influence_radius_m = static_cast<double>(reach) * kReachStep_m;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (s.influence_radius_m > kMaxCoordinate_m) io.fail("water influence"), s.influence_radius_m = 0;
}

/// A junction.
void serialise(auto& io, roads::Junction& j) {
  enumerator(io, "junction family", j.family, roads::Family::kOther);
  points(io, "junction places", j.nodes, 1);
  list(io, "junction arms", j.cuts, 1, [&](roads::Cut& cut) {
    quarters(io, "cut lengths", cut.length_m);
    quarters(io, "corner radii", cut.radius_m);
  });
}

/// The end of a bridge or tunnel.
void serialise(auto& io, structures::SpanEnd& end) {
  enumerator(io, "span ends", end.kind, structures::EndKind::kCount);
  if (end.kind == structures::EndKind::kGround || end.kind == structures::EndKind::kJoint) io.point(end.beyond);
  if (end.kind == structures::EndKind::kBesideRoad) quarters(io, "end cut", end.cut_m);
}

// A pier: its distance from the pier before, or from the way's start, and the height of its foot, both in quarters of a
// metre.
void serialise(auto& io, structures::Pier& p, const structures::Pier* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((p.at_m - from_m) * 4);
  io.number("pier step", steps);
  p.at_m = from_m + static_cast<double>(steps) / 4;
  quanta(io, "pier foot", p.foot_m, 0.25);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if ((before && steps == 0) || p.at_m > kMaxCoordinate_m) io.fail("pier step");
}

// Gaps of a parapet. Starts and ends are written as distances from the number before, in quarters of a metre.
void openings(auto& io, std::vector<structures::ParapetGap>& side) {
  double last_m = 0;
  list(io, "openings", side, 0, [&](structures::ParapetGap& o) {
    for (double* at_m : {&o.from_m, &o.to_m}) {
      auto steps = static_cast<std::uint64_t>((*at_m - last_m) * 4);
      io.number("opening step", steps);
      last_m = *at_m = last_m + static_cast<double>(steps) / 4;
    }
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (o.to_m <= o.from_m || o.to_m > kMaxCoordinate_m) io.fail("opening step");
  });
}

// The layer, counted from the lowest one that OSM allows.
void layer(auto& io, std::int8_t& value) {
  constexpr int kLowest = -10, kHighest = 10;
  auto above = static_cast<std::uint8_t>(value - kLowest);
  io.number("span layer", above);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (above > kHighest - kLowest) io.fail("span layer");
  value = static_cast<std::int8_t>(above + kLowest);
}

// A deck that the map has as an area.
void serialise(auto& io, structures::Plate& plate) {
  ObjectId number{plate.id, 0};
  id(io, number);
  plate.id = number.osm;
  enumerator(io, "plate surface", plate.surface, map::LandCoverClass::kCount);
  list(io, "plate parts", plate.parts, 1, [&](structures::PlatePart& part) {
    flag(io, "plate below road", part.is_below_road);
    list(io, "plate rings", part.rings, 1, [&](std::vector<structures::PlateCorner>& ring) {
      list(io, "plate corners", ring, 3, [&](structures::PlateCorner& corner) {
        Vec2 at = in_plan(corner.at);
        io.point(at);
        corner.at.x = at.x, corner.at.y = at.y;
        quanta(io, "plate height", corner.at.z, kProfileQuantum_m);
        flag(io, "plate walls", corner.has_wall);
      });
    });
  });
}

/// A bridge or tunnel.
void serialise(auto& io, structures::Span& s, KindsOfChunk& kinds) {
  kinds.road(io, s);
  serialise(io, s.from), serialise(io, s.to);
  flag(io, "bored", s.is_bored);
  layer(io, s.layer);
  enumerator(io, "deck form", s.deck, structures::DeckForm::kCount);
  list(io, "plates", s.plates, 0, [&](structures::Plate& plate) { serialise(io, plate); });
  openings(io, s.left_gaps), openings(io, s.right_gaps);
  std::size_t i = 0;
  list(io, "piers", s.piers, 0, [&](structures::Pier& p) {
    serialise(io, p, i > 0 ? &s.piers[i - 1] : nullptr);
    ++i;
  });
}

}  // namespace citykiln::exporters
