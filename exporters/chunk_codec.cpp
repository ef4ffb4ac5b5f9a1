#include "exporters/chunk_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

#include "compiler/contract/tolerance.h"
#include "compiler/map/building_classes.h"
#include "exporters/road_kinds.h"
#include "exporters/streams.h"

// Writing and reading are one description: `describe` walks a chunk once, and a Writer or a Reader stands behind it.
namespace citykiln::exporters {
namespace {

using scene::Chunk;

constexpr const char* kStreamNames[] = {"point step",
                                        "field",
                                        "heights",
                                        "points",
                                        "x",
                                        "y",
                                        "point jumps",
                                        "id type",
                                        "id",
                                        "part",
                                        "surfaces",
                                        "surface class",
                                        "surface area",
                                        "surface rings",
                                        "ring points",
                                        "roads",
                                        "streams",
                                        "road points",
                                        "road kind",
                                        "road kinds",
                                        "road surface",
                                        "bridges",
                                        "tunnels",
                                        "span ends",
                                        "end cut",
                                        "piers",
                                        "pier step",
                                        "buildings",
                                        "footprint points",
                                        "footprint holes",
                                        "hole points",
                                        "building bottom",
                                        "building top",
                                        "building stands",
                                        "wall",
                                        "roof",
                                        "colours",
                                        "colour values",
                                        "trees",
                                        "tree height",
                                        "tree kind",
                                        "woods",
                                        "wood",
                                        "barriers",
                                        "barrier points",
                                        "barrier kind",
                                        "barrier height",
                                        "barrier width",
                                        "lamps",
                                        "lamp height",
                                        "junctions",
                                        "junction family",
                                        "junction places",
                                        "junction arms",
                                        "cut lengths",
                                        "corner radii",
                                        "road traits",
                                        "axis offset",
                                        "lanes",
                                        "lane kind",
                                        "lane width",
                                        "lane turns",
                                        "passed",
                                        "track points",
                                        "track vertex",
                                        "track sign",
                                        "water class",
                                        "water sides",
                                        "narrowed roads",
                                        "narrowed road",
                                        "pinches",
                                        "pinch steps",
                                        "pinch half",
                                        "knots",
                                        "knot steps",
                                        "knot height",
                                        "knot tilt",
                                        "levelled",
                                        "water level",
                                        "water reach",
                                        "pier foot",
                                        "bored",
                                        "openings",
                                        "opening step",
                                        "span layer",
                                        "building floor",
                                        "roof form",
                                        "roof rise",
                                        "roof traits",
                                        "roof direction",
                                        "roof eaves",
                                        "style",
                                        "building class",
                                        "storeys",
                                        "year",
                                        "shop",
                                        "fronts",
                                        "front",
                                        "party walls",
                                        "party edge",
                                        "party place",
                                        "party top",
                                        "party traits",
                                        "graded"};

constexpr std::size_t kMostPerFile = 1u << 28;
constexpr std::size_t kMostAtOnce = 1u << 12;
// The plane reaches 80 degrees of longitude from its origin: 16 000 km.
constexpr double kFarthest_m = 0x1p25;

// Points that several rings and lines share are written once. A point is a step along the list of those that came
// before (a shared border is followed forwards or backwards), a jump to one of them, or new.
enum PointCode : std::uint64_t { kNewPoint, kNextPoint, kPreviousPoint, kFirstJump };

// The map's own points lie on its step; a chunk with a finer point is written in the plane's finest.
using map::kMapStep_m;

struct Writer {
  static constexpr bool kReads = false;
  std::map<std::string, StreamWriter> streams;
  std::map<Vec2, std::int64_t> known;
  std::int64_t last = -1;
  double point_step_m = kQuantum_m;

  void point(Vec2& p) {
    const auto [entry, is_new] = known.try_emplace(p, static_cast<std::int64_t>(known.size()));
    const std::int64_t step = entry->second - last;
    StreamWriter& codes = streams["points"];
    if (is_new) {
      codes.put(kNewPoint);
      streams["x"].put_delta(static_cast<std::int64_t>(std::floor(p.x / point_step_m + 0.5)));
      streams["y"].put_delta(static_cast<std::int64_t>(std::floor(p.y / point_step_m + 0.5)));
    } else if (step == 1 || step == -1) {
      codes.put(step == 1 ? kNextPoint : kPreviousPoint);
    } else {
      codes.put(kFirstJump);
      streams["point jumps"].put_signed(step);
    }
    last = entry->second;
  }

