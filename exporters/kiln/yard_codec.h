// Reads and writes the yards of one tile. `io` is a Writer, a Reader or a probe (chunk_io.h); io.fail() notes the first
// wrong stream, and reading goes on. Surfaces, barriers and trees of yards are generated from them
// (compiler/scene/yard_recipes.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <type_traits>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/lots/recipe.h"
#include "exporters/kiln/member_codecs.h"

namespace citykiln::exporters {

/// A signed whole number of steps, in zigzag order. `value` is a multiple of the step.
void steps(auto& io, Stream name, double& value, double step_m) {
  const auto count = static_cast<std::int64_t>(std::floor(value / step_m + 0.5));
  auto zigzag = static_cast<std::uint64_t>(count) << 1 ^ static_cast<std::uint64_t>(count >> 63);
  io.number(name, zigzag);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    value = static_cast<double>(static_cast<std::int64_t>(zigzag >> 1 ^ (~(zigzag & 1) + 1))) * step_m;
    if (std::abs(value) > 2 * kMaxCoordinate_m) io.fail(name), value = 0;
  }
}

/// Bits, seven in a number, the first one in the least significant bit. Trailing false ones are removed from `all`, and
/// not written.
void bits(auto& io, Stream size, Stream name, std::vector<bool>& all) {
  while (!all.empty() && !all.back()) all.pop_back();
  const std::size_t count = io.count(size, (all.size() + 6) / 7);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint8_t group = 0;
    for (std::size_t k = 0; k < 7 && 7 * i + k < all.size(); ++k)
      group |= static_cast<std::uint8_t>(all[7 * i + k] << k);
    io.number(name, group);
    if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
      if (!io.wrong.empty()) return;
      for (int k = 0; k < 7; ++k) all.push_back((group >> k & 1) != 0);
    }
  }
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    while (!all.empty() && !all.back()) all.pop_back();
}

/// The points of outlines, each once, in the order in which they appear. Codes are those of PointCode
/// (chunk_io.h).
struct OutlinePoints {
  std::map<Vec2, std::size_t> numbers;
  std::vector<Vec2> all;
  std::size_t last = 0;  ///< The number of the previous point.

  void add(Vec2 p) { numbers.emplace(p, all.size()), last = all.size(), all.push_back(p); }
  std::uint64_t code_of(Vec2 p) const {
    const auto found = numbers.find(p);
    if (found == numbers.end()) return kNewPoint;
    return found->second == last + 1 ? kNextPoint : found->second + 1 == last ? kPreviousPoint : kFirstJump;
  }
};

/// A point of an outline: a new one as the difference to the previous one, or to (0, 0), in steps of kOutlineStep_m.
void outline_point(auto& io, OutlinePoints& known, Vec2& p) {
  std::uint64_t code = known.code_of(p);
  io.number("yard points", code);
  const Vec2 from = known.all.empty() ? Vec2{} : known.all[known.last];
  if (code == kNewPoint) {
    Vec2 step = p - from;
    steps(io, "yard x", step.x, lots::kOutlineStep_m), steps(io, "yard y", step.y, lots::kOutlineStep_m);
    return known.add(p = from + step);
  }
  double jump = code == kNextPoint ? 1 : -1;
  if (code == kFirstJump) {
    jump = static_cast<double>(known.numbers[p]) - static_cast<double>(known.last);
    steps(io, "yard point jumps", jump, 1);
  }
  const double to = static_cast<double>(known.last) + jump;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (code > kFirstJump || !(to >= 0 && to < static_cast<double>(known.all.size()))) return io.fail("yard points");
  known.last = static_cast<std::size_t>(to);
  p = known.all[known.last];
}

void serialise(auto& io, Polygon& polygon, OutlinePoints& known) {
  const auto ring = [&](Ring& all) {
    list(io, "yard ring points", all, 3, [&](Vec2& p) { outline_point(io, known, p); });
  };
  ring(polygon.outer);
  list(io, "yard holes", polygon.holes, 0, ring);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (const Box2 box = box_of(polygon.outer); !(std::max(box.width(), box.height()) <= lots::kLargestYard_m))
      io.fail("yard x");
}

