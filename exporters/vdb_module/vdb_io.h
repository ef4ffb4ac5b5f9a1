// The C interface of the module that writes OpenVDB files. It is loaded at run time, since only scenes with clouds need
// it.
#pragma once

extern "C" {

/// A block of 8 x 8 x 8 voxels, in the order x slowest, z fastest. `low` is the index of its first voxel, a multiple of
/// 8.
struct CitykilnVdbBlock {
  int low[3];
  const float* values;
};

/// A fog volume. The centre of voxel (i, j, k) is origin + voxel_m (i, j, k). Voxels outside of all blocks are 0.
struct CitykilnVdbGrid {
  const char* name;
  const char* creator;
  double voxel_m;
  double origin[3];
  int block_count;
  const struct CitykilnVdbBlock* blocks;
};

/// Receives the bytes of the file; called once.
typedef void (*CitykilnTakeBytes)(void* owner, const char* bytes, unsigned long size);

/// Makes a .vdb file. Deterministic. Returns 0, or 1 with a message in `error` (at most error_size bytes with the final
/// zero).
int citykiln_encode_vdb(const struct CitykilnVdbGrid* grid, CitykilnTakeBytes take, void* owner, char* error,
                        int error_size);
}
