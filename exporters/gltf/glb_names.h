// Names in the JSON of a .glb that writing, packing and reading share.
#pragma once

namespace citykiln::exporters {

/// The name of the node of all lights, which has no mesh.
inline constexpr const char* kLightGroup = "lights";

/// The names of images other than textures, which have their material's name with a suffix.
inline constexpr const char* kMarkingAtlasImage = "marking_atlas";
inline constexpr const char* kFacadeAtlasImage = "facade_atlas";  ///< Begins the names of the atlas's other images.
inline constexpr const char* kFacadeSurfaceImage = "facade_atlas_surface";
inline constexpr const char* kFacadeEmissionImage = "facade_atlas_emission";
inline constexpr const char* kFacadeNormalImage = "facade_atlas_normal";
inline constexpr const char* kCutoutImage = "cutout";
inline constexpr const char* kCutoutNormalImage = "cutoutNormal";

/// Extensions that are in more than one step.
inline constexpr const char* kInstancingExtension = "EXT_mesh_gpu_instancing";
inline constexpr const char* kMetadataExtension = "EXT_structural_metadata";
inline constexpr const char* kTextureTransformExtension = "KHR_texture_transform";

}  // namespace citykiln::exporters
