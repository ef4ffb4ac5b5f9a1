#include "compiler/wires/sag.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::wires {
namespace {

// The sag of a wire with which it has a clearance at a place; it may be negative.
double sag_with_clearance_m(const Wire& wire, const Below& below, double clearance_m) {
  const double straight_m = wire.from.z + (wire.to.z - wire.from.z) * below.t;
  return (straight_m - below.z_m - clearance_m) / (4 * below.t * (1 - below.t));
}

}  // namespace

double sag_m_of(std::span<const Wire> wires, std::span<const std::vector<Below>> below, double length_m,
                const SagClass& line) {
  assert(wires.size() == below.size());
  double sag_m = length_m * length_m / (8 * line.parameter_m);
  for (std::size_t i = 0; i < wires.size(); ++i)
    for (const Below& place : below[i])
      if (place.t > 0 && place.t < 1) sag_m = std::min(sag_m, sag_with_clearance_m(wires[i], place, line.clearance_m));
  sag_m = std::max(sag_m, kTautShare * length_m);
  return std::floor(sag_m / kWireQuantum_m) * kWireQuantum_m;
}

double shortfall_m(const Wire& wire, std::span<const Below> below, double over_road_m) {
  double largest_m = 0;
  for (const Below& place : below) {
    const double above_m = place_on(wire, place.t).z - place.z_m;
    largest_m = std::max(largest_m, (place.is_road ? over_road_m : 0) - above_m);
  }
  return largest_m;
}

}  // namespace citykiln::wires