  void number(const char* name, auto& value) { streams[name].put(static_cast<std::uint64_t>(value)); }
  void delta(const char* name, auto& value) { streams[name].put_delta(static_cast<std::int64_t>(value)); }
  void metres(const char* name, double& value) {
    streams[name].put_delta(static_cast<std::int64_t>(std::floor(value / kQuantum_m + 0.5)));
  }
  void real(const char* name, double& value) { streams[name].put_double(value); }
  std::size_t count(const char* name, std::size_t size) {
    streams[name].put(size);
    return size;
  }
};

struct Reader {
  static constexpr bool kReads = true;
  std::map<std::string, StreamReader> streams;
  std::string wrong;
  std::vector<Vec2> known;
  std::int64_t last = -1;
  double point_step_m = kQuantum_m;

  void point(Vec2& p) {
    const std::uint64_t code = whole("points");
    if (code == kNewPoint) {
      p.x = place("x", point_step_m), p.y = place("y", point_step_m);
      last = static_cast<std::int64_t>(known.size());
      known.push_back(p);
      return;
    }
    if (code > kFirstJump) return fail("points");
    const std::int64_t step = code == kNextPoint ? 1 : code == kPreviousPoint ? -1 : jump();
    const auto found = static_cast<std::uint64_t>(last) + static_cast<std::uint64_t>(step);
    if (found >= known.size()) return fail("points");
    last = static_cast<std::int64_t>(found);
    p = known[found];
  }

  StreamReader& of(const char* name) {
    const auto found = streams.find(name);
    if (found == streams.end()) fail(name);
    return found == streams.end() ? streams[name] : found->second;
  }
  // what a stream gives; where it has run out, zero, and the chunk is wrong
  template <typename T>
  T checked(const char* name, T (StreamReader::*get)()) {
    StreamReader& stream = of(name);
    const T value = (stream.*get)();
    if (!stream.good()) fail(name);
    return value;
  }
  std::uint64_t whole(const char* name) { return checked<std::uint64_t>(name, &StreamReader::get); }
  std::int64_t jump() { return checked("point jumps", &StreamReader::get_signed); }
  double place(const char* name, double step_m) {
    const double value = static_cast<double>(checked(name, &StreamReader::get_delta)) * step_m;
    if (std::abs(value) <= kFarthest_m) return value;
    fail(name);
    return 0;
  }
  void number(const char* name, auto& value) {
    using T = std::remove_reference_t<decltype(value)>;
    const std::uint64_t read = whole(name);
    value = static_cast<T>(read);
    if (static_cast<std::uint64_t>(value) != read) fail(name);
  }
  void delta(const char* name, std::int64_t& value) { value = checked(name, &StreamReader::get_delta); }
  void metres(const char* name, double& value) { value = place(name, kQuantum_m); }
  void real(const char* name, double& value) {
    value = checked(name, &StreamReader::get_double);
    if (!std::isfinite(value)) fail(name);
  }
  // no more things than the whole chunk has bytes: a thing takes at least one byte of some stream
  std::size_t total_bytes = 0;
  std::size_t count(const char* name, std::size_t) {
    const std::uint64_t size = whole(name);
    if (size <= total_bytes) return static_cast<std::size_t>(size);
    fail(name);
    return 0;
  }
  void fail(const char* name) {
    if (wrong.empty()) wrong = name;
  }
};

template <typename Enum>
void enumerator(auto& io, const char* name, Enum& value, Enum count) {
  auto number = static_cast<std::uint64_t>(value);
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number >= static_cast<std::uint64_t>(count)) io.fail(name), number = 0;
    value = static_cast<Enum>(number);
  }
}

