// The names that a server answers, and their bytes: files of a run, the page and the tree of tiles of a scene, by their
// names in a run. Bytes that are not in the run are made when they are asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "compiler/commands/serve/content_cache.h"
#include "compiler/commands/serve_module/serve_io.h"
#include "compiler/outputs/tiles3d/tree_source.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "exporters/file_list.h"

namespace citykiln::commands {

/// The choices of a site.
struct SiteRequest {
  std::string path;             ///< A manifest, or the folder of a run.
  Outputs outputs;              ///< How contents are made.
  scene::ShownRequest shown{};  ///< Tiles of a run that show something else are not taken; they are baked.
  bool has_page = false;
  std::uint64_t cache_bytes = 0;
  int threads = 0;
};

/// The names that are answered, and how. Thread-safe.
class Site {
 public:
  /// Opens a run or a manifest. Tiles are files of the run if it has a tileset and nothing else is to be shown; else
  /// they are baked on request: with the run's levels, or for a manifest alone with those of the request. Errors: a
  /// path that is neither a finished run nor a manifest; a run without a manifest that lacks its tileset or the wanted
  /// page; files that cannot be read; a scene without tiles, if they are to be baked.
  static Result<std::unique_ptr<Site>> open(const SiteRequest& request);

  /// Returns the answer for a path such as "/page/page.json"; "/" is index.html. 404 for names that are not of the
  /// site, 403 for paths with "..", 304 if the client has the same bytes already. O(log n).
  HttpAnswer answer(const HttpRequest& request) const;

  /// Makes the JSON files of the tileset, for which the land around is baked, and, if the site has a page, the content
  /// that it shows first. Does nothing if tiles are not baked. Meant to run in another thread while the browser starts.
  void prepare() const;
  bool bakes() const { return tree_ != nullptr; }
  ContentCache::Counters counters() const { return cache_.counters(); }

 private:
  /// How a name is answered: by a file, or by bytes that are made. The tag names the bytes.
  struct Entry {
    std::string file{};
    ContentCache::Make make{};
    std::string etag{};
  };

  explicit Site(const SiteRequest& request);
  Result<Done> add_run(const SiteRequest& request, const exporters::FileList& list);
  Result<Done> add_scene(const SiteRequest& request, const std::string& manifest, bool has_tileset);
  void add_page();
  Entry made(std::string_view name, ContentCache::Make make) const;
  std::optional<Entry> entry_at(const std::string& name) const;

  Outputs outputs_;
  scene::ShownRequest shown_;
  bool has_page_;
  std::uint64_t version_ = 0;  ///< A hash of the manifest, the settings and the program.
  scene::Scene scene_;
  map::Geoid geoid_;
  std::unique_ptr<outputs::TreeSource> tree_;
  std::map<std::string, Entry> entries_;
  mutable ContentCache cache_;
};

/// Returns the media type by the ending of a name.
const char* media_type_of(std::string_view name);

/// Tests whether a header Host is "127.0.0.1:PORT" or "localhost:PORT". Other hosts are refused against DNS rebinding:
/// the owner of another name can make it resolve to this machine, so that foreign pages could read the answers.
bool is_own_host(std::string_view host, int port);

}  // namespace citykiln::commands
