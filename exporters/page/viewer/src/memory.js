// The memory that a tile takes: each buffer and each picture once, however many meshes and materials share it.

/** Bytes of a pixel with its mipmaps. */
const PIXEL_BYTES = (4 * 4) / 3;

/** Returns the bytes of the geometry and of the textures of a scene. */
export function bytesOf(scene) {
  const arrays = new Set(), pictures = new Set();
  scene.traverse(({ geometry, material, instanceMatrix }) => {
    if (!geometry) return;
    for (const attribute of [geometry.index, instanceMatrix, ...Object.values(geometry.attributes)]) if (attribute) arrays.add(attribute.data?.array ?? attribute.array);
    for (const value of Object.values(material)) if (value?.isTexture) pictures.add(value.source.data);
  });
  const buffers = [...arrays].reduce((sum, array) => sum + array.byteLength, 0);
  return [...pictures].reduce((sum, picture) => sum + (picture?.width ?? 0) * (picture?.height ?? 0) * PIXEL_BYTES, buffers);
}
