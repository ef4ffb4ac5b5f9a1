// The parts of ids: objects that are made from an element of another kind have parts of their own.
//
//     part          objects
//     from 0        polygons of a multipolygon, pieces of a way
//     from 0x1000   rims of pools
//     from 0x4000   derived objects: goals of fields, parked cars, yards, railings, axes of bridge areas, rails of
//                   roads, masts and wires along tracks
//     n · 2^16      pieces and treads of footprints
//     2^30, 2^31    traffic islands and junctions
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"

namespace citykiln {

/// The first part of derived objects. Their properties are those of the element that they are derived from.
inline constexpr std::uint32_t kFirstDerivedPart = 0x4000;

/// True for the id of a derived object. Ids of buildings and of land cover are not asked: their other parts are large.
constexpr bool is_derived(ObjectId id) { return id.part >= kFirstDerivedPart; }

/// Returns the id of the n-th object that is derived from an object. Parts must have few of these.
constexpr ObjectId derived_id(ObjectId from, std::uint32_t n) { return {from.osm, kFirstDerivedPart + from.part + n}; }

/// Returns the id of the n-th of at most `most` objects that are derived from each part of an element.
constexpr ObjectId derived_id(ObjectId from, std::uint32_t most, std::uint32_t n) {
  return {from.osm, kFirstDerivedPart + from.part * most + n};
}

/// Returns the id of the rim of a pool.
constexpr ObjectId rim_id(ObjectId pool) { return {pool.osm, pool.part + 0x1000}; }

/// Returns the id of the n-th piece or tread of a footprint, from 0 on.
constexpr ObjectId piece_id(ObjectId footprint, std::uint32_t n) {
  return {footprint.osm, footprint.part + (n + 1) * 0x10000};
}

/// Returns the id of the surface of a traffic island.
constexpr ObjectId island_id(ObjectId island) { return {island.osm, island.part | 0x40000000u}; }

/// Returns the id of the surface of a junction whose main road has this id.
constexpr ObjectId junction_id(ObjectId main_road) { return {main_road.osm, main_road.part | 0x80000000u}; }

}  // namespace citykiln