template <typename Io, typename Object, typename Each>
void list(Io& io, const char* name, std::vector<Object>& objects, std::size_t least, Each each) {
  const std::size_t size = io.count(name, objects.size());
  if constexpr (Io::kReads) {
    if (size < least) return io.fail(name);
    // room grows with what is there, not with what the count says
    objects.reserve(std::min(size, kMostAtOnce));
    for (std::size_t i = 0; i < size && io.wrong.empty(); ++i) each(objects.emplace_back());
  } else {
    for (Object& object : objects) each(object);
  }
}

void flag(auto& io, const char* name, bool& value) {
  std::uint8_t number = value ? 1 : 0;
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 1) io.fail(name);
  value = number != 0;
}

void id(auto& io, ObjectId& id) {
  enumerator(io, "id type", id.osm.type, static_cast<OsmType>(4));
  io.delta("id", id.osm.id);
  io.number("part", id.part);
}

void points(auto& io, const char* kind, std::vector<Vec2>& axis, std::size_t least) {
  list(io, kind, axis, least, [&](Vec2& p) { io.point(p); });
}

// In whole quanta, as a difference to the last one.
void quanta(auto& io, const char* name, double& value, double quantum) {
  auto count = static_cast<std::int64_t>(std::floor(value / quantum + 0.5));
  io.delta(name, count);
  value = static_cast<double>(count) * quantum;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (std::abs(value) > kFarthest_m) io.fail(name), value = 0;
}

// How far from the knot before, in eighths of a metre.
void knot(auto& io, Knot& k, const Knot* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((k.at_m - from_m) * 8);
  io.number("knot steps", steps);
  k.at_m = from_m + static_cast<double>(steps) / 8;
  quanta(io, "knot height", k.z_m, kProfileQuantum_m);
  quanta(io, "knot tilt", k.tilt, kTiltQuantum);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if ((before && steps == 0) || k.at_m > kFarthest_m) io.fail("knot steps");
}

void profile(auto& io, Profile& p) {
  std::size_t i = 0;
  list(io, "knots", p, 0, [&](Knot& k) {
    knot(io, k, i > 0 ? &p[i - 1] : nullptr);
    ++i;
  });
}

// Standing water has one.
void level(auto& io, ground::Surface& s) {
  bool is_levelled = s.level_m.has_value();
  flag(io, "levelled", is_levelled);
  if (!is_levelled) return;
  if (!s.level_m) s.level_m.emplace();
  quanta(io, "water level", *s.level_m, kProfileQuantum_m);
}

void surface(auto& io, ground::Surface& s) {
  id(io, s.id);
  enumerator(io, "surface class", s.surface, map::SurfaceClass::kCount);
  io.number("surface area", s.area_m2);
  list(io, "surface rings", s.rings, 1, [&](Ring& ring) { points(io, "ring points", ring, 3); });
  level(io, s);
  flag(io, "graded", s.is_graded);
}

// Whole quarters of a metre, below 64 m.
void quarters(auto& io, const char* name, double& value) {
  auto quarters = static_cast<std::uint8_t>(value * 4);
  io.number(name, quarters);
  value = quarters / 4.0;
}

// Several small numbers in one: each takes the bits that its count needs.
struct Packed {
  std::uint64_t number;
  std::uint64_t take(std::uint64_t count) {
    const std::uint64_t taken = number % count;
    number /= count;
    return taken;
  }
};

// Steps of 2^-11 m, not below 0: the middle of what is counted in quanta.
void half_steps(auto& io, const char* name, double& value) {
  constexpr double kHalf_m = kQuantum_m / 2;
  auto steps = static_cast<std::uint64_t>(value / kHalf_m);
  io.number(name, steps);
  value = static_cast<double>(steps) * kHalf_m;
}

