// The sources of the data as one text, which formats with one field for them carry.
#pragma once

#include <string>
#include <vector>

namespace citykiln::exporters {

/// The attributions in their order, "; " between them.
inline std::string joined_attributions(const std::vector<std::string>& attributions) {
  std::string all;
  for (const std::string& attribution : attributions) all += (all.empty() ? "" : "; ") + attribution;
  return all;
}

}  // namespace citykiln::exporters
