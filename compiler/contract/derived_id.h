// The part numbers of ids. An object that is made from an element has the element's id and a part from these ranges.
//
//     part          objects
//     from 0        polygons of a multipolygon, pieces of a way
//     from 0x1000   rims of pools
//     from 0x4000   derived objects: goals of pitches, yards, railings, axes of bridge areas, rails of
//                   roads, masts and wires along tracks
//     n · 2^16      pieces and treads of footprints
//     from 2^28     fields of farmland, and the hedges and walls between them
//     from 2^29     hedges and guard rails beside roads
//     2^30, 2^31    traffic islands and junctions
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"

namespace citykiln {

/// The first part of derived objects. Their properties are those of the element that they are derived from.
inline constexpr std::uint32_t kFirstDerivedPart = 0x4000;

/// True for the id of a derived object. It is true for pieces, treads, islands and junctions too, since their parts are
/// larger. A caller that asks ids of buildings or of land cover must tell these apart first.
constexpr bool is_derived(ObjectId id) { return id.part >= kFirstDerivedPart; }

/// Returns the id of the n-th object that is derived from an object. The n-th of part p has the id of the first of part
/// p + n, so elements of several parts use the form with `most`.
constexpr ObjectId derived_id(ObjectId from, std::uint32_t n) { return {from.osm, kFirstDerivedPart + from.part + n}; }

/// Returns the id of the n-th object, from 0 to most - 1, that is derived from a part of an element. Ids of different
/// parts differ.
constexpr ObjectId derived_id(ObjectId from, std::uint32_t most, std::uint32_t n) {
  return {from.osm, kFirstDerivedPart + from.part * most + n};
}

/// Returns the id of the rim of a pool.
constexpr ObjectId rim_id(ObjectId pool) { return {pool.osm, pool.part + 0x1000}; }

/// Returns the id of the n-th piece or tread of a footprint, from 0 on.
constexpr ObjectId piece_id(ObjectId footprint, std::uint32_t n) {
  return {footprint.osm, footprint.part + (n + 1) * 0x10000};
}

/// The parts of fields and of the hedges and walls between them are below twice this.
inline constexpr std::uint32_t kFirstFieldPart = 1u << 28;

/// Returns the id of a field, or of a barrier between fields, of an area of land. Ids of different numbers differ.
/// @param number  Below kFirstFieldPart.
constexpr ObjectId field_id(ObjectId land, std::uint32_t number) {
  return {land.osm, kFirstFieldPart | (number & (kFirstFieldPart - 1))};
}

/// True for an id that field_id() made.
constexpr bool is_of_field(ObjectId id) { return (id.part & ~(kFirstFieldPart - 1)) == kFirstFieldPart; }

/// Returns the id of the n-th hedge or guard rail beside a road, below 2^16; roads have parts below 2^13.
constexpr ObjectId roadside_id(ObjectId road, std::uint32_t n) {
  return {road.osm, 2 * kFirstFieldPart + (road.part << 16) + n};
}

/// True for an id that roadside_id() made.
constexpr bool is_of_roadside(ObjectId id) { return id.part >= 2 * kFirstFieldPart && id.part < 4 * kFirstFieldPart; }

/// Returns the id of the surface of a traffic island.
constexpr ObjectId island_id(ObjectId island) { return {island.osm, island.part | 0x40000000u}; }

/// Returns the id of the surface of a junction whose main road has this id.
constexpr ObjectId junction_id(ObjectId main_road) { return {main_road.osm, main_road.part | 0x80000000u}; }

}  // namespace citykiln
