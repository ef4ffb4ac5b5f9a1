// Spools: one file of raw elements for each region, appended to in the order in which a pass finds them.
#pragma once

#include <cstdint>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm/object.hpp>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::regions {

/// Collects elements for many files. Memory: kSpoolBuffer_bytes a file. Files are removed by remove().
class Spools {
 public:
  /// @param folder  Exists; the spools are its files 0, 1, …
  Spools(std::string folder, std::size_t count);

  void add(std::size_t spool, const osmium::OSMObject& object);

  /// Writes what is in memory. Error: the first write that failed, now or before.
  Result<Done> flush();

  /// The elements of a spool. Error: a file that cannot be read.
  Result<osmium::memory::Buffer> read(std::size_t spool) const;

  void remove() const;

 private:
  std::string path_of(std::size_t spool) const;
  void flush(std::size_t spool);

  std::string folder_;
  std::vector<std::vector<unsigned char>> bytes_;
  bool failed_ = false;
};

inline constexpr std::size_t kSpoolBuffer_bytes = 65536;

}  // namespace citykiln::regions
