// Spools: files of raw elements, one per region, to which a pass over the extract appends elements as it finds them.
#pragma once

#include <cstdint>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm/object.hpp>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::regions {

/// Appends elements to many files. Memory: kSpoolBuffer_bytes and one element per file. The files stay until remove()
/// is called.
class Spools {
 public:
  /// @param folder  Must exist. The spools are its files 0, 1, …
  Spools(std::string folder, std::size_t count);

  /// Appends an element to a spool, by the spool's number.
  void add(std::size_t spool, const osmium::OSMObject& object);

  /// Writes the elements that are still in memory. Error: the first write that failed since construction.
  Result<Done> flush();

  /// Returns the elements of a spool. Error: a file that cannot be read.
  Result<osmium::memory::Buffer> read(std::size_t spool) const;

  /// Deletes the folder with all that is in it.
  void remove() const;

 private:
  std::string path_of(std::size_t spool) const;
  void flush(std::size_t spool);

  std::string folder_;
  std::vector<std::vector<unsigned char>> bytes_;
  bool failed_ = false;
};

/// The number of bytes that a spool collects in memory before it writes them.
inline constexpr std::size_t kSpoolBuffer_bytes = 65536;

}  // namespace citykiln::regions
