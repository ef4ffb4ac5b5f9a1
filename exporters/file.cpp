#include "exporters/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

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

Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string part = path + ".part" + std::to_string(::getpid());
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return file_error(path, "cannot be created");
  const bool written = write_all(file, bytes);
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed || std::rename(part.c_str(), path.c_str()) != 0) {
    if (!written) errno = reason;
    const Error error = file_error(path, "cannot be written");
    std::remove(part.c_str());
    return error;
  }
  return Done{};
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
