#include "compiler/source/format/mended_pbf.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include <protozero/pbf_writer.hpp>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

enum class Packing { kRaw, kZlib, kZlibWithoutSize, kLz4, kZstd };

std::string packed_blob(const std::string& content, Packing packing) {
  std::string packed(content.size() + 1000, '\0'), blob;
  protozero::pbf_writer writer(blob);
  if (packing == Packing::kRaw) return writer.add_bytes(1, content), blob;
  if (packing != Packing::kZlibWithoutSize) writer.add_int32(2, static_cast<std::int32_t>(content.size()));
  if (packing == Packing::kLz4) {
    const int size = LZ4_compress_default(content.data(), packed.data(), static_cast<int>(content.size()),
                                          static_cast<int>(packed.size()));
    writer.add_bytes(6, packed.data(), static_cast<std::size_t>(size));
  } else if (packing == Packing::kZstd) {
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), content.data(), content.size(), 3);
    writer.add_bytes(7, packed.data(), size);
  } else {
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
             content.size());
    writer.add_bytes(3, packed.data(), size);
  }
  return blob;
}

std::string framed(const std::string& type, const std::string& blob) {
  std::string header;
  protozero::pbf_writer writer(header);
  writer.add_string(1, type), writer.add_int32(3, static_cast<std::int32_t>(blob.size()));
  return std::string{'\0', '\0', '\0', static_cast<char>(header.size())} + header + blob;
}

// A file of one tree.
std::string pbf_of_a_tree(Packing packing) {
  std::string head, node, group, strings, data;
  protozero::pbf_writer(head).add_string(4, "OsmSchema-V0.6");
  protozero::pbf_writer node_writer(node);
  const std::uint32_t key = 1, value = 2;
  node_writer.add_sint64(1, 7);
  node_writer.add_packed_uint32(2, &key, &key + 1), node_writer.add_packed_uint32(3, &value, &value + 1);
  node_writer.add_sint64(8, 480000000), node_writer.add_sint64(9, 110000000);
  protozero::pbf_writer(group).add_message(1, node);
  protozero::pbf_writer string_writer(strings);
  for (const char* text : {"", "natural", "tree"}) string_writer.add_bytes(1, text);
  protozero::pbf_writer data_writer(data);
  data_writer.add_message(1, strings), data_writer.add_message(2, group);
  return framed("OSMHeader", packed_blob(head, packing)) + framed("OSMData", packed_blob(data, packing));
}

std::string read_pbf(const std::string& bytes) {
  const ScratchFolder folder;
  Report report;
  const Result<OsmData> data = read_osm(folder.write("a.osm.pbf", bytes), 1, report);
  return data ? text_of(*data) : data.error().message;
}

TEST(MendedPbf, BlobsOfEveryPackingAreRead) {
  const std::string expected = read_pbf(pbf_of_a_tree(Packing::kZlib));
  EXPECT_NE(expected.find("tree"), std::string::npos) << expected;
  for (const Packing packing : {Packing::kRaw, Packing::kZlibWithoutSize, Packing::kLz4, Packing::kZstd})
    EXPECT_EQ(read_pbf(pbf_of_a_tree(packing)), expected) << static_cast<int>(packing);
}

TEST(MendedPbf, FilesThatLibosmiumReadsStayAsTheyAre) {
  const ScratchFolder folder;
  for (const Packing packing : {Packing::kRaw, Packing::kZlib}) {
    const auto mended = mended_pbf(folder.write("a.osm.pbf", pbf_of_a_tree(packing)));
    ASSERT_TRUE(mended);
    EXPECT_FALSE(mended->has_value());
  }
}

TEST(MendedPbf, DamagedDataNamesTheByte) {
  const ScratchFolder folder;
  std::string bytes = pbf_of_a_tree(Packing::kZlibWithoutSize);
  for (std::size_t at = bytes.size() - 8; at < bytes.size(); ++at) bytes[at] = '\xff';
  const auto mended = mended_pbf(folder.write("a.osm.pbf", bytes));
  ASSERT_FALSE(mended);
  EXPECT_NE(mended.error().where.find(", byte "), std::string::npos);
}

// Found by fuzz_extract: protozero asserts the type of a field that is read.
TEST(MendedPbf, FieldsOfOtherTypesAreSkipped) {
  const std::string bytes = pbf_of_a_tree(Packing::kLz4);
  for (std::size_t at = 4; at < bytes.size(); ++at) {
    for (const char type : {'\0', '\1', '\2', '\5'}) {
      std::string changed = bytes;
      changed[at] = static_cast<char>((changed[at] & ~7) | type);
      EXPECT_FALSE(read_pbf(changed).empty()) << at;
    }
  }
}

}  // namespace
}  // namespace citykiln::source
