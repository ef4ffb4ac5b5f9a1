#include "compiler/ground/water/fit_rivers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "compiler/ground/water/river_depth.h"

namespace citykiln::ground {
namespace {

constexpr std::uint32_t kNoStream = 0xffffffffu;

bool meets_standing_water(const RiverNetwork& network, const RiverLine& line) {
  return std::ranges::any_of(line.stops, [&](const RiverStation& stop) { return network.is_water(stop.node); });
}

// A stream that is too far off.
struct Offender {
  std::uint32_t stream;
  double off_m;
  bool is_off_alone;
  auto blame() const { return std::tuple(is_off_alone, off_m, ~stream); }
};

// Returns those that share no node with one of more blame.
std::vector<Offender> most_blamed(const RiverNetwork& network, const std::vector<Offender>& offenders) {
  std::vector<std::uint32_t> worst(network.nodes.size(), kNoStream);
  const auto for_each_node = [&](const Offender& offender, auto visit) {
    for (const RiverStation& stop : network.lines[offender.stream].stops) visit(worst[stop.node]);
  };
  for (std::uint32_t i = 0; i < offenders.size(); ++i)
    for_each_node(offenders[i], [&](std::uint32_t& known) {
      if (known == kNoStream || offenders[known].blame() < offenders[i].blame()) known = i;
    });
  std::vector<Offender> most;
  for (std::uint32_t i = 0; i < offenders.size(); ++i) {
    bool is_most = true;
    for_each_node(offenders[i], [&](std::uint32_t known) { is_most = is_most && known == i; });
    if (is_most) most.push_back(offenders[i]);
  }
  return most;
}

class RiverFit {
 public:
  RiverFit(const RiverNetwork& network, const std::vector<bool>& seas, std::span<const double> max_off_m, double run_m)
      : network_(network),
        seas_(seas),
        max_off_m_(max_off_m),
        run_m_(run_m),
        left_out_(network.lines.size()),
        is_off_alone_(max_off_m.size()),
        fitted_{{}, std::vector<Apart>(max_off_m.size(), Apart::kNot), std::vector<double>(max_off_m.size())} {}

  FittedRivers fit() {
    for (int round = 1;; ++round) {
      fitted_.heights = find_river_heights(network_, seas_, left_out_);
      const std::vector<Offender> offenders = find_offenders();
      if (offenders.empty()) return std::move(fitted_);
      for (const Offender& offender : round < kCarefulRounds ? most_blamed(network_, offenders) : offenders)
        leave_out(offender);
    }
  }

 private:
  std::vector<Offender> find_offenders() {
    std::vector<Offender> offenders;
    for (std::uint32_t s = 0; s < max_off_m_.size(); ++s) {
      if (left_out_[s]) continue;
      const RiverLine& line = network_.lines[s];
      fitted_.off_m[s] = sustained_depth_m(network_, line, heights_of_stops(line, fitted_.heights), run_m_);
      if (fitted_.off_m[s] > max_off_m_[s]) offenders.push_back({s, fitted_.off_m[s], is_off_alone(s)});
    }
    return offenders;
  }

  bool is_off_alone(std::uint32_t s) {
    if (!is_off_alone_[s]) is_off_alone_[s] = off_alone_m(network_, network_.lines[s], seas_, run_m_) > max_off_m_[s];
    return *is_off_alone_[s];
  }

  void leave_out(const Offender& offender) {
    left_out_[offender.stream] = true;
    fitted_.apart[offender.stream] = offender.is_off_alone ? Apart::kRises
                                     : meets_standing_water(network_, network_.lines[offender.stream])
                                         ? Apart::kLake
                                         : Apart::kNeighbours;
  }

  const RiverNetwork& network_;
  const std::vector<bool>& seas_;
  std::span<const double> max_off_m_;
  double run_m_;
  std::vector<bool> left_out_;                     // per line
  std::vector<std::optional<bool>> is_off_alone_;  // per stream, once it was asked for
  FittedRivers fitted_;
};

}  // namespace

std::vector<double> heights_of_stops(const RiverLine& line, const RiverHeights& heights) {
  std::vector<double> of_stops;
  for (const RiverStation& stop : line.stops) of_stops.push_back(heights.height_m[stop.node]);
  return of_stops;
}

double off_alone_m(const RiverNetwork& network, const RiverLine& line, const std::vector<bool>& seas, double run_m) {
  const std::vector<double> heights = heights_alone(network, line, seas);
  double off_m = sustained_depth_m(network, line, heights, run_m);
  for (std::size_t i = 0; i < line.stops.size(); ++i)
    if (network.is_water(line.stops[i].node))
      off_m = std::max(off_m, std::abs(heights[i] - network.nodes[line.stops[i].node].land_m));
  return off_m;
}

FittedRivers fit_rivers(const RiverNetwork& network, const std::vector<bool>& seas, std::span<const double> max_off_m,
                        double run_m) {
  assert(seas.size() == network.water_count && max_off_m.size() <= network.lines.size());
  return RiverFit(network, seas, max_off_m, run_m).fit();
}

}  // namespace citykiln::ground
