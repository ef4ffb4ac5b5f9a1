// Values that tags state, and the guesses of them, for the chart of assumptions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"

namespace citykiln::charts {

/// A value of an element: the element, and the side of a way (0 left, 1 right) or 0.
using ValueKey = std::pair<OsmId, int>;
/// The values that are built of elements. Values of yes and no are 1 and 0.
using Values = std::map<ValueKey, double>;

/// Means of values by way, weighted by the lengths of its tracks.
struct MeansByWay {
  Values sums, lengths_m;

  void add(ValueKey key, double value, double length_m) { sums[key] += value * length_m, lengths_m[key] += length_m; }

  Values means() const {
    Values all;
    for (const auto& [key, sum] : sums) all[key] = sum / lengths_m.at(key);
    return all;
  }
};

/// A value that tags state.
struct Sample {
  ValueKey key;
  Vec2 at;               ///< The middle of the element, plane metres.
  int kind = 0;          ///< The class of the road or building.
  double tagged = 0;     ///< The value by the tags.
  double assumed = 0;    ///< The value that is assumed where the tags of the whole place are left out.
  double unassumed = 0;  ///< The value that is built there without assumptions.
  double constant = 0;   ///< The simple guess for a whole place: the constant of the class in other places.
  double in_block = 0;   ///< The value that is assumed where the tags of every other block are left out.
  double mean = 0;       ///< The simple guess for blocks: the mean of the nearest tagged values outside the block.
};

/// The side of the blocks that are left out within a place.
inline constexpr double kBlock_m = 256;
/// The colour of a place on the checkerboard of blocks, 0 or 1.
int block_colour(Vec2 at);

/// Sets Sample::constant: for numbers the median, else the share of yes, of the samples of the class in all other
/// places; of a single place, of its own. Classes with fewer than 5 samples have the constant of all classes. A share
/// of 0.5 and more counts as yes (score_of()).
void set_constants(std::span<std::vector<Sample>> places, bool is_yes_or_no);

/// Sets Sample::mean: of the eight nearest samples of the other colour.
void set_means(std::span<Sample> samples);

/// How good guesses are.
struct Score {
  std::size_t samples = 0;
  double half = 0;    ///< Half of the errors are at most this; of values of yes and no, the balanced accuracy.
  double tenths = 0;  ///< Nine tenths of the errors are at most this; of values of yes and no, the share of yes.
};
/// Scores guesses. A yes-or-no guess of 0.5 and more is a yes. Balanced accuracy: the mean of the shares of the tagged
/// yes and the tagged no that are guessed; 0.5 for always the same guess. Where all tags say the same, it is the share
/// that is guessed.
Score score_of(std::span<const Sample> samples, double Sample::*guess, bool is_yes_or_no);

/// The median of one value of samples; 0 for none.
double median_of(std::span<const Sample> samples, double Sample::*value);

/// The shares of the tagged yes and of the tagged no that are guessed to be yes; 0 for none.
struct YesShares {
  double of_yes = 0, of_no = 0;
};
YesShares yes_shares_of(std::span<const Sample> samples, double Sample::*guess);

}  // namespace citykiln::charts
