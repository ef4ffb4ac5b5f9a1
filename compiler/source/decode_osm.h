// Decodes a whole OSM file into memory buffers with libosmium; all later steps work on these buffers.
#pragma once

#include <optional>
#include <osmium/memory/buffer.hpp>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Elements in file order.
struct DecodedOsm {
  std::vector<osmium::memory::Buffer> buffers;
  std::optional<LonLatBox> header_box;
  bool has_places_in_ways = false;  ///< Ways state the places of their nodes (LocationsOnWays).
};

/// Errors: those of read_osm(). Memory: about 25 times the size of a PBF file, about the size of plain XML.
Result<DecodedOsm> decode_osm(const std::string& path, int threads);

}  // namespace citykiln::source
