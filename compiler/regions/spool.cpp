#include "compiler/regions/spool.h"

#include <filesystem>
#include <fstream>
#include <utility>

namespace citykiln::regions {

namespace fs = std::filesystem;

Spools::Spools(std::string folder, std::size_t count) : folder_(std::move(folder)), bytes_(count) {}

std::string Spools::path_of(std::size_t spool) const { return folder_ + "/" + std::to_string(spool); }

void Spools::add(std::size_t spool, const osmium::OSMObject& object) {
  std::vector<unsigned char>& bytes = bytes_[spool];
  bytes.insert(bytes.end(), object.data(), object.data() + object.padded_size());
  if (bytes.size() >= kSpoolBuffer_bytes) flush(spool);
}

void Spools::flush(std::size_t spool) {
  std::vector<unsigned char> bytes = std::exchange(bytes_[spool], {});
  std::ofstream file(path_of(spool), std::ios::binary | std::ios::app);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  failed_ = failed_ || !file.flush();
}

Result<Done> Spools::flush() {
  for (std::size_t i = 0; i < bytes_.size(); ++i)
    if (!bytes_[i].empty()) flush(i);
  if (failed_) return Error{folder_, "cannot be written"};
  return Done{};
}

Result<osmium::memory::Buffer> Spools::read(std::size_t spool) const {
  std::error_code none;
  const std::string path = path_of(spool);
  const std::uintmax_t size = fs::exists(path, none) ? fs::file_size(path, none) : 0;
  // a capacity of at least 64 bytes, a multiple of 8
  osmium::memory::Buffer buffer(size + 64 - size % 64, osmium::memory::Buffer::auto_grow::no);
  if (size == 0) return buffer;
  std::ifstream file(path, std::ios::binary);
  unsigned char* to = buffer.reserve_space(size);
  if (!file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(size))) return Error{path, "cannot be read"};
  buffer.commit();
  return buffer;
}

void Spools::remove() const {
  std::error_code none;
  fs::remove_all(folder_, none);
}

}  // namespace citykiln::regions
