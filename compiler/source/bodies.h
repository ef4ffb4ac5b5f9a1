// Tells things that can be seen from boundaries, routes, addresses and other elements that nothing is built of.
#pragma once

#include <string_view>

namespace citykiln::source {

/// True if a tag says that its element is a thing with a body, by bodies.inc: man_made=mast, landuse=meadow; not
/// boundary=administrative, shop=bakery. O(rows of the table).
bool has_body(std::string_view key, std::string_view value);

}  // namespace citykiln::source