// Kind, way and whether it is raised, as one number.
void lane(auto& io, map::Lane& l) {
  constexpr std::uint64_t kWays = 3, kRaised = 2;
  auto number =
      (static_cast<std::uint64_t>(l.kind) * kWays + static_cast<std::uint64_t>(l.way)) * kRaised + l.is_raised;
  io.number("lane kind", number);
  Packed packed{number};
  l.is_raised = packed.take(kRaised) != 0;
  l.way = static_cast<map::LaneWay>(packed.take(kWays));
  l.kind = static_cast<map::LaneKind>(packed.number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (packed.number >= static_cast<std::uint64_t>(map::LaneKind::kCount)) io.fail("lane kind");
  io.metres("lane width", l.width_m);
  io.number("lane turns", l.turns);
}

void road_kind(auto& io, RoadKind& k) {
  enumerator(io, "road surface", k.surface, map::SurfaceClass::kCount);
  const bool drives_left = k.side == map::DrivingSide::kLeft;
  auto traits = static_cast<std::uint64_t>(drives_left | k.is_lit << 1 | k.is_link << 2 | k.is_roundabout << 3);
  io.number("road traits", traits);
  k.side = (traits & 1) != 0 ? map::DrivingSide::kLeft : map::DrivingSide::kRight;
  k.is_lit = (traits & 2) != 0, k.is_link = (traits & 4) != 0, k.is_roundabout = (traits & 8) != 0;
  half_steps(io, "axis offset", k.section.axis_offset_m);
  list(io, "lanes", k.section.lanes, 1, [&](map::Lane& l) { lane(io, l); });
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (traits > 15) io.fail("road traits");
    if (!is_sound(k.section)) io.fail("lanes");
  }
}

// Kind and facing as one number.
void track_point(auto& io, map::TrackPoint& p) {
  constexpr std::uint64_t kFacings = 3;
  io.number("track vertex", p.vertex);
  auto sign = static_cast<std::uint64_t>(p.kind) * kFacings + static_cast<std::uint64_t>(p.facing + 1);
  io.number("track sign", sign);
  Packed packed{sign};
  p.facing = static_cast<std::int8_t>(static_cast<int>(packed.take(kFacings)) - 1);
  p.kind = static_cast<map::TrackPointKind>(packed.number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (packed.number >= static_cast<std::uint64_t>(map::TrackPointKind::kCount)) io.fail("track sign");
}

// Steps of 2^-10 m, not as a difference: mostly zero.
void passed(auto& io, double& value) {
  auto steps = static_cast<std::uint64_t>(value / kQuantum_m);
  io.number("passed", steps);
  value = static_cast<double>(steps) * kQuantum_m;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (value > kFarthest_m) io.fail("passed"), value = 0;
}

void road(auto& io, roads::Road& r, std::span<const RoadKind> kinds, std::uint32_t& number) {
  id(io, r.id);
  points(io, "road points", r.axis, 2);
  io.number("road kind", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number >= kinds.size()) return io.fail("road kind");
    set_kind(kinds[number], r);
  }
  passed(io, r.passed_m);
  list(io, "track points", r.points, 0, [&](map::TrackPoint& p) {
    track_point(io, p);
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (p.vertex >= r.axis.size()) io.fail("track vertex");
  });
  profile(io, r.profile);
}

// The kinds of all roads of a chunk, bridges and tunnels among them, and which of them is whose, as they come.
struct KindsOfChunk {
  RoadKinds kinds;
  std::size_t next = 0;

  template <typename Io>
  void road(Io& io, roads::Road& r) {
    if constexpr (Io::kReads) kinds.of_road.push_back(0);
    exporters::road(io, r, kinds.kinds, kinds.of_road[next++]);
  }
};

template <typename Io>
KindsOfChunk kinds_of_chunk(Io& io, const Chunk& c) {
  KindsOfChunk all;
  if constexpr (!Io::kReads) {
    std::vector<roads::Road> roads = c.roads;
    roads.insert(roads.end(), c.bridges.begin(), c.bridges.end());
    roads.insert(roads.end(), c.tunnels.begin(), c.tunnels.end());
    all.kinds = kinds_of(roads);
  }
  list(io, "road kinds", all.kinds.kinds, 0, [&](RoadKind& k) { road_kind(io, k); });
  return all;
}

