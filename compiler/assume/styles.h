// Marks buildings that are built as is usual in their country group.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the features with Assumption::kStyles on each footprint: style, untagged materials and colours of the
/// building are those of Footprint::country. The choice among styles of a group, by storeys and party walls, is made
/// when buildings are planned (buildings/regional_styles.h). Tagged materials and colours stay. Each footprint is
/// decided by itself.
map::Features assume_styles(map::Features features, Report& report);

}  // namespace citykiln::assume
