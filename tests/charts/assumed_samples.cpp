#include "tests/charts/assumed_samples.h"

#include <algorithm>
#include <cmath>

namespace citykiln::charts {
namespace {

/// The fewest samples of a class that have a constant of their own, and the neighbours of a mean.
constexpr std::size_t kFewestOfClass = 5, kNeighbours = 8;

/// The value below which a share of the values lies; 0 for none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, at);
  return *at;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// Tagged values by class.
struct TaggedByClass {
  std::map<int, std::vector<double>> classes;
  std::vector<double> all;

  void add(std::span<const Sample> samples) {
    for (const Sample& sample : samples) classes[sample.kind].push_back(sample.tagged), all.push_back(sample.tagged);
  }

  double constant(int kind, bool is_yes_or_no) const {
    const auto found = classes.find(kind);
    const bool has_class = found != classes.end() && found->second.size() >= kFewestOfClass;
    const std::vector<double>& values = has_class ? found->second : all;
    return is_yes_or_no ? mean_of(values) : quantile(values, 0.5);
  }
};

double mean_of_nearest(std::span<const Sample> samples, const Sample& sample) {
  std::vector<std::pair<double, double>> near;  // distance and value
  for (const Sample& other : samples)
    if (block_colour(other.at) != block_colour(sample.at))
      near.emplace_back(distance(other.at, sample.at), other.tagged);
  const std::size_t count = std::min(kNeighbours, near.size());
  std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(near[i].second);
  return mean_of(values);
}

Score balanced_accuracy(std::span<const Sample> samples, double Sample::*guess) {
  double right[2] = {0, 0}, all[2] = {0, 0};
  for (const Sample& sample : samples) {
    const int is_yes = sample.tagged >= 0.5 ? 1 : 0;
    all[is_yes] += 1;
    right[is_yes] += (sample.*guess >= 0.5) == (is_yes == 1) ? 1 : 0;
  }
  double sum = 0, values = 0, count = 0;
  for (const int value : {0, 1})
    if (all[value] > 0) sum += right[value] / all[value], values += 1, count += all[value];
  return {samples.size(), values > 0 ? sum / values : 0, count > 0 ? all[1] / count : 0};
}

}  // namespace

int block_colour(Vec2 at) {
  const auto block = [](double m) { return static_cast<long>(std::floor(m / kBlock_m)); };
  return static_cast<int>((block(at.x) + block(at.y)) & 1);
}

void set_constants(std::span<std::vector<Sample>> places, bool is_yes_or_no) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    TaggedByClass known;
    for (std::size_t j = 0; j < places.size(); ++j)
      if (j != i) known.add(places[j]);
    if (known.all.empty()) known.add(places[i]);
    for (Sample& sample : places[i]) sample.constant = known.constant(sample.kind, is_yes_or_no);
  }
}

void set_means(std::span<Sample> samples) {
  for (Sample& sample : samples) sample.mean = mean_of_nearest(samples, sample);
}

double median_of(std::span<const Sample> samples, double Sample::*value) {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(sample.*value);
  return quantile(values, 0.5);
}

YesShares yes_shares_of(std::span<const Sample> samples, double Sample::*guess) {
  double yes[2] = {0, 0}, all[2] = {0, 0};
  for (const Sample& sample : samples) {
    const int is_yes = sample.tagged >= 0.5 ? 1 : 0;
    all[is_yes] += 1, yes[is_yes] += sample.*guess >= 0.5 ? 1 : 0;
  }
  return {all[1] > 0 ? yes[1] / all[1] : 0, all[0] > 0 ? yes[0] / all[0] : 0};
}

Score score_of(std::span<const Sample> samples, double Sample::*guess, bool is_yes_or_no) {
  if (is_yes_or_no) return balanced_accuracy(samples, guess);
  std::vector<double> errors;
  for (const Sample& sample : samples) errors.push_back(std::abs(sample.*guess - sample.tagged));
  return {samples.size(), quantile(errors, 0.5), quantile(errors, 0.9)};
}

}  // namespace citykiln::charts
