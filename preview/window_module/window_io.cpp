#include "preview/window_module/window_io.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace {

struct Window {
  GLFWwindow* glfw = nullptr;
  GLuint texture = 0;
  double seen_s = 0, mouse_x = 0, mouse_y = 0;
  double stops = 0;
  bool asks_for_picture = false;
  int picture_width = 0, picture_height = 0;
};

void on_key(GLFWwindow* glfw, int key, int, int action, int) {
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(glfw));
  if (action != GLFW_PRESS) return;
  if (key == GLFW_KEY_P) window.asks_for_picture = true;
  if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(glfw, GLFW_TRUE);
}

// + and - are at other keys on other keyboards, so the character counts.
void on_character(GLFWwindow* glfw, unsigned character) {
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(glfw));
  if (character == '+' || character == '=') window.stops += 0.5;
  if (character == '-') window.stops -= 0.5;
}

double held(GLFWwindow* glfw, int key) { return glfwGetKey(glfw, key) == GLFW_PRESS ? 1 : 0; }

// The largest rectangle of the picture's aspect ratio in the middle of the window.
void set_viewport(const Window& window) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window.glfw, &width, &height);
  const double scale = std::min(static_cast<double>(width) / std::max(window.picture_width, 1),
                                static_cast<double>(height) / std::max(window.picture_height, 1));
  const int w = static_cast<int>(window.picture_width * scale), h = static_cast<int>(window.picture_height * scale);
  glViewport((width - w) / 2, (height - h) / 2, w, h);
}

void draw(const Window& window) {
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  set_viewport(window);
  glEnable(GL_TEXTURE_2D);
  glBegin(GL_TRIANGLE_STRIP);
  for (const int corner : {0, 1, 2, 3}) {
    const float x = static_cast<float>(corner % 2), y = static_cast<float>(corner / 2);
    // the first row of the texture is the top
    glTexCoord2f(x, 1 - y), glVertex2f(2 * x - 1, 2 * y - 1);
  }
  glEnd();
  glfwSwapBuffers(window.glfw);
}

void take_input(Window& window, CitykilnInput& input) {
  glfwPollEvents();
  GLFWwindow* glfw = window.glfw;
  const double now_s = glfwGetTime();
  double x = 0, y = 0;
  glfwGetCursorPos(glfw, &x, &y);
  const bool turns = glfwGetMouseButton(glfw, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                     glfwGetMouseButton(glfw, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
  input = {};
  input.seconds = now_s - window.seen_s;
  input.ahead = held(glfw, GLFW_KEY_W) - held(glfw, GLFW_KEY_S);
  input.aside = held(glfw, GLFW_KEY_D) - held(glfw, GLFW_KEY_A);
  input.upward = held(glfw, GLFW_KEY_E) - held(glfw, GLFW_KEY_Q);
  if (turns) input.turn_px = x - window.mouse_x, input.tilt_px = y - window.mouse_y;
  input.exposure_stops = window.stops;
  input.is_fast = held(glfw, GLFW_KEY_LEFT_SHIFT) + held(glfw, GLFW_KEY_RIGHT_SHIFT) > 0 ? 1 : 0;
  input.asks_for_picture = window.asks_for_picture ? 1 : 0;
  input.is_closed = glfwWindowShouldClose(glfw);
  glfwGetFramebufferSize(glfw, &input.width, &input.height);
  window.seen_s = now_s, window.mouse_x = x, window.mouse_y = y;
  window.stops = 0, window.asks_for_picture = false;
}

void end(const char* message, char* error, int error_size) {
  const char* why = nullptr;
  glfwGetError(&why);
  std::snprintf(error, static_cast<std::size_t>(error_size), "%s", why != nullptr ? why : message);
  glfwTerminate();
}

}  // namespace

extern "C" void* citykiln_open_window(int width, int height, const char* title, char* error, int error_size) {
  if (glfwInit() != GLFW_TRUE) return end("no display", error, error_size), nullptr;
  auto window = std::make_unique<Window>();
  window->glfw = glfwCreateWindow(width, height, title, nullptr, nullptr);
  if (window->glfw == nullptr) return end("no OpenGL", error, error_size), nullptr;
  glfwMakeContextCurrent(window->glfw);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window->glfw, window.get());
  glfwSetKeyCallback(window->glfw, on_key);
  glfwSetCharCallback(window->glfw, on_character);
  glGenTextures(1, &window->texture);
  glBindTexture(GL_TEXTURE_2D, window->texture);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  window->seen_s = glfwGetTime();
  return window.release();
}

extern "C" void citykiln_show(void* handle, const unsigned char* rgb, int width, int height, CitykilnInput* input) {
  Window& window = *static_cast<Window*>(handle);
  if (rgb != nullptr) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    window.picture_width = width, window.picture_height = height;
  }
  draw(window);
  take_input(window, *input);
}

extern "C" void citykiln_close_window(void* handle) {
  const std::unique_ptr<Window> window(static_cast<Window*>(handle));
  glfwDestroyWindow(window->glfw);
  glfwTerminate();
}
