// The names of the files and folders that a run writes into its folder. Names of tiles, levels and textures are made by
// gltf/write/encode_tile.h, usd/usd_names.h and tiles3d/tileset.h.
#pragma once

namespace citykiln::exporters {

inline constexpr const char* kManifestName = "scene.kiln";     ///< kiln/manifest.h
inline constexpr const char* kReportName = "report.json";      ///< Sizes, errors, ledger and diagnoses of the run.
inline constexpr const char* kFindingsName = "findings.json";  ///< The diagnoses with their places, as GeoJSON.
inline constexpr const char* kTimingName = "timing.json";      ///< Seconds of each stage; differs between equal runs.
inline constexpr const char* kFileListName = "files.json";     ///< file_list.h
inline constexpr const char* kKeysName = "keys.jsonl";  ///< Keys of the files for the next run (output_folder.h).
inline constexpr const char* kStagingName = ".new";     ///< The folder of a run in progress (output_folder.h).

inline constexpr const char* kGlbFolder = "glb";
inline constexpr const char* kGlbSurroundingsName = "glb/surroundings.glb";
inline constexpr const char* kGlbCloudsName = "glb/clouds.glb";
inline constexpr const char* kSharedFolder = "shared/";  ///< In kGlbFolder: files that tiles share.

inline constexpr const char* kUsdFolder = "usd";
inline constexpr const char* kUsdSceneName = "usd/scene.usda";
inline constexpr const char* kUsdTileFolder = "usd/tiles/";  ///< Layers of tiles and of their levels.
inline constexpr const char* kUsdTextureFolder = "usd/textures/";
inline constexpr const char* kUsdSurroundingsName = "usd/surroundings.usdc";
inline constexpr const char* kUsdCloudsName = "usd/clouds.usdc";
inline constexpr const char* kVdbName = "usd/clouds.vdb";

inline constexpr const char* kTilesetFolder = "3dtiles";
inline constexpr const char* kTilesetName = "tileset.json";              ///< In kTilesetFolder.
inline constexpr const char* kTilesetArchiveName = "tileset.3tz";        ///< tiles3d/archive.h
inline constexpr const char* kSurroundingsContent = "surroundings.glb";  ///< In kGlbFolder and kTilesetFolder.

inline constexpr const char* kPageIndexName = "index.html";
inline constexpr const char* kPageFolder = "page";
inline constexpr const char* kPageName = "page/page.json";           ///< page/page_json.h
inline constexpr const char* kPageNamesName = "page/names.json";     ///< The names of features.
inline constexpr const char* kPageSkyFolder = "page/skies/";         ///< Tables of skies.
inline constexpr const char* kPageFeatureFolder = "page/features/";  ///< Records of features.

}  // namespace citykiln::exporters
