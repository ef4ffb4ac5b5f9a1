#include "compiler/source/format/decode_osm.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/thread/pool.hpp>
#include <thread>

#include "compiler/source/closing_ring.h"
#include "compiler/source/format/mended_xml.h"
#include "compiler/source/format/osm_format.h"
#include "compiler/source/format/plain_words.h"

namespace citykiln::source {
namespace {

const char* osmium_name(OsmFormat format) {
  switch (format) {
    case OsmFormat::kXml:
      return "osm";
    case OsmFormat::kXmlGzip:
      return "osm.gz";
    case OsmFormat::kXmlBzip2:
      return "osm.bz2";
    case OsmFormat::kPbf:
      return "pbf";
  }
  return "";
}

std::optional<LonLatBox> box_of_header(const osmium::io::Header& header) {
  const osmium::Box box = header.joined_boxes();
  if (!box.valid()) return std::nullopt;
  return LonLatBox{box.bottom_left().lon(), box.bottom_left().lat(), box.top_right().lon(), box.top_right().lat()};
}

// The header numbers the optional features of a PBF file.
bool has_places_in_ways(const osmium::io::Header& header) {
  for (int i = 0;; ++i) {
    const std::string feature = header.get(fmt::format("pbf_optional_feature_{}", i));
    if (feature.empty() || feature == "LocationsOnWays") return !feature.empty();
  }
}

// The file, or the text that stands for it.
osmium::io::File source_of(const std::string& path, OsmFormat format, const std::optional<std::string>& text) {
  const OsmFormat of_text = format == OsmFormat::kPbf ? OsmFormat::kPbf : OsmFormat::kXml;
  if (text) return osmium::io::File(text->data(), text->size(), osmium_name(of_text));
  // an absolute path, since libosmium would pass a name like http:x to curl
  return osmium::io::File(std::filesystem::absolute(path).string(), osmium_name(format));
}

DecodedOsm decode_file(const osmium::io::File& file, int threads) {
  osmium::thread::Pool pool(threads > 0 ? threads
                                        : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  osmium::io::Reader reader(file, osmium::osm_entity_bits::nwr, pool);
  DecodedOsm decoded;
  decoded.header_box = box_of_header(reader.header());
  decoded.is_of_region = reader.header().get("generator") == kGeneratorOfRegions;
  decoded.has_places_in_ways = has_places_in_ways(reader.header());
  while (osmium::memory::Buffer buffer = reader.read()) {
    make_words_plain(buffer);
    decoded.buffers.push_back(std::move(buffer));
  }
  reader.close();
  return decoded;
}

}  // namespace

Result<DecodedOsm> decode_osm(const std::string& path, int threads) {
  const Result<OsmFormat> format = osm_format_of(path);
  if (!format) return format.error();
  const Result<std::optional<std::string>> mended = mended_file(path, *format);
  if (!mended) return mended.error();
  try {
    return decode_file(source_of(path, *format, *mended), threads);
  } catch (const osmium::xml_error& error) {
    if (error.line == 0) return Error{path, error.error_string};
    return Error{fmt::format("{}:{}:{}", path, error.line, error.column + 1),
                 reading_error("malformed XML: " + error.error_string)};
  } catch (const std::bad_alloc&) {
    return Error{path, "not enough memory to hold the extract"};
  } catch (const std::exception& error) {
    return Error{path, reading_error(error.what())};
  }
}

}  // namespace citykiln::source
