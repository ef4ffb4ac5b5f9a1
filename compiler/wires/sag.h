// How far wires sag: by the class of their line, and by what is below them.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/wires/recipe.h"

namespace citykiln::wires {

/// The practice of a class of lines.
struct SagClass {
  double parameter_m;  ///< The horizontal tension over the weight per metre.
  double clearance_m;  ///< The least height above the ground and above roads.
};
/// The parameters are estimates. Clearances: authorities ask for 4.6 to 7 m by voltage and place (Public Utilities
/// Commission of Sri Lanka, Height above the ground of overhead lines).
inline constexpr SagClass kLineSag{1225, 6}, kMinorLineSag{600, 5}, kAerialwaySag{1500, 5};

/// The smallest sag, as a share of the span.
inline constexpr double kTautShare = 0.005;

/// A height that a wire passes over.
struct Below {
  double t = 0;    ///< The share of the wire's length, 0 to 1.
  double z_m = 0;  ///< Plane height.
  bool is_road = false;
};

/// Returns the sag of a span: length_m² / (8 parameter_m), or less where a wire would be nearer than clearance_m to
/// what is below it, but at least kTautShare of the length. A multiple of kWireQuantum_m, rounded down.
/// @param wires   Their sags do not count.
/// @param below   One list for each wire.
double sag_m_of(std::span<const Wire> wires, std::span<const std::vector<Below>> below, double length_m,
                const SagClass& line);

/// Returns by how much a wire is too low: less than over_road_m above a road, or below the ground. 0: nowhere.
double shortfall_m(const Wire& wire, std::span<const Below> below, double over_road_m);

}  // namespace citykiln::wires
