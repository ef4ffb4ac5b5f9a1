// The C interface of the image module, which is loaded at run time, since linking OpenImageIO adds 0.27 s to every
// start.
#pragma once

extern "C" {

/// How a channel is stored. Samples are given as unsigned char for kByte, as float for kHalf and kFloat, as uint32_t
/// for kUint.
enum CitykilnSample { kCitykilnByte, kCitykilnHalf, kCitykilnFloat, kCitykilnUint };

/// A channel of a picture: sample i is at `samples[i * stride]`, counted in samples, row by row from the top.
struct CitykilnChannel {
  const char* name;
  enum CitykilnSample type;
  const void* samples;
  int stride;
};

struct CitykilnPicture {
  int width, height;
  int channel_count;
  const struct CitykilnChannel* channels;
  int text_count;
  const char* const* texts;  ///< Name and value of each text in the file's header, in turn.
};

/// Writes a file of the format that the path's extension names. Returns 0, or 1 with a message in `error` (at most
/// error_size bytes with the final zero).
int citykiln_write_picture(const char* path, const struct CitykilnPicture* picture, char* error, int error_size);

/// Returns memory for 3 floats a pixel, or null to refuse the size.
typedef float* (*CitykilnAllocate)(void* owner, int width, int height);

/// Reads a file as linear RGB, row by row from the top; one channel is grey. Asks for memory only after the size is
/// known. Returns 0, or 1 with a message.
int citykiln_read_picture(const char* path, CitykilnAllocate allocate, void* owner, char* error, int error_size);
}