// How far from the pinch before on its side, in quarters of a metre, and whether the limit runs straight from there.
void pinch(auto& io, roads::Pinch& p, const roads::Pinch* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((p.at_m - from_m) * 4) * 2 + p.is_wall;
  io.number("pinch steps", steps);
  p.is_wall = steps % 2 != 0;
  p.at_m = from_m + static_cast<double>(steps / 2) / 4;
  auto half = static_cast<std::int64_t>(p.half_m * 32);
  io.delta("pinch half", half);
  p.half_m = static_cast<double>(half) / 32;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    const bool follows = before ? p.at_m > from_m : !p.is_wall;
    if (!follows || p.at_m > kFarthest_m) io.fail("pinch steps");
    if (half <= 0 || p.half_m > kFarthest_m) io.fail("pinch half");
  }
}

void pinches(auto& io, std::vector<roads::Pinch>& side) {
  std::size_t i = 0;
  list(io, "pinches", side, 0, [&](roads::Pinch& p) {
    pinch(io, p, i > 0 ? &side[i - 1] : nullptr);
    ++i;
  });
}

// Most roads are not narrowed and take no bytes.
template <typename Io>
void narrowings(Io& io, std::vector<roads::Road>& roads) {
  std::vector<std::uint64_t> narrowed;
  for (std::size_t i = 0; i < roads.size(); ++i)
    if (!roads[i].narrowing.is_empty()) narrowed.push_back(i);
  std::uint64_t next = 0;
  list(io, "narrowed roads", narrowed, 0, [&](std::uint64_t& road) {
    std::uint64_t skipped = road - next;
    io.number("narrowed road", skipped);
    if constexpr (Io::kReads)
      if (skipped >= roads.size() - next) return io.fail("narrowed road");
    road = next + skipped, next = road + 1;
    pinches(io, roads[road].narrowing.left), pinches(io, roads[road].narrowing.right);
  });
}

template <typename Io>
void roads_of(Io& io, std::vector<roads::Road>& roads, KindsOfChunk& kinds) {
  list(io, "roads", roads, 0, [&](roads::Road& r) { kinds.road(io, r); });
  narrowings(io, roads);
}

// What rivers' areas reach is counted in these.
constexpr double kReachStep_m = 16;

void stream(auto& io, roads::Strip& s) {
  id(io, s.id);
  points(io, "road points", s.axis, 2);
  enumerator(io, "water class", s.surface, map::SurfaceClass::kCount);
  io.metres("water sides", s.left_m), io.metres("water sides", s.right_m);
  passed(io, s.passed_m);
  profile(io, s.profile);
  auto reach = static_cast<std::uint64_t>(s.reach_m / kReachStep_m);
  io.number("water reach", reach);
  s.reach_m = static_cast<double>(reach) * kReachStep_m;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (s.reach_m > kFarthest_m) io.fail("water reach"), s.reach_m = 0;
}

void junction(auto& io, roads::Junction& j) {
  enumerator(io, "junction family", j.family, roads::Family::kOther);
  points(io, "junction places", j.places, 1);
  list(io, "junction arms", j.cuts, 1, [&](roads::Cut& cut) {
    quarters(io, "cut lengths", cut.length_m);
    quarters(io, "corner radii", cut.radius_m);
  });
}

void span_end(auto& io, structures::SpanEnd& end) {
  enumerator(io, "span ends", end.kind, structures::EndKind::kCount);
  if (end.kind == structures::EndKind::kGround || end.kind == structures::EndKind::kJoint) io.point(end.beyond);
  if (end.kind == structures::EndKind::kAcross) quarters(io, "end cut", end.cut_m);
}

// How far from the pier before, or from the way's beginning, in quarters of a metre.
void pier(auto& io, structures::Pier& p, const structures::Pier* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((p.at_m - from_m) * 4);
  io.number("pier step", steps);
  p.at_m = from_m + static_cast<double>(steps) / 4;
  quanta(io, "pier foot", p.foot_m, 0.25);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if ((before && steps == 0) || p.at_m > kFarthest_m) io.fail("pier step");
}

// As steps from the end of the opening before, in quarters of a metre.
void openings(auto& io, std::vector<structures::Opening>& side) {
  double last_m = 0;
  list(io, "openings", side, 0, [&](structures::Opening& o) {
    for (double* at_m : {&o.from_m, &o.to_m}) {
      auto steps = static_cast<std::uint64_t>((*at_m - last_m) * 4);
      io.number("opening step", steps);
      last_m = *at_m = last_m + static_cast<double>(steps) / 4;
    }
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (o.to_m <= o.from_m || o.to_m > kFarthest_m) io.fail("opening step");
  });
}

