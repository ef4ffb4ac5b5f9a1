// Reads and writes the fields of buildings. `io` is a Writer, a Reader or a PointStepProbe (chunk_io.h); each function
// serves all three. The strings are names of streams. With a Reader the functions check values: io.fail(stream) marks
// the chunk as wrong, reading goes on, and decode_chunk() refuses the chunk at its end.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "compiler/buildings/recipe.h"
#include "compiler/map/buildings/building_classes.h"
#include "exporters/kiln/member_codecs.h"

namespace citykiln::exporters {

/// A colour that may be missing.
void colour(auto& io, std::optional<map::Srgb>& value) {
  bool is_there = value.has_value();
  flag(io, "colours", is_there);
  if (!is_there) return;
  if (!value) value.emplace();
  for (std::uint8_t& c : *value) io.number("colour values", c);
}

/// The shape of a roof; flat roofs have only their form.
void serialise(auto& io, roofs::RoofShape& roof) {
  enumerator(io, "roof form", roof.form, roofs::RoofForm::kCount);
  if (roof.form == roofs::RoofForm::kFlat) return;
  io.metres("roof rise", roof.height_m);
  bool has_direction = roof.direction.has_value();
  flags(io, "roof traits", has_direction, roof.is_ridge_across);
  io.metres("roof eaves", roof.overhang_m);
  if (!has_direction) return;
  if (!roof.direction) roof.direction.emplace();
  io.metres("roof direction", roof.direction->x), io.metres("roof direction", roof.direction->y);
}

/// An edge of a footprint: doors, buried storeys and the flag of a street, as one number.
void serialise(auto& io, buildings::FacadeEdge& f) {
  auto number = 512u * f.doors + 2u * f.buried_storeys + (f.faces_street ? 1 : 0);
  io.number("facade edge", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number >> 9 > 0xffff) io.fail("facade edge");
  f = {(number & 1) != 0, static_cast<std::uint8_t>(number / 2 & 0xff), static_cast<std::uint16_t>(number >> 9)};
}

/// A part of a wall that touches a neighbour.
/// @param edges  The number of edges of the footprint.
void serialise(auto& io, buildings::PartyWall& w, std::size_t edges) {
  io.number("party edge", w.edge);
  io.metres("party place", w.from_m), io.metres("party place", w.to_m), io.metres("party top", w.top_m);
  flags(io, "party traits", w.is_hidden, w.has_windows_above);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (w.edge >= edges || !(w.from_m >= 0 && w.from_m < w.to_m)) io.fail("party edge");
}

/// A place where the number of buried storeys of an edge changes.
/// @param edges  The number of edges of the footprint.
void serialise(auto& io, buildings::BuriedFrom& b, std::size_t edges) {
  io.number("buried edge", b.edge);
  io.metres("buried from", b.from_m);
  io.number("buried storeys", b.storeys);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (b.edge >= edges || !(b.from_m > 0)) io.fail("buried edge");
}

/// A shop front.
/// @param edges  The number of edges of the footprint.
void serialise(auto& io, buildings::Front& f, std::size_t edges) {
  io.number("front edge", f.edge);
  quanta(io, "front place", f.from_m, buildings::kFrontStep_m),
      quanta(io, "front place", f.to_m, buildings::kFrontStep_m);
  auto kind = 2 * static_cast<std::uint64_t>(f.kind) + (f.is_assumed ? 1 : 0);
  io.number("front kind", kind);
  f.is_assumed = (kind & 1) != 0, f.kind = static_cast<map::FrontKind>(kind / 2);
  bool has_hours = f.hours.has_value();
  flag(io, "front hours", has_hours);
  if (has_hours && !f.hours) f.hours.emplace();
  if (has_hours)
    for (std::uint8_t& quarter : f.hours->quarters) io.number("front hours", quarter);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (f.edge >= edges) io.fail("front edge");
    if (!(f.from_m >= 0 && f.from_m < f.to_m)) io.fail("front place");
    if (kind / 2 >= static_cast<std::uint64_t>(map::FrontKind::kCount)) io.fail("front kind"), f.kind = {};
    if (has_hours && std::ranges::max(f.hours->quarters) > map::kLatestClosing) io.fail("front hours");
  }
}

