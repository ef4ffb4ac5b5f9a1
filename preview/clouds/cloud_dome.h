// The clouds' part of the light that falls on matt surfaces, as a table by direction.
#pragma once

#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// The effect of clouds on the light from behind them: light · passed + added.
struct CloudVeil {
  double passed = 1;  ///< Share of the light from behind that passes, 0 to 1.
  Rgb added{};        ///< Radiance that the clouds add.
};

/// Returns the effect of clouds along a ray together with the air before them.
CloudVeil veil_of(const CloudPath& path, const sky::AirPath& before);

/// A table of CloudVeil by the direction from one eye, in cells of about three degrees; scattered light does not show
/// finer detail. For another place below the clouds, the ray is followed to the height of the lowest base, and the
/// table is read in the direction from the eye to that point. Thread-safe.
class CloudDome {
 public:
  /// Computes the table for an eye (plane metres). Cost: 12,288 rays. Same bits for any number of threads.
  CloudDome(const CloudField& field, const sky::SkyModel& model, Vec3 eye, int threads);

  /// Returns the effect of clouds along a ray. Empty where the place or the eye is above the lowest base, and for
  /// directions that do not go up.
  std::optional<CloudVeil> along(Vec3 from, Vec3 direction) const;

 private:
  Vec3 eye_;
  double base_m_;
  std::vector<CloudVeil> cells_;
};

}  // namespace citykiln::preview
