#include "exporters/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace citykiln::exporters {
namespace {

Error file_error(const std::string& path, const char* what) {
  return {path, std::string(what) + ": " + std::strerror(errno)};
}

// All bytes, or false with errno.
bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

GrowingFile::GrowingFile(std::string path, std::string part, int file)
    : path_(std::move(path)), part_(std::move(part)), file_(file) {}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)), part_(std::move(other.part_)), file_(std::exchange(other.file_, -1)) {}

GrowingFile::~GrowingFile() {
  if (file_ < 0) return;
  ::close(file_);
  std::remove(part_.c_str());
}

Error GrowingFile::not_written(int reason) const {
  errno = reason;
  return file_error(path_, "cannot be written");
}

Result<GrowingFile> GrowingFile::create(std::string path, std::string part) {
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return file_error(path, "cannot be created");
  return GrowingFile(std::move(path), std::move(part), file);
}

Result<Done> GrowingFile::append(std::span<const std::byte> bytes) {
  if (!write_all(file_, bytes)) return not_written(errno);
  return Done{};
}

Result<Done> GrowingFile::finish() {
  const bool closed = ::close(std::exchange(file_, -1)) == 0;
  if (closed && std::rename(part_.c_str(), path_.c_str()) == 0) return Done{};
  const Error error = not_written(errno);
  std::remove(part_.c_str());
  return error;
}

Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes) {
  Result<GrowingFile> file = GrowingFile::create(path, path + ".part" + std::to_string(::getpid()));
  if (!file) return file.error();
  if (Result<Done> done = file->append(bytes); !done) return done;
  return file->finish();
}

Result<std::vector<std::byte>> read_file(const std::string& path) {
  std::error_code bad;
  if (std::filesystem::is_directory(path, bad)) return Error{path, "expected a file, found a folder"};
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return file_error(path, "cannot be opened");
  std::vector<std::byte> bytes(static_cast<std::size_t>(file.tellg()));
  file.seekg(0);
  if (!bytes.empty() && !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    return file_error(path, "cannot be read");
  return bytes;
}

}  // namespace citykiln::exporters
