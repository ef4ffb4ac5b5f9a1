// The C interface of the image module. The module is loaded at run time, since linking OpenImageIO adds 0.27 s to every
// start.
#pragma once

extern "C" {

/// The type in which a channel is stored. Samples are passed as unsigned char for kByte, as float for kHalf and kFloat,
/// as uint32_t for kUint.
enum CitykilnSample { kCitykilnByte, kCitykilnHalf, kCitykilnFloat, kCitykilnUint };

/// A channel of a picture: the sample of pixel i, row by row from the top, is `samples[i * stride]`.
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

/// Reads a file as linear RGB, row by row from the top. One channel is read as grey. Asks for memory only when the size
/// is known. Returns 0, or 1 with a message.
int citykiln_read_picture(const char* path, CitykilnAllocate allocate, void* owner, char* error, int error_size);
}