// From the lowest that a map may tell.
void layer(auto& io, std::int8_t& value) {
  constexpr int kLowest = -10, kHighest = 10;
  auto above = static_cast<std::uint8_t>(value - kLowest);
  io.number("span layer", above);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (above > kHighest - kLowest) io.fail("span layer");
  value = static_cast<std::int8_t>(above + kLowest);
}

void span(auto& io, structures::Span& s, KindsOfChunk& kinds) {
  kinds.road(io, s);
  span_end(io, s.from), span_end(io, s.to);
  flag(io, "bored", s.is_bored);
  layer(io, s.layer);
  openings(io, s.left_open), openings(io, s.right_open);
  std::size_t i = 0;
  list(io, "piers", s.piers, 0, [&](structures::Pier& p) {
    pier(io, p, i > 0 ? &s.piers[i - 1] : nullptr);
    ++i;
  });
}

void colour(auto& io, std::optional<map::Srgb>& value) {
  bool is_there = value.has_value();
  flag(io, "colours", is_there);
  if (!is_there) return;
  if (!value) value.emplace();
  for (std::uint8_t& c : *value) io.number("colour values", c);
}

// Two truths as one number.
void flags(auto& io, const char* name, bool& first, bool& second) {
  std::uint8_t number = static_cast<std::uint8_t>((first ? 1 : 0) + (second ? 2 : 0));
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 3) io.fail(name);
  first = (number & 1) != 0, second = (number & 2) != 0;
}

void roof_shape(auto& io, roofs::RoofShape& roof) {
  enumerator(io, "roof form", roof.form, roofs::Form::kCount);
  if (roof.form == roofs::Form::kFlat) return;
  io.metres("roof rise", roof.height_m);
  bool has_direction = roof.direction.has_value();
  flags(io, "roof traits", has_direction, roof.is_ridge_across);
  io.metres("roof eaves", roof.overhang_m);
  if (!has_direction) return;
  if (!roof.direction) roof.direction.emplace();
  io.metres("roof direction", roof.direction->x), io.metres("roof direction", roof.direction->y);
}

void front(auto& io, buildings::Front& f) {
  auto number = static_cast<std::uint16_t>(2 * f.buried_storeys + (f.faces_street ? 1 : 0));
  io.number("front", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 511) io.fail("front");
  f = {(number & 1) != 0, static_cast<std::uint8_t>(number / 2)};
}

void party_wall(auto& io, buildings::PartyWall& w, std::size_t edges) {
  io.number("party edge", w.edge);
  io.metres("party place", w.from_m), io.metres("party place", w.to_m), io.metres("party top", w.top_m);
  flags(io, "party traits", w.is_hidden, w.has_windows_above);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (w.edge >= edges || !(w.from_m >= 0 && w.from_m < w.to_m)) io.fail("party edge");
}

// Heights in order, and a roof that fits: what expanding counts on.
bool is_upright(const buildings::Building& b) {
  return b.bottom_m < b.top_m && b.bottom_m <= b.floor_m && b.floor_m <= eaves_m(b) && b.levels > 0 &&
         b.roof_shape.height_m >= 0 && b.roof_shape.overhang_m >= 0 && b.roof_shape.overhang_m <= 16;
}

void facade(auto& io, buildings::Building& b) {
  const std::size_t edges = b.footprint.outer.size();
  enumerator(io, "style", b.style, buildings::Style::kCount);
  enumerator(io, "building class", b.building_class, static_cast<std::uint8_t>(map::BuildingClass::kCount));
  io.number("storeys", b.levels), io.number("year", b.year);
  flag(io, "shop", b.has_shop);
  list(io, "fronts", b.fronts, 0, [&](buildings::Front& f) { front(io, f); });
  list(io, "party walls", b.party_walls, 0, [&](buildings::PartyWall& w) { party_wall(io, w, edges); });
}

