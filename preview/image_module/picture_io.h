// The C interface of the image module, which is loaded at run time, since linking OpenImageIO adds 0.27 s to every
// start.
#pragma once

extern "C" {

/// Writes `channels` 8 bit or float samples per pixel. Returns 0, or 1 with a message in `error` (at most error_size
/// bytes with the final zero).
int citykiln_write_picture(const char* path, int width, int height, const void* pixels, int is_float, char* error,
                           int error_size);
}