/// An opening for a way. Its sides are up to 64 m from its axis.
void serialise(auto& io, buildings::Passageway& p) {
  id(io, p.way);
  points(io, "passageway points", p.axis, 2);
  io.metres("passageway sides", p.left_m), io.metres("passageway sides", p.right_m);
  io.metres("passageway top", p.top_m);
  io.metres("passageway pillars", p.pillars_left_m), io.metres("passageway pillars", p.pillars_right_m);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    constexpr double kMost_m = 64;
    const bool has_width = p.left_m + p.right_m > 0 && std::abs(p.left_m) <= kMost_m && std::abs(p.right_m) <= kMost_m;
    if (!has_width) io.fail("passageway sides");
    if (std::abs(p.pillars_left_m) > kMost_m || std::abs(p.pillars_right_m) > kMost_m) io.fail("passageway pillars");
    if (std::ranges::adjacent_find(p.axis) != p.axis.end()) io.fail("passageway points");
  }
}

// True if heights are in order and the roof fits, as generating a building requires.
inline bool has_ordered_heights(const buildings::Building& b) {
  return b.bottom_m < b.top_m && b.bottom_m <= b.floor_m && b.floor_m <= eaves_m(b) && b.levels > 0 &&
         b.roof_shape.height_m >= 0 && b.roof_shape.overhang_m >= 0 && b.roof_shape.overhang_m <= 16 &&
         (b.posts.empty() || b.post_foot_m < b.bottom_m);
}

/// The properties that decide the walls of a building.
void facade(auto& io, buildings::Building& b) {
  const std::size_t edges = b.footprint.outer.size();
  enumerator(io, "style", b.style, buildings::Style::kCount);
  enumerator(io, "building class", b.building_class, static_cast<std::uint8_t>(map::BuildingClass::kCount));
  io.number("storeys", b.levels), io.number("year", b.year);
  flag(io, "shop", b.has_shop);
  enumerator(io, "building country", b.country, map::CountryGroup::kCount);
  io.number("building assumed", b.assumed);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (b.assumed > kAllAssumptions) io.fail("building assumed");
  list(io, "facade edges", b.facade_edges, 0, [&](buildings::FacadeEdge& f) { serialise(io, f); });
  list(io, "buried places", b.buried_from, 0, [&](buildings::BuriedFrom& f) { serialise(io, f, edges); });
  list(io, "party walls", b.party_walls, 0, [&](buildings::PartyWall& w) { serialise(io, w, edges); });
}

/// A building.
void serialise(auto& io, buildings::Building& b) {
  id(io, b.id);
  points(io, "footprint points", b.footprint.outer, 3);
  list(io, "footprint holes", b.footprint.holes, 0, [&](Ring& hole) { points(io, "hole points", hole, 3); });
  io.metres("building bottom", b.bottom_m), io.metres("building floor", b.floor_m), io.metres("building top", b.top_m);
  flag(io, "building stands", b.stands_on_ground);
  enumerator(io, "wall", b.wall, materials::Material::kCount);
  enumerator(io, "roof", b.roof, materials::Material::kCount);
  colour(io, b.wall_colour), colour(io, b.roof_colour);
  serialise(io, b.roof_shape);
  facade(io, b);
  points(io, "posts", b.posts, 0);
  if (!b.posts.empty()) io.metres("post foot", b.post_foot_m);
  list(io, "passageways", b.passageways, 0, [&](buildings::Passageway& p) { serialise(io, p); });
  list(io, "fronts", b.fronts, 0, [&](buildings::Front& f) { serialise(io, f, b.footprint.outer.size()); });
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (!has_ordered_heights(b)) io.fail("building top");
}

}  // namespace citykiln::exporters
