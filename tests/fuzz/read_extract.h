// Checks that a file is an extract or an error of one line, for fuzz_extract and for
// tests/compiler/source/any_extract_test.cpp, which changes its seeds.
#pragma once

#include <cstdint>
#include <protozero/pbf_writer.hpp>
#include <string>
#include <string_view>

#include "compiler/source/read_osm.h"
#include "tests/scratch_folder.h"

namespace citykiln::source {

// A blob with its header and their lengths.
inline std::string framed_blob(const char* type, std::string_view blob) {
  std::string header;
  protozero::pbf_writer writer(header);
  writer.add_string(1, type), writer.add_int32(3, static_cast<std::int32_t>(blob.size()));
  return std::string{'\0', '\0', '\0', static_cast<char>(header.size())} + header + std::string(blob);
}

// A PBF file whose only blob of data is these bytes: its lengths are right.
inline std::string pbf_of_blob(std::string_view blob) {
  std::string head, raw;
  protozero::pbf_writer writer(head);
  writer.add_string(4, "OsmSchema-V0.6"), writer.add_string(4, "DenseNodes");
  protozero::pbf_writer(raw).add_bytes(1, head);
  return framed_blob("OSMHeader", raw) + framed_blob("OSMData", blob);
}

// Reads the bytes as a file of that name. Returns "" if they are elements or an error of one line, else what is wrong.
inline std::string fault_of_extract(const std::string& name, std::string_view bytes) {
  static const ScratchFolder folder;
  Report report;
  const Result<OsmData> data = read_osm(folder.write(name, bytes), 1, report);
  if (data) return "";
  const std::string line = to_string(data.error());
  if (data.error().message.empty()) return "an error without a message";
  return line.find('\n') == std::string::npos ? "" : "an error of several lines: " + line;
}

// Reads the bytes of a fuzzer as a file. The first one chooses: '0' XML, '1' a PBF file, '2' one blob of a PBF file,
// '3' and '4' packed XML.
inline std::string fault_of_bytes(std::string_view bytes) {
  if (bytes.empty()) return "";
  const std::string_view rest = bytes.substr(1);
  switch ((static_cast<unsigned char>(bytes[0]) + 256u - '0') % 5) {
    case 0:
      return fault_of_extract("map.osm", rest);
    case 1:
      return fault_of_extract("map.osm.pbf", rest);
    case 2:
      return fault_of_extract("map.osm.pbf", pbf_of_blob(rest));
    case 3:
      return fault_of_extract("map.osm.gz", rest);
    default:
      return fault_of_extract("map.osm.bz2", rest);
  }
}

}  // namespace citykiln::source
