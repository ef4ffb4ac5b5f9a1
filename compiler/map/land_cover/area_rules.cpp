#include "compiler/map/land_cover/area_rules.h"

namespace citykiln::map {
namespace {

constexpr AreaRule kAreaRules[] = {
#define AREA(key, value, surface) {key, value, LandCoverClass::surface},
#include "compiler/map/land_cover/area_rules.inc"
#undef AREA
};

}  // namespace

std::span<const AreaRule> area_rules() { return kAreaRules; }

}  // namespace citykiln::map
