#include "exporters/gltf/pack/shared_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/gltf/format_error.h"
#include "exporters/gltf/glb_checks.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pack/draco_codec.h"
#include "exporters/gltf/pack/glb_primitives.h"
#include "exporters/gltf/pack/meshopt_codec.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

// ---- sharing -------------------------------------------------------------------------------------------------------

std::span<const unsigned char> bytes_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()};
}

// A view's buffer and place, which meshopt has in an extension.
Json& place_of(Json& view) {
  return view.contains("extensions") && view["extensions"].contains(kMeshoptExtension)
             ? view["extensions"][kMeshoptExtension]
             : view;
}

// The buffer views of a mesh.
std::vector<std::size_t> views_of(const Json& gltf, const Json& mesh) {
  std::vector<std::size_t> views;
  const auto add = [&](const Json& accessor_number) {
    const Json& accessor = gltf.at("accessors").at(accessor_number.get<std::size_t>());
    if (accessor.contains("bufferView")) views.push_back(accessor["bufferView"].get<std::size_t>());
  };
  for (const Json& primitive : mesh.at("primitives")) {
    for (const auto& [name, number] : primitive.at("attributes").items()) add(number);
    add(primitive.at("indices"));
    if (primitive.contains("extensions") && primitive["extensions"].contains(kDracoExtension))
      views.push_back(primitive["extensions"][kDracoExtension]["bufferView"].get<std::size_t>());
  }
  return views;
}

bool is_of_tile(const Json& image) {
  const std::string name = image.value("name", "");
  return name == kMarkingAtlasImage || name.starts_with(kFacadeAtlasImage);
}

// Stands (bake/parts/stands.h) hold the plants of one place, which no other tile has.
bool is_stand(const Json& mesh) { return mesh.value("name", "").starts_with("stand_of_"); }

// A .glb while its views are divided among files.
struct Sharing {
  GlbParts from, to{};
  std::vector<SharedFile> files{};
  std::set<std::size_t> moved{}, dropped{};     // views; those of images go
  std::map<std::size_t, std::size_t> number{};  // of views, old and new

  // Returns the URI, or nothing where the tile has this file already: each byte is used once.
  std::optional<std::string> add_file(std::vector<std::byte> bytes, std::string_view suffix) {
    const std::string name =
        fmt::format("{}{}_{}.{}", kSharedFolder, hash_text(content_hash(bytes)), bytes.size(), suffix);
    if (bytes.empty() || std::ranges::find(files, name, &SharedFile::name) != files.end()) return std::nullopt;
    files.push_back({name, std::move(bytes)});
    return name;
  }

  void move_mesh(const Json& mesh) {
    GlbParts file;
    std::map<std::size_t, std::size_t> offsets;  // by view
    for (const std::size_t view : views_of(from.gltf, mesh))
      if (!offsets.contains(view))
        offsets[view] = append(file, bytes_of_view(from, place_of(from.gltf["bufferViews"][view])));
    const std::size_t size = file.buffer.size();
    const auto uri = add_file(std::move(file.buffer), "bin");
    if (!uri) return;
    const std::size_t buffer = to.gltf["buffers"].size();
    to.gltf["buffers"].push_back({{"uri", *uri}, {"byteLength", size}});
    for (const auto& [view, offset] : offsets) {
      Json& place = place_of(to.gltf["bufferViews"][view]);
      place["buffer"] = buffer, place["byteOffset"] = offset, moved.insert(view);
    }
  }

  void move_image(Json& image) {
    const auto view = image.at("bufferView").get<std::size_t>();
    const auto bytes = std::as_bytes(bytes_of_view(from, from.gltf["bufferViews"][view]));
    const std::string type = image.at("mimeType");
    const auto uri =
        add_file({bytes.begin(), bytes.end()}, type == "image/jpeg" ? "jpg" : type.substr(type.find('/') + 1));
    if (!uri) return;
    image["uri"] = *uri;
    image.erase("bufferView"), moved.insert(view), dropped.insert(view);
  }

  // Copies the views that stay into the new buffer, and renumbers all but those of images that went.
  void copy_rest() {
    Json views = Json::array();
    for (std::size_t i = 0; i < to.gltf["bufferViews"].size(); ++i) {
      if (dropped.contains(i)) continue;
      number[i] = views.size();
      Json view = to.gltf["bufferViews"][i];
      Json& place = place_of(view);
      if (!moved.contains(i))
        place["byteOffset"] = append(to, bytes_of_view(from, place_of(from.gltf["bufferViews"][i])));
      views.push_back(std::move(view));
    }
    to.gltf["bufferViews"] = std::move(views);
  }
};

// Replaces the numbers of buffer views everywhere: members of that name, and the columns of property tables.
void renumber_views(Json& at, const std::map<std::size_t, std::size_t>& number) {
  if (at.is_array())
    for (Json& item : at) renumber_views(item, number);
  if (!at.is_object()) return;
  for (auto& [name, value] : at.items()) {
    const bool is_view = name == "bufferView" || name == "values" || name == "stringOffsets";
    if (is_view && value.is_number_integer())
      value = number.at(value.get<std::size_t>());
    else if (name != "extras")
      renumber_views(value, number);
  }
}

