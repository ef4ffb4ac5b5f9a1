// Trees by the parameters of Weber and Penn, "Creation and Rendering of Realistic Trees" (SIGGRAPH 1995): stems of up
// to four levels, each with the numbers, lengths, angles and curves of its stems. notation.md explains .tree files.
//
//   level 0: trunk ─ 1: branches along it, their length by the tree's shape ─ 2, 3: twigs ─ leaves on the last level
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/rewriting/skeleton.h"

namespace citykiln::lsystems {

/// The parameters of a level. Angles are in degrees, lengths in shares of the parent's length.
struct StemParameters {
#define LEVEL_PARAMETER(name, member, least, most, value) double member = value;
#include "lsystems/weber_penn_parameters.inc"
};

/// The parameters of a tree. Lengths are in metres.
struct TreeParameters {
  std::string file;
#define PARAMETER(name, member, least, most, value) double member = value;
#include "lsystems/weber_penn_parameters.inc"
  std::array<StemParameters, 4> level{};
  std::string leaf;  ///< The picture of a leaf card, as in .lsys files: "oak_leaf".
  std::string bark;  ///< The name of a bark material, or empty.
};

/// Reads a .tree file: a parameter, =, and its value in a line; "#" begins a comment. Parameters that are missing have
/// the defaults of weber_penn_parameters.inc.
///
/// Errors, with file, line and column: an unknown parameter, one that is given twice, a value outside its range, a line
/// of another form; more than kTextLimit bytes; parameters that allow more than 4,000,000 stems.
Result<TreeParameters> read_weber_penn(std::string_view text, std::string_view file);

/// A grown tree.
struct GrownTree {
  Skeleton skeleton;  ///< In metres. All instances have the kind 0.
  /// It would have more than kMostPlantParts parts, or take too long; the skeleton has the rest.
  bool stopped = false;
};

/// Grows a tree. Equations of the paper, except:
///   - stems beside their parent are closed tubes of their own, which begin on its axis;
///   - the substems of a stem with clones (splits) are shared out among the clones, so that their number stays;
///   - a card shows LeavesPerCard leaves, with the area of all of them, times LeafArea;
///   - the clones of 0BaseSplits stand evenly about the trunk;
///   - Lobes, LobeDepth, Flare and LeafShape are read but not used: cross-sections are round, and feet flare as those
///     of all plants do. Nor are ScaleV and ZScaleV: the scene decides the height of each plant;
///   - the lower part of the envelope of pruning is as wide at its peak as the upper one.
/// Guarantees: the same bits on every machine; all numbers are finite. O(parts), some 10 ms.
GrownTree grow_tree(const TreeParameters& tree, std::uint64_t seed);

}  // namespace citykiln::lsystems
