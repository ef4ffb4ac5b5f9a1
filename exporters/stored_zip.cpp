#include "exporters/stored_zip.h"

#include <cstdint>
#include <limits>

#include "exporters/zip_writer.h"

namespace citykiln::exporters {

Result<std::vector<std::byte>> stored_zip(std::span<const ZippedFile> files, std::size_t alignment) {
  const Error too_large{"", "a zip archive has at most 4 GB"};
  ZipWriter zip{.alignment = alignment};
  std::vector<std::byte> out;
  for (const ZippedFile& file : files) {
    const Result<std::vector<std::byte>> header = add_zip_file(zip, file.name, file.bytes);
    if (!header) return too_large;
    out.insert(out.end(), header->begin(), header->end());
    out.insert(out.end(), file.bytes.begin(), file.bytes.end());
  }
  const std::vector<std::byte> directory = zip_directory(zip);
  out.insert(out.end(), directory.begin(), directory.end());
  if (out.size() > std::numeric_limits<std::uint32_t>::max() ||
      files.size() >= std::numeric_limits<std::uint16_t>::max())
    return too_large;
  return out;
}

}  // namespace citykiln::exporters