// ---- embedding -----------------------------------------------------------------------------------------------------

[[noreturn]] void refuse_layout(const std::string& what) { throw std::runtime_error(what); }

// Reads one shared file.
std::vector<std::byte> shared_bytes(const std::string& folder, const std::string& uri) {
  namespace fs = std::filesystem;
  if (!is_shared_uri(uri))
    refuse_layout(fmt::format("refers to \"{}\"; only files in {} beside it are read", uri, kSharedFolder));
  const fs::path path = fs::path(folder) / uri;
  std::error_code ignored;
  if (fs::is_symlink(path.parent_path(), ignored) || !fs::is_regular_file(fs::symlink_status(path, ignored)))
    refuse_layout(fmt::format("refers to \"{}\", which is missing or no plain file", uri));
  auto bytes = read_file(path.string());
  if (!bytes) refuse_layout(to_string(bytes.error()));
  return std::move(*bytes);
}

// A .glb while files are embedded.
struct Embedding {
  GlbParts parts;
  const std::string& folder;
  std::set<std::string> read{};

  std::vector<std::byte> take(const Json& at) {
    const auto uri = at.at("uri").get<std::string>();
    if (!read.insert(uri).second) refuse_layout(fmt::format("refers to \"{}\" twice", uri.substr(0, 80)));
    return shared_bytes(folder, uri);
  }

  // Appends the buffers that are files, which are the last ones, and moves their views.
  void embed_buffers() {
    Json& buffers = parts.gltf.at("buffers");
    std::map<std::size_t, std::size_t> begin;
    for (std::size_t b = 1; b < buffers.size(); ++b) {
      if (!buffers[b].contains("uri")) continue;
      const std::vector<std::byte> bytes = take(buffers[b]);
      if (bytes.size() != buffers[b].at("byteLength").get<std::size_t>())
        refuse_layout(fmt::format("refers to \"{}\", which has another length", buffers[b]["uri"].get<std::string>()));
      begin[b] = append(parts, bytes_of(bytes));
    }
    if (begin.empty()) return;
    for (Json& view : parts.gltf.at("bufferViews")) {
      Json& place = place_of(view);
      const auto found = begin.find(place.at("buffer").get<std::size_t>());
      if (found == begin.end()) continue;
      const auto offset = place.value("byteOffset", std::uint64_t{0}),
                 length = place.at("byteLength").get<std::uint64_t>(),
                 size = buffers[found->first].at("byteLength").get<std::uint64_t>();
      if (offset > size || length > size - offset) refuse_layout("has buffer views outside their buffer");
      place["buffer"] = 0, place["byteOffset"] = offset + found->second;
    }
    while (buffers.size() > 1 && buffers.back().contains("uri")) buffers.erase(buffers.size() - 1);
  }

  void embed_images() {
    if (!parts.gltf.contains("images")) return;
    for (Json& image : parts.gltf["images"]) {
      if (!image.contains("uri")) continue;
      image["bufferView"] = add_view(parts, bytes_of(take(image)));
      image.erase("uri");
    }
  }
};

}  // namespace

SharedGlb share_prototypes(GlbParts glb) {
  Sharing sharing{std::move(glb)};
  sharing.to.gltf = sharing.from.gltf;
  Json& gltf = sharing.to.gltf;
  for (const std::size_t mesh : instanced_meshes(gltf))
    if (const Json& moved = sharing.from.gltf["meshes"].at(mesh); !is_stand(moved)) sharing.move_mesh(moved);
  if (gltf.contains("images"))
    for (Json& image : gltf["images"])
      if (!is_of_tile(image)) sharing.move_image(image);
  sharing.copy_rest();
  renumber_views(gltf, sharing.number);
  return {join_glb(std::move(sharing.to)), std::move(sharing.files)};
}

bool is_shared_uri(std::string_view uri) {
  constexpr std::string_view kFolder = kSharedFolder;
  constexpr std::size_t kLongest = 100;
  if (!uri.starts_with(kFolder) || uri.size() > kLongest) return false;
  const std::string_view name = uri.substr(kFolder.size());
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  };
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, is_plain);
}

Result<std::vector<std::byte>> with_shared_files(std::vector<std::byte> glb, const std::string& folder,
                                                 const std::string& name) {
  try {
    if (glb.size() < 4 || std::memcmp(glb.data(), "glTF", 4) != 0) return glb;
    expect_chunks(glb);
    if (json_of_glb(glb).find("\"uri\"") == std::string_view::npos) return glb;
    Embedding embedding{split_glb(glb), folder};
    embedding.embed_buffers();
    embedding.embed_images();
    return join_glb(std::move(embedding.parts));
  } catch (const FormatError& wrong) {
    return Error{name, "expected " + wrong.what};
  } catch (const std::exception& wrong) {
    return Error{name, wrong.what()};
  }
}

}  // namespace citykiln::exporters
