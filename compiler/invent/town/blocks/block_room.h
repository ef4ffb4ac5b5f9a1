// Room on the land of a block: places things so that they lie within it and apart from each other.
#pragma once

#include <optional>

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/quarters.h"

namespace citykiln::invent {

class BlockRoom {
 public:
  /// @param number  The number of the block, for its random numbers.
  BlockRoom(const TownPlan& plan, const TownBlock& block, std::size_t number, const char* role);

  const Ring& land() const { return block_.land.outer; }
  /// The direction of the longest side of the land, length 1.
  Vec2 along() const { return along_; }
  Draws& draws() { return draws_; }

  /// Finds room for a rectangle with sides along and square to along(), margin_m from the land's border and gap_m from
  /// what is there, and takes it: the first of `tries` random places that fits. Its first edge runs along along().
  std::optional<Ring> take_box(double width_m, double depth_m, double margin_m, double gap_m, int tries = 60);
  /// Finds room for a rectangle as above, and shrinks it to 60 % in steps if there is none.
  std::optional<Ring> take_box_shrunk(double width_m, double depth_m, double margin_m, double gap_m);
  /// Takes a ring if it fits.
  bool take(const Ring& ring, double margin_m, double gap_m);
  /// True if a place is in the land, margin_m from its border and gap_m from what is there.
  bool is_free(Vec2 p, double margin_m, double gap_m) const;

  /// Paths from the streets about the block to its middle; they meet there. At most `count`, each through the land
  /// only. Takes a strip along each.
  std::vector<Polyline> take_paths(std::size_t count);

  /// Tries one random place for each each_m2 of the box of the land; adds a point where it is free and 4.5 m from
  /// others.
  void scatter(InventedMap& map, const Tags& tags, double each_m2, double margin_m, double gap_m);
  /// Adds points along the border of the land, inset_m inside, step_m apart, where there is room.
  void line_border(InventedMap& map, const Tags& tags, double inset_m, double step_m);

 private:
  bool reaches(Vec2 from, Vec2 to) const;

  const TownPlan& plan_;
  const TownBlock& block_;
  Draws draws_;
  Vec2 along_{1, 0};
  std::vector<Ring> taken_;
  std::vector<Polyline> paths_;
};

}  // namespace citykiln::invent
