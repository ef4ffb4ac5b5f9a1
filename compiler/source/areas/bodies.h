// Distinguishes visible things, which could be built, from boundaries, routes, addresses and other elements without a
// body.
#pragma once

#include <string_view>

namespace citykiln::source {

/// True if a tag says that its element is a visible thing, by bodies.inc: man_made=mast and landuse=meadow are,
/// boundary=administrative and shop=bakery are not. O(rows of the table).
bool has_body(std::string_view key, std::string_view value);

}  // namespace citykiln::source