void building(auto& io, buildings::Building& b) {
  id(io, b.id);
  points(io, "footprint points", b.footprint.outer, 3);
  list(io, "footprint holes", b.footprint.holes, 0, [&](Ring& hole) { points(io, "hole points", hole, 3); });
  io.metres("building bottom", b.bottom_m), io.metres("building floor", b.floor_m), io.metres("building top", b.top_m);
  flag(io, "building stands", b.stands_on_ground);
  enumerator(io, "wall", b.wall, materials::Material::kCount);
  enumerator(io, "roof", b.roof, materials::Material::kCount);
  colour(io, b.wall_colour), colour(io, b.roof_colour);
  roof_shape(io, b.roof_shape);
  facade(io, b);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (!is_upright(b)) io.fail("building top");
}

void tree(auto& io, plants::Tree& t) {
  id(io, t.id);
  io.point(t.at), io.metres("tree height", t.height_m);
  enumerator(io, "tree kind", t.archetype, plants::Archetype::kCount);
}

void wood(auto& io, plants::Wood& w) {
  id(io, w.surface);
  io.real("wood", w.spacing_m), io.real("wood", w.needle_share), io.real("wood", w.height_m);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    // what would ask for a million trees a hectare, or none, is no wood
    const bool is_wood = w.spacing_m >= 1 && w.spacing_m <= scene::kHalo_m && w.needle_share >= 0 &&
                         w.needle_share <= 1 && w.height_m > 0 && w.height_m <= 200;
    if (!is_wood) io.fail("wood");
  }
}

void barrier(auto& io, props::Barrier& b) {
  id(io, b.id);
  points(io, "barrier points", b.axis, 2);
  enumerator(io, "barrier kind", b.kind, static_cast<map::BarrierKind>(6));
  io.metres("barrier height", b.height_m), io.metres("barrier width", b.width_m);
}

void lamp(auto& io, props::Lamp& l) {
  id(io, l.id);
  io.point(l.at), io.metres("lamp height", l.height_m);
}

// Each height as its difference to what its western, southern and south-western neighbours foretell.
std::int64_t foretold(const map::Heightfield& h, std::size_t i) {
  const auto across = static_cast<std::size_t>(h.columns);
  const std::int64_t west = i % across > 0 ? h.heights[i - 1] : 0, south = i >= across ? h.heights[i - across] : 0;
  if (i % across == 0) return south;
  return i < across ? west : west + south - h.heights[i - across - 1];
}

// Corner and steps are whole eighths of a metre.
bool is_on_grid(const map::Heightfield& h) {
  const auto is_whole = [](double v, double step) { return std::floor(v / step) * step == v; };
  const auto fits = [&](double start, double step) {
    return step >= 1 && is_whole(step, map::kStepUnit_m) && is_whole(start, map::kStepUnit_m);
  };
  return fits(h.min.x, h.step_m.x) && fits(h.min.y, h.step_m.y);
}

int common_zeros(const map::Heightfield& h) {
  std::uint32_t all = 1u << 20;
  for (const std::int32_t height : h.heights) all |= static_cast<std::uint32_t>(height);
  return std::countr_zero(all);
}

template <typename Io>
void heights(Io& io, map::Heightfield& h) {
  io.metres("field", h.min.x), io.metres("field", h.min.y);
  io.metres("field", h.step_m.x), io.metres("field", h.step_m.y);
  io.number("field", h.columns), io.number("field", h.rows);
  io.metres("field", h.resampling_error_m);
  const std::size_t size = io.count("field", h.heights.size());
  if constexpr (Io::kReads) {
    const bool fits = h.columns >= 2 && h.rows >= 2 && is_on_grid(h) && h.resampling_error_m >= 0 &&
                      static_cast<std::uint64_t>(h.columns) * static_cast<std::uint64_t>(h.rows) == size &&
                      size < kMostPerFile;
    if (!fits) return io.fail("field");
    h.heights.resize(size);
  }
  // the zeros that all heights end in are written once
  int shift = common_zeros(h);
  io.number("field", shift);
  if constexpr (Io::kReads)
    if (shift < 0 || shift > 30) return io.fail("field");
  for (std::size_t i = 0; i < size; ++i) {
    std::int64_t off = (h.heights[i] - foretold(h, i)) >> shift;
    std::uint64_t zigzag = static_cast<std::uint64_t>(off) << 1 ^ static_cast<std::uint64_t>(off >> 63);
    io.number("heights", zigzag);
    if constexpr (Io::kReads) {
      const std::uint64_t undone = (zigzag >> 1 ^ (~(zigzag & 1) + 1)) << shift;
      const auto height = static_cast<std::int64_t>(static_cast<std::uint64_t>(foretold(h, i)) + undone);
      h.heights[i] = static_cast<std::int32_t>(height);
      if (h.heights[i] != height) return io.fail("heights");
    }
  }
}

