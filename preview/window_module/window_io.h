// The C interface of the window module. The module is loaded at run time, so that programs without a display need no
// OpenGL.
#pragma once

extern "C" {

/// The keys and mouse movements since the last call.
struct CitykilnInput {
  double seconds;               ///< Time since the last call.
  double ahead, aside, upward;  ///< Keys held: -1, 0 or 1.
  double turn_px, tilt_px;      ///< Mouse moved with a button held, to the right and down.
  double exposure_stops;        ///< Keys + and - pressed.
  int is_fast;                  ///< Shift is held.
  int asks_for_picture;         ///< P was pressed.
  int is_closed;                ///< Esc was pressed, or the window was closed.
  int width, height;            ///< Size of the window, in pixels.
};

/// Opens a window. Returns null with a message in `error` (at most error_size bytes with the final zero) where there is
/// no display or no OpenGL.
void* citykiln_open_window(int width, int height, const char* title, char* error, int error_size);

/// Shows 8 bit sRGB pixels, row by row from the top, in the middle of the window, as large as their aspect ratio
/// allows, and fills `input`. If `rgb` is null, the window keeps its picture.
void citykiln_show(void* window, const unsigned char* rgb, int width, int height, struct CitykilnInput* input);

/// Closes a window that was opened.
void citykiln_close_window(void* window);
}
