#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

std::string_view name_of(CloudKind kind) {
  switch (kind) {
    case CloudKind::kCumulus:
      return "cumulus";
    case CloudKind::kStratus:
      return "stratus";
    case CloudKind::kCirrus:
      return "cirrus";
    case CloudKind::kCount:
      break;
  }
  return "";
}

bool is_sound(const CloudLayer& layer) {
  return layer.kind < CloudKind::kCount && layer.cover >= 0 && layer.cover <= 1 && layer.base_m >= kLowestCloud_m &&
         layer.top_m <= kHighestCloud_m && layer.top_m - layer.base_m >= kThinnestCloud_m &&
         length(layer.wind) <= kStrongestWind_m_s;
}

}  // namespace citykiln::sky
