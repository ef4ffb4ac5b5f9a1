// Clouds as matt surfaces see them, as a table by direction.
#pragma once

#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// Light behind clouds becomes light passed + added.
struct CloudVeil {
  double passed = 1;
  Rgb added{};
};

/// Clouds along a ray and the air before them.
CloudVeil veil_of(const CloudPath& path, const sky::AirPath& before);

/// What clouds add, behind the air before them, and let pass, by the direction from one eye, in cells of about three
/// degrees: light that surfaces scatter does not show more. Other places below the clouds look up the direction in
/// which the eye sees the place where their ray meets the lowest base. Thread-safe.
class CloudDome {
 public:
  /// Cost: 12,288 rays. Same bits for any number of threads.
  CloudDome(const CloudField& field, const sky::SkyModel& model, Vec3 eye, int threads);

  /// Empty where the place or the eye is above the lowest base, and for directions that do not go up.
  std::optional<CloudVeil> along(Vec3 from, Vec3 direction) const;

 private:
  Vec3 eye_;
  double base_m_;
  std::vector<CloudVeil> cells_;
};

}  // namespace citykiln::preview
