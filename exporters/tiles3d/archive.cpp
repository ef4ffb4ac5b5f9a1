#include "exporters/tiles3d/archive.h"

#include <algorithm>
#include <utility>

#include "exporters/tiles3d/md5.h"

namespace citykiln::exporters {
namespace {

constexpr const char* kIndexName = "@3dtilesIndex1@";

std::uint64_t half_of_md5(const ArchivePlace& place, std::size_t half) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) value |= static_cast<std::uint64_t>(place.md5[8 * half + i]) << 8 * i;
  return value;
}

}  // namespace

std::vector<std::byte> archive_index(std::vector<ArchivePlace> places) {
  std::ranges::sort(places, {},
                    [](const ArchivePlace& place) { return std::pair(half_of_md5(place, 0), half_of_md5(place, 1)); });
  std::vector<std::byte> bytes;
  for (const ArchivePlace& place : places) {
    bytes.insert(bytes.end(), place.md5.begin(), place.md5.end());
    for (std::size_t i = 0; i < sizeof place.offset; ++i)
      bytes.push_back(static_cast<std::byte>(place.offset >> 8 * i));
  }
  return bytes;
}

Result<std::vector<std::byte>> add_to_archive(TilesetArchive& archive, const std::string& name,
                                              std::span<const std::byte> bytes) {
  archive.index.push_back({md5(name), archive.zip.size});
  return add_zip_file(archive.zip, name, bytes);
}

Result<std::vector<std::byte>> end_of_archive(TilesetArchive archive) {
  const std::vector<std::byte> index = archive_index(std::move(archive.index));
  Result<std::vector<std::byte>> end = add_zip_file(archive.zip, kIndexName, index);
  if (!end) return end;
  const std::vector<std::byte> directory = zip_directory(archive.zip);
  end->insert(end->end(), index.begin(), index.end());
  end->insert(end->end(), directory.begin(), directory.end());
  return end;
}

}  // namespace citykiln::exporters
