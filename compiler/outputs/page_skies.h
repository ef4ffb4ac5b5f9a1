// The skies of the page: that of the run's time, and those of the same day.
#pragma once

#include <vector>

#include "compiler/scene/scene.h"
#include "exporters/page/page_json.h"

namespace citykiln::outputs {

/// Returns the sky of the run, and skies every three hours of local mean solar time on its date, with the same air; in
/// the order of the day. Cost: 0.4 s each, in parallel.
std::vector<exporters::PageSky> page_skies(const scene::Header& header, int threads);

}  // namespace citykiln::outputs
