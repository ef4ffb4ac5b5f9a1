// The streams of a chunk: one a property, by names that the compiler looks up.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace citykiln::exporters {

/// In the order in which a chunk holds them. Part of the format: add at the end.
inline constexpr std::array kStreamNames = {"point step",
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
                                            "tree species",
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

/// One of them: "knot height" where a Stream is wanted. A name that is not listed does not compile.
struct Stream {
  std::size_t number;
  consteval Stream(const char* name)  // NOLINT: implicit, so that names read as names
      : number(
            static_cast<std::size_t>(std::ranges::find(kStreamNames, std::string_view(name)) - kStreamNames.begin())) {
    if (number == kStreamNames.size()) throw "a name of the list";
  }
  const char* name() const { return kStreamNames[number]; }
};

}  // namespace citykiln::exporters