template <typename Io>
void describe(Io& io, Chunk& c) {
  std::uint64_t is_coarse = io.point_step_m == kMapStep_m ? 1 : 0;
  io.number("point step", is_coarse);
  if constexpr (Io::kReads)
    if (is_coarse > 1) io.fail("point step");
  io.point_step_m = is_coarse != 0 ? kMapStep_m : kQuantum_m;
  heights(io, c.heights);
  list(io, "surfaces", c.surfaces, 0, [&](auto& o) { surface(io, o); });
  KindsOfChunk kinds = kinds_of_chunk(io, c);
  roads_of(io, c.roads, kinds);
  list(io, "junctions", c.junctions, 0, [&](auto& o) { junction(io, o); });
  list(io, "streams", c.streams, 0, [&](auto& o) { stream(io, o); });
  list(io, "bridges", c.bridges, 0, [&](auto& o) { span(io, o, kinds); });
  list(io, "tunnels", c.tunnels, 0, [&](auto& o) { span(io, o, kinds); });
  list(io, "buildings", c.buildings, 0, [&](auto& o) { building(io, o); });
  list(io, "trees", c.trees, 0, [&](auto& o) { tree(io, o); });
  list(io, "woods", c.woods, 0, [&](auto& o) { wood(io, o); });
  list(io, "barriers", c.barriers, 0, [&](auto& o) { barrier(io, o); });
  list(io, "lamps", c.lamps, 0, [&](auto& o) { lamp(io, o); });
}

// Looks at every point of a chunk and leaves it as it is.
struct StepFinder {
  static constexpr bool kReads = false;
  double point_step_m = kMapStep_m;

  void point(Vec2& p) {
    const auto fits = [](double v) { return std::floor(v / kMapStep_m) * kMapStep_m == v; };
    if (!fits(p.x) || !fits(p.y)) point_step_m = kQuantum_m;
  }
  void number(const char*, auto&) {}
  void delta(const char*, auto&) {}
  void metres(const char*, double&) {}
  void real(const char*, double&) {}
  std::size_t count(const char*, std::size_t size) { return size; }
};

double step_of(Chunk& chunk) {
  StepFinder finder;
  describe(finder, chunk);
  return finder.point_step_m;
}

}  // namespace

std::span<const char* const> stream_names() { return kStreamNames; }

Streams encode_chunk(const Chunk& chunk) {
  Writer writer;
  // the description is one for both ways, so it takes what it may change
  Chunk copy = chunk;
  writer.point_step_m = step_of(copy);
  describe(writer, copy);
  Streams streams;
  for (const auto& [name, stream] : writer.streams) streams[name] = stream.bytes();
  return streams;
}

std::optional<Chunk> decode_chunk(const Streams& streams, scene::TileKey tile, std::string& wrong) {
  Reader reader;
  for (const auto& [name, bytes] : streams) {
    reader.streams.emplace(name, StreamReader(bytes));
    reader.total_bytes += bytes.size();
  }
  Chunk chunk;
  chunk.tile = tile;
  describe(reader, chunk);
  for (const auto& [name, stream] : reader.streams)
    if (reader.wrong.empty() && !stream.is_finished()) reader.wrong = name;
  wrong = reader.wrong;
  if (!wrong.empty()) return std::nullopt;
  return chunk;
}

}  // namespace citykiln::exporters