/// The buildings and outline points of a chunk, and the place and heading of the yard before.
struct YardContext {
  std::vector<buildings::Building>& buildings;
  OutlinePoints points{};
  std::size_t next_building = 0;
  std::uint16_t heading = 0;
};

/// The building's place in the list of buildings, sorted by id; as many as buildings if it is not in it.
inline std::size_t place_in(const std::vector<buildings::Building>& buildings, ObjectId building) {
  const auto found = std::ranges::lower_bound(buildings, building, {}, &buildings::Building::id);
  const bool is_there = found != buildings.end() && found->id == building;
  return is_there ? static_cast<std::size_t>(found - buildings.begin()) : buildings.size();
}

/// The building, which is read before: 1 plus the number of buildings skipped since that of the previous yard; or 0,
/// then its id.
void building_of(auto& io, ObjectId& building, YardContext& context) {
  const std::size_t index = place_in(context.buildings, building);
  const bool is_listed = index >= context.next_building && index < context.buildings.size();
  std::size_t number = is_listed ? index - context.next_building + 1 : 0;
  io.number("yard building", number);
  if (number == 0) return id(io, building);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > context.buildings.size() - context.next_building) return io.fail("yard building");
  context.next_building += number;
  building = context.buildings[context.next_building - 1].id;
}

/// The setback of the building; 0 if it is not in the chunk.
inline double computed_setback(const lots::Yard& yard, const YardContext& context) {
  const std::size_t index = place_in(context.buildings, yard.building);
  if (index == context.buildings.size()) return 0;
  return lots::setback_of(context.buildings[index].footprint.outer, yard.frame);
}

void serialise(auto& io, lots::YardStrip& strip) {
  flag(io, "yard strip kind", strip.is_drive);
  steps(io, "yard strip x", strip.from.x, lots::kYardStep_m),
      steps(io, "yard strip y", strip.from.y, lots::kYardStep_m);
  double aside_m = strip.to.x - strip.from.x;
  steps(io, "yard strip aside", aside_m, lots::kYardStep_m);
  strip.to.x = strip.from.x + aside_m;
  steps(io, "yard strip end", strip.to.y, lots::kYardStep_m);
}

/// @param end  The end of the previous run, modulo 2^32; set to that of this one. Runs may be in any order.
void serialise(auto& io, lots::BorderRun& run, std::uint32_t& end) {
  enumerator(io, "border place", run.place, lots::BorderPlace::kCount);
  std::uint32_t gap = run.first - end;
  io.number("border steps", gap), io.number("border steps", run.count);
  run.first = end + gap, end = run.first + run.count;
}

void serialise(auto& io, lots::Yard& yard, YardContext& context) {
  building_of(io, yard.building, context);
  enumerator(io, "yard country", yard.country, map::CountryGroup::kCount);
  enumerator(io, "yard kind", yard.kind, lots::LotKind::kCount);
  flag(io, "yard kind", yard.is_arid), flag(io, "yard kind", yard.has_bays);
  serialise(io, yard.polygon, context.points);
  const Vec2 corner = yard.polygon.outer.empty() ? Vec2{} : yard.polygon.outer.front();
  Vec2 origin = yard.frame.origin - corner;
  steps(io, "yard frame x", origin.x, lots::kYardStep_m), steps(io, "yard frame y", origin.y, lots::kYardStep_m);
  yard.frame.origin = corner + origin;
  auto turn = static_cast<std::uint16_t>((yard.frame.heading - context.heading) & (lots::kHeadings - 1));
  io.number("yard heading", turn);
  yard.frame.heading = context.heading = static_cast<std::uint16_t>((context.heading + turn) & (lots::kHeadings - 1));
  const double usual_m = computed_setback(yard, context);
  double more_m = yard.setback_m - usual_m;
  steps(io, "yard setback", more_m, lots::kYardStep_m);
  yard.setback_m = usual_m + more_m;
  list(io, "yard strips", yard.strips, 0, [&](lots::YardStrip& strip) { serialise(io, strip); });
  std::uint32_t end = 0;
  list(io, "yard borders", yard.borders, 0, [&](lots::BorderRun& run) { serialise(io, run, end); });
  bits(io, "yard plants", "yard plant bits", yard.plants);
}

}  // namespace citykiln::exporters
