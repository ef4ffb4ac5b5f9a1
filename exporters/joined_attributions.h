// The sources of the data as one text, for formats that have one field for them.
#pragma once

#include <string>
#include <vector>

namespace citykiln::exporters {

/// Returns the attributions in their order, joined by "; ".
inline std::string joined_attributions(const std::vector<std::string>& attributions) {
  std::string all;
  for (const std::string& attribution : attributions) all += (all.empty() ? "" : "; ") + attribution;
  return all;
}

}  // namespace citykiln::exporters
